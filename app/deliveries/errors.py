"""Errors of this room, each named after the fact."""

from app.core.errors import Conflict, Forbidden, Invalid, NotFound, Refused


class DeliveryNotFound(NotFound):
    """No delivery of that id within the caller's sight."""


class DeliveryClosed(Conflict):
    """The designer has closed the delivery; what is already on its way still comes in."""


class TakeNotFound(NotFound):
    """No take of that id within the caller's sight."""


class DryStemNotFound(NotFound):
    """The take has no dry stem."""


class SourceFileNotFound(NotFound):
    """No source file of that id within the caller's sight."""


class SourceBankHandedOver(Conflict):
    """The source bank of an approved take is the studio's, so nothing is taken out of it."""


class HandoffNotFound(NotFound):
    """No hand-off of that id within the caller's sight."""


class NothingToHandOff(Conflict):
    """The maker has delivered nothing for the cue."""


class NextMakerUnknown(Invalid):
    """The person is no other designer of the project."""


class OwnDesignerNeeded(Forbidden):
    """Only the sound's own designer does this: takes a fix, gives a dry stem, keeps a source bank."""


class WrongState(Conflict):
    """The take is not in a state from which this can be done."""


class TrayActionNotFound(NotFound):
    """No action on takes of that id within the caller's sight."""


class AlreadyUndone(Conflict):
    """The action was undone before."""


class VariationUnknown(Invalid):
    """The cue has no variation of that number."""


class InHouseDesignerNeeded(Forbidden):
    """A build delivers in the name of the project's one in-house designer, and there is not exactly one."""


class NoSourceNamed(Invalid):
    """A statement of sources names none."""


class SourcesFixed(Conflict):
    """The take is approved, so its sources can no longer be changed."""


class SourcesMissing(Conflict):
    """The contract asks for the sources of a sound first, and they are not all stated."""


class UnknownTusVersion(Refused):
    """The client uses another version of tus."""

    status = 412


class BadUploadHeader(Refused):
    """A header of an upload is missing or cannot be read."""

    status = 400


class LengthRequired(Refused):
    """The request has no Content-Length."""

    status = 411


class WrongContentType(Refused):
    """The bytes of an upload come as application/offset+octet-stream."""

    status = 415


class MasterDeleted(Refused):
    """The master was deleted when the contract's years of keeping it were over."""

    status = 410


class ArchiveRefused(Exception):
    """A ZIP that cannot or should not be unpacked; the message says why."""


class AdoptionNotFound(NotFound):
    """No adoption of that id within the caller's sight."""


class AdoptionClosed(Conflict):
    """The folder is adopted or undone already."""


class GameProjectUnreadable(Invalid):
    """Sent data that are no project of a known engine or middleware, or are too large."""


class PathTwice(Invalid):
    """Two files of a folder have one path."""


class DownloadUnpaid(Forbidden):
    """The contract opens this sound's masters and game files by payment, and it is not paid yet."""
