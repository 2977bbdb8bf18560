"""The basis of a project's computed costs; each function is one SELECT of narrow rows."""

from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Any
from uuid import UUID

from sqlalchemy import Row, func, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractCue
from app.core.in_array import in_array
from app.deliveries.models import Take
from app.money.models import WorkLog
from app.sound_lists.models import Cue, CueChange, Revision


def ordered(session: Session, contract_ids: Collection[UUID]) -> Sequence[Row[ContractCue, str, Any]]:
    """Return the cues of contracts, each with the contract's currency and the cue's state."""
    return session.execute(
        select(ContractCue, Contract.currency, Cue.state)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .join(Cue, Cue.id == ContractCue.cue_id)
        .where(in_array(ContractCue.contract_id, contract_ids))
        .order_by(ContractCue.id)
    ).all()


def first_takes(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, datetime]:
    """Return the arrival of each cue's first version; cues without any are left out."""
    rows = select(Take.cue_id, func.min(Take.received_at)).where(in_array(Take.cue_id, cue_ids)).group_by(Take.cue_id)
    return {cue_id: at for cue_id, at in session.execute(rows) if cue_id is not None}


def first_logs(session: Session, cue_ids: Collection[UUID]) -> dict[UUID, datetime]:
    """Return the moment of the first logged time of each cue; cues without any are left out."""
    rows = select(WorkLog.cue_id, func.min(WorkLog.created_at)).where(in_array(WorkLog.cue_id, cue_ids))
    return {row[0]: row[1] for row in session.execute(rows.group_by(WorkLog.cue_id))}


def changes(
    session: Session, cue_ids: Collection[UUID]
) -> Sequence[Row[UUID, datetime, dict[str, Any], dict[str, Any]]]:
    """Return cue, time, and facts before and after of what revisions of the list changed in cues."""
    return session.execute(
        select(CueChange.cue_id, Revision.created_at, CueChange.before, CueChange.after)
        .join(Revision, Revision.id == CueChange.revision_id)
        .where(in_array(CueChange.cue_id, cue_ids))
        .order_by(Revision.number)
    ).all()
