"""How far the work under a contract is."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements import plan_queries
from app.agreements.models import Contract
from app.agreements.rules import WorkState
from app.amendments import queries
from app.reviews.rules import work_state


def work_states(session: Session, contract: Contract) -> dict[UUID, WorkState]:
    """Return how far its designer's work is on each cue of a contract that is not settled."""
    covered = [
        one for one in plan_queries.cues_of(session, contract.id) if one.accepted_at is None and one.cut_at is None
    ]
    states = queries.variation_states(session, [one.cue_id for one in covered], contract.designer_id)
    found = {one.cue_id: work_state(one.cue.variations, states[one.cue_id]) for one in covered}
    for cue_id, state in found.items():
        if state is WorkState.ACCEPTED and plan_queries.is_accepted_elsewhere(session, contract.id, cue_id):
            found[cue_id] = WorkState.NOT_BEGUN  # it was paid for there
    return found
