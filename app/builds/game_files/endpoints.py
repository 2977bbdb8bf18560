"""The endpoints of `soundlist pull` and `soundlist why`."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.builds.endpoints import Target
from app.builds.errors import GameFileNotApproved
from app.builds.game_files import service as game_files
from app.builds.game_files.client_program import NAME, client_program
from app.builds.game_files.schemas import GameFileOrigin, GameFilesRead
from app.builds.packs import service as packs
from app.core.storage import BlobMissing
from app.core.web.blob_response import blob_response
from app.core.web.downloads import downloads, file_response
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.deliveries.errors import DownloadUnpaid
from app.projects.errors import ProducerNeeded, ProjectNotFound, TeamNeeded
from app.projects.service import project_access
from app.renders.errors import NothingRendered, RenderNotFound, TargetUnknown
from app.renders.rules import MEDIA_TYPES, media_type_of

router = APIRouter(prefix="/v1", tags=["builds"])
ZIPAPP = "application/zip"


@router.get(
    "/projects/{project_id}/game-files",
    response_model=GameFilesRead,
    responses=problems(ProjectNotFound, TeamNeeded, TargetUnknown),
)
def list_game_files(
    project_id: UUID,
    session: DbSession,
    target: Target = None,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> GameFilesRead:
    """Return every approved game file of a target with its hash, and what the game still lacks."""
    return game_files.game_files_read(session, actor, project_id, target)


@router.get(
    "/projects/{project_id}/game-files/origins",
    response_model=list[GameFileOrigin],
    responses=problems(ProjectNotFound, ProducerNeeded, TargetUnknown),
)
def list_game_file_origins(
    project_id: UUID,
    session: DbSession,
    name: Annotated[
        str, Query(max_length=1_000, description="A path in the game, a file name, its stem, or a cue's number.")
    ] = "",
    target: Target = None,
    take: Annotated[UUID | None, Query(description="Only this version, which may have been replaced since.")] = None,
    actor: Actor = allows(Audience.PRODUCER, build=Scope.RIGHTS_READ),
) -> list[GameFileOrigin]:
    """Return cue, approval, contract and sources of the game files of a name; an empty list where none has it."""
    return game_files.origins_of(session, actor, project_id, name=name, target=target, take_id=take)


@router.get(
    "/projects/{project_id}/soundlist.pyz",
    **downloads(ZIPAPP, ProjectNotFound, TeamNeeded),
)
def get_client_program(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ)
) -> Response:
    """Return `soundlist pull` and `soundlist why` as one file, to be run by Python 3.11 or newer."""
    packs.ensure_team_or_build(project_access(session, actor, project_id))
    return _program()


@router.get("/me/soundlist.pyz", **downloads(ZIPAPP))
def get_own_client_program(_actor: Actor = allows(Audience.PERSON, desk_token=True)) -> Response:
    """Return `soundlist desk` as one file, to be run by Python 3.11 or newer."""
    return _program()


def _program() -> Response:
    return file_response(client_program(), ZIPAPP, NAME)


@router.get(
    "/projects/{project_id}/game-files/{render_id}",
    **downloads(
        MEDIA_TYPES,
        ProjectNotFound,
        TeamNeeded,
        RenderNotFound,
        GameFileNotApproved,
        NothingRendered,
        DownloadUnpaid,
        BlobMissing,
    ),
)
def get_game_file(
    project_id: UUID,
    render_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.TEAM, build=Scope.MANIFEST_READ),
) -> Response:
    """Download an approved game file, or parts of it by Range."""
    render, sha256 = game_files.approved_file(session, actor, project_id, render_id)
    return blob_response(
        request, runtime.store, render.studio_id, sha256, media_type=media_type_of(render.facts), by_link=True
    )
