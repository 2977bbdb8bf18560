"""Sounds of the reels of designers on file: uploaded, played, removed."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.quotas.service import QuotaKind, ensure_quota
from app.accounts.rules import Actor
from app.core.errors import FieldProblem
from app.core.storage import Store
from app.core.uploads import finished_upload
from app.deliveries.signals import ReelUpload
from app.deliveries.uploads.destinations import reel_scope
from app.hiring.errors import NoSound, ReelFull, ReelSoundNotFound
from app.hiring.models import ReelSound
from app.hiring.roster import queries as roster_queries
from app.hiring.roster.service import entry_seen, roster_access
from app.references.rules import HEAD_BYTES, ReferenceKind, type_of

MAX_SOUNDS = 20  # of one reel


def ensure_may_upload(session: Session, upload: ReelUpload) -> UUID:
    """Return the studio that an upload belongs to; raise unless the caller may add it to the reel of a designer."""
    _, entry = entry_seen(session, upload.actor, upload.roster_entry_id)
    if upload.length is not None:
        kept_bytes = roster_queries.kept_reel_bytes
        ensure_quota(session, entry.studio_id, QuotaKind.REEL_BYTES, kept_bytes, added=upload.length)
    return entry.studio_id


def add_sound(
    session: Session, actor: Actor, entry_id: UUID, *, upload_id: UUID, title: str, store: Store
) -> ReelSound:
    """Add a finished upload to a reel; raise NoSound for what browsers do not play as a sound."""
    _, entry = entry_seen(session, actor, entry_id)
    if len(roster_queries.sounds_of(session, [entry_id]).get(entry_id, [])) >= MAX_SOUNDS:
        raise ReelFull(f"a reel has {MAX_SOUNDS} sounds at most", fix="remove one first")
    upload = finished_upload(session, upload_id, owner_id=actor.person, scope=reel_scope(entry_id))
    end = min(HEAD_BYTES, upload.size_bytes)
    file_type = type_of(b"".join(store.stream(entry.studio_id, upload.sha256, 0, end)) if end else b"")
    if file_type.kind is not ReferenceKind.AUDIO:
        message = "this is not a sound that browsers play; wanted WAV, FLAC, MP3, Ogg or M4A"
        raise NoSound(message, errors=[FieldProblem(where="upload_id", message=message)])
    sound = ReelSound(
        studio_id=entry.studio_id,
        entry_id=entry_id,
        title=title,
        file_name=upload.file_name,
        media_type=file_type.media_type,
        sha256=upload.sha256,
        file_bytes=upload.size_bytes,
        added_by=actor.person,
    )
    session.add(sound)
    session.flush()
    return sound


def sound_seen(session: Session, actor: Actor, sound_id: UUID) -> ReelSound:
    """Return a sound of a reel that the caller's studio keeps."""
    sound = roster_queries.sound_for(session, actor, sound_id)
    if sound is None:
        raise ReelSoundNotFound(f"no sound {sound_id} of a reel")
    roster_access(session, actor, sound.studio_id)
    return sound


def remove_sound(session: Session, actor: Actor, sound_id: UUID) -> UUID:
    """Remove a sound from its reel; return whose it was."""
    sound = sound_seen(session, actor, sound_id)
    session.delete(sound)
    session.flush()
    return sound.entry_id
