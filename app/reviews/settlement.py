"""Applies decisions on a cue to its contract, in the same transaction."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.agreements.rules import AcceptedBy, WorkState
from app.money import settlement
from app.reviews import queries
from app.reviews.rules import missing_variations, work_state
from app.sound_lists.models import Cue


def settle_acceptance(session: Session, cue: Cue, *, person_id: UUID, by: AcceptedBy = AcceptedBy.VERDICT) -> bool:
    """Return whether a cue is accepted now, and make its share due, or take it back, accordingly."""
    approved = queries.approved_takes(session, cue.id)
    accepted = not missing_variations(cue.variations, [take.variation for take in approved])
    if accepted:
        designers = {take.designer_id for take in approved}
        settlement.accept_cue(session, cue.id, designer_ids=designers, person_id=person_id, by=by)
    else:
        settlement.reopen_cue(session, cue.id, person_id=person_id)
    return accepted


def add_accepted_cue(session: Session, contract_id: UUID, cue_id: UUID) -> None:
    """Settle a cue that was accepted before its contract was agreed, in the name of its approver."""
    queries.lock_cue(session, cue_id)
    cue, contract = session.get_one(Cue, cue_id), session.get_one(Contract, contract_id)
    approved = queries.approved_takes(session, cue_id)
    if missing_variations(cue.variations, [take.variation for take in approved]):
        return
    if contract.designer_id in {take.designer_id for take in approved}:
        verdicts = queries.effective_verdicts(session, [take.id for take in approved])
        person_id = verdicts[-1].given_by if verdicts else contract.created_by
        settlement.add_accepted_cue(session, contract_id, cue_id, person_id=person_id)


def state_of_work(session: Session, cue: Cue) -> WorkState:
    """Return how far the work on a cue is, as its kill fee goes by it."""
    return work_state(cue.variations, queries.variation_states(session, cue.id))
