"""Reasons and labels, read from the database; callers have checked access."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import select
from sqlalchemy.orm import Session

from app.reviews.models import ReasonList
from app.reviews.reason_rules import ReasonKind


def lists_of(session: Session, studio_id: UUID) -> dict[ReasonKind, Sequence[str]]:
    """Return the lists that a studio wrote."""
    query = select(ReasonList.kind, ReasonList.reasons).where(ReasonList.studio_id == studio_id)
    return dict(session.execute(query).all())
