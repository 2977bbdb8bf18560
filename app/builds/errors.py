"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound, Refused


class BuildNotFound(NotFound):
    """No build of that id within the caller's sight."""


class NothingAccepted(Conflict):
    """No cue is accepted yet, so there is nothing to pack."""


class ContractNotEnded(Conflict):
    """A handover pack is made once the contract has ended."""


class PackIncomplete(Conflict):
    """An accepted sound has no game file for the target."""


class BlobDamaged(Refused):
    """The store lost or altered a file; nothing is handed out in its place."""

    status = 500


class ReportInvalid(Invalid):
    """The body is not a report of audio-checks."""


class PackNotFound(NotFound):
    """No pack of that id within the caller's sight."""


class PackNotSealed(Conflict):
    """The pack is being put together, or could not be."""


class PlaceholderAccepted(Conflict):
    """An accepted sound is a placeholder file, and the pack was requested without placeholder files."""


class GameFileNotApproved(Conflict):
    """The game file belongs to a version that is not approved."""


class ManifestNotReady(Conflict):
    """Some of the approved sounds have not been listened to yet."""

    retry_after_s = 5


class AuditNotFound(NotFound):
    """No audit of that id within the caller's sight."""


class AuditedSoundNotFound(NotFound):
    """The audit has no sound of that path."""


class NothingDrifted(Conflict):
    """The sound plays as approved in this build, so there is nothing to accept or to send back."""


class AcceptedDriftNotFound(NotFound):
    """No accepted drift of that id within the caller's sight."""


class BadLibrarySheet(Invalid):
    """A file is not a sheet of fingerprints."""


class LibraryFull(Conflict):
    """The studio keeps as many sounds of libraries as it may."""


class LibraryNotFound(NotFound):
    """No sound library of that id within the caller's sight."""


class NothingToHear(Conflict):
    """No build was audited yet, so there is no list of sounds to hear."""


class ListeningPassNotFound(NotFound):
    """No listening pass of that id within the caller's sight."""


class ListeningPassClosed(Conflict):
    """The listening pass is closed and takes no new notes."""


class ListeningNoteNotFound(NotFound):
    """No note of that id within the caller's sight."""


class ListeningNoteInvalid(Invalid):
    """The note contradicts itself."""


class ListeningNoteTaken(Conflict):
    """Another note has this id."""


class GameTaskNotFound(NotFound):
    """No task of that id within the caller's sight."""


class ImplementerNeeded(Forbidden):
    """Only an implementer or a person who acts for the team can do this."""
