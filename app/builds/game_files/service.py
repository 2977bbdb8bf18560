"""The approved game files of a project, as `soundlist pull` fetches them, and where each comes from."""

import hashlib
from pathlib import PurePosixPath
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.builds import queries
from app.builds.clearance.service import clearance_rows
from app.builds.errors import GameFileNotApproved
from app.builds.game_files.schemas import GameFile, GameFileOrigin, GameFilesRead, OpenGameFile
from app.builds.packs.placeholders import open_slots
from app.builds.packs.service import Pack, PackedSound, ensure_team_or_build, mark_of, pack_of
from app.builds.queries import AdoptedMaster
from app.deliveries.downloads import ensure_open
from app.deliveries.models import Take
from app.deliveries.queries import take_with_cue
from app.deliveries.rules import TakeState
from app.projects.models import Project
from app.projects.queries import current_spec
from app.projects.service import project_access
from app.renders.errors import NothingRendered, RenderNotFound
from app.renders.models import Render
from app.sound_lists.rules import label

MARKED = "the accepted version is marked as a placeholder, not the final sound"
NOT_ACCEPTED = "no sound is accepted for it yet"


def game_files_read(session: Session, actor: Actor, project_id: UUID, target: str | None) -> GameFilesRead:
    """Return every approved game file of a target, and what the game still lacks."""
    access = project_access(session, actor, project_id)
    ensure_team_or_build(access)
    pack = pack_of(session, access.project, target, actor)
    adopted = queries.adopted_masters(session, project_id)
    return GameFilesRead(
        project_id=project_id,
        project=access.project.name,
        target=pack.target,
        spec_version=current_spec(session, project_id).version,
        files=[
            _game_file(pack, sound, render, adopted.get((sound.cue.id, sound.variation)))
            for sound in pack.sounds
            if (render := sound.packed)
        ],
        missing=[
            OpenGameFile(path=sound.path, cue=_label(pack.project, sound), reason=sound.why_missing)
            for sound in pack.sounds
            if not sound.packed
        ],
        placeholders=_placeholders(session, pack),
    )


def _placeholders(session: Session, pack: Pack) -> list[OpenGameFile]:
    """Return files without a final sound: those with no accepted one, and accepted ones that carry the mark.

    A sound that is accepted and has no game file yet is listed as missing instead.
    """
    accepted = {(sound.cue.id, sound.variation) for sound in pack.sounds}
    lacking = [
        OpenGameFile(path=slot.path, cue=label(pack.project.cue_prefix, slot.cue.number), reason=NOT_ACCEPTED)
        for slot in open_slots(session, pack)
        if (slot.cue.id, slot.variation) not in accepted
    ]
    marked = [
        OpenGameFile(path=sound.path, cue=_label(pack.project, sound), reason=MARKED)
        for sound in pack.sounds
        if sound.take.id in pack.marked
    ]
    return [*lacking, *marked]


def _game_file(pack: Pack, sound: PackedSound, render: Render, adopted: AdoptedMaster | None) -> GameFile:
    return GameFile(
        path=sound.path,
        sha256=render.sha256 or "",
        bytes=render.file_bytes or 0,
        sound=hashlib.sha256(mark_of(render).encode()).hexdigest()[:16],
        cue=_label(pack.project, sound),
        cue_name=sound.cue.name,
        take_id=sound.take.id,
        url=f"/v1/projects/{pack.project.id}/game-files/{render.id}",
        adopted_sha256=adopted.sha256 if adopted else None,
        is_adopted_sound=adopted is not None and render.pcm_sha256 in adopted.pcm_sha256s,
    )


def _label(project: Project, sound: PackedSound) -> str:
    return label(project.cue_prefix, sound.cue.number)


def approved_file(session: Session, actor: Actor, project_id: UUID, render_id: UUID) -> tuple[Render, str]:
    """Return an approved game file and its hash.

    Raises RenderNotFound, GameFileNotApproved unless its take is approved or it is in a sealed pack, NothingRendered
    where there is no file, DownloadUnpaid where its contract opens it by payment.
    """
    access = project_access(session, actor, project_id)
    render_and_take = queries.render_of_project(session, project_id, render_id)
    if render_and_take is None or access.only_designer_id not in (None, render_and_take[1].designer_id):
        raise RenderNotFound(f"no render {render_id}")
    ensure_team_or_build(access)
    render, take = render_and_take
    if take.state is not TakeState.APPROVED and not queries.is_in_sealed_pack(session, project_id, render_id):
        raise GameFileNotApproved("this game file belongs to a version that is not approved")
    if render.sha256 is None:
        raise NothingRendered(f"the render for {render.target} was refused: {render.refusal}")
    ensure_open(session, actor, take.cue_id, take.designer_id)
    return render, render.sha256


def origins_of(
    session: Session, actor: Actor, project_id: UUID, *, name: str, target: str | None, take_id: UUID | None
) -> list[GameFileOrigin]:
    """Return the origins of the game files of a name: a path, a file name, its stem, or a cue's number.

    With a take, only that version of the file, which a newer one may have replaced since. For producers, and for builds
    with the scope for it.
    """
    access = project_access(session, actor, project_id)
    if not actor.is_build:
        access.ensure_producer()
    pack = pack_of(session, access.project, target, actor)
    sounds = [(sound.path, sound.take) for sound in pack.sounds if _has_name(pack.project, sound, name)]
    current = {take.id for _, take in sounds}
    if take_id is not None and take_id not in current:
        take = _earlier_take(session, access.project, take_id)
        sounds = [(sounds[0][0] if sounds else name, take)] if take else []
    elif take_id is not None:
        sounds = [(path, take) for path, take in sounds if take.id == take_id]
    version = current_spec(session, project_id).version
    rows = clearance_rows(session, access.project, sounds)
    return [
        GameFileOrigin(
            path=row.file,
            target=pack.target,
            cue=row.cue,
            cue_name=row.name,
            variation=row.variation,
            version=row.version,
            take_id=take.id,
            is_current=take.id in current,
            spec_version=version,
            approved_by=row.approved_by,
            approved_on=row.approved_on,
            designer=row.designer,
            contract=row.agreement,
            from_scratch=row.from_scratch,
            own_recordings=row.own_recordings,
            libraries=row.libraries,
            generated=row.generated,
            performers=row.performers,
            note=row.note,
            open_points=row.open_points,
            master=row.master,
            master_sha256=row.master_sha256,
        )
        for row, (_, take) in zip(rows, sounds, strict=True)
    ]


def _has_name(project: Project, sound: PackedSound, name: str) -> bool:
    stem = PurePosixPath(sound.path).stem
    return name in (sound.path, sound.file_name, stem, _label(project, sound))


def _earlier_take(session: Session, project: Project, take_id: UUID) -> Take | None:
    take = take_with_cue(session, take_id)
    return take if take is not None and take.project_id == project.id else None
