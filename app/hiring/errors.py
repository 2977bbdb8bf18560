"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound


class PostingNotFound(NotFound):
    """No posting of that id, or behind that link, within the caller's sight."""


class BidNotFound(NotFound):
    """No bid of that id within the caller's sight."""


class BidNoteNotFound(NotFound):
    """No note of the caller's own on a bid of that id."""


class CandidateNotFound(NotFound):
    """The posting has no invited person of that id."""


class PostingQuestionNotFound(NotFound):
    """No question of that id within the caller's sight."""


class WrongPostingState(Conflict):
    """The posting is not in a state in which this can be done."""


class PostingClosed(Conflict):
    """The posting takes no bids: it is closed, awarded, or its last day is over."""


class PostingChanged(Conflict):
    """Another person changed the posting since it was read."""


class BidChanged(Conflict):
    """The bid was changed in another window since it was read."""


class BidNotSent(Conflict):
    """The bid was not sent, or was withdrawn."""


class LinkTaken(Conflict):
    """The personal link of a posting was used by another account."""


class PostingQuestionAnswered(Conflict):
    """The question has its answer."""


class PersonalLinkNeeded(Conflict):
    """The link is for everyone: an account is made only by a link mailed to its address."""


class OwnPosting(Conflict):
    """The caller is a member of the studio that posted it."""


class PostingInvalid(Invalid):
    """The posting does not hold together; `errors` names each field."""


class BidInvalid(Invalid):
    """The bid does not hold together; `errors` names each field."""


class ScoresInvalid(Invalid):
    """A score is not of one of the posting's headings."""


class RosterEntryNotFound(NotFound):
    """The roster of the caller's studios has nobody of that id."""


class ReelSoundNotFound(NotFound):
    """The reel has no sound of that id."""


class AlreadyOnRoster(Conflict):
    """The studio has that address on file already."""


class RosterEntryChanged(Conflict):
    """Another person changed the entry since it was read."""


class RosterFull(Conflict):
    """The roster has as many people as a studio may keep."""


class RosterInvalid(Invalid):
    """The entry does not hold together; `errors` names each field."""


class CalendarUnreadable(Invalid):
    """The file is not a readable calendar, or it is too large."""


class ReelFull(Conflict):
    """The reel has as many sounds as it may have."""


class SampleNotFound(NotFound):
    """The bid has no sample of that id that the caller may hear."""


class SamplesFull(Conflict):
    """The bid has as many samples as it may have."""


class SampleInvalid(Invalid):
    """The sample is not for a line of the posting, or cannot be read."""


class NoSound(Invalid):
    """The file is not a sound that browsers play."""
