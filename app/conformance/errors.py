"""What this room refuses, each named after the fact."""

from app.kit.errors import Conflict, NotFound


class CheckNotFound(NotFound):
    """The take has not been checked yet."""


class NothingToWaive(Conflict):
    """The take was not returned, or its file cannot be read, so there is nothing to let through."""


class NothingToMend(Conflict):
    """Nothing was found in the take that a mend can put right, or the take is decided upon."""


class MendNotMade(Conflict):
    """The mended copy is still being made, or could not be made."""
