"""Uploads that their sender brings to the bucket by itself, in parts, by links that we sign.

The sender is never trusted: what the parts became is read again, and only what was read is kept.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime, timedelta
from uuid import UUID

from app.core import clock
from app.core.storage.multipart import Multipart, Part, checksum_header, part_length, part_start
from app.core.storage.objects import Objects
from app.core.storage.signing import Signer
from app.core.storage.store import Pieces, StoredBlob, altered

LINK_WORKS_FOR_S = 3600
RENEWED_AFTER = timedelta(hours=1)  # what is older is stored again, so that no deletion takes it for unused
Place = Callable[[UUID, str], str]  # of a studio's blob of that SHA-256


@dataclass(frozen=True)
class Incoming:
    """One upload in parts: its id, the length of its file, and what the bucket calls it."""

    upload_id: UUID
    length: int
    multipart_id: str


@dataclass(frozen=True)
class PartLink:
    """The target and headers of one part of an upload, and its byte range in the file."""

    number: int
    start: int
    length: int
    url: str
    headers: dict[str, str]


class DirectUploads:
    """The uploads that come to one bucket by themselves."""

    def __init__(
        self, objects: Objects, multipart: Multipart, public: Signer, bucket: str, prefix: str, place: Place
    ) -> None:
        self._objects = objects
        self._multipart = multipart
        self._public = public
        self._bucket = bucket
        self._prefix = prefix
        self._place = place

    def key(self, upload_id: UUID) -> str:
        """Return the place in the bucket of an upload until it is kept."""
        return f"{self._prefix}{upload_id}"

    def begin(self, upload_id: UUID, length: int) -> Incoming:
        """Begin an upload in parts."""
        return Incoming(upload_id, length, self._multipart.begin(self.key(upload_id)))

    def links(self, incoming: Incoming, sha256s: Mapping[int, bytes]) -> list[PartLink]:
        """Sign links for parts; each takes exactly the bytes that its part has, by their number and SHA-256."""
        return [self._link(incoming, number, sha256) for number, sha256 in sha256s.items()]

    def parts(self, incoming: Incoming) -> list[Part]:
        """Return the parts that are in the bucket and as long as they must be; raise MultipartGone."""
        parts = self._multipart.parts(self.key(incoming.upload_id), incoming.multipart_id)
        return [part for part in parts if part.size_bytes == part_length(incoming.length, part.number)]

    def complete(self, incoming: Incoming, parts: list[Part]) -> None:
        """Make one object of the parts; after that no link works any more. Raise MultipartGone."""
        self._multipart.complete(self.key(incoming.upload_id), incoming.multipart_id, parts)

    def size_bytes(self, upload_id: UUID) -> int | None:
        """Return the length of the object that the parts became; None where they have not become one."""
        return self._objects.size_bytes(self.key(upload_id))

    def stream(self, upload_id: UUID) -> Pieces:
        """Yield the bytes of what the parts became; raise FileNotFoundError."""
        return self._objects.stream(self.key(upload_id))

    def keep(self, upload_id: UUID, studio_id: UUID, stored: StoredBlob) -> None:
        """Copy the read content to its place, unless it is there, whole and stored within the last hour."""
        target = self._place(studio_id, stored.sha256)
        if not self._objects.is_renewed(target, stored.sha256, since=clock.now() - RENEWED_AFTER):
            self._objects.copy(self.key(upload_id), target)
        if (stored_bytes := self._objects.size_bytes(target)) != stored.size_bytes:
            raise altered(stored.sha256, f"{stored_bytes} bytes long, not {stored.size_bytes},")

    def forget(self, upload_id: UUID, multipart_id: str | None = None) -> None:
        """Delete an upload's object, or its parts where the bucket's name for it is given."""
        if multipart_id is not None:
            self._multipart.abort(self.key(upload_id), multipart_id)
        self._objects.delete(self.key(upload_id))

    def abandon(self, incoming: Incoming) -> None:
        """Drop the parts of an upload that was begun twice."""
        self._multipart.abort(self.key(incoming.upload_id), incoming.multipart_id)

    def orphaned(self, before: datetime) -> Iterator[tuple[UUID, str | None]]:
        """Yield uploads begun before an instant and still there: upload, and the bucket's name for its parts."""
        for unfinished in self._multipart.unfinished(self._prefix):
            with suppress(ValueError):
                if unfinished.begun_at < before:
                    yield UUID(unfinished.key.removeprefix(self._prefix)), unfinished.multipart_id
        for key, _, changed_at in self._objects.listed(self._prefix):
            with suppress(ValueError):
                if changed_at < before:
                    yield UUID(key.removeprefix(self._prefix)), None

    def _link(self, incoming: Incoming, number: int, sha256: bytes) -> PartLink:
        length, headers = part_length(incoming.length, number), checksum_header(sha256)
        url = self._public.url(
            "PUT",
            f"/{self._bucket}/{self.key(incoming.upload_id)}",
            {"partNumber": str(number), "uploadId": incoming.multipart_id},
            headers={"content-length": str(length), **headers},
            expires_in_s=LINK_WORKS_FOR_S,
        )
        return PartLink(number, part_start(number), length, url, headers)
