"""Mails about what gives access to an account or a studio, sent whatever their reader wishes of other mails."""

from collections.abc import Iterable
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import DeskToken, Person, Studio, Token
from app.accounts.queries import tokens_that_end_before
from app.accounts.rules import TOKEN_WARNED_BEFORE, is_end_near
from app.core import clock
from app.core.jobs.queue import Payload
from app.core.plural import day_in_words
from app.core.runtime import Runtime
from app.notifications import queries, service
from app.notifications.kinds import notice
from app.notifications.notices import service as notices
from app.notifications.preferences.rules import News
from app.projects.models import Project

NOT_YOU = "If it was not you, set a new password now: that signs out every browser and ends every desk token."


@notice("password.changed")
def notify_new_password(runtime: Runtime, payload: Payload) -> None:
    """Tell a person that their password was changed."""
    line = f"The password of your account was changed, and its other sign-ins were ended. {NOT_YOU}"
    with runtime.database.writing() as session:
        _tell_person(runtime, session, payload, "Your password was changed", line, page="forgotten-password")


@notice("device.signed_in")
def notify_new_device(runtime: Runtime, payload: Payload) -> None:
    """Tell a person that a browser signed in that had not before."""
    line = f"{payload['device']} signed in to your account from {payload['place']}, for the first time. {NOT_YOU}"
    with runtime.database.writing() as session:
        _tell_person(runtime, session, payload, "A new browser signed in to your account", line, page="account")


@notice("address.changed")
def notify_new_address(runtime: Runtime, payload: Payload) -> None:
    """Tell both addresses that the address of an account was changed."""
    old_email, new_email = payload["old_email"], payload["new_email"]
    line = (
        f"The email of your account was changed from {old_email} to {new_email}, and its other sign-ins were ended. "
        "If it was not you, write to the operator of this server."
    )
    with runtime.database.writing() as session:
        for recipient in (old_email, new_email):
            service.write_mail(
                session,
                event_id=payload["event_id"],
                studio_id=None,
                topic=f"{payload['event']}:{payload['event_id']}",
                recipient=recipient,
                subject="The email of your account was changed",
                lines=[line],
                link=f"{runtime.settings.base_url}/account/tokens",
            )


@notice("second_factor.changed")
def notify_second_factor(runtime: Runtime, payload: Payload) -> None:
    """Tell a person of a change to the second factor of their account."""
    line = f"{payload['change']} {NOT_YOU}"
    with runtime.database.writing() as session:
        _tell_person(runtime, session, payload, "The second factor of your account", line, page="account")


@notice("desk_token.made")
def notify_desk_token(runtime: Runtime, payload: Payload) -> None:
    """Tell a person that a desk token of theirs was made."""
    line = f"The desk token “{payload['name']}” was made for your account. {NOT_YOU}"
    with runtime.database.writing() as session:
        _tell_person(runtime, session, payload, "A new desk token of your account", line, page="account/tokens")


@notice("token.made", topics={"tokens": News.LIST})
def notify_token(runtime: Runtime, payload: Payload) -> None:
    """Tell the producers of a studio that a token for builds was made."""
    with runtime.database.writing() as session:
        token = session.get_one(Token, UUID(payload["token_id"]))
        maker, project = session.get_one(Person, token.created_by), session.get_one(Project, token.project_id)
        line = (
            f"{maker.name} made the token “{token.name}” for builds of {project.name}. It ends on "
            f"{day_in_words(token.expires_at)}. If nobody of you meant to, revoke it on the page Tokens."
        )
        event_id, subject, path = payload["event_id"], f"{project.name}: a new token for builds", _tokens_page(project)
        _tell_producers(runtime, session, event_id, token.studio_id, "tokens", subject, line, path, of=project)


@notice("producer.named", topics={"producers": News.LIST})
def notify_producer(runtime: Runtime, payload: Payload) -> None:
    """Tell the other producers of a studio that a person became one."""
    with runtime.database.writing() as session:
        studio_id, person_id = UUID(payload["studio_id"]), UUID(payload["person_id"])
        studio, person = session.get_one(Studio, studio_id), session.get_one(Person, person_id)
        line = (
            f"{person.name} ({person.email}) is a producer of {studio.name} now, and may do everything there. "
            "If nobody of you meant to, give them another role on the page Studio."
        )
        event_id, subject = payload["event_id"], f"{studio.name}: a new producer"
        path = f"/studio?studio={studio_id}"
        _tell_producers(runtime, session, event_id, studio_id, "producers", subject, line, path, but=person.email)


@notice("sign_in_provider.changed", topics={"providers": News.LIST})
def notify_sign_in_provider(runtime: Runtime, payload: Payload) -> None:
    """Tell the producers of a studio that its sign-in provider was set, changed or removed."""
    with runtime.database.writing() as session:
        studio_id = UUID(payload["studio_id"])
        studio, person = session.get_one(Studio, studio_id), session.get_one(Person, UUID(payload["person_id"]))
        line = (
            f"{person.name} ({person.email}) {payload['change']} "
            "If nobody of you meant to, remove the provider on the page Studio."
        )
        event_id, subject = payload["event_id"], f"{studio.name}: the sign-in provider was changed"
        path = f"/studio?studio={studio_id}"
        _tell_producers(runtime, session, event_id, studio_id, "providers", subject, line, path)


@notice()
def warn_of_token_ends(runtime: Runtime, _payload: Payload) -> None:
    """Announce once the end of each token: of builds to the producers, of a desk to its person."""
    now = clock.now()
    with runtime.database.writing() as session:
        for token in tokens_that_end_before(session, now + TOKEN_WARNED_BEFORE, now):
            if not is_end_near(token.created_at, token.expires_at, now):
                continue
            token.warned_at = now
            end, event_id = day_in_words(token.expires_at), f"token-end:{token.id}"
            if isinstance(token, DeskToken):
                line = f"The desk token “{token.name}” ends on {end}. Make a new one before, on the page Tokens."
                service.write_mail(
                    session,
                    event_id=event_id,
                    studio_id=None,
                    topic=event_id,
                    recipient=queries.address_of(session, token.person_id),
                    subject=f"A desk token ends on {end}",
                    lines=[line],
                    link=f"{runtime.settings.base_url}/account/tokens",
                )
                continue
            project = session.get_one(Project, token.project_id)
            line = (
                f"The token “{token.name}” ends on {end}. Builds that use it are refused from then on: make a new one."
            )
            subject, path = f"{project.name}: a token for builds ends on {end}", _tokens_page(project)
            _tell_producers(runtime, session, event_id, token.studio_id, "tokens", subject, line, path, of=project)


def _tokens_page(project: Project) -> str:
    return f"/projects/{project.id}/tokens"


def _tell_person(runtime: Runtime, session: Session, payload: Payload, subject: str, line: str, *, page: str) -> None:
    service.write_mail(
        session,
        event_id=payload["event_id"],
        studio_id=None,  # of the person's own account, which no outbox shows to a studio
        topic=f"{payload['event']}:{payload['event_id']}",
        recipient=queries.address_of(session, UUID(payload["person_id"])),
        subject=subject,
        lines=[line],
        link=f"{runtime.settings.base_url}/{page}",
    )


def _tell_producers(
    runtime: Runtime,
    session: Session,
    event_id: str,
    studio_id: UUID,
    kind: str,
    subject: str,
    line: str,
    path: str,
    *,
    but: str = "",
    of: Project | None = None,
) -> None:
    project_id = of.id if of else None
    recipients: Iterable[str] = sorted(queries.producer_addresses(session, studio_id) - {but})
    topic = f"{kind}:{event_id}"
    for recipient in recipients:
        person_id = queries.person_id_at(session, recipient)
        if person_id is not None and not queries.is_addressed(session, studio_id, person_id, project_id):
            continue  # a member who is not in the project
        notices.add(
            session,
            event_id=event_id,
            studio_id=studio_id,
            project_id=project_id,
            topic=topic,
            recipient=recipient,
            subject=subject,
            text=line,
            path=path,
        )
        service.write_mail(
            session,
            event_id=event_id,
            studio_id=studio_id,
            project_id=project_id,
            topic=topic,
            recipient=recipient,
            subject=subject,
            lines=[line],
            link=f"{runtime.settings.base_url}{path}",
        )
