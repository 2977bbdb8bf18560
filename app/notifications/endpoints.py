"""The studio's outbox."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import ProducerNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.notifications import links, service
from app.notifications.errors import MailNotFailed, MailNotFound
from app.notifications.models import Mail
from app.notifications.rules import mail_state, text_of
from app.notifications.schemas import MailedLinkRead, MailedLinksRead, MailRead, OutboxRead
from app.projects.errors import ProjectNotFound, TeamNeeded

router = APIRouter(prefix="/v1", tags=["notifications"])


def _shown_link(mail: Mail, *, can_send: bool) -> str | None:
    # A secret link is shown only if no mail server delivers it to its recipient, or it was asked for after a refusal.
    is_delivered = can_send and mail.secret_of is not None and mail.failure is None
    return None if mail.sent_at is not None or is_delivered else mail.link


def _read(mail: Mail, *, can_send: bool) -> MailRead:
    link = _shown_link(mail, can_send=can_send)
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


@router.get("/projects/{project_id}/mailed-links", responses=problems(ProjectNotFound, TeamNeeded))
def list_mailed_links(
    project_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.TEAM)
) -> MailedLinksRead:
    """Return the state of each invitation email: to designers, candidates and, for producers, members."""
    can_send = bool(runtime.settings.smtp_url)
    return MailedLinksRead(
        can_send=can_send,
        links=[
            MailedLinkRead(
                of_id=mail.secret_of_id,
                mail_id=mail.id,
                recipient=mail.recipient,
                state=mail_state(mail.sent_at, mail.failure, can_send=can_send),
                created_at=mail.created_at,
                sent_at=mail.sent_at,
                failure=mail.failure,
                link=_shown_link(mail, can_send=can_send),
            )
            for mail in service.mailed_links(session, actor, project_id)
            if mail.secret_of_id is not None
        ],
    )


@router.post("/mails/{mail_id}/link", responses=problems(MailNotFound, MailNotFailed))
def hand_over_link(
    mail_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> MailRead:
    """Show the link of a mail that the mail server refused, to be handed over."""
    mail = links.link_by_hand(session, actor, mail_id, base_url=runtime.settings.base_url)
    return _read(mail, can_send=bool(runtime.settings.smtp_url))


@router.post("/mails/{mail_id}/send", responses=problems(MailNotFound))
def send_mail_again(
    mail_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> MailRead:
    """Try a mail again that was not sent."""
    return _read(service.send_again(session, actor, mail_id), can_send=bool(runtime.settings.smtp_url))
