"""Tells the contract, in the verdict's own transaction, what a decision makes of a cue."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.contracts import settlement
from app.contracts.rules import WorkState
from app.reviews import queries
from app.reviews.rules import missing_variations, work_state
from app.sound_lists.models import Cue


def settle_acceptance(session: Session, cue: Cue, *, person_id: UUID) -> bool:
    """Return whether a cue is accepted now, and make its share due, or take it back, accordingly."""
    approved = queries.approved_takes(session, cue.id)
    accepted = not missing_variations(cue.variations, [take.variation for take in approved])
    if accepted:
        designers = {take.designer_id for take in approved}
        settlement.accept_cue(session, cue.id, designer_ids=designers, person_id=person_id)
    else:
        settlement.reopen_cue(session, cue.id, person_id=person_id)
    return accepted


def state_of_work(session: Session, cue: Cue) -> WorkState:
    """Return how far the work on a cue is, as its kill fee goes by it."""
    return work_state(cue.variations, queries.variation_states(session, cue.id))
