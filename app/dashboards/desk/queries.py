"""Queries of a designer's desk; each function is one SELECT, whatever the size of the project."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import NamedTuple
from uuid import UUID

from sqlalchemy import ColumnElement, Row, exists, func, select, tuple_
from sqlalchemy.orm import Session, aliased

from app.core.in_array import in_array
from app.deliveries.cue_counts.rules import WITH_DESIGNER
from app.deliveries.models import Take, TakeCounts
from app.deliveries.rules import TakeState
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def waiting_counts(session: Session, project_id: UUID, designer_id: UUID) -> dict[TakeState, int]:
    """Return the numbers of a designer's takes, each for a cue, being checked now and waiting for their verdict."""
    moving = Take.state.in_((TakeState.RECEIVED, TakeState.CONFORMING))
    rows = session.execute(
        select(Take.state, func.count())
        .where(Take.project_id == project_id, moving, Take.cue_id.is_not(None), Take.designer_id == designer_id)
        .group_by(Take.state)
    )
    return dict(rows.all())


class BackCue(NamedTuple):
    """A cue of which takes came back to a designer."""

    id: UUID
    since: datetime
    variations: int
    facts: str


def back_cues(
    session: Session, project_id: UUID, designer_id: UUID, *, after: tuple[datetime, UUID] | None, limit: int
) -> list[BackCue]:
    """Return the cues of which takes came back to a designer, those that wait longest first."""
    query = select(TakeCounts.cue_id, TakeCounts.back_since, TakeCounts.variations, TakeCounts.facts)
    of_designer = (TakeCounts.project_id == project_id, TakeCounts.viewer_id == designer_id)
    query = query.where(*of_designer, TakeCounts.back_since.is_not(None), TakeCounts.state != CueState.CUT)
    if after is not None:
        query = query.where(tuple_(TakeCounts.back_since, TakeCounts.cue_id) > tuple_(*after))
    rows = session.execute(query.order_by(TakeCounts.back_since, TakeCounts.cue_id).limit(limit))
    return [BackCue._make(row) for row in rows]


def takes_back(session: Session, cue_ids: Collection[UUID], designer_id: UUID) -> Sequence[Row[Take, Cue]]:
    """Return a designer's takes of some cues that came back and were not followed by another of theirs."""
    later = aliased(Take)
    is_followed = exists().where(
        later.cue_id == Take.cue_id,
        later.variation == Take.variation,
        later.designer_id == designer_id,
        later.number > Take.number,
    )
    return session.execute(
        select(Take, Cue)
        .join(Cue, Cue.id == Take.cue_id)
        .where(in_array(Take.cue_id, cue_ids), Take.designer_id == designer_id)
        .where(Take.state.in_(WITH_DESIGNER), ~is_followed)
        .order_by(Take.state_since, Take.id)
    ).all()


def has_facts(project_id: UUID, designer_id: UUID, facts: Collection[str]) -> ColumnElement[bool]:
    """Say of a cue that a designer's takes add up to one of these facts."""
    of_designer = (TakeCounts.project_id == project_id, TakeCounts.viewer_id == designer_id)
    return Cue.id.in_(select(TakeCounts.cue_id).where(*of_designer, in_array(TakeCounts.facts, facts)))


def cues_by_id(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, Cue]:
    """Return cues without the stems that they own."""
    return {cue.id: cue for cue in session.scalars(select(Cue).where(in_array(Cue.id, cue_ids)))}
