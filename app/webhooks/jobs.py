"""The jobs of this room."""

from uuid import UUID

from app.core import clock
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.webhooks import queries, sending, service
from app.webhooks.messages import message_of


@job(service.WRITE_CALLS)
def write_calls(runtime: Runtime, payload: Payload) -> None:
    """Write the messages of an event for every webhook that is called for it."""
    with runtime.database.writing() as session:
        project_id, message = message_of(session, runtime.settings.base_url, payload)
        for webhook in queries.webhooks_called(session, UUID(payload["studio_id"]), project_id):
            if message.event in webhook.events:
                service.write_call(session, webhook, payload["event_id"], message, project_id=project_id)


@job(service.SEND_CALL)
def send_call(runtime: Runtime, payload: Payload) -> None:
    """Send one message to one address."""
    sending.send(runtime, UUID(payload["call_id"]), UUID(payload["attempt"]))


@job("webhooks.delete_old_calls")
def delete_old_calls(runtime: Runtime, _payload: Payload) -> None:
    """Delete calls sent long ago from the log."""
    with runtime.database.writing() as session:
        service.delete_old_calls(session, clock.now())
