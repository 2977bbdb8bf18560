"""The progress of the work under a contract."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.rules import WorkState
from app.money import verdicts


def work_states(session: Session, contract: Contract) -> dict[UUID, WorkState]:
    """Return the progress of its designer's work on each cue of a contract that is not settled."""
    covered = plan_queries.cues_of(session, contract.id)
    return verdicts.work_states(
        session,
        contract,
        [contract_cue for contract_cue in covered if contract_cue.accepted_at is None and contract_cue.cut_at is None],
    )
