"""The secret addresses of people's calendars: who made one, and whose it is."""

from collections.abc import Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.authentication import new_secret, sha256_of
from app.accounts.queries import actor_for_person
from app.accounts.rules import Actor, MemberChange
from app.core import clock
from app.core.db import bypass_row_policies, set_access_scope
from app.money import queries
from app.money.errors import CalendarNotFound
from app.money.models import CalendarLink
from app.projects.service import project_access


def make_link(session: Session, actor: Actor, project_id: UUID) -> str:
    """Return the secret of the caller's calendar of a project; an earlier one loses its worth."""
    access = project_access(session, actor, project_id)
    withdraw_links(session, actor, project_id)
    secret = new_secret()
    session.add(
        CalendarLink(
            studio_id=access.project.studio_id,
            project_id=project_id,
            person_id=actor.person,
            secret_sha256=sha256_of(secret),
        )
    )
    session.flush()
    return secret


def withdraw_links(session: Session, actor: Actor, project_id: UUID) -> None:
    """Revoke the addresses of the caller's calendar of a project."""
    project_access(session, actor, project_id)
    for link in queries.calendars_of(session, project_id, actor.person):
        link.revoked_at = clock.now()


def end_links_of_member(session: Session, payload: Mapping[str, Any]) -> None:
    """Revoke the calendars of who left the studio, but of projects that engage them: a handler of `member.changed`."""
    change = MemberChange.of(payload)
    if change.has_left:
        for link in queries.calendars_of_former_member(session, change.studio_id, change.person_id):
            link.revoked_at = clock.now()
        session.flush()


def holder_of(session: Session, secret: str) -> tuple[Actor, CalendarLink]:
    """Return the owner of a link's calendar, and go on with that person's reach; raise CalendarNotFound for others."""
    with bypass_row_policies(session):  # the secret is all that says whose calendar it is
        link = queries.calendar_by_secret(session, sha256_of(secret))
        actor = actor_for_person(session, link.person_id) if link else None
    if link is None or actor is None:
        raise CalendarNotFound(
            "this calendar link is unknown or was replaced", fix="create a new calendar link on the project's page"
        )
    set_access_scope(session, actor.reach)
    return actor, link
