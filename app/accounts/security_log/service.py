"""The security log of a studio: written here only, in the transaction of the act."""

from collections.abc import Mapping, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.models import Token
from app.accounts.rules import Actor, network_of
from app.accounts.security_log import queries as security_event_queries
from app.accounts.security_log.models import SecurityEvent
from app.accounts.security_log.rules import KEPT_FOR, SecurityEventKind, names_of_roles
from app.accounts.service import ensure_producer_of
from app.core import clock
from app.core.db import bypass_row_policies
from app.core.web.http import CLIENT_ADDRESS

PERSONAL = {
    "password.changed": (SecurityEventKind.PASSWORD, "set a new password"),
    "address.changed": (SecurityEventKind.EMAIL, "changed the email of the account"),
    "desk_token.made": (SecurityEventKind.TOKEN, "made a desk token"),
}


def record(
    session: Session,
    kind: SecurityEventKind,
    summary: str,
    *,
    studio_ids: Sequence[UUID],
    project_id: UUID | None = None,
    person_id: UUID | None,
    about_id: UUID | None = None,
) -> None:
    """Add a line to the log of each studio; of a project, only who sees it reads the line."""
    network = network_of(session.info.get(CLIENT_ADDRESS, ""))
    with bypass_row_policies(session):  # who joins or leaves cannot see the studio
        session.add_all(
            SecurityEvent(
                studio_id=studio_id,
                project_id=project_id,
                kind=kind,
                summary=summary,
                person_id=person_id,
                about_id=about_id,
                network=network,
            )
            for studio_id in studio_ids
        )
        session.flush()


def record_of_person(session: Session, kind: SecurityEventKind, summary: str, person_id: UUID) -> None:
    """Add a line about a person's own account to the log of each studio that they belong to."""
    with bypass_row_policies(session):  # the link or the password identifies the person
        studio_ids = security_event_queries.studios_of(session, person_id)
    record(session, kind, summary, studio_ids=studio_ids, person_id=person_id)


def record_personal_event(session: Session, payload: Mapping[str, Any]) -> None:
    """Record a changed password, a changed email or a desk token."""
    kind, summary = PERSONAL[payload["event"]]
    record_of_person(session, kind, summary, UUID(payload["person_id"]))


def record_second_factor(session: Session, payload: Mapping[str, Any]) -> None:
    """Record a change of a person's second factors, or the use of a recovery code."""
    record_of_person(session, SecurityEventKind.SECOND_FACTOR, payload["summary"], UUID(payload["person_id"]))


def record_token(session: Session, payload: Mapping[str, Any]) -> None:
    """Record a new token for builds."""
    token = session.get_one(Token, UUID(payload["token_id"]))
    summary = f"made the build token {token.name}"
    record(
        session,
        SecurityEventKind.TOKEN,
        summary,
        studio_ids=[token.studio_id],
        project_id=token.project_id,
        person_id=token.created_by,
    )


def record_joining(session: Session, payload: Mapping[str, Any]) -> None:
    """Record the roles of a person who joined the studio."""
    summary = f"joined with the roles {names_of_roles(payload['roles'])}"
    studio_ids = [UUID(payload["studio_id"])]
    record(session, SecurityEventKind.ROLES, summary, studio_ids=studio_ids, person_id=UUID(payload["person_id"]))


def record_member_change(session: Session, payload: Mapping[str, Any]) -> None:
    """Record other roles of a member, or their removal."""
    roles = names_of_roles(payload["roles"])
    record(
        session,
        SecurityEventKind.ROLES if roles else SecurityEventKind.REMOVAL,
        f"changed the roles to {roles}" if roles else "removed from the studio",
        studio_ids=[UUID(payload["studio_id"])],
        person_id=UUID(payload["changed_by"]),
        about_id=UUID(payload["person_id"]),
    )


def events_of(
    session: Session,
    actor: Actor,
    studio_id: UUID,
    *,
    kind: SecurityEventKind | None,
    before: UUID | None = None,
    limit: int,
) -> Sequence[SecurityEvent]:
    """Return lines of the studio's log to a producer, newest first."""
    ensure_producer_of(session, actor, studio_id)
    return security_event_queries.events(session, studio_id, kind=kind, before=before, limit=limit)


def delete_old(session: Session) -> None:
    """Delete lines that are older than the log goes back."""
    security_event_queries.delete_before(session, clock.now() - KEPT_FOR)
