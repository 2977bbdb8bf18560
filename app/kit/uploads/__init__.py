"""Files on their way in, through this process or straight to the store; what is finished is in the store."""

from app.kit.uploads.checksum import CHECKSUMS, Checksum
from app.kit.uploads.errors import (
    ChecksumMismatch,
    OffsetMismatch,
    PartsNotTaken,
    PartUnknown,
    SentInParts,
    StoreFull,
    UploadBusy,
    UploadIncomplete,
    UploadNotFound,
    UploadStalled,
    UploadTooLong,
    UploadUnfinished,
)
from app.kit.uploads.model import FinishedUpload, Upload, finished_upload
from app.kit.uploads.pace import Pace
from app.kit.uploads.parts import PartsProgress
from app.kit.uploads.staged import Uploads

__all__ = [
    "CHECKSUMS",
    "Checksum",
    "ChecksumMismatch",
    "FinishedUpload",
    "OffsetMismatch",
    "Pace",
    "PartUnknown",
    "PartsNotTaken",
    "PartsProgress",
    "SentInParts",
    "StoreFull",
    "Upload",
    "UploadBusy",
    "UploadIncomplete",
    "UploadNotFound",
    "UploadStalled",
    "UploadTooLong",
    "UploadUnfinished",
    "Uploads",
    "finished_upload",
]
