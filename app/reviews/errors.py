"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class StaleView(Conflict):
    """The take is no longer in the state that the caller saw."""


class NotReviewable(Conflict):
    """The take cannot get a verdict in its state."""


class TooLateToUndo(Conflict):
    """The minute for taking a verdict back is over."""


class NothingToUndo(Conflict):
    """There is no verdict of the caller that can be undone."""


class VerdictSince(Conflict):
    """Something was decided after the verdict, so it cannot be taken back."""


class SetIncomplete(Conflict):
    """A variation has no version that could be accepted."""


class VersionsUndecided(Conflict):
    """A variation has several files of one delivery between which nobody chose; `take_ids` says which is meant."""


class AlreadyAccepted(Conflict):
    """Every variation has its approved take, and nothing newer waits."""


class NothingToSend(Conflict):
    """No draft can be sent now."""


class AlreadySent(Conflict):
    """The change request went to its designer; it can no longer be dropped."""


class ChangeRequestNotFound(NotFound):
    """No change request of that id within the caller's sight."""


class CommentNotFound(NotFound):
    """No comment of that id within the caller's sight."""


class NoteNeeded(Invalid):
    """A change request says what to change."""


class RangeInvalid(Invalid):
    """The time does not lie within the sound."""


class NotOfThisCue(Invalid):
    """A named take belongs to another cue, or two are named for one variation."""


class NoteNotFound(NotFound):
    """No such note was carried over to the version."""


class FilesMissing(Conflict):
    """Files of a folder are not uploaded yet, so it cannot be adopted."""


class NothingToAdopt(Conflict):
    """No file of a folder becomes a cue."""


class AdoptionInUse(Conflict):
    """Work was built on what an adoption made, so it cannot be undone as a whole."""


class NotMentionable(Invalid):
    """A person cannot be mentioned: they may not see the version, or the text does not name them."""


class AcknowledgementNotDue(Conflict):
    """A comment is acknowledged by those it mentions and by the designer of the version."""


class ApprovalBlocked(Conflict):
    """Something is open that the project wants closed before approval."""


class ChecklistInvalid(Invalid):
    """A checklist has an item twice."""


class TooManyChecklists(Conflict):
    """As many categories have a checklist as may have one."""


class ChecklistItemNotFound(NotFound):
    """No such item on the checklist of the version's category."""


class ReasonsInvalid(Invalid):
    """A list has a reason or label twice."""


class PaletteIncomplete(Conflict):
    """The palette has no cue, or one whose sound is not accepted."""
