"""Queries of hand-offs."""

from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import or_, select
from sqlalchemy.orm import Session, joinedload

from app.core.in_array import in_array
from app.deliveries.models import Handoff, Take


def handoffs_of(session: Session, cue_id: UUID, designer_id: UUID | None) -> Sequence[Handoff]:
    """Return the hand-offs of a cue with their people, the newest first; those from or to one designer where given."""
    query = select(Handoff).where(Handoff.cue_id == cue_id)
    if designer_id is not None:
        query = query.where(or_(Handoff.from_id == designer_id, Handoff.to_id == designer_id))
    people = joinedload(Handoff.maker), joinedload(Handoff.next_maker), joinedload(Handoff.author)
    return session.scalars(query.options(*people).order_by(Handoff.id.desc())).all()


def handoff_by_id(session: Session, handoff_id: UUID) -> Handoff | None:
    """Return a hand-off without asking who looks."""
    return session.get(Handoff, handoff_id)


def takes_by(session: Session, cue_id: UUID, designer_ids: Collection[UUID]) -> Sequence[Take]:
    """Return the takes of makers for a cue, the newest first."""
    return session.scalars(
        select(Take)
        .where(Take.cue_id == cue_id, in_array(Take.designer_id, designer_ids), Take.discarded_at.is_(None))
        .order_by(Take.id.desc())
    ).all()


def partners_of(session: Session, project_id: UUID, designer_id: UUID) -> Sequence[UUID]:
    """Return the designers from whom a designer took cues of a project, or to whom they gave some."""
    given = select(Handoff.to_id).where(Handoff.project_id == project_id, Handoff.from_id == designer_id)
    taken = select(Handoff.from_id).where(Handoff.project_id == project_id, Handoff.to_id == designer_id)
    return [person_id for person_id in session.scalars(given.union(taken)) if person_id is not None]
