"""The jobs of this room: what a silent studio means, and what was accepted before its contract."""

from uuid import UUID

from app.contracts.money_queries import cues_of
from app.kit import clock
from app.kit.queue import Payload, job
from app.kit.runtime import Runtime
from app.reviews import silent_acceptance
from app.reviews.owed import adopt_cue


@job("reviews.mind_silence")
def mind_silence(runtime: Runtime, _payload: Payload) -> None:
    """Remind deciders of cues that a clause on silence will accept, and accept those whose days are over."""
    now = clock.now()
    with runtime.database.reading() as session:
        cue_ids = silent_acceptance.not_minded_yet(session, now)
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            silent_acceptance.mind(session, cue_id, now)


@job("reviews.adopt_accepted")
def adopt_accepted(runtime: Runtime, payload: Payload) -> None:
    """Take the cues that were accepted before into the contract that is agreed now."""
    contract_id = UUID(payload["contract_id"])
    with runtime.database.reading() as session:
        cue_ids = [cue.cue_id for cue in cues_of(session, contract_id) if cue.accepted_at is None]
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            adopt_cue(session, contract_id, cue_id)
