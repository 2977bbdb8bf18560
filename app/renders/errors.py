"""What this room refuses, each named after the fact."""

from app.kit.errors import Conflict, NotFound


class SoundNotFound(NotFound):
    """No sound of that id within the caller's sight."""


class RenderNotFound(NotFound):
    """No render of that id within the caller's sight."""


class NothingRendered(Conflict):
    """The target's render was refused, so there is no file."""


class NotDrawn(Conflict):
    """The sound could not be drawn or previewed."""
