"""Queries of what is due in a project."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import distinct, func, select
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def open_cues(session: Session, project_id: UUID) -> Sequence[Cue]:
    """Return the cues that have a day and are neither cut nor approved in every variation, by day."""
    approved = (
        select(func.count(distinct(Take.variation)))
        .where(Take.cue_id == Cue.id, Take.state == TakeState.APPROVED)
        .correlate(Cue)
        .scalar_subquery()
    )
    return session.scalars(
        select(Cue)
        .where(Cue.project_id == project_id, Cue.due_on.is_not(None), Cue.state != CueState.CUT)
        .where(approved < Cue.variations)
        .order_by(Cue.due_on, Cue.number)
    ).all()
