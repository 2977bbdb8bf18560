"""Hours of agreed work; each function is one SELECT. Only for producers of the studio."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy import Row, exists, func, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.rules import ContractState
from app.sound_lists.models import Cue
from app.sound_lists.rules import CueState


def open_work(session: Session, project_id: UUID) -> Sequence[Row[UUID, UUID, UUID, str, int | None, date | None]]:
    """Return contract, designer, cue, category, estimate and day of the agreed cues that are not accepted or cut."""
    due_on = func.coalesce(Cue.due_on, Milestone.due_on)
    rows = (
        select(Contract.id, Contract.designer_id, Cue.id, Cue.category, ContractCue.estimate_min, due_on)
        .join(ContractCue, ContractCue.contract_id == Contract.id)
        .join(Milestone, Milestone.id == ContractCue.milestone_id)
        .join(Cue, Cue.id == ContractCue.cue_id)
        .where(
            Contract.project_id == project_id,
            Contract.state == ContractState.AGREED,
            ContractCue.accepted_at.is_(None),
            ContractCue.cut_at.is_(None),
            Cue.state != CueState.CUT,
        )
    )
    return session.execute(rows.order_by(Cue.position, Cue.number)).all()


def uncontracted_cues(session: Session, project_id: UUID) -> int:
    """Return the number of cues of a list that no agreed contract covers; cut ones are not counted."""
    covered = (
        exists()
        .where(ContractCue.cue_id == Cue.id, Contract.id == ContractCue.contract_id)
        .where(Contract.state == ContractState.AGREED)
    )
    of_list = (Cue.project_id == project_id, Cue.state != CueState.CUT)
    return session.scalar(select(func.count()).select_from(Cue).where(*of_list, ~covered)) or 0
