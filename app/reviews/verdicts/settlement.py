"""Applies decisions on a cue to its contract, in the same transaction."""

from collections.abc import Sequence
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractCue
from app.agreements.plan import queries as plan_queries
from app.agreements.rules import AcceptedBy, WorkState
from app.core.recorded_rows import RowChanges
from app.deliveries.models import Take
from app.money import settlement
from app.reviews import queries
from app.reviews.rules import missing_variations, work_state
from app.sound_lists.models import Cue


def settle_acceptance(
    session: Session, cue: Cue, *, person_id: UUID | None, by: AcceptedBy = AcceptedBy.VERDICT
) -> bool:
    """Return whether a cue is accepted now, and make its share due, or take it back, accordingly."""
    approved = queries.approved_takes(session, cue.id)
    accepted = not missing_variations(cue.variations, [take.variation for take in approved])
    if accepted:
        designers = {take.designer_id for take in approved}
        rows = _rows_of(session, approved)
        settlement.accept_cue(session, cue.id, designer_ids=designers, person_id=person_id, rows=rows, by=by)
    else:
        settlement.reopen_cue(session, cue.id, person_id=person_id)
    return accepted


def _rows_of(session: Session, approved: Sequence[Take]) -> RowChanges:
    """Return the takes that a cue is accepted by, and their verdicts, for the record."""
    return RowChanges().add(*approved, *queries.effective_verdicts(session, [take.id for take in approved]))


def add_accepted_cue(session: Session, contract_id: UUID, cue_id: UUID) -> None:
    """Settle a cue that was accepted before its contract was agreed, in the name of who approved it, if anyone did."""
    queries.lock_cue(session, cue_id)
    cue, contract = session.get_one(Cue, cue_id), session.get_one(Contract, contract_id)
    approved = queries.approved_takes(session, cue_id)
    if missing_variations(cue.variations, [take.variation for take in approved]):
        return
    if contract.designer_id in {take.designer_id for take in approved}:
        verdicts = queries.effective_verdicts(session, [take.id for take in approved])
        if any(verdict.adoption_id is not None for verdict in verdicts):
            return  # it was in the game before anyone was asked to make it
        person_id = verdicts[-1].given_by if verdicts else contract.created_by
        rows = RowChanges().add(*approved, *verdicts)
        settlement.add_accepted_cue(session, contract_id, cue_id, person_id=person_id, rows=rows)


def work_states(session: Session, contract: Contract, covered: Sequence[ContractCue]) -> dict[UUID, WorkState]:
    """Return the state of the work of a contract's own designer on cues that it covers, as kill fees go by it."""
    states = queries.variation_states(session, [contract_cue.cue_id for contract_cue in covered], contract.designer_id)
    states_by_cue = {
        contract_cue.cue_id: work_state(contract_cue.cue.variations, states[contract_cue.cue_id])
        for contract_cue in covered
    }
    for cue_id, state in states_by_cue.items():
        if state is WorkState.ACCEPTED and plan_queries.is_accepted_elsewhere(session, contract.id, cue_id):
            states_by_cue[cue_id] = WorkState.NOT_BEGUN  # it was paid for there
    return states_by_cue


def settle_cut(session: Session, cue: Cue, *, person_id: UUID) -> None:
    """Settle a cut cue under the contract that covers it, by how far its designer's work is."""
    covered = plan_queries.running_cue(session, cue.id, None)
    if covered is not None:
        states = work_states(session, session.get_one(Contract, covered.contract_id), [covered])
        settlement.settle_cut(session, cue.id, state=states[cue.id], person_id=person_id)
