"""Blobs in a bucket of an S3 server, or in a part of one. ETags are not checksums: what counts is hashed again."""

from collections.abc import Iterable, Iterator, Mapping
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from datetime import datetime
from pathlib import Path
from tempfile import TemporaryDirectory
from uuid import UUID

from app.core import clock
from app.core.db import new_id
from app.core.storage.direct import RENEWED_AFTER, DirectUploads
from app.core.storage.multipart import AlreadyStored, Multipart, MultipartGone, parts_of
from app.core.storage.objects import Objects, ObjectState
from app.core.storage.retry_policy import RetryPolicy
from app.core.storage.signing import Key, Signer
from app.core.storage.store import (
    COPY_PREFIX,
    Pieces,
    Store,
    StoredBlob,
    StoreUnavailable,
    StoreUnready,
    missing,
)
from app.settings import BucketAddress

HEADS_AT_ONCE = 16
LINK_WORKS_FOR_S = 900
INCOMING, PROBES = ".incoming/", ".probes/"
RETRY_POLICY = RetryPolicy()
PROBING = RetryPolicy(tries=1, connect_timeout_s=3.0, read_timeout_s=5.0)  # readiness probes ask again


class BucketStore(Store):
    """A bucket; what is under a hash is put there again only if it is altered, or was stored more than an hour ago."""

    def __init__(
        self,
        address: BucketAddress,
        key: Key,
        staging_root: Path,
        *,
        direct: bool = False,
        patience: RetryPolicy = RETRY_POLICY,
    ) -> None:
        super().__init__()
        self.staging_root = staging_root.resolve()
        self.address = address
        self._root = f"{address.prefix}/" if address.prefix else ""
        self._objects = Objects(address, key, patience)
        self._probed = Objects(address, key, PROBING)
        self.multipart = Multipart(Signer(address.endpoint, address.region, key), address.bucket, patience)
        self._public = Signer(address.public_endpoint, address.region, key)
        self.direct = DirectUploads(
            self._objects, self.multipart, self._public, address.bucket, f"{self._root}{INCOMING}", self.key
        )
        if direct:
            self.public_origin = address.public_endpoint

    def key(self, studio_id: UUID, sha256: str) -> str:
        """Return a blob's present or future place in the bucket."""
        return f"{self._root}{studio_id}/{sha256[:2]}/{sha256}"

    def keep(self, studio_id: UUID, source: Path, sha256: str) -> StoredBlob:
        """Store a finished file under its hash, unless it is there, whole and stored within the last hour."""
        key, stored = self.key(studio_id, sha256), StoredBlob(sha256, source.stat().st_size)
        if parts_of(stored.size_bytes) == 1:
            is_new = self._objects.put_new(key, source.read_bytes())
        else:
            is_new = self._objects.size_bytes(key) is None and self._sent(key, source)
        if not is_new and not self._objects.is_renewed(key, sha256, since=clock.now() - RENEWED_AFTER):
            self._replace(key, source)
        return stored

    def delete(self, studio_id: UUID, sha256: str) -> None:
        """Delete a blob; one that is not there is deleted."""
        self._objects.delete(self.key(studio_id, sha256))

    def stored_at(self, studio_id: UUID, sha256: str) -> datetime:
        """Return the time of a blob's last storage; raise BlobMissing if there is none."""
        return self._object_state(studio_id, sha256).changed_at

    def put_file(self, studio_id: UUID, source: Path) -> StoredBlob:
        """Store a copy of a file, without copying it on this machine first."""
        return self.save_renders(studio_id, source)

    def size_bytes(self, studio_id: UUID, sha256: str) -> int:
        """Return the size of a blob; raise BlobMissing if there is none."""
        return self._object_state(studio_id, sha256).size_bytes

    def sizes_bytes(self, studio_id: UUID, sha256s: Iterable[str]) -> Mapping[str, int]:
        """Return the length of each of many blobs, many asked at once; those that are missing are left out."""
        asked = list(sha256s)
        with ThreadPoolExecutor(HEADS_AT_ONCE) as pool:
            sizes = pool.map(lambda sha256: self._objects.size_bytes(self.key(studio_id, sha256)), asked)
            return {sha256: size for sha256, size in zip(asked, sizes, strict=True) if size is not None}

    def _pieces(self, studio_id: UUID, sha256: str, start: int, end: int | None) -> Pieces:
        try:
            yield from self._objects.stream(self.key(studio_id, sha256), start, end)
        except FileNotFoundError:
            raise missing(studio_id, sha256) from None

    @contextmanager
    def local_copy(self, studio_id: UUID, sha256: str) -> Iterator[Path]:
        """Give a temporary copy; raise BlobAltered where its hash is not its name."""
        with self._in_words():
            self.staging_root.mkdir(parents=True, exist_ok=True)
            folder = TemporaryDirectory(prefix=COPY_PREFIX, dir=self.staging_root)
        with folder as name:
            path = Path(name, sha256)
            with self._in_words():
                self._copy(studio_id, sha256, path)
            yield path

    def blobs(self) -> Iterator[tuple[UUID, StoredBlob]]:
        """Yield every blob with its studio."""
        for key, size_bytes, _ in self._objects.listed(self._root):
            studio, _, rest = key.removeprefix(self._root).partition("/")
            if not studio.startswith("."):
                yield UUID(studio), StoredBlob(rest.rpartition("/")[2], size_bytes)

    def sweep(self, before: datetime) -> int:
        """Drop the parts of large blobs that dead processes left half-sent before an instant, and their probes."""
        gone = 0
        for unfinished in self.multipart.unfinished(self._root):
            if unfinished.begun_at < before and not unfinished.key.startswith(f"{self._root}{INCOMING}"):
                self.multipart.abort(unfinished.key, unfinished.multipart_id)
                gone += 1
        for key, _, changed_at in self._objects.listed(f"{self._root}{PROBES}"):
            if changed_at < before:
                self._objects.delete(key)
                gone += 1
        return gone

    def signed_url(self, studio_id: UUID, sha256: str, *, media_type: str, disposition: str | None) -> str | None:
        """Return a link to a blob; None where the settings keep browsers away from the bucket."""
        if self.public_origin is None:
            return None
        query = {"response-content-type": media_type, "response-cache-control": "private, immutable"}
        if disposition is not None:
            query["response-content-disposition"] = disposition
        path = f"/{self.address.bucket}/{self.key(studio_id, sha256)}"
        return self._public.url("GET", path, query, expires_in_s=LINK_WORKS_FOR_S)

    def ensure_ready(self) -> None:
        """Raise StoreUnready unless the bucket takes an object, gives it back and lets go of it."""
        key, probe = f"{self._root}{PROBES}{new_id()}", b"ready?"
        try:
            self._probed.put_new(key, probe)
            given = b"".join(self._probed.stream(key))
            self._probed.delete(key)
        except (StoreUnavailable, FileNotFoundError) as error:
            raise StoreUnready(self._in_words_of(error)) from error
        if given != probe:
            raise StoreUnready("the bucket gives back other bytes than it was given")

    def _in_words_of(self, error: Exception) -> str:
        """Return the reason for an unusable bucket, without its address: the answer is public."""
        cause = str(error.__cause__ or error)
        if "NoSuchBucket" in cause:
            return "the store's bucket is not there; create it, or fix SOUNDLIST_STORE_URL"
        if "403 Forbidden" in cause or "401 Unauthorized" in cause:
            return (
                "the store refuses our key; see that AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY are right, and that "
                "the key may get, put, list and delete in the bucket"
            )
        return "the store does not answer as an S3 server does; see that the endpoint in SOUNDLIST_STORE_URL is right"

    def _sent(self, key: str, source: Path) -> bool:
        try:
            self.multipart.send_file(key, source)
        except (AlreadyStored, MultipartGone):  # another was faster, or the answer to our own completion was lost
            return False
        return True

    def _replace(self, key: str, source: Path) -> None:
        if parts_of(source.stat().st_size) == 1:
            self._objects.put(key, source.read_bytes())
        else:
            self.multipart.send_file(key, source, if_absent=False)

    def _copy(self, studio_id: UUID, sha256: str, path: Path) -> None:
        with path.open("wb") as file:
            for piece in self.stream(studio_id, sha256):
                file.write(piece)

    def _state(self, studio_id: UUID, sha256: str) -> str:
        state = self._object_state(studio_id, sha256)
        return f"{state.etag} {state.size_bytes} {state.changed_at}"

    def _object_state(self, studio_id: UUID, sha256: str) -> ObjectState:
        state = self._objects.state(self.key(studio_id, sha256))
        if state is None:
            raise missing(studio_id, sha256)
        return state
