"""Errors of this room, each named after the fact."""

from app.kit.errors import Conflict, NotFound


class MailNotFound(NotFound):
    """No mail of that id within the caller's sight."""


class MailBusy(Conflict):
    """Another worker is handing this mail to the server."""
