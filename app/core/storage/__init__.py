"""Blobs by content: in a folder or in a bucket, behind one interface."""

from app.core.storage.bucket import BucketStore
from app.core.storage.direct import DirectUploads, Incoming, PartLink
from app.core.storage.folder import FolderStore, make_folder, sync
from app.core.storage.multipart import MultipartGone
from app.core.storage.signing import Key
from app.core.storage.store import (
    COPY_PREFIX,
    MAKING_PREFIX,
    PUT_PREFIX,
    READ_AGAIN_FIX,
    READ_BYTES,
    BlobAltered,
    BlobMissing,
    Store,
    StoredBlob,
    StoreUnavailable,
    StoreUnready,
    write_all,
)
from app.settings import Settings


def open_store(settings: Settings) -> Store:
    """Open the store that the settings name."""
    if settings.bucket is None:
        return FolderStore(settings.blob_dir)
    key = Key(
        settings.aws_access_key_id,
        settings.aws_secret_access_key.get_secret_value(),
        settings.aws_session_token.get_secret_value(),
    )
    return BucketStore(settings.bucket, key, settings.data_dir / "incoming", direct=settings.store_direct)


__all__ = [
    "COPY_PREFIX",
    "MAKING_PREFIX",
    "PUT_PREFIX",
    "READ_AGAIN_FIX",
    "READ_BYTES",
    "BlobAltered",
    "BlobMissing",
    "BucketStore",
    "DirectUploads",
    "FolderStore",
    "Incoming",
    "MultipartGone",
    "PartLink",
    "Store",
    "StoreUnavailable",
    "StoreUnready",
    "StoredBlob",
    "make_folder",
    "open_store",
    "sync",
    "write_all",
]
