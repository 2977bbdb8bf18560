"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class CueNotFound(NotFound):
    """No cue of that id within the caller's sight."""


class QuestionNotFound(NotFound):
    """No question of that id within the caller's sight."""


class KitNotFound(NotFound):
    """No kit of that key."""


class RevisionNotFound(NotFound):
    """The list has no revision of that number."""


class CueChanged(Conflict):
    """Another person changed the cue since it was read."""


class CueIsCut(Conflict):
    """A cut cue is kept as it was."""


class AdditionInUse(Conflict):
    """The list, or a cue that was added, has changed since the addition."""


class QuestionOwnerUnknown(Invalid):
    """The named owner of a question is no member of the studio."""


class QuestionAnswered(Conflict):
    """The question has its answer."""


class RowsInvalid(Invalid):
    """Rows of the list are wrong; nothing was changed."""


class SheetUnreadable(Invalid):
    """The file is not a readable sheet, or it is too large."""


class RecordingInvalid(Invalid):
    """The recording is not a WAV file, is too long, or nothing is heard in it."""


class SpokenPlaceholderMissing(NotFound):
    """No person said a placeholder for this cue."""


class ColumnUnknown(Invalid):
    """The mapping names a column that the sheet does not have, or one field twice."""


class ColumnsChanged(Conflict):
    """Another person changed the columns since they were read."""


class ColumnsInvalid(Invalid):
    """A column cannot be as it was sent; nothing was changed."""


class MatrixInvalid(Invalid):
    """The line makes no cues, or too many."""


class OrderInvalid(Invalid):
    """The new order names a cue twice or one of another list."""


class NamesNotResolved(Invalid):
    """A refused name cannot be resolved as asked; nothing was changed."""
