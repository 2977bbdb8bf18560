"""Uploads that come to the store in parts, without passing through this process.

The sender is not trusted: the sizes of the parts are read from the store, and the joined file is read
and hashed before the upload counts as finished.
"""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime, timedelta

from sqlalchemy import update

from app.core import clock, kill_points, metrics
from app.core.db import Database
from app.core.storage import DirectUploads, Incoming, MultipartGone, PartLink, Store, StoredBlob, multipart
from app.core.storage.direct import LINK_WORKS_FOR_S
from app.core.uploads.errors import ChecksumMismatch, PartsNotTaken, PartUnknown, UploadNotFound, UploadUnfinished
from app.core.uploads.model import Upload

PARTS_NAMED = 5


@dataclass(frozen=True)
class PartsProgress:
    """The parts of an upload, those in the store, and the targets of the requested ones."""

    part_bytes: int
    parts: int
    here: list[int]
    links: list[PartLink]
    links_expire_at: datetime


class UploadParts:
    """The parts of uploads to one store."""

    def __init__(self, database: Database, store: Store) -> None:
        self._database = database
        self._store = store

    def standing(self, upload: Upload, sha256s: Mapping[int, bytes]) -> PartsProgress:
        """Begin an upload in parts where that was not done, and sign links for those whose SHA-256 is given."""
        count = multipart.parts_of(upload.length)
        if beyond := [number for number in sha256s if not 1 <= number <= count]:
            raise PartUnknown(f"there is no part {beyond[0]}: a file of {upload.length} bytes comes in {count}, from 1")
        direct = self._direct()
        if self._store.public_origin is None or upload.sha256 is not None:
            raise PartsNotTaken("no part of this file is taken", fix="send its bytes to the server")
        incoming = self._incoming(upload) if upload.multipart_id else self._begun(upload, direct)
        return PartsProgress(
            part_bytes=multipart.PART_BYTES,
            parts=count,
            here=self._numbers_here(direct, incoming),
            links=direct.links(incoming, sha256s),
            links_expire_at=clock.now() + timedelta(seconds=LINK_WORKS_FOR_S),
        )

    def offset(self, upload: Upload) -> int:
        """Return the number of bytes in the store without a gap, from the first."""
        here = set(self._numbers_here(self._direct(), self._incoming(upload)))
        whole = next(number for number in range(1, len(here) + 2) if number not in here) - 1
        return min(upload.length, multipart.part_start(whole + 1))

    def finish(self, upload: Upload) -> Upload:
        """Make one file of the parts, read and hash it, keep it under its hash, and write that down, in this order."""
        if upload.sha256 is not None:
            return upload
        direct = self._direct()
        self._make_whole(upload, direct)
        kill_points.point("uploads.made_whole")
        stored = self._read(upload, direct)
        if upload.expected_sha256 not in (None, stored.sha256):
            self._begin_again(upload, direct)
            raise ChecksumMismatch(
                f"the whole file's SHA-256 is {stored.sha256}, announced was {upload.expected_sha256}",
                fix="send the file again from its first part",
            )
        kill_points.point("uploads.before_store")
        direct.keep(upload.id, upload.studio_id, stored)
        kill_points.point("uploads.after_store")
        with self._database.writing() as session:
            row = session.get_one(Upload, upload.id)
            row.sha256, row.finished_at = stored.sha256, clock.now()
        metrics.UPLOADED.inc(row.length)
        kill_points.point("uploads.finished")
        direct.forget(upload.id)
        return row

    def forget(self, upload: Upload) -> None:
        """Delete an upload's data from the store."""
        if upload.multipart_id is not None:
            self._direct().forget(upload.id, upload.multipart_id)

    def sweep(self, before: datetime) -> int:
        """Delete uploads begun before an instant and never finished; return their number."""
        if (direct := self._store.direct) is None:
            return 0
        gone = 0
        for upload_id, multipart_id in direct.orphaned(before):
            direct.forget(upload_id, multipart_id)
            gone += 1
            with self._database.writing() as session:
                row = session.get(Upload, upload_id)
                if row is not None and row.sha256 is None:
                    session.delete(row)
        return gone

    def _begun(self, upload: Upload, direct: DirectUploads) -> Incoming:
        incoming = direct.begin(upload.id, upload.length)
        with self._database.writing() as session:
            unbegun = (Upload.id == upload.id, Upload.multipart_id.is_(None), Upload.sha256.is_(None))
            begun = update(Upload).where(*unbegun).values(multipart_id=incoming.multipart_id).returning(Upload.id)
            is_ours = session.scalar(begun) is not None
            row = session.get(Upload, upload.id)
        if row is None:
            direct.forget(upload.id, incoming.multipart_id)
            raise UploadNotFound(f"no upload {upload.id}: it was given up or has expired")
        if not is_ours:  # a duplicate of this request was faster
            direct.abandon(incoming)
        return self._incoming(row)

    def _begin_again(self, upload: Upload, direct: DirectUploads) -> None:
        with self._database.writing() as session:
            session.get_one(Upload, upload.id).multipart_id = None
        direct.forget(upload.id)

    def _numbers_here(self, direct: DirectUploads, incoming: Incoming) -> list[int]:
        try:
            return [part.number for part in direct.parts(incoming)]
        except MultipartGone:  # all parts arrived, and an earlier request joined them but did not record it
            if direct.size_bytes(incoming.upload_id) is None:
                raise UploadNotFound(f"no upload {incoming.upload_id}: it was given up or has expired") from None
            return list(range(1, multipart.parts_of(incoming.length) + 1))

    def _make_whole(self, upload: Upload, direct: DirectUploads) -> None:
        incoming = self._incoming(upload)
        try:
            parts = direct.parts(incoming)
            part_numbers = range(1, multipart.parts_of(upload.length) + 1)
            if missing := [number for number in part_numbers if number not in {part.number for part in parts}]:
                named = ", ".join(str(number) for number in missing[:PARTS_NAMED])
                more = f" and {len(missing) - PARTS_NAMED} more" if len(missing) > PARTS_NAMED else ""
                raise UploadUnfinished(
                    f"of {len(part_numbers)} parts these are not in the store: {named}{more}",
                    fix="ask for links, send them",
                )
            direct.complete(incoming, parts)
        except MultipartGone:  # made whole before, or kept and written down by a request that was faster
            return

    def _read(self, upload: Upload, direct: DirectUploads) -> StoredBlob:
        digest, size_bytes = hashlib.sha256(), 0
        try:
            for piece in direct.stream(upload.id):
                digest.update(piece)
                size_bytes += len(piece)
        except FileNotFoundError:
            raise UploadNotFound(f"no upload {upload.id}: it was given up or has expired") from None
        if size_bytes != upload.length:
            raise UploadUnfinished(f"{size_bytes} bytes are in the store, {upload.length} were announced")
        return StoredBlob(digest.hexdigest(), size_bytes)

    def _direct(self) -> DirectUploads:
        if self._store.direct is None:
            raise PartsNotTaken("no part of a file is taken here", fix="send its bytes to the server")
        return self._store.direct

    @staticmethod
    def _incoming(upload: Upload) -> Incoming:
        if upload.multipart_id is None:
            raise UploadUnfinished("no part of this file is in the store", fix="ask for links, and send its parts")
        return Incoming(upload.id, upload.length, upload.multipart_id)
