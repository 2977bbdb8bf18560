"""A webhook with one call, as part of one of everything."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.core import clock
from app.webhooks.models import Webhook, WebhookAttempt, WebhookCall
from app.webhooks.rules import CallState, WebhookEvent, WebhookForm


def add_webhook(session: Session, *, studio_id: UUID, created_by: UUID) -> dict[str, UUID]:
    """Add an address that took a message; return its ids by the names in paths."""
    webhook = Webhook(
        studio_id=studio_id,
        url="https://hooks.example.com/in",
        form=WebhookForm.JSON,
        events=[WebhookEvent.PACK_MADE],
        created_by=created_by,
    )
    session.add(webhook)
    session.flush()
    call = WebhookCall(
        studio_id=studio_id,
        webhook_id=webhook.id,
        event_id="1",
        event=WebhookEvent.PACK_MADE,
        body="{}",
        state=CallState.DELIVERED,
        tries=1,
        tried_at=clock.now(),
        status=200,
        answer="taken",
    )
    session.add(call)
    session.flush()
    attempt = {"tried_at": clock.now(), "took_ms": 12, "status": 200, "answer": "taken", "problem": ""}
    session.add(WebhookAttempt(studio_id=studio_id, call_id=call.id, **attempt))
    session.flush()
    return {"webhook_id": webhook.id, "webhook_call_id": call.id}
