"""Scenes as they are shown: their lanes and clips, and which bands of a version are heard."""

from collections.abc import Mapping, Sequence
from uuid import UUID

import numpy as np
from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core.errors import FieldProblem
from app.renders.service import sound_places
from app.scenes.errors import LaneUnknown
from app.scenes.excitations import placed, unpacked
from app.scenes.models import Bed
from app.scenes.rules import HIGHEST_DB, LOWEST_DB, CoveredBand, masking_words, missing_words
from app.scenes.schemas import BedRead, ClipRead, MaskedBand, MaskingRead, SceneLaneRead, SceneRead
from app.scenes.service import SOUND, Lane, Scene, scene_of
from audio_checks import CENTRES_HZ, Masking, masking


def read_scene(scene: Scene) -> SceneRead:
    """Return a scene as it is shown."""
    access = scene.access
    return SceneRead(
        take_id=scene.take_id,
        cue_id=scene.cue.id,
        category=scene.cue.category,
        length_s=scene.length_s,
        has_spots=scene.has_spots,
        audit_label=scene.audit_label,
        lanes=[_read_lane(scene, lane) for lane in scene.lanes],
        clips=[
            ClipRead(
                reference_id=clip.reference_id,
                reference_version_id=clip.id,
                caption=clip.reference.caption,
                file_name=clip.file_name,
                media_type=clip.media_type,
                start_s=clip.reference.start_s or 0.0,
                end_s=clip.reference.end_s,
            )
            for clip in scene.clips
        ],
        is_ready=all(scene.is_measured(lane) for lane in scene.lanes),
        may_change=access.is_producer or access.is_liaison or access.is_approver,
    )


def _read_lane(scene: Scene, lane: Lane) -> SceneLaneRead:
    sound = scene.sounds.get(lane.sound)
    picture = lane.take.picture if lane.take else None
    if picture is not None:
        places = sound_places(picture, picture.thumb)
        preview_url, thumb, duration_s = places["preview_url"], places["thumb"], places["duration_s"]
    else:
        is_playable = sound is not None and sound.preview_sha256 is not None
        preview_url = f"/v1/scene-sounds/{sound.id}/preview" if sound and is_playable else None
        thumb, duration_s = (sound.thumb or None, sound.duration_s) if sound and is_playable else (None, None)
    return SceneLaneRead(
        id=lane.id,
        name=lane.name,
        cue_id=lane.take.cue.id if lane.take else None,
        take_id=lane.take.take.id if lane.take else None,
        bed=read_bed(lane.bed) if lane.bed else None,
        reference_version_id=lane.version.id if lane.version else None,
        preview_url=preview_url,
        thumb=thumb,
        duration_s=duration_s,
        loops=lane.loops,
        starts_s=lane.starts_s,
        level_db=lane.level_db,
        level_from=lane.level_from,
        is_on=lane.is_on,
        is_measured=sound is not None,
        problem=sound.problem if sound else "",
    )


def read_bed(bed: Bed) -> BedRead:
    """Return a bed as it is set."""
    return BedRead.model_validate({name: getattr(bed, name) for name in BedRead.model_fields})


def masking_of(session: Session, actor: Actor, take_id: UUID, levels: Mapping[str, float] | None) -> MaskingRead:
    """Return the bands of a version heard in its scene; with `levels`, among these lanes alone and so loud."""
    scene = scene_of(session, actor, take_id, measured=True)
    if levels is None:
        levels = {lane.id: lane.level_db for lane in scene.lanes if lane.is_on}
    names = {lane.id: lane for lane in scene.lanes}
    for lane_id, level in levels.items():
        if lane_id not in names:
            raise _unknown(f"this scene has no lane {lane_id}")
        if not LOWEST_DB <= level <= HIGHEST_DB:
            raise _unknown(f"{lane_id} is at {level:g} dB; a level lies between {LOWEST_DB:g} and {HIGHEST_DB:g} dB")
    levels = {SOUND: scene.lanes[0].level_db} | dict(levels)
    played = [lane for lane in scene.lanes if lane.id in levels]
    others = scene.lanes[1:]
    is_compared = len(played) > 1
    missing = missing_words(
        neighbours=any(lane.bed is None for lane in others),
        bed=any(lane.bed is not None for lane in others),
        any_on=is_compared,
    )
    is_measured = all(scene.is_measured(lane) for lane in played)
    if not is_measured or not is_compared:
        return MaskingRead(
            is_measured=is_measured,
            is_compared=is_compared,
            missing=missing,
            bands=[],
            part_bands=0,
            heard_bands=0,
            energy_share=0,
            time_share=0,
            in_words=missing if is_measured else "",
        )
    powers = [_power(scene, lane, levels[lane.id]) for lane in played]
    return _read_masking(masking(powers[0], powers[1:]), played[1:], missing)


def _power(scene: Scene, lane: Lane, level_db: float) -> np.ndarray:
    kept = scene.sounds[lane.sound].excitation
    return placed(
        unpacked(kept or ""), starts_s=lane.starts_s, loops=lane.loops, length_s=scene.length_s, gain_db=level_db
    )


def _read_masking(comparison: Masking, others: Sequence[Lane], missing: str) -> MaskingRead:
    bands, words = [], []
    for band, hz in enumerate(CENTRES_HZ.tolist()):
        covers = int(comparison.covers[band])
        lane = others[covers] if covers >= 0 else None
        is_part, is_heard = bool(comparison.is_part[band]), bool(comparison.is_heard[band])
        margin = float(comparison.margin_db[band])
        words.append(CoveredBand(hz, is_part, is_heard, margin, lane.name if lane else ""))
        bands.append(
            MaskedBand(
                hz=round(hz, 1),
                is_part=is_part,
                is_heard=is_heard,
                sound_db=_finite(float(comparison.sound_db[band])),
                cover_db=_finite(float(comparison.cover_db[band])),
                margin_db=_finite(margin),
                covered_by=lane.id if lane else None,
            )
        )
    return MaskingRead(
        is_measured=True,
        is_compared=True,
        missing=missing,
        bands=bands,
        part_bands=int(comparison.is_part.sum()),
        heard_bands=int(comparison.is_heard.sum()),
        energy_share=round(comparison.energy_share, 4),
        time_share=round(comparison.time_share, 4),
        in_words=" ".join(filter(None, [masking_words(words), missing])),
    )


def _finite(level: float) -> float | None:
    return round(level, 1) if np.isfinite(level) else None


def _unknown(message: str) -> LaneUnknown:
    return LaneUnknown(message, errors=[FieldProblem(where="lane", message=message)])
