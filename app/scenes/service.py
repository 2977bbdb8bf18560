"""The scene of a version: its lanes with their levels, the clips that show it, and the beds under it."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.core import clock
from app.core.errors import FieldProblem
from app.core.events import publish
from app.deliveries.errors import TakeNotFound
from app.deliveries.models import Take
from app.deliveries.service import take_for
from app.projects.errors import ProjectNotFound
from app.projects.rules import OPENS_APPROVED
from app.projects.service import ProjectAccess, project_access
from app.references.models import ReferenceVersion
from app.references.service import opened_file
from app.scenes import queries
from app.scenes.errors import BedInvalid, BedNotFound, SceneSoundNotFound, SceneSoundNotMade
from app.scenes.models import Bed, SceneSound
from app.scenes.queries import PlayableTake
from app.scenes.rules import (
    FIRST_SPOT_S,
    LOOPING_ROLES,
    SCENE_COLUMNS,
    SPOT_COLUMNS,
    BedRole,
    Candidate,
    LevelFrom,
    column_value,
    likeliest_neighbours,
    part_name,
    scene_length_s,
    spots_in,
)
from app.sound_lists.models import Cue
from app.sound_lists.rules import folded

SOUND = "sound"  # the lane of the version itself


@dataclass(frozen=True)
class Lane:
    """One sound of a scene."""

    id: str
    name: str
    take: PlayableTake | None
    version: ReferenceVersion | None
    bed: Bed | None
    loops: bool
    starts_s: list[float]
    level_db: float
    level_from: LevelFrom
    is_on: bool

    @property
    def sound(self) -> tuple[str, str]:
        """The stored sound that is measured and its part."""
        if self.take is not None:
            return self.take.picture.preview_sha256 or "", ""
        if self.version is None or self.version.sha256 is None:
            return "", ""
        reference = self.version.reference
        return self.version.sha256, part_name(reference.start_s, reference.end_s)


@dataclass(frozen=True)
class Scene:
    """A version among what sounds with it; the first lane is the version itself."""

    access: ProjectAccess
    cue: Cue
    take_id: UUID
    length_s: float
    has_spots: bool
    audit_label: str | None
    lanes: list[Lane]
    clips: Sequence[ReferenceVersion]
    sounds: Mapping[tuple[str, str], SceneSound]

    def is_measured(self, lane: Lane) -> bool:
        """Whether a lane's sound is measured, or cannot be."""
        return lane.sound in self.sounds


def scene_of(session: Session, actor: Actor, take_id: UUID, *, measured: bool = False) -> Scene:
    """Return the scene of a version of a known cue that is drawn, with the sounds that the caller may hear."""
    _, access = take_for(session, actor, take_id)
    playable = queries.playable_take(session, take_id)
    if playable is None:
        raise TakeNotFound(f"version {take_id} is for no cue yet, or is not drawn")
    cue = playable.cue
    audit = queries.newest_audit(session, cue.project_id)
    neighbours = _neighbours(session, access, playable, audit.id if audit else None)
    gains = (
        queries.gains_in_game(session, audit.id, [cue.id, *(neighbour.cue.id for neighbour in neighbours)])
        if audit
        else {}
    )
    clips = queries.clips(session, cue)
    spots = _spots_of(cue)
    starts = [0.0] if cue.loop else spots or [FIRST_SPOT_S]
    lanes = [_take_lane(SOUND, playable, starts, gains)]
    lanes += [
        _take_lane(str(neighbour.cue.id), neighbour, _starts_of(neighbour.cue, starts), gains)
        for neighbour in neighbours
    ]
    lanes += _bed_lanes(session, access, cue)
    sounds = queries.scene_sounds(
        session, access.project.studio_id, [lane.sound[0] for lane in lanes], measured=measured
    )
    return Scene(
        access=access,
        cue=cue,
        take_id=take_id,
        length_s=scene_length_s(
            duration_s=playable.picture.duration_s or 0.0, spots=starts, clip_s=_clip_s(clips[0]) if clips else None
        ),
        has_spots=bool(spots),
        audit_label=audit.label if audit else None,
        lanes=lanes,
        clips=clips,
        sounds=sounds,
    )


def is_heard(access: ProjectAccess, take: Take) -> bool:
    """Whether the caller may hear an approved take: other designers than its own may as the project allows."""
    return access.only_designer_id in (None, take.designer_id) or access.project.designers_hear in OPENS_APPROVED


def _neighbours(
    session: Session, access: ProjectAccess, playable: PlayableTake, audit_id: UUID | None
) -> list[PlayableTake]:
    cue = playable.cue
    column = next((name for name in cue.extra if folded(name) in SCENE_COLUMNS), None)
    scene = column_value(cue.extra, SCENE_COLUMNS)
    near = queries.possible_neighbours(session, cue, (column, scene) if column and scene else None)
    heard = [neighbour for neighbour in near if is_heard(access, neighbour.take)]
    gains = (
        queries.gains_in_game(session, audit_id, [heard_neighbour.cue.id for heard_neighbour in heard])
        if audit_id
        else {}
    )
    by_cue = {heard_neighbour.cue.id: heard_neighbour for heard_neighbour in heard}
    candidates = [_candidate(heard_neighbour, gains) for heard_neighbour in heard]
    return [
        by_cue[likeliest_neighbour.cue_id]
        for likeliest_neighbour in likeliest_neighbours(_candidate(playable, {}), candidates)
    ]


def _candidate(playable: PlayableTake, gains: Mapping[UUID, float]) -> Candidate:
    cue, loudness = playable.cue, playable.loudness_lufs
    return Candidate(
        cue_id=cue.id,
        scene=column_value(cue.extra, SCENE_COLUMNS),
        category=cue.category,
        loops=cue.loop,
        variations=cue.variations,
        level_lufs=None if loudness is None else loudness + gains.get(cue.id, 0.0),
        position=cue.position,
    )


def _spots_of(cue: Cue) -> list[float]:
    return spots_in(column_value(cue.extra, SPOT_COLUMNS))


def _starts_of(cue: Cue, starts: list[float]) -> list[float]:
    """Return the starts of a neighbour; without times in the list the version's first start, where it covers most."""
    return [0.0] if cue.loop else _spots_of(cue) or starts[:1]


def _clip_s(clip: ReferenceVersion) -> float | None:
    start_s, end_s = clip.reference.start_s, clip.reference.end_s
    return None if end_s is None else end_s - (start_s or 0.0)


def _take_lane(lane_id: str, playable: PlayableTake, starts_s: list[float], gains: Mapping[UUID, float]) -> Lane:
    gain = gains.get(playable.cue.id)
    return Lane(
        id=lane_id,
        name=playable.cue.name,
        take=playable,
        version=None,
        bed=None,
        loops=playable.cue.loop,
        starts_s=starts_s,
        level_db=round(gain or 0.0, 1),
        level_from=LevelFrom.APPROVED if gain is None else LevelFrom.AUDIT,
        is_on=True,
    )


def _bed_lanes(session: Session, access: ProjectAccess, cue: Cue) -> Iterator[Lane]:
    bed_takes = queries.beds(session, cue.project_id, cue.category)
    takes = queries.approved_takes(session, [bed.take_id for bed in bed_takes.values() if bed.take_id])
    ids = [bed.reference_id for bed in bed_takes.values() if bed.reference_id]
    versions = queries.sound_references(session, cue.project_id, ids)
    for role in BedRole:
        bed = bed_takes.get(role)
        if bed is None:
            continue
        take = takes.get(bed.take_id) if bed.take_id else None
        if take is not None and not is_heard(access, take.take):
            continue
        version = versions.get(bed.reference_id) if bed.reference_id else None
        if take is None and version is None:
            continue  # withdrawn or removed since: nothing of it can be played
        yield Lane(
            id=role.value,
            name=take.cue.name if take else _name_of(version) if version else "",
            take=take,
            version=version,
            bed=bed,
            loops=role in LOOPING_ROLES,
            starts_s=[0.0],
            level_db=bed.level_db,
            level_from=LevelFrom.BED,
            is_on=bed.is_on,
        )


def _name_of(version: ReferenceVersion) -> str:
    return version.reference.caption or version.file_name


def ask_for_missing(session: Session, scene: Scene) -> None:
    """Ask for the missing measurements; each sound once, however often it is asked for."""
    studio_id = scene.access.project.studio_id
    for lane in scene.lanes:
        sha256, part = lane.sound
        if sha256 and not scene.is_measured(lane):
            once = f"{studio_id}:{sha256}:{part}"
            publish(session, "scene_sound.asked", studio_id=studio_id, once=once, sha256=sha256, part=part)


def set_bed(session: Session, actor: Actor, project_id: UUID, facts: Mapping[str, Any]) -> Bed:
    """Put a sound under a project or a category, in place of what was there in its role."""
    access = project_access(session, actor, project_id)
    access.ensure_may_speak()
    take_id, reference_id = facts["take_id"], facts["reference_id"]
    if (take_id is None) == (reference_id is None):
        raise _invalid("take_id", "name an approved version or a reference, one of the two")
    if take_id is not None:
        take = queries.approved_takes(session, [take_id]).get(take_id)
        if take is None or take.take.project_id != project_id:
            raise _invalid("take_id", "no approved version of this project has this id")
    if reference_id is not None and reference_id not in queries.sound_references(session, project_id, [reference_id]):
        raise _invalid("reference_id", "no sound on the references board of this project has this id")
    queries.lock_beds(session, project_id)
    bed = queries.bed_of(session, project_id, facts["category"], facts["role"])
    if bed is None:
        bed = Bed(studio_id=access.project.studio_id, project_id=project_id)
        session.add(bed)
    for name, value in facts.items():
        setattr(bed, name, value)
    return _changed(session, actor, bed)


def change_bed(session: Session, actor: Actor, bed_id: UUID, changes: Mapping[str, Any]) -> Bed:
    """Change the level of a bed, or turn it on or off, for the whole team."""
    bed = _bed_to_change(session, actor, bed_id)
    for name, value in changes.items():
        if value is not None:
            setattr(bed, name, value)
    return _changed(session, actor, bed)


def remove_bed(session: Session, actor: Actor, bed_id: UUID) -> None:
    """Take a bed away; under a category the project's plays again."""
    session.delete(_bed_to_change(session, actor, bed_id))
    session.flush()


def bed_sources(
    session: Session, actor: Actor, project_id: UUID
) -> tuple[list[tuple[UUID, Cue]], Sequence[ReferenceVersion]]:
    """Return sounds of a project that can be beds, to the team: approved versions with their cues, and references."""
    project_access(session, actor, project_id).ensure_team()
    takes = [(take.id, cue) for take, cue in queries.bed_takes(session, project_id)]
    return takes, queries.bed_references(session, project_id)


def playable_part(session: Session, actor: Actor, scene_sound_id: UUID) -> tuple[SceneSound, str]:
    """Return a part of a reference that can be played and its hash, to people of its project who opened it."""
    sound = queries.scene_sound_by_id(session, scene_sound_id)
    for version in [] if sound is None else queries.version_of_sound(session, sound):
        try:
            project_access(session, actor, version.project_id)
        except ProjectNotFound:
            continue
        opened_file(session, actor, version.id)
        if sound is None or sound.preview_sha256 is None:
            raise SceneSoundNotMade(f"this part cannot be played: {sound.problem if sound else ''}")
        return sound, sound.preview_sha256
    raise SceneSoundNotFound(f"no sound {scene_sound_id} of a scene")


def _bed_to_change(session: Session, actor: Actor, bed_id: UUID) -> Bed:
    bed = queries.bed_by_id(session, bed_id)
    if bed is None:
        raise BedNotFound(f"no bed {bed_id}")
    try:
        access = project_access(session, actor, bed.project_id)
    except ProjectNotFound:
        raise BedNotFound(f"no bed {bed_id}") from None
    access.ensure_may_speak()
    return bed


def _changed(session: Session, actor: Actor, bed: Bed) -> Bed:
    bed.changed_by, bed.changed_at = actor.person, clock.now()
    session.flush()
    return bed


def _invalid(where: str, message: str) -> BedInvalid:
    return BedInvalid(message, errors=[FieldProblem(where=where, message=message)])
