"""The basis of computed pace; each function is one SELECT of narrow rows."""

from collections.abc import Sequence
from datetime import date, datetime
from uuid import UUID

from sqlalchemy import ColumnElement, Row, exists, func, select
from sqlalchemy.orm import Session, aliased

from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.reviews.models import Round, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, Question
from app.sound_lists.rules import CueState

NEWEST = 1_000  # decisions, questions: older ones say nothing of today


def cues(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[UUID, int, str, int, date | None]]:
    """Return the cues that are not cut; of a designer, those that she sent something for."""
    query = select(Cue.id, Cue.number, Cue.name, Cue.variations, Cue.due_on).where(
        Cue.project_id == project_id, Cue.state != CueState.CUT
    )
    if designer_id is not None:
        query = query.where(exists().where(Take.cue_id == Cue.id, Take.designer_id == designer_id))
    return session.execute(query.order_by(Cue.position, Cue.number)).all()


def rounds(session: Session, project_id: UUID) -> Sequence[Row[UUID, int, datetime]]:
    """Return the number of changes sent for each cue, and the time of the first."""
    return session.execute(
        select(Round.cue_id, func.count(), func.min(Round.created_at))
        .where(Round.project_id == project_id)
        .group_by(Round.cue_id)
    ).all()


def approvals(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[Row[UUID, int, datetime, bool]]:
    """Return the variations whose approval stands: cue, variation, since when, and whether only an adoption gave it."""
    query = (
        select(
            *(Verdict.cue_id, Take.variation, func.min(Verdict.created_at)),
            func.count(Verdict.adoption_id) == func.count(),
        )
        .join(Take, Take.id == Verdict.take_id)
        .where(Verdict.project_id == project_id, Verdict.kind == VerdictKind.APPROVE, *_stands(designer_id))
        .group_by(Verdict.cue_id, Take.variation)
    )
    return session.execute(query).all()


def review_times(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[Row[datetime, datetime]]:
    """Return the start of the wait and the time of the verdict of the versions that were reviewed last."""
    query = (
        select(Verdict.since_before, Verdict.created_at)
        .join(Take, Take.id == Verdict.take_id)
        .where(
            Verdict.project_id == project_id,
            Verdict.kind.in_((VerdictKind.APPROVE, VerdictKind.REQUEST_CHANGE)),
            Verdict.given_by.is_not(None),
            Verdict.adoption_id.is_(None),
            *_stands(designer_id),
        )
        .order_by(Verdict.id.desc())
        .limit(NEWEST)
    )
    return session.execute(query).all()


def review_waits(session: Session, project_id: UUID, designer_id: UUID | None) -> Sequence[datetime]:
    """Return the starts of the waits for a verdict."""
    waiting = (
        select(Take.state_since)
        .join(Cue, Cue.id == Take.cue_id)
        .where(Take.project_id == project_id, Take.state == TakeState.CONFORMING, Cue.state != CueState.CUT)
    )
    if designer_id is not None:
        waiting = waiting.where(Take.designer_id == designer_id)
    return session.scalars(waiting).all()


def answer_times(
    session: Session, project_id: UUID, designer_id: UUID | None
) -> Sequence[Row[datetime, datetime | None]]:
    """Return the times of questions and of their answers; the newest."""
    query = select(Question.asked_at, Question.answered_at).where(Question.project_id == project_id)
    if designer_id is not None:
        query = query.where(Question.asked_by == designer_id)
    return session.execute(query.order_by(Question.id.desc()).limit(NEWEST)).all()


def _stands(designer_id: UUID | None) -> tuple[ColumnElement[bool], ...]:
    withdrawal = aliased(Verdict)
    stands = ~exists().where(withdrawal.withdraws_id == Verdict.id)
    return (stands,) if designer_id is None else (stands, Take.designer_id == designer_id)
