"""Where the bytes of a blob lie, for tests that lose or spoil them behind the store's back."""

from pathlib import Path
from uuid import UUID

from app.core.storage import BucketStore, FolderStore, Store
from tests.support.s3 import folder_of


def blob_file(store: Store, studio_id: UUID, sha256: str) -> Path:
    """Return the file that holds a blob, on this disk or on the S3 server's."""
    if isinstance(store, FolderStore):
        return store.path(studio_id, sha256)
    assert isinstance(store, BucketStore)
    return folder_of(store.address.endpoint) / store.address.bucket / store.key(studio_id, sha256)
