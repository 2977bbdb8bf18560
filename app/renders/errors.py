"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class SoundNotFound(NotFound):
    """No sound of that id within the caller's sight."""


class RenderNotFound(NotFound):
    """No render of that id within the caller's sight."""


class NothingRendered(Conflict):
    """The target's render was refused, so there is no file."""


class NotDrawn(Conflict):
    """The sound could not be drawn or previewed."""


class BatchNotFound(NotFound):
    """No batch of that id within the caller's sight."""


class BatchEnded(Conflict):
    """The batch is over, so it cannot be cancelled."""


class NothingToRender(Conflict):
    """No take may ship yet, or the spec has no target."""


class TargetUnknown(Invalid):
    """The project's spec has no target of that name."""


class LossUnknown(Conflict):
    """The game file was refused, or made before losses were measured."""


class ReelNotFound(NotFound):
    """No reel of that id within the caller's sight."""


class NothingToPlay(Conflict):
    """The cue has no take that the caller sees and that can be played."""


class TakesBeingDrawn(Conflict):
    """A take of the cue has no preview yet."""


class ReelTooLong(Conflict):
    """The takes of the cue are too many or too long for one reel."""


class MasterExportNotFound(NotFound):
    """No handed-out master of that id within the caller's sight."""


class MasterExportNotMade(Conflict):
    """The copy has no file: it is still being made, or could not be."""


class ReelNotMade(Conflict):
    """The reel has no file: it is still being made, or could not be."""
