"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class WebhookNotFound(NotFound):
    """No webhook of that id in a studio that the caller runs."""


class WebhookCallNotFound(NotFound):
    """No call of that id by a webhook of a studio that the caller runs."""


class WebhookAddressRefused(Invalid):
    """The address is none that this server sends to."""


class WebhooksFull(Conflict):
    """The studio has as many webhooks as it may have."""


class WebhookDisabled(Conflict):
    """A disabled webhook sends nothing."""
