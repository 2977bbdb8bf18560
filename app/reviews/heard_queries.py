"""Which takes can be recorded as heard; callers have checked access."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.kit.in_array import in_array


def takes_of_project(session: Session, project_id: UUID, take_ids: Collection[UUID]) -> Sequence[UUID]:
    """Return which of some takes belong to a project."""
    return session.scalars(select(Take.id).where(Take.project_id == project_id, in_array(Take.id, take_ids))).all()
