"""Blobs in a folder of this machine, each synced to disk before it is confirmed."""

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from uuid import UUID

from app.kit.storage.store import READ_BYTES, Pieces, Store, StoredBlob, StoreUnready, missing


class FolderStore(Store):
    """A folder of blobs; files on their way in wait inside it, so that storing one is a link."""

    def __init__(self, root: Path) -> None:
        self.root = self.staging_root = root.resolve()

    def path(self, studio_id: UUID, sha256: str) -> Path:
        """Return where a blob is or would be."""
        return self.root / str(studio_id) / sha256[:2] / sha256

    def keep(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Link a finished file to its place."""
        target = self.path(studio_id, sha256)
        with self._in_words():
            size_bytes = source.stat().st_size
            source.chmod(0o400)
            sync(source)
            made = make_folder(target.parent)
            with suppress(FileExistsError):
                os.link(source, target)
            for folder in {target.parent, *made}:
                sync(folder)
        return StoredBlob(sha256, size_bytes)

    def size_bytes(self, studio_id: UUID, sha256: str) -> int:
        """Return the size of a blob; raise BlobMissing if there is none."""
        try:
            return self.path(studio_id, sha256).stat().st_size
        except FileNotFoundError:
            raise missing(studio_id, sha256) from None

    def stream(self, studio_id: UUID, sha256: str, start: int = 0, end: int | None = None) -> Pieces:
        """Yield a blob's bytes from `start` up to, not including, `end`; raise BlobMissing where there is none."""
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
        """Give the blob's own path."""
        path = self.path(studio_id, sha256)
        if not path.exists():
            raise missing(studio_id, sha256)
        yield path

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
        """Return what the folder's disk has left for this process."""
        self.root.mkdir(parents=True, exist_ok=True)
        return shutil.disk_usage(self.root).free

    def signed_url(self, studio_id: UUID, sha256: str, *, media_type: str, disposition: str | None) -> None:
        """Offer none: only this process reaches the folder."""

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
    """Return when a file's bytes, or a folder's entries, are on the disk."""
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
