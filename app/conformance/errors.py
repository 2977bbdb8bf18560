"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, NotFound


class CheckNotFound(NotFound):
    """The take has not been checked yet."""


class NothingToWaive(Conflict):
    """The take was not returned, or its file cannot be read, so there is nothing to let through."""


class NothingToFix(Conflict):
    """Nothing was found in the take that a fix can put right, or the take is decided upon."""


class FixNotReady(Conflict):
    """The fixed copy is still being made, or could not be made."""
