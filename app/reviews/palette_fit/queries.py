"""Features for comparing takes, read from the database; callers have checked access."""

from dataclasses import dataclass
from uuid import UUID

from sqlalchemy import ColumnElement, and_, exists, select
from sqlalchemy.orm import Session, joinedload

from app.conformance.models import CheckRun
from app.deliveries.models import Delivery, Take
from app.deliveries.rules import TakeState
from app.renders.models import Timbre
from app.reviews.palette_fit.rules import Likeness
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState

DECIDABLE = (TakeState.CONFORMING, TakeState.APPROVED, TakeState.SET_ASIDE, TakeState.CHANGE_REQUESTED)


@dataclass(frozen=True)
class Compared:
    """A matched take, and what of it is compared; `is_analysed` is false until its timbre has been measured."""

    take: Take
    cue: Cue
    likeness: Likeness
    is_analysed: bool


def approved_sounds(session: Session, project_id: UUID) -> list[Compared]:
    """Return the approved takes of a project's cues that are not cut, in list order."""
    return _compared(
        session, Take.project_id == project_id, Take.state == TakeState.APPROVED, Cue.state != CueState.CUT
    )


def take_compared(session: Session, take_id: UUID) -> Compared | None:
    """Return a matched take that has been checked."""
    rows = _compared(session, Take.id == take_id)
    return rows[0] if rows else None


def takes_compared(session: Session, delivery_id: UUID) -> list[Compared]:
    """Return the matched takes of a delivery that did not come back, in list order."""
    return _compared(session, Take.delivery_id == delivery_id, Take.state.in_(DECIDABLE))


def _compared(session: Session, *conditions: ColumnElement[bool]) -> list[Compared]:
    report = CheckRun.report
    integrated = report[("measurements", "integrated_lufs")].as_float()
    shortest = report[("measurements", "short_loudness_lufs")].as_float()
    score = report[("judgements", "reverb", "score")].as_float()
    rows = session.execute(
        select(Take, Cue, Timbre, integrated, shortest, score)
        .join(Cue, Cue.id == Take.cue_id)
        .join(CheckRun, and_(CheckRun.take_id == Take.id, CheckRun.is_current))
        .outerjoin(Timbre, and_(Timbre.studio_id == Take.studio_id, Timbre.sound_sha256 == Take.master_sha256))
        .where(*conditions)
        .options(joinedload(Take.designer), joinedload(Take.delivery))
        .order_by(Cue.position, Cue.number, Take.variation, Take.number)
    )
    return [
        Compared(
            take,
            cue,
            Likeness(
                loudness_lufs=shortest if whole is None else whole,
                reverb_score=reverb,
                bands_db=(timbre.bands_db or None) if timbre else None,
                timbre=(timbre.timbre or None) if timbre else None,
            ),
            is_analysed=timbre is not None,
        )
        for take, cue, timbre, whole, shortest, reverb in rows
    ]


def is_first_delivery(session: Session, delivery: Delivery) -> bool:
    """Whether a designer delivered nothing to this project before."""
    earlier = exists().where(
        Delivery.project_id == delivery.project_id,
        Delivery.designer_id == delivery.designer_id,
        Delivery.number < delivery.number,
    )
    return not session.scalar(select(earlier))
