"""Files on their way in, through this process or straight to the store; what is finished is in the store."""

from app.core.uploads.checksum import CHECKSUMS, Checksum
from app.core.uploads.errors import (
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
from app.core.uploads.minimum_rate import MinimumRate
from app.core.uploads.model import FinishedUpload, Upload, finished_upload
from app.core.uploads.parts import PartsProgress
from app.core.uploads.staged import Uploads

__all__ = [
    "CHECKSUMS",
    "Checksum",
    "ChecksumMismatch",
    "FinishedUpload",
    "MinimumRate",
    "OffsetMismatch",
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
