"""Errors of this room, each named after the fact."""

from app.kit.errors import Conflict, Invalid, NotFound, Refused


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
    """The body is no report of audio-checks."""


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
