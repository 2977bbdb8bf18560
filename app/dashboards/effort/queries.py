"""Logged hours that an estimate is based on; only for producers of the studio."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy import Row, func, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractCue
from app.money.models import WorkLog
from app.sound_lists.models import Cue

NEWEST = 1_000  # accepted cues; older ones say little of today


def logged_cues(session: Session, studio_id: UUID) -> Sequence[Row[UUID, str, int, float | None, int]]:
    """Return designer, category, variations, length and minutes of a studio's accepted cues, the newest first."""
    minutes = (
        select(WorkLog.contract_id, WorkLog.cue_id, func.sum(WorkLog.minutes).label("minutes"))
        .where(WorkLog.studio_id == studio_id)
        .group_by(WorkLog.contract_id, WorkLog.cue_id)
        .subquery()
    )
    rows = (
        select(Contract.designer_id, Cue.category, Cue.variations, Cue.planned_length_s, minutes.c.minutes)
        .join(ContractCue, ContractCue.contract_id == Contract.id)
        .join(Cue, Cue.id == ContractCue.cue_id)
        .join(minutes, (minutes.c.contract_id == Contract.id) & (minutes.c.cue_id == Cue.id))
        .where(Contract.studio_id == studio_id, ContractCue.accepted_at.is_not(None))
        .order_by(ContractCue.accepted_at.desc())
        .limit(NEWEST)
    )
    return session.execute(rows).all()


def estimated_minutes(session: Session, contract_id: UUID) -> dict[UUID, int | None]:
    """Return the minutes that a contract's plan estimates, by cue; None for a cue without an estimate."""
    rows = session.execute(
        select(ContractCue.cue_id, ContractCue.estimate_min).where(ContractCue.contract_id == contract_id)
    )
    return dict(rows.all())
