"""Errors of uploads, each named after the fact."""

from app.core.errors import Conflict, Invalid, NotFound, Refused


class UploadNotFound(NotFound):
    """No upload of that id within the caller's sight."""


class UploadUnfinished(Conflict):
    """Not all bytes of the upload are here yet."""


class OffsetMismatch(Conflict):
    """The bytes sent do not continue at the upload's offset."""


class UploadBusy(Refused):
    """Another request is writing to this upload."""

    status = 423


class UploadTooLong(Refused):
    """More bytes than were announced, or than one file may have."""

    status = 413


class UploadIncomplete(Refused):
    """Fewer bytes came than were announced."""

    status = 400


class UploadStalled(Refused):
    """The sender sends too slowly, or nothing."""

    status = 408


class ChecksumMismatch(Refused):
    """The bytes that came are not the bytes that were sent."""

    status = 460


class StoreFull(Refused):
    """The disk has no room for this file."""

    status = 507


class PartsNotTaken(Conflict):
    """The bytes of this upload come through the server."""


class SentInParts(Conflict):
    """The bytes of this upload come to the store in parts."""


class PartUnknown(Invalid):
    """The file has no part of that number."""
