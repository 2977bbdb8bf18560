"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class BedNotFound(NotFound):
    """No bed of that id within the caller's sight."""


class BedInvalid(Invalid):
    """A bed does not name one sound that can be played; `errors` names each field."""


class SceneSoundNotFound(NotFound):
    """No sound of a scene of that id within the caller's sight."""


class SceneSoundNotMade(NotFound):
    """The part of a reference is not prepared yet, or cannot be played."""


class LaneUnknown(Invalid):
    """A lane that the scene does not have, or a level out of range; `errors` names it."""


class NothingToCompare(Conflict):
    """One of the two sounds has no preview yet, or both are the same file."""


class ComparisonNotFound(NotFound):
    """No comparison of that id within the caller's sight."""


class ComparisonNotMade(NotFound):
    """The difference track is not made yet, or cannot be made."""
