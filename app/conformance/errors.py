"""What this room refuses, each named after the fact."""

from app.kit.errors import Conflict, NotFound


class CheckNotFound(NotFound):
    """The take has not been checked yet."""


class NothingToWaive(Conflict):
    """The take was not returned, or its file cannot be read, so there is nothing to let through."""
