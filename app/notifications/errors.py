"""What this room refuses, each named after the fact."""

from app.kit.errors import NotFound


class MailNotFound(NotFound):
    """No mail of that id within the caller's sight."""
