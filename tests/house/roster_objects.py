"""A designer on file with a sound of their reel, as part of one of everything."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.core import clock
from app.core.uploads import Upload
from app.deliveries.uploads.destinations import reel_scope
from app.hiring.models import ReelSound, RosterEntry


def add_roster_entry(
    session: Session, *, studio_id: UUID, added_by: UUID, sha256: str, file_bytes: int
) -> dict[str, UUID]:
    """Put a designer without an account on file, with a sound and an upload; return their ids by name."""
    entry = RosterEntry(
        studio_id=studio_id,
        name="A designer on file",
        email="on.file@example.test",
        specialities=["weapons"],
        services=[],
        languages=[],
        links=[],
        added_by=added_by,
    )
    session.add(entry)
    session.flush()
    sound = ReelSound(
        studio_id=studio_id,
        entry_id=entry.id,
        title="Reel",
        file_name="reel.wav",
        media_type="audio/wav",
        sha256=sha256,
        file_bytes=file_bytes,
        added_by=added_by,
    )
    upload = Upload(
        studio_id=studio_id,
        owner_id=added_by,
        scope=reel_scope(entry.id),
        file_name="reel.wav",
        length=file_bytes,
        sha256=sha256,
        finished_at=clock.now(),
    )
    session.add_all([sound, upload])
    session.flush()
    return {"roster_entry_id": entry.id, "reel_sound_id": sound.id, "reel_upload_id": upload.id}
