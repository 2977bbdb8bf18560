"""Uploads in progress: resumable, and safe against a kill or a dropped connection at any point.

The offset of an upload is the size of its file on disk and nothing else. Bytes that carry a checksum
are counted only once it was found right. A finished file is in the store before its row says so.
"""

import asyncio
import fcntl
import hashlib
import itertools
import os
import shutil
from collections.abc import AsyncIterator, Callable, Iterator, Mapping
from datetime import UTC, datetime, timedelta
from pathlib import Path
from uuid import UUID

from anyio import to_thread
from sqlalchemy import select

from app.core import clock, kill_points, metrics
from app.core.db import Database, new_id, row_of
from app.core.errors import Conflict
from app.core.storage import COPY_PREFIX, MAKING_PREFIX, PUT_PREFIX, READ_BYTES, Store, make_folder, sync, write_all
from app.core.uploads.checksum import Checksum
from app.core.uploads.errors import (
    ChecksumMismatch,
    OffsetMismatch,
    PartsNotTaken,
    SentInParts,
    StoreFull,
    UploadBusy,
    UploadNotFound,
    UploadTooLong,
)
from app.core.uploads.minimum_rate import MinimumRate
from app.core.uploads.model import BEGIN, FINISH, OF_ID, Upload
from app.core.uploads.parts import PartsProgress, UploadParts
from app.core.web.concurrency import limiter

KEPT_FOR = timedelta(days=7)  # since the last byte of an unfinished upload
ROWS_KEPT_FOR = timedelta(days=28)  # of unfinished uploads whose file is on no disk that this process sees
ORPHANED_AFTER = timedelta(days=1)  # temporary files of a process that died
ORPHAN_PREFIXES = (PUT_PREFIX, COPY_PREFIX, MAKING_PREFIX)
SPARE_BYTES = 256 << 20  # room on the disk that uploads leave to the database
STAGING = ".uploads"


class Uploads:
    """The uploads of one server, before they reach the store."""

    def __init__(
        self, database: Database, store: Store, *, reserve_bytes: int = SPARE_BYTES, pace: MinimumRate | None = None
    ) -> None:
        self._reserve_bytes = reserve_bytes
        self._pace = pace or MinimumRate()
        self._database = database
        self._store = store
        self._parts = UploadParts(database, store)

    def create(
        self,
        *,
        studio_id: UUID,
        owner_id: UUID,
        scope: str,
        file_name: str,
        length: int,
        max_length: int,
        expected_sha256: str | None = None,
    ) -> Upload:
        """Make room for a file; a file of no bytes is finished at once."""
        if length > max_length:
            raise UploadTooLong(f"the file has {length} bytes; one file may have {max_length}")
        if self._store.public_origin is None:  # else its bytes may never come here
            self._ensure_room(length)
        upload = Upload(
            id=new_id(),
            studio_id=studio_id,
            owner_id=owner_id,
            scope=scope,
            file_name=file_name,
            length=length,
            expected_sha256=expected_sha256,
            created_at=clock.now(),
        )
        self._database.write_autocommit(BEGIN, row_of(upload))
        staging = self._staging(upload)
        made = make_folder(staging.parent)
        os.close(os.open(staging, os.O_CREAT | os.O_WRONLY, 0o600))
        for folder in {staging.parent, *made}:
            sync(folder)
        return upload if length else self._settled(upload)

    def find(self, upload_id: UUID, *, owner_id: UUID) -> Upload:
        """Return an upload of this owner; one that is whole and was interrupted before its end is finished first."""
        upload = self._row(upload_id, owner_id)
        try:
            return self._settled(upload)
        except UploadNotFound:  # finished by another request since its row was read, or given up
            return self._settled(self._row(upload_id, owner_id))

    def offset(self, upload: Upload) -> int:
        """Return the number of bytes here and on the disk."""
        if upload.sha256 is not None:
            return upload.length
        if upload.multipart_id is not None:
            return self._parts.offset(upload)
        try:
            with self._staging(upload).open("rb", buffering=0) as file:
                if here := os.fstat(file.fileno()).st_size:
                    os.fsync(file.fileno())
                return here
        except FileNotFoundError:
            raise UploadNotFound(f"no upload {upload.id}: it was given up or has expired") from None

    def expires_at(self, upload: Upload) -> datetime | None:
        """Return the expiry of an unfinished upload; None once it is finished."""
        if upload.sha256 is not None:
            return None
        if upload.multipart_id is not None:
            return upload.created_at + KEPT_FOR
        return _touched_at(self._staging(upload)) + KEPT_FOR

    async def receive(
        self,
        upload: Upload,
        offset: int,
        stream: AsyncIterator[bytes],
        *,
        announced: int | None = None,
        checksum: Checksum | None = None,
    ) -> Upload:
        """Append the incoming bytes, unless too slow, and finish the upload with its last byte.

        Whatever a broken line leaves behind stays and counts, unless a checksum was to prove it.
        More bytes than `announced` for the file are refused before the first is stored.
        """
        stream = self._pace.hold(stream)
        if upload.sha256 is not None:
            _ensure_continues(upload.length, offset)
            await _ensure_empty(stream)
            return upload
        if upload.multipart_id is not None:
            raise SentInParts(
                "this upload comes to the store in parts", fix="send the parts that are missing, or begin again"
            )
        file = self._locked(upload, os.O_WRONLY | os.O_APPEND)  # waits for nothing: cheaper than to send a thread
        try:
            here = os.fstat(file).st_size
            room = upload.length - here
            _ensure_continues(here, offset)
            if announced is not None and announced > room:
                raise UploadTooLong(f"{announced} bytes are announced, {room} are missing; none was stored")
            if checksum is None:
                await _write_stream(stream, file, room)
            else:
                await self._write_verified(upload, stream, file, room, checksum)
            async with limiter().for_upload_finish():
                return await to_thread.run_sync(self._received, upload, file)
        finally:
            os.close(file)  # which gives the lock back

    def _received(self, upload: Upload, file: int) -> Upload:
        os.fsync(file)
        kill_points.point("uploads.received")
        return self._finish(upload) if os.fstat(file).st_size == upload.length else upload

    def parts(self, upload: Upload, sha256s: Mapping[int, bytes]) -> PartsProgress:
        """Return the parts of an upload that are in the store, and links for those whose SHA-256 is given."""
        if upload.sha256 is None and upload.multipart_id is None and self.offset(upload) > 0:
            raise PartsNotTaken("some of this file came through the server", fix="ask for its offset and send the rest")
        return self._parts.standing(upload, sha256s)

    def finish_parts(self, upload: Upload) -> Upload:
        """Finish an upload whose parts are all in the store: read what they became, and keep that under its hash."""
        if upload.sha256 is not None:
            return upload
        file = self._locked(upload, os.O_RDWR | os.O_CREAT)
        try:
            finished = self._parts.finish(self._row(upload.id, upload.owner_id))
            self._staging(upload).unlink(missing_ok=True)
            return finished
        finally:
            os.close(file)

    def give_up(self, upload: Upload) -> None:
        """Delete an unfinished upload; a finished one belongs to its take."""
        if upload.sha256 is not None:
            raise Conflict("this file is complete; it cannot be withdrawn")
        file = self._locked(upload, os.O_RDWR | os.O_CREAT)
        try:
            self._parts.forget(upload)
            self._forget(upload.id, self._staging(upload))
        finally:
            os.close(file)

    def sweep(self) -> int:
        """Delete expired unfinished uploads and the leftovers of dead processes; return the number of files."""
        staged = list(self._store.staging_root.glob(f"*/{STAGING}/*"))  # listed before rows are read: rows come first
        gone = sum(self._swept(staging) for staging in staged)
        left_overs = [self._store.staging_root.glob(f"{prefix}*") for prefix in ORPHAN_PREFIXES]
        for orphaned in itertools.chain(*left_overs):
            if clock.now() - _touched_at(orphaned) > ORPHANED_AFTER:
                if orphaned.is_dir():
                    shutil.rmtree(orphaned, ignore_errors=True)
                else:
                    orphaned.unlink(missing_ok=True)
                gone += 1
        self._forget_rows_without_file({staging.stem for staging in staged})
        return gone + self._parts.sweep(clock.now() - KEPT_FOR) + self._store.sweep(clock.now() - ORPHANED_AFTER)

    def _forget_rows_without_file(self, staged: set[str]) -> None:
        with self._database.writing() as session:
            long_ago = clock.now() - ROWS_KEPT_FOR
            for row in session.scalars(select(Upload).where(Upload.sha256.is_(None), Upload.created_at < long_ago)):
                if str(row.id) not in staged:
                    session.delete(row)

    def _swept(self, staging: Path) -> bool:
        upload = self._found(UUID(staging.stem))
        if upload is None or upload.sha256 is not None:
            staging.unlink(missing_ok=True)
            return True
        if clock.now() - _touched_at(self._staging(upload)) < KEPT_FOR:
            return False
        try:
            self.give_up(upload)
        except (UploadBusy, UploadNotFound):
            return False
        return True

    def _forget(self, upload_id: UUID, staging: Path) -> None:
        staging.unlink(missing_ok=True)
        _part_of(staging).unlink(missing_ok=True)
        with self._database.writing() as session:
            if (row := session.get(Upload, upload_id)) is not None:
                session.delete(row)

    def _settled(self, upload: Upload) -> Upload:
        """Finish an upload whose last byte is here, unless another request is doing so."""
        if upload.sha256 is not None or upload.multipart_id is not None or self.offset(upload) < upload.length:
            return upload
        file = self._locked(upload, os.O_RDONLY)
        try:
            return self._finish(upload)
        finally:
            os.close(file)

    def _finish(self, upload: Upload) -> Upload:
        """Hash the whole file, give it to the store, write that down, and drop the staging name, in this order."""
        staging = self._staging(upload)
        with staging.open("rb") as content:
            sha256 = hashlib.file_digest(content, "sha256").hexdigest()
        if upload.expected_sha256 not in (None, sha256):
            os.truncate(staging, 0)
            sync(staging)
            raise ChecksumMismatch(
                f"the whole file's SHA-256 is {sha256}, announced was {upload.expected_sha256}",
                fix="send the file again from its first byte",
            )
        kill_points.point("uploads.before_store")
        self._store.keep(upload.studio_id, staging, sha256)
        kill_points.point("uploads.after_store")
        finished_at = clock.now()
        facts = {"upload_id": upload.id, "found_sha256": sha256, "then": finished_at}
        if not self._database.write_autocommit(FINISH, facts):
            raise UploadNotFound(f"no upload {upload.id}: it was given up or has expired")
        upload.sha256, upload.finished_at = sha256, finished_at
        metrics.UPLOADED.inc(upload.length)
        kill_points.point("uploads.finished")
        staging.unlink(missing_ok=True)
        return upload

    def _staging(self, upload: Upload) -> Path:
        return self._store.staging_root / str(upload.studio_id) / STAGING / str(upload.id)

    def _row(self, upload_id: UUID, owner_id: UUID) -> Upload:
        upload = self._found(upload_id)
        if upload is None or upload.owner_id != owner_id:
            raise UploadNotFound(f"no upload {upload_id}")
        return upload

    def _found(self, upload_id: UUID) -> Upload | None:
        with self._database.autocommit_session() as session:
            if (upload := session.scalar(OF_ID, {"upload_id": upload_id})) is not None:
                session.expunge(upload)
            return upload

    def _locked(self, upload: Upload, flags: int) -> int:
        """Open an unfinished upload's file, and lock it against a second writer."""
        staging = self._staging(upload)
        try:
            file = os.open(staging, flags)
        except FileNotFoundError:
            raise UploadNotFound(f"no upload {upload.id}: it was given up or has expired") from None
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            os.close(file)
            raise UploadBusy(
                "another request is sending to this upload", fix="ask for its offset in a few seconds and go on there"
            ) from None
        if not staging.exists():  # given up or finished between opening and locking
            os.close(file)
            raise UploadNotFound(f"no upload {upload.id}: it was given up or is finished")
        return file

    async def _write_verified(
        self, upload: Upload, stream: AsyncIterator[bytes], file: int, room: int, checksum: Checksum
    ) -> None:
        part = _part_of(self._staging(upload))
        digest = hashlib.new(checksum.algorithm, usedforsecurity=False)
        aside = os.open(part, os.O_CREAT | os.O_TRUNC | os.O_RDWR, 0o600)
        try:
            await _write_stream(stream, aside, room, digest.update)
            if digest.digest() != checksum.digest:
                raise ChecksumMismatch(
                    f"the {checksum.algorithm} of what came is {digest.hexdigest()}, announced was "
                    f"{checksum.digest.hex()}; none of it was kept",
                    fix="send these bytes again",
                )
            await asyncio.to_thread(_append, aside, file)
        finally:
            os.close(aside)
            part.unlink(missing_ok=True)

    def _ensure_room(self, length: int) -> None:
        folder = self._store.staging_root
        folder.mkdir(parents=True, exist_ok=True)
        free = shutil.disk_usage(folder).free
        if free < length + self._reserve_bytes:
            raise StoreFull(
                f"the file has {length:,} bytes; the server's disk has {free:,} left, "
                f"of which {self._reserve_bytes:,} are kept for the database",
                fix="contact the operator of this server",
            )


async def _write_stream(
    stream: AsyncIterator[bytes], file: int, room: int, also: Callable[[bytes], None] | None = None
) -> None:
    """Write the bytes to the file, in large pieces; stop before the first byte without room."""
    waiting = bytearray()
    try:
        async for chunk in stream:
            room -= len(chunk)
            if room < 0:
                raise UploadTooLong("more bytes came than were announced for this file")
            waiting += chunk
            if len(waiting) >= READ_BYTES:
                piece, waiting = bytes(waiting), bytearray()
                await asyncio.to_thread(_write, file, piece, also)
    finally:
        if waiting:
            _write(file, bytes(waiting), also)


async def _ensure_empty(stream: AsyncIterator[bytes]) -> None:
    async for chunk in stream:
        if chunk:
            raise UploadTooLong("this upload is finished; it takes no more bytes")


def _ensure_continues(here: int, offset: int) -> None:
    if offset != here:
        raise OffsetMismatch(f"{here} bytes are here, the request continues at {offset}", fix=f"continue at {here}")


def _write(file: int, piece: bytes, also: Callable[[bytes], None] | None) -> None:
    try:
        write_all(file, piece)
    except OSError as error:
        raise StoreFull(f"the server could not write: {error.strerror}", fix="contact the operator") from None
    if also is not None:
        also(piece)


def _append(source: int, target: int) -> None:
    os.lseek(source, 0, os.SEEK_SET)
    for piece in _pieces(source):
        _write(target, piece, None)


def _pieces(file: int) -> Iterator[bytes]:
    while piece := os.read(file, READ_BYTES):
        yield piece


def _part_of(staging: Path) -> Path:
    return staging.with_suffix(".part")


def _touched_at(path: Path) -> datetime:
    try:
        return datetime.fromtimestamp(path.stat().st_mtime, UTC)
    except FileNotFoundError:
        return clock.now()
