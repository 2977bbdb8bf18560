"""Blobs by content: in a folder or in a bucket, behind one interface."""

from app.kit.storage.folder import FolderStore, make_folder, sync
from app.kit.storage.store import (
    COPY_PREFIX,
    PUT_PREFIX,
    READ_BYTES,
    BlobAltered,
    BlobMissing,
    Store,
    StoredBlob,
    StoreUnavailable,
    StoreUnready,
)

__all__ = [
    "COPY_PREFIX",
    "PUT_PREFIX",
    "READ_BYTES",
    "BlobAltered",
    "BlobMissing",
    "FolderStore",
    "Store",
    "StoreUnavailable",
    "StoreUnready",
    "StoredBlob",
    "make_folder",
    "sync",
]
