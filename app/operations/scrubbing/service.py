"""Scrubbing: every blob that a row names is read and hashed, and blobs that no row names are counted.

A pass goes on where the last step ended, by studio and hash, so that it may be spread over hours and survive restarts.
"""

import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import datetime, timedelta
from itertools import groupby
from uuid import UUID

from app.core import clock
from app.core.db import Database
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing, Store, StoredBlob
from app.operations.models import BlobState, DamagedBlob, Scrub
from app.operations.schemas import KeptKind
from app.operations.scrubbing import queries as blob_queries

ORPHANED_AFTER = timedelta(days=1)  # a blob is stored before a row names it
ORPHANS_KEPT = timedelta(days=7)  # since they were stored last
STEP_BLOBS = 500


@dataclass(frozen=True)
class Damage:
    """One blob that a row names and that is missing or altered."""

    studio_id: UUID
    sha256: str
    kind: KeptKind
    state: BlobState

    def __str__(self) -> str:
        return f"{self.state}: {self.kind}, {self.studio_id}/{self.sha256}"


@dataclass
class Step:
    """The results of one step: the blobs that were verified, the damage, and the blob that came last."""

    studio_id: UUID
    verified: list[str] = field(default_factory=list)
    size_bytes: int = 0
    damages: list[Damage] = field(default_factory=list)


class RateLimit:
    """Sleeps so that bytes are read no faster than so many a second."""

    def __init__(self, bytes_per_s: float | None) -> None:
        self._bytes_per_s = bytes_per_s
        self._began, self._bytes = time.monotonic(), 0

    def wait(self, size_bytes: int) -> None:
        """Count bytes that were read, and sleep until they are within the rate."""
        self._bytes += size_bytes
        if self._bytes_per_s:
            time.sleep(max(0.0, self._began + self._bytes / self._bytes_per_s - time.monotonic()))


def begin(database: Database) -> Scrub:
    """Begin a pass at the first blob."""
    with database.writing() as session:
        scrub = Scrub()
        session.add(scrub)
    return scrub


def run(runtime: Runtime, scrub: Scrub, *, rate: RateLimit, max_bytes: int | None = None) -> Iterator[Damage]:
    """Go on with a pass and yield the damage; stop after so many bytes, or finish it with the count of orphans."""
    left_bytes = max_bytes
    while (step := _step(runtime, scrub, rate, left_bytes)) is not None:
        if not _record(runtime.database, scrub, step):
            return
        yield from step.damages
        if left_bytes is not None:
            left_bytes -= step.size_bytes
            if left_bytes <= 0:
                return
    sizes_bytes = [blob.size_bytes for _, blob in orphans(runtime)]
    with runtime.database.writing() as session:
        scrub = session.merge(scrub)
        scrub.orphaned, scrub.orphaned_bytes = len(sizes_bytes), sum(sizes_bytes)
        scrub.finished_at = clock.now()


def orphans(runtime: Runtime, older_than: timedelta = ORPHANED_AFTER) -> Iterator[tuple[UUID, StoredBlob]]:
    """Yield the blobs older than a day that no row names."""
    before = clock.now() - older_than
    for studio_id, blobs in groupby(runtime.store.blobs(), lambda blob: blob[0]):
        unnamed = list(blobs)
        with runtime.database.reading() as session:
            named = blob_queries.named_blobs(session, studio_id)
        for _, blob in unnamed:
            if blob.sha256 not in named and _is_older(runtime.store, studio_id, blob.sha256, before):
                yield studio_id, blob


def delete_orphans(runtime: Runtime, older_than: timedelta = ORPHANED_AFTER) -> Iterator[tuple[UUID, StoredBlob]]:
    """Delete the blobs older than a day that no row names, and yield them."""
    for studio_id, blob in orphans(runtime, older_than):
        with runtime.database.reading() as session:
            if blob_queries.is_named(session, studio_id, blob.sha256):  # by now
                continue
        runtime.store.delete(studio_id, blob.sha256)
        yield studio_id, blob


def _step(runtime: Runtime, scrub: Scrub, rate: RateLimit, left_bytes: int | None) -> Step | None:
    """Verify the next blobs, all of one studio; return None where none is left."""
    with runtime.database.reading() as session:
        studios = [
            studio_id
            for studio_id in blob_queries.studio_ids(session)
            if scrub.last_studio_id is None or studio_id >= scrub.last_studio_id
        ]
        for studio_id in studios:
            after = scrub.last_sha256 if studio_id == scrub.last_studio_id else None
            named = blob_queries.named_blobs(session, studio_id)
            following = sorted(sha256 for sha256 in named if after is None or sha256 > after)[:STEP_BLOBS]
            if following:
                break
        else:
            return None
    step = Step(studio_id)
    for sha256 in following:
        size_bytes, state = _verified(runtime.store, studio_id, sha256)
        step.verified.append(sha256)
        step.size_bytes += size_bytes
        if state is not None and _is_still_named(runtime, studio_id, sha256):
            step.damages.append(Damage(studio_id, sha256, named[sha256], state))
        rate.wait(size_bytes)
        if left_bytes is not None and step.size_bytes >= left_bytes:
            break
    return step


def _record(database: Database, scrub: Scrub, step: Step) -> bool:
    """Write down a step, unless another worker went on from the same place; return whether it was written."""
    with database.writing() as session:
        current = session.get(Scrub, scrub.id, with_for_update=True)
        if current is None or (current.last_studio_id, current.last_sha256) != (
            scrub.last_studio_id,
            scrub.last_sha256,
        ):
            return False
        current.last_studio_id, current.last_sha256 = step.studio_id, step.verified[-1]
        current.blobs += len(step.verified)
        current.size_bytes += step.size_bytes
        current.missing += sum(damage.state is BlobState.MISSING for damage in step.damages)
        current.altered += sum(damage.state is BlobState.ALTERED for damage in step.damages)
        for healed in blob_queries.damaged_of(session, step.studio_id, step.verified):
            session.delete(healed)
        session.flush()
        for damage in step.damages:
            session.add(
                DamagedBlob(
                    studio_id=damage.studio_id, sha256=damage.sha256, kind=damage.kind.value, state=damage.state
                )
            )
    for column in Scrub.__table__.columns:
        setattr(scrub, column.key, getattr(current, column.key))
    return True


def _verified(store: Store, studio_id: UUID, sha256: str) -> tuple[int, BlobState | None]:
    """Return the size of a blob, and its fault if it has one."""
    try:
        return store.verify(studio_id, sha256), None
    except BlobMissing:
        return 0, BlobState.MISSING
    except BlobAltered:
        return store.size_bytes(studio_id, sha256), BlobState.ALTERED


def _is_still_named(runtime: Runtime, studio_id: UUID, sha256: str) -> bool:
    with runtime.database.reading() as session:
        return blob_queries.is_named(session, studio_id, sha256)


def _is_older(store: Store, studio_id: UUID, sha256: str, before: datetime) -> bool:
    try:
        return store.stored_at(studio_id, sha256) < before
    except BlobMissing:  # deleted since it was listed
        return False
