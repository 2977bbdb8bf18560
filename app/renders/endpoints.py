"""The endpoints of this room."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.web.blob_response import blob_response
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, Page, cursor_of, problems, uuid_cursor
from app.deliveries.errors import DownloadUnpaid, MasterDeleted, TakeNotFound
from app.projects.errors import DesignerNeeded, ProjectNotFound, TeamNeeded
from app.renders import service
from app.renders.batches import service as batches
from app.renders.errors import (
    BatchEnded,
    BatchNotFound,
    LossUnknown,
    MasterExportNotFound,
    MasterExportNotMade,
    NotDrawn,
    NothingRendered,
    NothingToPlay,
    NothingToRender,
    ReelNotFound,
    ReelNotMade,
    ReelTooLong,
    RenderNotFound,
    SoundNotFound,
    TakesBeingDrawn,
    TargetUnknown,
)
from app.renders.master_exports import service as master_exports
from app.renders.other_sounds import service as other_sounds
from app.renders.reels import service as reels
from app.renders.rules import MEDIA_TYPES, media_type_of
from app.renders.schemas import (
    BatchAdd,
    BatchRead,
    BatchSummary,
    LossRead,
    MasterExportRead,
    OtherSound,
    PeaksRead,
    ReelAdd,
    ReelRead,
    TakeSoundsRead,
)
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["renders"])
MAY_SEE: Actor = allows(Audience.PROJECT)
DESIGNER: Actor = allows(Audience.DESIGNER)
TEAM: Actor = allows(Audience.TEAM)
PAGE = 50


@router.get("/takes/{take_id}/sounds", response_model=TakeSoundsRead, responses=problems(TakeNotFound))
def get_take_sounds(take_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> TakeSoundsRead:
    """Return a take's master and its game files at the current spec, with what is needed to show and play them."""
    return service.take_sounds(session, actor, take_id)


@router.get(
    "/projects/{project_id}/other-sounds",
    response_model=Page[OtherSound],
    responses=problems(ProjectNotFound, DesignerNeeded),
)
def list_other_sounds(
    project_id: UUID, session: DbSession, palette: bool = False, cursor: str | None = None, actor: Actor = DESIGNER
) -> Page[OtherSound]:
    """Return the sounds of other designers that the project lets its designers hear, the newest first."""
    sounds = other_sounds.sounds_of_others(
        session, actor, project_id, palette=palette, before=uuid_cursor(cursor), limit=PAGE + 1
    )
    return Page(items=sounds[:PAGE], next=cursor_of(sounds[PAGE - 1].id) if len(sounds) > PAGE else None)


@router.get(
    "/sounds/{picture_id}/preview",
    **downloads(("audio/flac", "audio/ogg", "audio/wav"), SoundNotFound, NotDrawn, BlobMissing),
)
def get_preview(
    picture_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    light: bool = False,
    actor: Actor = MAY_SEE,
) -> Response:
    """Play a sound: at most 48 kHz, 16 bit, in a form that every browser plays; parts of it by Range.

    With `light` in Ogg Vorbis, to begin with over a slow line; without such a preview as ever.
    """
    picture = service.picture_in_sight(session, actor, picture_id)
    sha256, media_type = service.preview_file(picture, light=light)
    return blob_response(request, runtime.store, picture.studio_id, sha256, media_type=media_type, by_link=True)


@router.get(
    "/sounds/{picture_id}/peaks.json",
    response_model=PeaksRead,
    responses=problems(SoundNotFound, NotDrawn, BlobMissing),
)
def get_peaks(
    picture_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Return the shape of a sound across a screen."""
    picture = service.picture_in_sight(session, actor, picture_id)
    sha256 = service.drawn(picture.peaks_sha256)
    return blob_response(request, runtime.store, picture.studio_id, sha256, media_type="application/json")


@router.get(
    "/sounds/{picture_id}/spectrum.png",
    **downloads("image/png", SoundNotFound, NotDrawn, BlobMissing),
)
def get_spectrum(
    picture_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Return the spectrum over time: 20 kHz at the top, 60 Hz at the bottom, white is loudest, 72 dB to black."""
    picture = service.picture_in_sight(session, actor, picture_id)
    sha256 = service.drawn(picture.spectrum_sha256)
    return blob_response(request, runtime.store, picture.studio_id, sha256, media_type="image/png")


@router.get(
    "/renders/{render_id}/file",
    **downloads(MEDIA_TYPES, RenderNotFound, NothingRendered, DownloadUnpaid, BlobMissing),
)
def get_render_file(
    render_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Download a game file under the name that the game expects."""
    render, sha256, file_name = service.render_file(session, actor, render_id)
    return blob_response(
        request,
        runtime.store,
        render.studio_id,
        sha256,
        media_type=media_type_of(render.facts),
        file_name=file_name,
        by_link=True,
    )


@router.get("/renders/{render_id}/loss", response_model=LossRead, responses=problems(RenderNotFound, LossUnknown))
def get_render_loss(render_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> LossRead:
    """Return the loss of a game file against its master, in figures and in both spectra."""
    return service.render_loss(session, actor, render_id)


@router.post(
    "/projects/{project_id}/batches",
    status_code=201,
    response_model=BatchSummary,
    responses=problems(ProjectNotFound, TeamNeeded, NothingToRender, TargetUnknown),
)
def add_batch(project_id: UUID, body: BatchAdd, session: DbSession, actor: Actor = TEAM) -> BatchSummary:
    """Render every game file of the project again, or those of some targets; earlier files are kept."""
    (summary,) = batches.summaries(session, [batches.request_batch(session, actor, project_id, body.targets)])
    return summary


@router.get(
    "/projects/{project_id}/batches",
    response_model=Page[BatchSummary],
    responses=problems(ProjectNotFound, TeamNeeded),
)
def list_batches(
    project_id: UUID, session: DbSession, cursor: str | None = None, actor: Actor = TEAM
) -> Page[BatchSummary]:
    """Return the project's batches of game files, the newest first."""
    batch_rows = batches.batches_in(session, actor, project_id, before=uuid_cursor(cursor), limit=PAGE + 1)
    return Page(
        items=batches.summaries(session, batch_rows[:PAGE]),
        next=cursor_of(batch_rows[PAGE - 1].id) if len(batch_rows) > PAGE else None,
    )


@router.get("/batches/{batch_id}", response_model=BatchRead, responses=problems(BatchNotFound, TeamNeeded))
def get_batch(batch_id: UUID, session: DbSession, actor: Actor = TEAM) -> BatchRead:
    """Return the progress of a batch, and its effect on the sizes."""
    return batches.batch_read(session, batches.visible_batch(session, actor, batch_id))


@router.post(
    "/batches/{batch_id}/cancel",
    response_model=BatchRead,
    responses=problems(BatchNotFound, TeamNeeded, BatchEnded),
)
def cancel_batch(batch_id: UUID, session: DbSession, actor: Actor = TEAM) -> BatchRead:
    """End a batch that is not through; what it has made stays."""
    return batches.batch_read(session, batches.cancel(session, actor, batch_id))


@router.post(
    "/cues/{cue_id}/reels",
    status_code=201,
    response_model=ReelRead,
    responses=problems(CueNotFound, NothingToPlay, TakesBeingDrawn, ReelTooLong),
)
def add_reel(cue_id: UUID, body: ReelAdd, session: DbSession, actor: Actor = MAY_SEE) -> ReelRead:
    """Put all takes of a cue that the caller sees in a row, to be listened to; the same takes give the same reel."""
    return reels.reel_read(reels.request_reel(session, actor, cue_id, body))


@router.get("/reels/{reel_id}", response_model=ReelRead, responses=problems(ReelNotFound))
def get_reel(reel_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> ReelRead:
    """Return whether a reel is made, and where each take begins in it."""
    return reels.reel_read(reels.visible_reel(session, actor, reel_id))


@router.get(
    "/reels/{reel_id}/file",
    **downloads("audio/wav", ReelNotFound, ReelNotMade, BlobMissing),
)
def get_reel_file(
    reel_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Play or download a reel: 16-bit WAV, which never ships."""
    reel = reels.visible_reel(session, actor, reel_id)
    sha256 = reels.file_of(reel)
    return blob_response(
        request, runtime.store, reel.studio_id, sha256, media_type="audio/wav", file_name=reel.file_name, by_link=True
    )


@router.post(
    "/takes/{take_id}/master-exports",
    status_code=201,
    response_model=MasterExportRead,
    responses=problems(TakeNotFound, DownloadUnpaid, MasterDeleted),
)
def add_master_export(take_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> MasterExportRead:
    """Have a take's master copied with what is known of it written into it; the master stays as it was delivered."""
    return master_exports.export_read(master_exports.request_export(session, actor, take_id))


@router.get(
    "/master-exports/{master_export_id}", response_model=MasterExportRead, responses=problems(MasterExportNotFound)
)
def get_master_export(master_export_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> MasterExportRead:
    """Return the state of a master with its provenance, and its metadata."""
    return master_exports.export_read(master_exports.visible_export(session, actor, master_export_id))


@router.get(
    "/master-exports/{master_export_id}/file",
    **downloads("audio/wav", MasterExportNotFound, MasterExportNotMade, DownloadUnpaid, BlobMissing),
)
def get_master_export_file(
    master_export_id: UUID, request: Request, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> Response:
    """Download a master with its provenance, in bext and in iXML with the fields of ASWG-G006."""
    export = master_exports.visible_export(session, actor, master_export_id)
    sha256 = master_exports.file_of(session, actor, export)
    return blob_response(
        request,
        runtime.store,
        export.studio_id,
        sha256,
        media_type="audio/wav",
        file_name=export.file_name,
        by_link=True,
    )
