"""The studio's outbox."""

from uuid import UUID

from app.accounts.errors import ProducerNeeded, StudioNotFound
from app.accounts.policies import allows
from app.accounts.rules import Actor, Audience
from app.kit.http import CurrentRuntime, DbSession, Route, Router, problems
from app.notifications import service
from app.notifications.errors import MailNotFound
from app.notifications.models import Mail
from app.notifications.rules import text_of
from app.notifications.schemas import MailRead, OutboxRead

router = Router(prefix="/v1", tags=["notifications"], route_class=Route)


def _read(mail: Mail, *, can_send: bool) -> MailRead:
    # A secret link is shown only if no mail server delivers it to its recipient.
    link = None if mail.sent_at is not None or (can_send and mail.secret_of is not None) else mail.link
    return MailRead(
        id=mail.id,
        recipient=mail.recipient,
        subject=mail.subject,
        text=text_of(mail.lines, link),
        link=link,
        created_at=mail.created_at,
        sent_at=mail.sent_at,
        failure=mail.failure,
    )


@router.get("/studios/{studio_id}/outbox", responses=problems(StudioNotFound, ProducerNeeded))
def read_outbox(
    studio_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> OutboxRead:
    """Return the studio's mails, those that wait for an SMTP server first."""
    mails = service.outbox(session, actor, studio_id)
    can_send = bool(runtime.settings.smtp_url)
    return OutboxRead(can_send=can_send, mails=[_read(mail, can_send=can_send) for mail in mails])


@router.post("/mails/{mail_id}/send", responses=problems(MailNotFound))
def send_mail_again(
    mail_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> MailRead:
    """Try a mail again that was not sent."""
    return _read(service.send_again(session, actor, mail_id), can_send=bool(runtime.settings.smtp_url))
