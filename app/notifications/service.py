"""Writing mails with the facts they tell, and sending them."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.accounts.service import ensure_producer_of
from app.kit import clock
from app.kit.events import publish
from app.notifications import queries
from app.notifications.errors import MailNotFound
from app.notifications.models import Mail


def write_mail(
    session: Session,
    *,
    event_id: str,
    studio_id: UUID | None,
    topic: str,
    recipient: str,
    subject: str,
    line: str,
    link: str | None = None,
    delay_s: float = 0,
) -> None:
    """Add news to the recipient's open mail on the topic, or begin one and have it sent after the delay."""
    mail = queries.open_mail(session, topic, recipient)
    if mail is not None:
        if event_id not in mail.event_ids:
            mail.lines = [*mail.lines, line]
            mail.event_ids = [*mail.event_ids, event_id]
        return
    mail = Mail(
        studio_id=studio_id,
        topic=topic,
        recipient=recipient,
        subject=subject,
        lines=[line],
        event_ids=[event_id],
        link=link,
    )
    session.add(mail)
    session.flush()
    publish(session, "mail.written", studio_id=mail.studio_id, delay_s=delay_s, mail_id=mail.id)


def outbox(session: Session, actor: Actor, studio_id: UUID) -> list[Mail]:
    """Return the mails that the studio's producer may see; mails about somebody's own account are not among them."""
    ensure_producer_of(session, actor, studio_id)
    return list(queries.outbox(session, studio_id))


def send_again(session: Session, actor: Actor, mail_id: UUID) -> Mail:
    """Try a mail again that was not sent."""
    mail = session.get(Mail, mail_id)
    if mail is None or mail.studio_id is None or not actor.roles_in(mail.studio_id) & {Role.PRODUCER}:
        raise MailNotFound(f"no mail {mail_id}")
    if mail.sent_at is None:
        publish(session, "mail.written", studio_id=mail.studio_id, mail_id=mail.id)
    return mail


def seal(session: Session, mail_id: UUID) -> Mail | None:
    """Close a mail to further news and return it, None when it was sent before."""
    mail = session.get(Mail, mail_id)
    if mail is None or mail.sent_at is not None:
        return None
    mail.sealed_at = mail.sealed_at or clock.now()
    return mail
