"""The jobs of this room: requested changes, and adopted sounds."""

from uuid import UUID

from app.core.jobs.queue import BULK, Payload, job
from app.core.runtime import Runtime
from app.reviews.adoptions.queries import adopted_take_ids
from app.reviews.rounds import change_requests

TAKES_AT_ONCE = 250  # so that others write between


@job("reviews.send_change_request")
def send_change_request(runtime: Runtime, payload: Payload) -> None:
    """Send a change request that was not undone."""
    with runtime.database.writing() as session:
        change_requests.send_due_change(session, UUID(payload["change_request_id"]))


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
