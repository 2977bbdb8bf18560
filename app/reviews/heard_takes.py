"""Which takes a person has heard; each person sees and records their own alone."""

from collections.abc import Collection
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.kit import clock
from app.kit.db import insert_all_if_absent
from app.projects.service import project_access
from app.reviews import heard_queries
from app.reviews.models import HeardTake


def record_heard_takes(session: Session, actor: Actor, project_id: UUID, take_ids: Collection[UUID]) -> None:
    """Record that the caller heard takes of a project; others among the ids are passed over."""
    project_access(session, actor, project_id).ensure_team()
    known = heard_queries.takes_of_project(session, project_id, take_ids)
    rows = [{"take_id": one, "person_id": actor.person, "heard_at": clock.now()} for one in known]
    if rows:
        insert_all_if_absent(session, HeardTake, rows, unique=("take_id", "person_id"))
