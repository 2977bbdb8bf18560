"""The interface of a blob store: `studio_id/sha256`, written once, never altered, nothing shared between studios."""

import hashlib
import io
import os
import stat
import tempfile
import time
from abc import ABC, abstractmethod
from collections.abc import Generator, Iterable, Iterator, Mapping
from contextlib import AbstractContextManager, closing, contextmanager
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING, BinaryIO
from uuid import UUID

from app.core.errors import Refused
from app.core.lru_cache import LRUCache

if TYPE_CHECKING:
    from app.core.storage.direct import DirectUploads

READ_BYTES = 1 << 20
VERIFIED_FOR_S = 3600.0  # so long a blob whose size, inode and times did not change is not hashed again
VERIFIED_KEPT = 20_000
READ_AGAIN_FIX = "upload the same file again, or have the operator run: soundlist restore FOLDER --sounds"
Pieces = Generator[bytes, None, None]
# What a process left that died at it is found by these.
PUT_PREFIX, COPY_PREFIX, MAKING_PREFIX = ".put-", ".copy-", ".making-"


class BlobMissing(Refused):
    """The database names a blob that the store does not have."""

    status = 500


class BlobAltered(Refused):
    """The store holds other bytes under a hash than those that the hash is of."""

    status = 500


class StoreUnavailable(Refused):
    """The store does not do its work now; nothing was half-kept, and the same may be tried again."""

    status = 503


class NoPlainFile(OSError):
    """The path to store is a link, a folder, a pipe or a device."""


class StoreUnready(Exception):
    """The store cannot be used as it is set up: states what was found and how to fix it, and nothing secret."""


@dataclass(frozen=True)
class StoredBlob:
    """A stored blob: the SHA-256 that names it and its size in bytes."""

    sha256: str
    size_bytes: int


class Store(ABC):
    """The store of masters, game files and pictures."""

    staging_root: Path  # on this machine's disk; bytes on their way in or out wait here
    direct: "DirectUploads | None" = None  # uploads that come to the store without passing through this process
    public_origin: str | None = None  # where browsers go for those, and for what links are signed to, if they may

    def __init__(self) -> None:
        self._verified_at: LRUCache[tuple[UUID, str, str], float] = LRUCache(VERIFIED_KEPT)

    @abstractmethod
    def keep(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Store a finished file below the staging root under its known hash, and leave it where it is.

        An altered blob under that hash is replaced. One that is whole counts as stored now, for a later deletion.
        Until the caller has written down that the blob is stored, that file is what a restart finds.
        """

    @abstractmethod
    def size_bytes(self, studio_id: UUID, sha256: str) -> int:
        """Return the size of a blob; raise BlobMissing if there is none."""

    @abstractmethod
    def delete(self, studio_id: UUID, sha256: str) -> None:
        """Delete a blob; one that is not there is deleted."""

    @abstractmethod
    def stored_at(self, studio_id: UUID, sha256: str) -> datetime:
        """Return the time of a blob's last storage; raise BlobMissing if there is none."""

    @abstractmethod
    def local_copy(self, studio_id: UUID, sha256: str) -> AbstractContextManager[Path]:
        """Give a path on this machine's disk to read a blob from, never to write to; raise BlobAltered, BlobMissing."""

    @abstractmethod
    def blobs(self) -> Iterator[tuple[UUID, StoredBlob]]:
        """Yield every blob with its studio."""

    @abstractmethod
    def ensure_ready(self) -> None:
        """Raise StoreUnready unless bytes can be stored and read again."""

    @abstractmethod
    def signed_url(self, studio_id: UUID, sha256: str, *, media_type: str, disposition: str | None) -> str | None:
        """Return a link to a blob that works for a while without credentials; None where none is offered."""

    @abstractmethod
    def _pieces(self, studio_id: UUID, sha256: str, start: int, end: int | None) -> Pieces:
        """Yield a blob's bytes as they are; raise BlobMissing where there is none."""

    @abstractmethod
    def _state(self, studio_id: UUID, sha256: str) -> str:
        """Return a text that changes whenever a blob is written; raise BlobMissing if there is none."""

    def stream(self, studio_id: UUID, sha256: str, start: int = 0, end: int | None = None) -> Pieces:
        """Yield a blob's bytes from `start` up to, not including, `end`; raise BlobMissing where there is none.

        A whole blob is hashed on its way: its last piece is given only if the hash is right, and BlobAltered is raised
        otherwise. A range cannot be; ensure_intact comes before it.
        """
        pieces = self._pieces(studio_id, sha256, start, end)
        return pieces if start or end is not None else _verified(sha256, pieces)

    def ensure_intact(self, studio_id: UUID, sha256: str) -> None:
        """Raise BlobMissing, or BlobAltered where a blob's hash is not its name; it is read at most once an hour."""
        key = (studio_id, sha256, self._state(studio_id, sha256))
        verified_at = self._verified_at.get(key)
        if verified_at is None or time.monotonic() - verified_at > VERIFIED_FOR_S:
            self.verify(studio_id, sha256)
            self._verified_at.keep(key, time.monotonic())

    def verify(self, studio_id: UUID, sha256: str) -> int:
        """Read a whole blob and return its size; raise BlobMissing, or BlobAltered where its hash is not its name."""
        return sum(map(len, self.stream(studio_id, sha256)))

    def free_bytes(self) -> int | None:
        """Return the free space of the store's disk; None where no disk of this machine bounds it."""
        return None

    def sweep(self, before: datetime) -> int:  # noqa: ARG002  for those that leave something
        """Delete half-stored leftovers of dead processes from before an instant; return their number."""
        return 0

    def put(self, studio_id: UUID, chunks: Iterable[bytes]) -> StoredBlob:
        """Store the joined chunks; storing the same bytes twice is storing them once."""
        with self._in_words():
            self.staging_root.mkdir(parents=True, exist_ok=True)
            descriptor, name = tempfile.mkstemp(prefix=PUT_PREFIX, dir=self.staging_root)
        try:
            with os.fdopen(descriptor, "wb", buffering=0) as file:
                digest = hashlib.sha256()
                for chunk in chunks:
                    digest.update(chunk)
                    with self._in_words():
                        write_all(file.fileno(), chunk)
            return self.keep(studio_id, Path(name), digest.hexdigest())
        finally:
            Path(name).unlink(missing_ok=True)

    def put_file(self, studio_id: UUID, source: Path) -> StoredBlob:
        """Store a copy of a file, of which other processes may still hold it open; a link or a device is refused."""
        if source.is_symlink() or source.parent.is_symlink():
            raise NoPlainFile(f"{source.name} is reached by a link; a plain file is wanted")
        with os.fdopen(os.open(source, os.O_RDONLY | os.O_NONBLOCK | os.O_NOFOLLOW), "rb", buffering=0) as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise NoPlainFile(f"{source.name} is a folder, a pipe or a device; a plain file is wanted")
            return self.put(studio_id, iter(lambda: file.read(READ_BYTES), b""))

    @contextmanager
    def making(self) -> Iterator[Path]:
        """Give a folder below the staging root for files to be stored; it is deleted afterwards."""
        with self._in_words():
            self.staging_root.mkdir(parents=True, exist_ok=True)
            folder = tempfile.TemporaryDirectory(prefix=MAKING_PREFIX, dir=self.staging_root)
        with folder as name:
            yield Path(name)

    def save_renders(self, studio_id: UUID, source: Path) -> StoredBlob:
        """Store a finished file of such a folder without copying it first."""
        with source.open("rb", buffering=0) as file:
            sha256 = hashlib.file_digest(file, "sha256").hexdigest()
        return self.keep(studio_id, source, sha256)

    def sizes_bytes(self, studio_id: UUID, sha256s: Iterable[str]) -> Mapping[str, int]:
        """Return the length of each of many blobs; those that are missing are left out."""
        sizes = {}
        for sha256 in sha256s:
            try:
                sizes[sha256] = self.size_bytes(studio_id, sha256)
            except BlobMissing:
                continue
        return sizes

    def open(self, studio_id: UUID, sha256: str) -> BinaryIO:
        """Open a blob for reading from its beginning to its end; raise BlobMissing where there is none."""
        return io.BufferedReader(_Flow(self.stream(studio_id, sha256)), READ_BYTES)

    def read(self, studio_id: UUID, sha256: str) -> bytes:
        """Return a whole small blob."""
        return b"".join(self.stream(studio_id, sha256))

    @contextmanager
    def _in_words(self) -> Iterator[None]:
        """Report an error of this machine's disk."""
        try:
            yield
        except OSError as error:
            raise StoreUnavailable(
                f"the server could not write to its disk ({error.strerror})", fix="contact the operator of this server"
            ) from error


def write_all(file: int, content: bytes) -> None:
    """Write all of it: the system may take less at once."""
    left = memoryview(content)
    while left:
        left = left[os.write(file, left) :]


def key_refused() -> StoreUnavailable:
    """Return the error for a key that the store refuses."""
    return StoreUnavailable("the store refuses our key", fix="ask the operator to check AWS_ACCESS_KEY_ID")


def altered(sha256: str, description: str) -> BlobAltered:
    """Return the error for a blob whose content does not match its name."""
    return BlobAltered(f"blob {sha256} is {description} in the store, and is not given out", fix=READ_AGAIN_FIX)


def missing(studio_id: UUID, sha256: str) -> BlobMissing:
    """Return the error for a missing blob."""
    return BlobMissing(f"blob {sha256} of studio {studio_id} is not in the store", fix=READ_AGAIN_FIX)


def _verified(sha256: str, pieces: Pieces) -> Pieces:
    """Yield pieces, the last only if all of them have the hash."""
    digest, last, size_bytes = hashlib.sha256(), b"", 0
    with closing(pieces):
        for piece in pieces:
            digest.update(piece)
            size_bytes += len(piece)
            if last:
                yield last
            last = piece
    if digest.hexdigest() != sha256:
        raise altered(sha256, f"{size_bytes} bytes with the SHA-256 {digest.hexdigest()}")
    if last:
        yield last


class _Flow(io.RawIOBase):
    """A file to be read once, from the beginning, out of pieces as they come."""

    def __init__(self, pieces: Pieces) -> None:
        self._pieces = pieces
        self._rest = memoryview(next(pieces, b""))  # so that a missing blob is reported when it is opened

    def readable(self) -> bool:
        return True

    def readinto(self, buffer: "memoryview[int]") -> int:  # type: ignore[override]  # a RawIOBase is asked with a memoryview only
        while not self._rest and (piece := next(self._pieces, b"")):
            self._rest = memoryview(piece)
        length = min(len(buffer), len(self._rest))
        buffer[:length] = self._rest[:length]
        self._rest = self._rest[length:]
        return length

    def close(self) -> None:
        self._pieces.close()
        super().close()
