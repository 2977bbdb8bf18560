"""The jobs of this room."""

from typing import Any
from uuid import UUID

from app.core import kill_points
from app.core.jobs.queue import Payload, job
from app.core.runtime import Runtime
from app.core.uploads import Upload
from app.deliveries import dry_stems, queries, service
from app.deliveries.errors import ArchiveRefused
from app.deliveries.models import Archive
from app.deliveries.rules import ArchiveState, shown_name
from app.deliveries.service import Origin
from app.deliveries.uploads import unzip


@job("deliveries.unpack_archive")
def unpack_archive(runtime: Runtime, payload: Payload) -> None:
    """Make each sound in a delivered ZIP a take; a second run continues where the first was killed."""
    archive_id = UUID(payload["archive_id"])
    with runtime.database.reading() as session:
        archive = session.get_one(Archive, archive_id)
        session.expunge(archive)
    if archive.state is not ArchiveState.RECEIVED:
        return
    entries: list[dict[str, Any]] = []
    try:
        with (
            runtime.store.local_copy(archive.studio_id, archive.sha256) as path,
            unzip.opened(path) as opened,
        ):
            for entry in opened.entries:
                entries.append(_unpacked(runtime, archive, opened, entry))
                kill_points.point("deliveries.entry_unpacked")
        state, message = ArchiveState.UNPACKED, ""
    except ArchiveRefused as refusal:
        state, message = ArchiveState.REFUSED, str(refusal)
    with runtime.database.writing() as session:
        row = session.get_one(Archive, archive_id, with_for_update=True)
        row.state, row.message, row.entries = state, message, entries


def _unpacked(runtime: Runtime, archive: Archive, opened: unzip.OpenArchive, entry: unzip.Entry) -> dict[str, Any]:
    """Store one file of a ZIP and make it a take, or say why not."""
    answer: dict[str, Any] = {
        "path": shown_name(entry.path),
        "taken": False,
        "take_id": None,
        "reason": entry.left_out,
    }
    if entry.left_out:
        return answer
    with runtime.database.reading() as session:
        take = queries.take_of_entry(session, archive.id, entry.place)
        if take is not None:
            return answer | {"taken": True, "take_id": str(take.id)}
        if (stem := queries.dry_stem_of_entry(session, archive.id, entry.place)) is not None:
            return answer | {"taken": True, "reason": _is_stem_of(stem.stem)}
    try:
        stored = runtime.store.put(archive.studio_id, opened.content(entry))
    except unzip.EntryBroken as error:
        return answer | {"reason": str(error)}
    with runtime.database.writing() as session:
        delivery = queries.delivery_by_id(session, archive.delivery_id)
        if delivery is None:
            raise LookupError(f"archive {archive.id} has no delivery")
        origin = Origin(archive_id=archive.id, archive_entry=entry.place)
        if (name := dry_stems.stem_for_name(session, delivery, entry.path)) is not None:
            dry_stems.add_dry_stem(session, delivery, stored.sha256, stored.size_bytes, entry.path, name, origin)
            return answer | {"taken": True, "reason": _is_stem_of(name)}
        take, already_here = service.add_take(
            session,
            delivery,
            stored.sha256,
            stored.size_bytes,
            entry.path,
            origin,
            sender_id=session.get_one(Upload, archive.upload_id).owner_id,
        )
        reason = "the same file was here before" if already_here else None
        return answer | {"taken": True, "take_id": str(take.id), "reason": reason}


def _is_stem_of(stem: str) -> str:
    return f"not a version: the dry stem of {shown_name(stem)}"
