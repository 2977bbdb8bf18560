"""Events that webhooks are called for, their signatures and pauses: without a database.

The signature is that of Standard Webhooks (version 1): headers webhook-id, webhook-timestamp and webhook-signature.
"""

import base64
import hashlib
import hmac
from collections.abc import Collection
from datetime import datetime, timedelta
from enum import StrEnum


class WebhookEvent(StrEnum):
    """A possible reason for a webhook's call."""

    TAKE_IN_REVIEW = "take.in_review"
    TAKE_RETURNED = "take.returned"
    TAKE_APPROVED = "take.approved"
    CHANGES_REQUESTED = "changes.requested"
    QUESTION_ASKED = "question.asked"
    LIST_REVISED = "list.revised"
    CUE_CUT = "cue.cut"
    PACK_MADE = "pack.made"
    BUILD_POSTED = "build.posted"
    AUDIT_POSTED = "audit.posted"
    CONTRACT_AGREED = "contract.agreed"
    INVOICE_ISSUED = "invoice.issued"
    PAYMENT_RECORDED = "payment.recorded"
    TEST = "webhook.test"  # sent by a button


class WebhookForm(StrEnum):
    """The form of a message: our own JSON, or a form that a chat takes."""

    JSON = "json"
    SLACK = "slack"
    DISCORD = "discord"
    TEAMS = "teams"


class CallState(StrEnum):
    """The state of a call."""

    WAITING = "waiting"
    DELIVERED = "delivered"
    FAILED = "failed"


# The event of a room, and what it is called to the outside.
EVENTS = {
    "take.in_review": WebhookEvent.TAKE_IN_REVIEW,
    "take.returned": WebhookEvent.TAKE_RETURNED,
    "take.approved": WebhookEvent.TAKE_APPROVED,
    "changes.sent": WebhookEvent.CHANGES_REQUESTED,
    "question.asked": WebhookEvent.QUESTION_ASKED,
    "list.revised": WebhookEvent.LIST_REVISED,
    "cue.cut": WebhookEvent.CUE_CUT,
    "pack.made": WebhookEvent.PACK_MADE,
    "build.posted": WebhookEvent.BUILD_POSTED,
    "audit.posted": WebhookEvent.AUDIT_POSTED,
    "contract.agreed": WebhookEvent.CONTRACT_AGREED,
    "invoice.issued": WebhookEvent.INVOICE_ISSUED,
    "payment.recorded": WebhookEvent.PAYMENT_RECORDED,
}
MAX_WEBHOOKS = 20  # of one studio
# Between the attempts at a call that fails, as Standard Webhooks recommends: three days in all.
PAUSES = tuple(timedelta(seconds=seconds) for seconds in (5, 300, 1_800, 7_200, 18_000, 36_000, 50_400, 72_000, 86_400))
DISABLED_AFTER = timedelta(days=5)  # of failures without a success between
OLD_SECRET_FOR = timedelta(days=1)
CALLS_KEPT_FOR = timedelta(days=30)
SECRET_PREFIX = "whsec_"  # noqa: S105  what a secret begins with


def secret_text(secret: bytes) -> str:
    """Return a secret as people copy it."""
    return SECRET_PREFIX + base64.b64encode(secret).decode()


def signature(secrets: Collection[bytes], call_id: str, at: datetime, body: bytes) -> str:
    """Return the header webhook-signature: one signature for each secret that is valid, the newest first."""
    content = f"{call_id}.{int(at.timestamp())}.".encode() + body
    macs = (hmac.digest(secret, content, hashlib.sha256) for secret in secrets)
    return " ".join(f"v1,{base64.b64encode(mac).decode()}" for mac in macs)


def is_old_secret_valid(rotated_at: datetime | None, now: datetime) -> bool:
    """Whether what was the secret before the last rotation still signs."""
    return rotated_at is not None and now < rotated_at + OLD_SECRET_FOR


def is_delivered(status: int) -> bool:
    """Whether an answer's status says that the message was taken; a redirect does not, for none is followed."""
    return 200 <= status < 300


def pause_after(tries: int) -> timedelta | None:
    """Return the pause after so many failed tries; None where that was the last."""
    return PAUSES[tries - 1] if tries <= len(PAUSES) else None
