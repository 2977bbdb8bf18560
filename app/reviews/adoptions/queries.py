"""The results of adoptions, read from the database; callers have checked access."""

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple
from uuid import UUID

from sqlalchemy import Row, func, select
from sqlalchemy.orm import Session, aliased

from app.conformance.models import CheckRun
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.renders.models import RenderSet
from app.reviews.models import Verdict
from app.sound_lists.models import Cue


def adopted_takes(session: Session, adoption_id: UUID) -> Sequence[Take]:
    """Return the takes that an adoption approved, in the order of their ids, locked."""
    query = select(Take).join(Verdict, Verdict.take_id == Take.id).where(Verdict.adoption_id == adoption_id)
    locked = query.order_by(Take.id).with_for_update(of=Take, key_share=True)
    return session.scalars(locked.execution_options(populate_existing=True)).all()


def adopted_take_ids(session: Session, adoption_id: UUID) -> Sequence[UUID]:
    """Return the ids of the takes that an adoption approved, in order."""
    return session.scalars(
        select(Verdict.take_id).where(Verdict.adoption_id == adoption_id).order_by(Verdict.take_id)
    ).all()


def verdicts_of(session: Session, adoption_id: UUID) -> Sequence[Verdict]:
    """Return the approvals that an adoption gave, in the order of their takes."""
    return session.scalars(select(Verdict).where(Verdict.adoption_id == adoption_id).order_by(Verdict.take_id)).all()


def later_verdicts(session: Session, adoption_id: UUID) -> int:
    """Return the number of verdicts on adopted takes besides the adoption."""
    adopted = select(Verdict.take_id).where(Verdict.adoption_id == adoption_id)
    others = (Verdict.take_id.in_(adopted), Verdict.adoption_id.is_distinct_from(adoption_id))
    return session.scalar(select(func.count()).where(*others)) or 0


def other_takes(session: Session, adoption_id: UUID, cue_ids: Collection[UUID]) -> int:
    """Return the number of takes that came for adopted cues besides the adopted ones."""
    adopted = select(Verdict.take_id).where(Verdict.adoption_id == adoption_id)
    others = (in_array(Take.cue_id, cue_ids), Take.id.not_in(adopted))
    return session.scalar(select(func.count()).where(*others)) or 0


class Counts(NamedTuple):
    """The number of takes that an adoption made, and their progress."""

    takes: int
    checked: int
    conforming: int
    rendered: int


def counts_of(session: Session, adoption_id: UUID) -> Counts:
    """Return the progress of the checks and game files of adopted takes."""
    query = (
        select(
            func.count(),
            func.count(CheckRun.id),
            func.count().filter(CheckRun.verdict == "conforming"),
            func.count(RenderSet.take_id),
        )
        .select_from(Verdict)
        .outerjoin(CheckRun, (CheckRun.take_id == Verdict.take_id) & CheckRun.is_current)
        .outerjoin(RenderSet, RenderSet.take_id == Verdict.take_id)
        .where(Verdict.adoption_id == adoption_id)
    )
    return Counts._make(session.execute(query).one())


def checks_to_show(session: Session, adoption_id: UUID, limit: int) -> Sequence[Row[*tuple[Any, ...]]]:
    """Return cue, take and check of adopted takes that have findings, those with errors first, in list order."""
    run = aliased(CheckRun)
    query = (
        select(Cue.id, Cue.number, Take.id, Take.file_name, run.verdict, run.report)
        .select_from(Verdict)
        .join(Take, Take.id == Verdict.take_id)
        .join(Cue, Cue.id == Verdict.cue_id)
        .join(run, (run.take_id == Take.id) & run.is_current)
        .where(Verdict.adoption_id == adoption_id, run.report["findings"][0]["code"].as_string().is_not(None))
        .order_by(run.verdict == "conforming", Cue.position, Cue.number, Take.variation)
    )
    return session.execute(query.limit(limit)).all()
