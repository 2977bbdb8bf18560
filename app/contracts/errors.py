"""What this room refuses, each named after the fact."""

from app.kit.errors import NotFound


class ContractNotFound(NotFound):
    """No contract of that id within the caller's sight."""
