"""The takes that a person heard, and those that can be recorded; callers have checked access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.core.in_array import in_array
from app.deliveries.models import Take
from app.reviews.models import HeardTake


def takes_of_project(session: Session, project_id: UUID, take_ids: Collection[UUID]) -> Sequence[UUID]:
    """Return those of some takes that belong to a project."""
    return session.scalars(select(Take.id).where(Take.project_id == project_id, in_array(Take.id, take_ids))).all()


def heard_among(session: Session, person_id: UUID, take_ids: Collection[UUID]) -> set[UUID]:
    """Return those of some takes that a person has heard."""
    heard = select(HeardTake.take_id).where(HeardTake.person_id == person_id, in_array(HeardTake.take_id, take_ids))
    return set(session.scalars(heard))
