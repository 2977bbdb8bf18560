"""Blobs by content: `studio_id/sha256`, written once, synced to disk before anybody is told."""

import hashlib
import os
import tempfile
from collections.abc import Iterable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO
from uuid import UUID

READ_BYTES = 1 << 20


class BlobMissing(Exception):
    """The database names a blob that the store does not have."""


@dataclass(frozen=True)
class StoredBlob:
    """What was stored: the SHA-256 that names it and its size in bytes."""

    sha256: str
    size_bytes: int


class Store:
    """A folder of blobs; nothing is shared between studios, and nothing stored is ever altered."""

    def __init__(self, root: Path) -> None:
        self.root = root.resolve()

    def path(self, studio_id: UUID, sha256: str) -> Path:
        """Return where a blob is or would be."""
        return self.root / str(studio_id) / sha256[:2] / sha256

    def put(self, studio_id: UUID, chunks: Iterable[bytes]) -> StoredBlob:
        """Store what the chunks add up to; storing the same bytes twice is storing them once."""
        staging = self.root / str(studio_id)
        staging.mkdir(parents=True, exist_ok=True)
        digest, size_bytes = hashlib.sha256(), 0
        descriptor, name = tempfile.mkstemp(prefix=".put-", dir=staging)
        try:
            with os.fdopen(descriptor, "wb") as file:
                for chunk in chunks:
                    digest.update(chunk)
                    size_bytes += len(chunk)
                    file.write(chunk)
            return self.adopt(studio_id, Path(name), digest.hexdigest())
        except BaseException:
            Path(name).unlink(missing_ok=True)
            raise

    def put_file(self, studio_id: UUID, source: Path) -> StoredBlob:
        """Store a copy of a file."""
        with source.open("rb") as file:
            return self.put(studio_id, iter(lambda: file.read(READ_BYTES), b""))

    def adopt(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Move a finished file of the same disk into the store under its known hash."""
        stored = self.keep(studio_id, source, sha256)
        source.unlink()
        return stored

    def keep(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Give the store a finished file of the same disk under its known hash, and leave its old name in place.

        Until the caller has written down that the blob is stored, the old name is what a restart finds.
        """
        target = self.path(studio_id, sha256)
        size_bytes = source.stat().st_size
        source.chmod(0o440)
        sync(source)
        made = make_folder(target.parent)
        with suppress(FileExistsError):
            os.link(source, target)
        for folder in {target.parent, *made}:
            sync(folder)
        return StoredBlob(sha256, size_bytes)

    @contextmanager
    def local_copy(self, studio_id: UUID, sha256: str) -> Iterator[Path]:
        """Give a path on this machine's disk to read a blob from; never write to it."""
        path = self.path(studio_id, sha256)
        if not path.exists():
            raise BlobMissing(f"blob {sha256} of studio {studio_id} is not in the store")
        yield path

    def open(self, studio_id: UUID, sha256: str) -> BinaryIO:
        """Open a blob for reading."""
        try:
            return self.path(studio_id, sha256).open("rb")
        except FileNotFoundError:
            raise BlobMissing(f"blob {sha256} of studio {studio_id} is not in the store") from None

    def read(self, studio_id: UUID, sha256: str) -> bytes:
        """Return a whole small blob."""
        with self.open(studio_id, sha256) as file:
            return file.read()


def make_folder(folder: Path) -> list[Path]:
    """Make a folder with its parents; return those whose entries changed, for the caller to sync."""
    changed = []
    missing = folder
    while not missing.exists():
        missing = missing.parent
        changed.append(missing)
    folder.mkdir(parents=True, exist_ok=True)
    return changed


def sync(path: Path) -> None:
    """Return when a file's bytes, or a folder's entries, are on the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
