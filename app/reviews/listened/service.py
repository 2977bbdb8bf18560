"""The takes that a person has heard; each person sees and records their own alone."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.db import insert_all_if_absent
from app.projects.service import project_access
from app.reviews.listened import queries as heard_queries
from app.reviews.models import HeardTake


def record_heard_takes(session: Session, actor: Actor, project_id: UUID, take_ids: Collection[UUID]) -> None:
    """Record that the caller heard takes of a project; others among the ids are passed over."""
    project_access(session, actor, project_id).ensure_team()
    _record(session, actor.person, heard_queries.takes_of_project(session, project_id, take_ids))


def heard_now_or_before(
    session: Session, person_id: UUID, take_ids: Collection[UUID], heard_now: Collection[UUID]
) -> set[UUID]:
    """Return those of some takes that a person has heard; those that they have just heard are recorded."""
    _record(session, person_id, [take_id for take_id in take_ids if take_id in heard_now])
    return heard_queries.heard_among(session, person_id, take_ids)


def _record(session: Session, person_id: UUID, take_ids: Collection[UUID]) -> None:
    rows = [{"take_id": take_id, "person_id": person_id, "heard_at": clock.now()} for take_id in take_ids]
    if rows:
        insert_all_if_absent(session, HeardTake, rows, unique=("take_id", "person_id"))
