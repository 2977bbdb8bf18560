"""The jobs of this room: requested changes, what a silent studio means, accepted cues, and adopted sounds."""

from uuid import UUID

from app.agreements.plan.queries import cues_of
from app.core import clock
from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.reviews.adoptions.queries import adopted_take_ids
from app.reviews.rounds import change_requests
from app.reviews.verdicts import deemed_acceptance
from app.reviews.verdicts.settlement import add_accepted_cue

TAKES_AT_ONCE = 250  # so that others write between


@job("reviews.send_change_request")
def send_change_request(runtime: Runtime, payload: Payload) -> None:
    """Send a change request that was not undone."""
    with runtime.database.writing() as session:
        change_requests.send_due_change(session, UUID(payload["change_request_id"]))


@job("reviews.apply_deemed_acceptance")
def apply_deemed_acceptance(runtime: Runtime, _payload: Payload) -> None:
    """Remind approvers of cues that a clause on silence will accept, and accept those whose days are over."""
    now = clock.now()
    with runtime.database.reading() as session:
        cue_ids = deemed_acceptance.deemed_cues_due(session, now)
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            deemed_acceptance.apply_deemed(session, cue_id, now)


@job("reviews.add_accepted_cues")
def add_accepted_cues(runtime: Runtime, payload: Payload) -> None:
    """Take the cues that were accepted before into the contract that is agreed now."""
    contract_id = UUID(payload["contract_id"])
    with runtime.database.reading() as session:
        cue_ids = [cue.cue_id for cue in cues_of(session, contract_id) if cue.accepted_at is None]
    for cue_id in cue_ids:
        with runtime.database.writing() as session:
            add_accepted_cue(session, contract_id, cue_id)


@job("reviews.check_adopted_takes")
def check_adopted_takes(runtime: Runtime, payload: Payload) -> None:
    """Schedule check and game files of each adopted sound, behind what people wait for."""
    with runtime.database.reading() as session:
        take_ids = adopted_take_ids(session, UUID(payload["adoption_id"]))
    for start in range(0, len(take_ids), TAKES_AT_ONCE):
        with runtime.database.writing() as session:
            for take_id in take_ids[start : start + TAKES_AT_ONCE]:
                runtime.queue.enqueue(
                    session,
                    "renders.prepare_take",
                    {"take_id": str(take_id)},
                    key=f"{payload['event_id']}:renders.prepare_take:{take_id}",
                    studio_id=UUID(payload["studio_id"]),
                    priority=BULK,
                )
