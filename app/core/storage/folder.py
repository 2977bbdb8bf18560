"""Blobs in a folder of this machine, each synced to disk before it is confirmed."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from datetime import UTC, datetime
from pathlib import Path
from uuid import UUID

from app.core.db import new_id
from app.core.storage.store import (
    PUT_PREFIX,
    READ_BYTES,
    BlobAltered,
    Pieces,
    Store,
    StoredBlob,
    StoreUnready,
    missing,
)


class FolderStore(Store):
    """A folder of blobs; files on their way in wait inside it, so that storing one is a link."""

    def __init__(self, root: Path) -> None:
        super().__init__()
        self.root = self.staging_root = root.resolve()

    def path(self, studio_id: UUID, sha256: str) -> Path:
        """Return a blob's present or future place."""
        return self.root / str(studio_id) / sha256[:2] / sha256

    def keep(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Link a finished file to its place; replace an altered blob there."""
        target = self.path(studio_id, sha256)
        with self._in_words():
            size_bytes = source.stat().st_size
            source.chmod(0o400)
            sync(source)
            made = make_folder(target.parent)
            try:
                os.link(source, target)
            except FileExistsError:
                self._renew(studio_id, source, sha256)
            for folder in {target.parent, *made}:
                sync(folder)
        return StoredBlob(sha256, size_bytes)

    def size_bytes(self, studio_id: UUID, sha256: str) -> int:
        """Return the size of a blob; raise BlobMissing if there is none."""
        return self._stat(studio_id, sha256).st_size

    def delete(self, studio_id: UUID, sha256: str) -> None:
        """Delete a blob; one that is not there is deleted."""
        with self._in_words():
            self.path(studio_id, sha256).unlink(missing_ok=True)

    def stored_at(self, studio_id: UUID, sha256: str) -> datetime:
        """Return the time of a blob's last storage; raise BlobMissing if there is none."""
        return datetime.fromtimestamp(self._stat(studio_id, sha256).st_mtime, UTC)

    def _pieces(self, studio_id: UUID, sha256: str, start: int, end: int | None) -> Pieces:
        try:
            file = self.path(studio_id, sha256).open("rb", buffering=0)
        except FileNotFoundError:
            raise missing(studio_id, sha256) from None
        with file:
            file.seek(start)
            while piece := file.read(READ_BYTES if end is None else min(READ_BYTES, end - start)):
                start += len(piece)
                yield piece

    @contextmanager
    def local_copy(self, studio_id: UUID, sha256: str) -> Iterator[Path]:
        """Give the blob's own path, once its hash was found right."""
        self.ensure_intact(studio_id, sha256)
        yield self.path(studio_id, sha256)

    def blobs(self) -> Iterator[tuple[UUID, StoredBlob]]:
        """Yield every blob with its studio."""
        for path in self.root.glob("[!.]*/??/*"):  # folders of files in the making begin with a dot and come and go
            try:
                blob = StoredBlob(path.name, path.stat().st_size)
            except FileNotFoundError:  # deleted since it was listed
                continue
            yield UUID(path.parents[1].name), blob

    def ensure_ready(self) -> None:
        """Raise StoreUnready unless the folder takes bytes and gives them back."""
        probe = b"ready?"
        try:
            self.root.mkdir(parents=True, exist_ok=True)
            with self._probe_file() as path:
                path.write_bytes(probe)
                sync(path)
                if path.read_bytes() != probe:
                    raise StoreUnready("the store gives back other bytes than it was given; look at its disk")
        except OSError as error:
            raise StoreUnready(
                f"the store cannot be written to ({error.strerror}); give the folder that SOUNDLIST_STORE_URL or "
                "SOUNDLIST_DATA_DIR names room and write permission"
            ) from error

    def free_bytes(self) -> int:
        """Return the free space of the folder's disk for this process."""
        self.root.mkdir(parents=True, exist_ok=True)
        return shutil.disk_usage(self.root).free

    def signed_url(self, studio_id: UUID, sha256: str, *, media_type: str, disposition: str | None) -> None:
        """Offer none: only this process reaches the folder."""

    def _state(self, studio_id: UUID, sha256: str) -> str:
        state = self._stat(studio_id, sha256)
        return f"{state.st_ino} {state.st_size} {state.st_mtime_ns} {state.st_ctime_ns}"

    def _stat(self, studio_id: UUID, sha256: str) -> os.stat_result:
        try:
            return self.path(studio_id, sha256).stat()
        except FileNotFoundError:
            raise missing(studio_id, sha256) from None

    def _renew(self, studio_id: UUID, source: Path, sha256: str) -> None:
        """Put a file in the place of a blob that is altered; mark one that is whole as stored now."""
        target = self.path(studio_id, sha256)
        try:
            self.verify(studio_id, sha256)
            os.utime(target)
        except BlobAltered:
            beside = self.root / f"{PUT_PREFIX}{new_id()}"
            os.link(source, beside)
            beside.replace(target)

    @contextmanager
    def _probe_file(self) -> Iterator[Path]:
        path = self.root / f".probe-{os.getpid()}"
        try:
            yield path
        finally:
            with suppress(OSError):
                path.unlink(missing_ok=True)


def make_folder(folder: Path) -> list[Path]:
    """Make a folder with its parents; return those whose entries changed, for the caller to sync."""
    changed = []
    missing_folder = folder
    while not missing_folder.exists():
        missing_folder = missing_folder.parent
        changed.append(missing_folder)
    folder.mkdir(parents=True, exist_ok=True)
    return changed


def sync(path: Path) -> None:
    """Force a file's bytes, or a folder's entries, onto the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
