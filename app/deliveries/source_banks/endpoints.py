"""The endpoints of the source banks of takes."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.uploads import UploadNotFound, UploadUnfinished
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.deliveries.errors import (
    DownloadUnpaid,
    OwnDesignerNeeded,
    SourceBankHandedOver,
    SourceFileNotFound,
    TakeNotFound,
)
from app.deliveries.models import SourceFile
from app.deliveries.schemas import RecipeSet, SourceBankRead, SourceFileAdd, SourceFileRead
from app.deliveries.source_banks import service
from app.deliveries.web.stored_files import stored_file_response

router = APIRouter()


@router.get("/takes/{take_id}/source-bank", response_model=SourceBankRead, responses=problems(TakeNotFound))
def see_source_bank(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> SourceBankRead:
    """Show the source bank of a take to its designer, and to the team once it is handed over."""
    return service.source_bank(session, actor, take_id)


@router.put(
    "/takes/{take_id}/source-bank",
    response_model=SourceBankRead,
    responses=problems(TakeNotFound, OwnDesignerNeeded, SourceBankHandedOver),
)
def set_recipe(
    take_id: UUID, body: RecipeSet, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> SourceBankRead:
    """Set plug-ins and recipe of a take."""
    return service.set_recipe(session, actor, take_id, body)


@router.post(
    "/takes/{take_id}/source-files",
    status_code=201,
    response_model=SourceFileRead,
    responses=problems(TakeNotFound, OwnDesignerNeeded, UploadNotFound, UploadUnfinished),
)
def add_source_file(
    take_id: UUID, body: SourceFileAdd, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> SourceFile:
    """Add a finished upload to the source bank of a take: audio is a layer, anything else the session."""
    return service.add_source_file(session, actor, take_id, body.upload_id)


@router.delete(
    "/source-files/{source_file_id}",
    status_code=204,
    responses=problems(SourceFileNotFound, OwnDesignerNeeded, SourceBankHandedOver),
)
def remove_source_file(source_file_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> None:
    """Remove a file from the source bank of a take, while it is not the studio's."""
    service.remove_source_file(session, actor, source_file_id)


@router.get(
    "/source-files/{source_file_id}",
    **downloads("application/octet-stream", SourceFileNotFound, DownloadUnpaid, BlobMissing),
)
def download_source_file(
    source_file_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Give a source file exactly as it was delivered; ranges may be asked for."""
    file = service.visible_source_file(session, actor, source_file_id)
    return stored_file_response(request, runtime, file.studio_id, file.sha256, file.file_name)
