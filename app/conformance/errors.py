"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class CheckNotFound(NotFound):
    """The take has not been checked yet."""


class NothingToWaive(Conflict):
    """The take was not returned, or its file cannot be read, so there is nothing to let through."""


class NothingToFix(Conflict):
    """Nothing was found in the take that a fix can put right, or the take is decided upon."""


class FixNotReady(Conflict):
    """The fixed copy is still being made, or could not be made."""


class NothingToSplit(Conflict):
    """The take is decided upon or discarded, so that no part of it becomes a version."""


class SplitNotReady(Conflict):
    """The parts of the file are not found yet, or there are none."""


class PartsMisplaced(Invalid):
    """A part that the file does not have, or two for one variation."""
