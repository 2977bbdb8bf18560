"""Preview reels: all takes of a cue in a row, for those who see them all; never for what ships."""

import hashlib
import json
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.events import publish
from app.core.storage import StoredBlob
from app.renders import queries
from app.renders.errors import NothingToPlay, ReelNotFound, ReelNotMade, ReelTooLong, TakesBeingDrawn
from app.renders.models import Picture, Reel
from app.renders.schemas import ReelAdd, ReelRead, ReelTake
from app.sound_lists.service import visible_cue
from audio_checks import slug

REEL_VERSION = 1  # counts up when the same takes would sound otherwise
MAX_TAKES = 60
MAX_DURATION_S = 600.0  # of all sounds together: the child holds them in memory
ENDING = "_reel"


def request_reel(session: Session, actor: Actor, cue_id: UUID, reel_add: ReelAdd) -> Reel:
    """Return the reel of the takes that the caller sees of a cue, and have it made unless it was or is."""
    access, cue = visible_cue(session, actor, cue_id)
    takes = queries.visible_takes_of_cue(session, actor, cue_id, newest_first=reel_add.order == "newest")
    pictures = queries.pictures_of_sounds(session, [cue.studio_id], [take.master_sha256 for take in takes])
    if any(take.master_sha256 not in pictures for take in takes):
        raise TakesBeingDrawn("a take of this cue is still being drawn", fix="ask again in a moment")
    heard = [
        (take, picture.preview_sha256)
        for take in takes
        if (picture := pictures[take.master_sha256]).preview_sha256 is not None
    ]
    if not heard:
        raise NothingToPlay("this cue has no take that can be played", fix="ask again when one was delivered")
    _ensure_short(len(heard), [pictures[take.master_sha256] for take, _ in heard])
    order = [
        {"take_id": str(take.id), "preview_sha256": preview, "variation": take.variation, "number": take.number}
        for take, preview in heard
    ]
    made_of = [REEL_VERSION, reel_add.gap_ms, reel_add.crossfade_ms, reel_add.slates, cue.variations > 1, order]
    key = hashlib.sha256(json.dumps(made_of, sort_keys=True).encode()).hexdigest()
    reel = queries.reel_of(session, cue_id, key)
    if reel is not None and reel.refusal is None:
        return reel
    if reel is None:
        reel = Reel(
            studio_id=cue.studio_id,
            project_id=cue.project_id,
            cue_id=cue_id,
            key=key,
            gap_ms=reel_add.gap_ms,
            crossfade_ms=reel_add.crossfade_ms,
            with_slates=reel_add.slates != "none",
            takes=order,
            file_name=f"{slug(cue.file_name or cue.name)}{ENDING}.wav",
        )
        session.add(reel)
    reel.refusal = None
    session.flush()
    publish(
        session,
        "reel.asked",
        studio_id=access.project.studio_id,
        reel_id=reel.id,
        sets=int(cue.variations > 1),
        speaks=int(reel_add.slates == "spoken"),
    )
    return reel


def _ensure_short(takes: int, pictures: list[Picture]) -> None:
    total_s = sum(picture.duration_s or 0.0 for picture in pictures)
    if takes > MAX_TAKES or total_s > MAX_DURATION_S:
        raise ReelTooLong(
            f"{takes} takes of {total_s:.0f} s together; a reel has at most {MAX_TAKES} and {MAX_DURATION_S:.0f} s",
            fix="play them one by one",
        )


def visible_reel(session: Session, actor: Actor, reel_id: UUID) -> Reel:
    """Return a reel; raise ReelNotFound unless the caller sees every take in it."""
    reel = queries.reel_by_id(session, reel_id)
    if reel is None or not queries.can_see_takes(session, actor, [UUID(take["take_id"]) for take in reel.takes]):
        raise ReelNotFound(f"no reel {reel_id}")
    return reel


def file_of(reel: Reel) -> str:
    """Return the hash of a reel's file; raise ReelNotMade if there is none."""
    if reel.sha256 is None:
        raise ReelNotMade(reel.refusal or "this reel is still being made", fix="ask again in a moment")
    return reel.sha256


def reel_read(reel: Reel) -> ReelRead:
    """Return a reel as it is shown."""
    return ReelRead(
        id=reel.id,
        cue_id=reel.cue_id,
        state="made" if reel.sha256 else "refused" if reel.refusal else "making",
        refusal=reel.refusal,
        gap_ms=reel.gap_ms,
        crossfade_ms=reel.crossfade_ms,
        slates="none" if not reel.with_slates else "spoken" if reel.is_spoken else "beeped",
        takes=[
            ReelTake(
                take_id=take["take_id"],
                variation=take["variation"],
                number=take["number"],
                start_s=take.get("start_s"),
            )
            for take in reel.takes
        ],
        duration_s=reel.duration_s,
        file_bytes=reel.file_bytes,
        file_name=reel.file_name,
        file_url=f"/v1/reels/{reel.id}/file" if reel.sha256 else None,
    )


def keep(
    session: Session, reel_id: UUID, blob: StoredBlob, *, duration_s: float, starts_s: list[float], is_spoken: bool
) -> None:
    """Put a reel's file on record, once."""
    reel = session.get_one(Reel, reel_id)
    if reel.sha256 is not None:
        return
    reel.sha256, reel.file_bytes, reel.refusal = blob.sha256, blob.size_bytes, None
    reel.duration_s, reel.is_spoken = duration_s, is_spoken
    reel.takes = [{**take, "start_s": start_s} for take, start_s in zip(reel.takes, starts_s, strict=True)]


def refuse(session: Session, reel_id: UUID, refusal: str) -> None:
    """Record the reel's reason for failure; the next request tries again."""
    reel = session.get_one(Reel, reel_id)
    if reel.sha256 is None:
        reel.refusal = refusal
