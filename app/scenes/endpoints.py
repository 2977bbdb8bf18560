"""The endpoints of this room."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.web.blob_response import WHILE_ASKED, blob_response
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.deliveries.errors import TakeNotFound
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.references.errors import ReferenceUnopened
from app.scenes import comparisons, service
from app.scenes.errors import (
    BedInvalid,
    BedNotFound,
    ComparisonNotFound,
    ComparisonNotMade,
    LaneUnknown,
    NothingToCompare,
    SceneSoundNotFound,
    SceneSoundNotMade,
)
from app.scenes.figures import masking_of, read_bed, read_scene
from app.scenes.schemas import (
    BedChange,
    BedRead,
    BedSet,
    BedSource,
    MaskingRead,
    SceneRead,
    SoundComparisonAdd,
    SoundComparisonRead,
)

router = APIRouter(prefix="/v1", tags=["scenes"])
TEAM: Actor = allows(Audience.TEAM)
MAY_SEE: Actor = allows(Audience.PROJECT)
LANE = "^[0-9a-z-]{1,36}:-?[0-9]{1,2}([.][0-9]{1,2})?$"


@router.post("/takes/{take_id}/scene", responses=problems(TakeNotFound))
def open_scene(take_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> SceneRead:
    """Return the sounds with a version in the game, and have the unmeasured ones measured."""
    scene = service.scene_of(session, actor, take_id)
    service.ask_for_missing(session, scene)
    return read_scene(scene)


@router.get("/takes/{take_id}/masking", responses=problems(TakeNotFound, LaneUnknown))
def get_masking(
    take_id: UUID,
    session: DbSession,
    lane: Annotated[
        list[Annotated[str, Query(pattern=LANE)]] | None,
        Query(max_length=32, description="Only these lanes, each with its level in dB, as in `music:-12`."),
    ] = None,
    actor: Actor = MAY_SEE,
) -> MaskingRead:
    """Return the bands of a version heard in its scene, and the sounds that cover the others."""
    levels = None
    if lane is not None:
        split = [lane_gain.rpartition(":") for lane_gain in lane]
        levels = {name: float(level) for name, _, level in split}
    return masking_of(session, actor, take_id, levels)


@router.get("/projects/{project_id}/bed-sources", responses=problems(ProjectNotFound, TeamNeeded))
def list_bed_sources(project_id: UUID, session: DbSession, actor: Actor = TEAM) -> list[BedSource]:
    """Return the sounds that can be beds: approved versions, those that loop first, then sounds of the references."""
    takes, versions = service.bed_sources(session, actor, project_id)
    return [
        *(BedSource(take_id=take_id, reference_id=None, name=cue.name, loops=cue.loop) for take_id, cue in takes),
        *(
            BedSource(
                take_id=None,
                reference_id=version.reference_id,
                name=version.reference.caption or version.file_name,
                loops=False,
            )
            for version in versions
        ),
    ]


@router.put("/projects/{project_id}/beds", responses=problems(ProjectNotFound, TeamNeeded, BedInvalid))
def set_bed(project_id: UUID, body: BedSet, session: DbSession, actor: Actor = TEAM) -> BedRead:
    """Put a sound under all sounds of a project, or under those of one category, where it replaces the project's."""
    return read_bed(service.set_bed(session, actor, project_id, body.model_dump()))


@router.patch("/beds/{bed_id}", responses=problems(BedNotFound, TeamNeeded))
def change_bed(bed_id: UUID, body: BedChange, session: DbSession, actor: Actor = TEAM) -> BedRead:
    """Change the level of a bed, or turn it on or off."""
    return read_bed(service.change_bed(session, actor, bed_id, body.model_dump(exclude_unset=True)))


@router.delete("/beds/{bed_id}", status_code=204, responses=problems(BedNotFound, TeamNeeded))
def remove_bed(bed_id: UUID, session: DbSession, actor: Actor = TEAM) -> None:
    """Take a bed away; under a category the project's plays again."""
    service.remove_bed(session, actor, bed_id)


@router.get(
    "/scene-sounds/{scene_sound_id}/preview",
    **downloads("audio/wav", SceneSoundNotFound, SceneSoundNotMade, ReferenceUnopened, BlobMissing),
)
def get_scene_sound(
    scene_sound_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Play the part of a reference that is a bed, to people whose opening of it was recorded."""
    sound, sha256 = service.playable_part(session, actor, scene_sound_id)
    headers = {"Cache-Control": WHILE_ASKED}
    return blob_response(request, runtime.store, sound.studio_id, sha256, media_type="audio/wav", headers=headers)


@router.post("/takes/{take_id}/comparisons", status_code=201, responses=problems(TakeNotFound, NothingToCompare))
def add_comparison(
    take_id: UUID, body: SoundComparisonAdd, session: DbSession, actor: Actor = MAY_SEE
) -> SoundComparisonRead:
    """Have a version compared with another, or with one of its game files; the same two give the same comparison."""
    comparison = comparisons.request_comparison(
        session, actor, take_id, against_take_id=body.against_take_id, target=body.target
    )
    return comparisons.comparison_read(comparison)


@router.get("/comparisons/{comparison_id}", responses=problems(ComparisonNotFound))
def get_comparison(comparison_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> SoundComparisonRead:
    """Return whether a comparison is made, and what differs."""
    return comparisons.comparison_read(comparisons.visible_comparison(session, actor, comparison_id))


@router.get(
    "/comparisons/{comparison_id}/file",
    **downloads("audio/wav", ComparisonNotFound, ComparisonNotMade, BlobMissing),
)
def get_comparison_file(
    comparison_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Play the rest of a version without the other sound."""
    comparison = comparisons.visible_comparison(session, actor, comparison_id)
    sha256 = comparisons.file_of(comparison)
    return blob_response(request, runtime.store, comparison.studio_id, sha256, media_type="audio/wav", by_link=True)
