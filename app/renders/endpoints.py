"""The endpoints of this room."""

from pathlib import Path
from uuid import UUID

from fastapi import APIRouter, Response
from fastapi.responses import FileResponse

from app.accounts.endpoints import allows
from app.accounts.rules import Actor, Sight
from app.deliveries.errors import TakeNotFound
from app.kit.http import CurrentRuntime, DbSession, Route, problems
from app.renders import service
from app.renders.errors import NotDrawn, NothingRendered, RenderNotFound, SoundNotFound
from app.renders.schemas import PeaksRead, TakeSoundsRead

router = APIRouter(prefix="/v1", tags=["renders"], route_class=Route)
# What is stored never changes, and is for the eyes of whoever was let in.
FOR_EVER = {"Cache-Control": "private, max-age=31536000, immutable"}
MAY_SEE: Actor = allows(Sight.PROJECT)


@router.get("/takes/{take_id}/sounds", response_model=TakeSoundsRead, responses=problems(TakeNotFound))
def get_take_sounds(take_id: UUID, session: DbSession, actor: Actor = MAY_SEE) -> TakeSoundsRead:
    """Return what can be seen and heard of a take: its master, and its game files at the current spec."""
    return service.take_sounds(session, actor, take_id)


@router.get(
    "/sounds/{picture_id}/preview",
    response_class=FileResponse,
    responses={200: {"content": {"audio/flac": {}, "audio/wav": {}}}, **problems(SoundNotFound, NotDrawn)},
)
def get_preview(picture_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE) -> FileResponse:
    """Play a sound: at most 48 kHz, 16 bit, in a form that every browser plays; parts of it by Range."""
    picture = service.picture_in_sight(session, actor, picture_id)
    path = runtime.store.path(picture.studio_id, service.drawn(picture.preview_sha256))
    return FileResponse(path, media_type=picture.preview_media_type, headers=FOR_EVER)


@router.get("/sounds/{picture_id}/peaks.json", response_model=PeaksRead, responses=problems(SoundNotFound, NotDrawn))
def get_peaks(picture_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE) -> Response:
    """Return the shape of a sound across a screen."""
    picture = service.picture_in_sight(session, actor, picture_id)
    path = runtime.store.path(picture.studio_id, service.drawn(picture.peaks_sha256))
    return _stored(path, "application/json")


@router.get(
    "/sounds/{picture_id}/spectrum.png",
    response_class=FileResponse,
    responses={200: {"content": {"image/png": {}}}, **problems(SoundNotFound, NotDrawn)},
)
def get_spectrum(picture_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE) -> FileResponse:
    """Return the spectrum over time: 20 kHz at the top, 60 Hz at the bottom, white is loudest, 72 dB to black."""
    picture = service.picture_in_sight(session, actor, picture_id)
    path = runtime.store.path(picture.studio_id, service.drawn(picture.spectrum_sha256))
    return _stored(path, "image/png")


@router.get(
    "/renders/{render_id}/file",
    response_class=FileResponse,
    responses={200: {"content": {"audio/wav": {}}}, **problems(RenderNotFound, NothingRendered)},
)
def get_render_file(
    render_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = MAY_SEE
) -> FileResponse:
    """Download a game file under the name that the game expects."""
    render, sha256, file_name = service.render_file(session, actor, render_id)
    path = runtime.store.path(render.studio_id, sha256)
    return FileResponse(path, media_type="audio/wav", filename=file_name, headers=FOR_EVER)


def _stored(path: Path, media_type: str) -> FileResponse:
    return FileResponse(path, media_type=media_type, headers=FOR_EVER)
