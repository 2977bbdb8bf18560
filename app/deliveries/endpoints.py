"""The endpoints of this room."""

from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Query, Request, Response
from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.schemas import PersonBrief
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.uploads import UploadNotFound, UploadUnfinished, finished_upload
from app.core.web.blob_response import blob_response
from app.core.web.downloads import downloads
from app.core.web.http import (
    CurrentRuntime,
    DbSession,
    Page,
    UploadSession,
    cursor_of,
    problems,
    uuid_cursor,
)
from app.deliveries import dry_stems, labels, queries, service
from app.deliveries.downloads import ensure_open
from app.deliveries.errors import (
    DeliveryNotFound,
    DownloadUnpaid,
    DryStemNotFound,
    InHouseDesignerNeeded,
    MasterDeleted,
    OwnDesignerNeeded,
    TakeNotFound,
    VariationUnknown,
    WrongState,
)
from app.deliveries.handoffs.endpoints import router as handoffs_router
from app.deliveries.models import Archive, Delivery
from app.deliveries.rules import TakeState, base_name, ensure_master_kept, shown_name
from app.deliveries.schemas import (
    ArchiveAdd,
    ArchiveRead,
    DeliveryAdd,
    DeliveryChange,
    DeliveryDetail,
    DeliveryRead,
    DryStemRead,
    DryStemUpload,
    TakeAdd,
    TakeAdded,
    TakeDetail,
    TakeLabelRead,
    TakeLabelSet,
    TakeMatch,
    TakeRead,
)
from app.deliveries.source_banks.endpoints import router as source_banks_router
from app.deliveries.sources.endpoints import router as sources_router
from app.deliveries.tray.endpoints import router as tray_router
from app.deliveries.uploads.endpoints import router as uploads_router
from app.deliveries.uploads.file_endpoints import router as files_router
from app.deliveries.uploads.file_endpoints import take_of
from app.deliveries.web.stored_files import stored_file_response
from app.projects.errors import DesignerNeeded, ProjectNotFound
from app.projects.service import project_access
from app.sound_lists.errors import CueNotFound

PAGE = 50
router = APIRouter(prefix="/v1", tags=["deliveries"])
router.include_router(uploads_router)
router.include_router(tray_router)
router.include_router(files_router)
router.include_router(sources_router)
router.include_router(source_banks_router)
router.include_router(handoffs_router)

SAME_TAKE: dict[int | str, dict[str, Any]] = {
    200: {"model": TakeAdded, "description": "The same file was here before; this is its take."}
}
STORED_ALONGSIDE: dict[int | str, dict[str, Any]] = {
    202: {"model": DryStemRead, "description": "It is named `…__dry`: no take, but the dry stem of the take so named."}
}
Cursor = Annotated[str | None, Query(description="`next` of the page before.")]
Limit = Annotated[int, Query(ge=1, le=200)]


@router.post(
    "/projects/{project_id}/deliveries",
    status_code=201,
    response_model=DeliveryRead,
    responses=problems(ProjectNotFound, DesignerNeeded, InHouseDesignerNeeded),
)
def open_delivery(
    project_id: UUID,
    body: DeliveryAdd,
    session: DbSession,
    actor: Actor = allows(Audience.DESIGNER, build=Scope.DELIVERIES_WRITE),
) -> DeliveryRead:
    """Open a delivery to upload into."""
    return _delivery_read(service.open_delivery(session, actor, project_id, body.note), 0)


@router.get("/projects/{project_id}/deliveries", response_model=Page[DeliveryRead], responses=problems(ProjectNotFound))
def list_deliveries(
    project_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT, build=Scope.DELIVERIES_WRITE),
    cursor: Cursor = None,
    limit: Limit = PAGE,
) -> Page[DeliveryRead]:
    """List deliveries, the newest first; a designer's own."""
    access = project_access(session, actor, project_id)
    deliveries = queries.deliveries_of(
        session, project_id, designer_id=access.only_designer_id, before=uuid_cursor(cursor), limit=limit + 1
    )
    shown = deliveries[:limit]
    counts = queries.takes_counts(session, [delivery.id for delivery in shown])
    return Page(
        items=[_delivery_read(delivery, counts.get(delivery.id, 0)) for delivery in shown],
        next=cursor_of(shown[-1].id) if len(deliveries) > limit else None,
    )


@router.get("/deliveries/{delivery_id}", response_model=DeliveryDetail, responses=problems(DeliveryNotFound))
def see_delivery(
    delivery_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT, build=Scope.DELIVERIES_WRITE),
) -> DeliveryDetail:
    """Show a delivery with its takes, dry stems and ZIPs."""
    delivery, access = service.delivery_for(session, actor, delivery_id)
    stored_takes = queries.takes_in(session, delivery_id)
    takes = service.read_takes(session, access.project, stored_takes)
    archives = [_archive_read(archive) for archive in queries.archives_in(session, delivery_id)]
    return DeliveryDetail(
        **_delivery_read(delivery, len(takes)).model_dump(exclude={"designer"}),
        designer=PersonBrief.model_validate(delivery.designer),
        takes=takes,
        dry_stems=dry_stems.read_dry_stems(session, delivery_id, stored_takes),
        archives=archives,
    )


@router.post(
    "/deliveries/{delivery_id}/close",
    response_model=DeliveryRead,
    responses=problems(DeliveryNotFound, DesignerNeeded, InHouseDesignerNeeded),
)
def close_delivery(
    delivery_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.DESIGNER, build=Scope.DELIVERIES_WRITE),
) -> DeliveryRead:
    """Close a delivery."""
    return _counted(session, service.close_delivery(session, actor, delivery_id))


@router.patch(
    "/deliveries/{delivery_id}",
    response_model=DeliveryRead,
    responses=problems(DeliveryNotFound, DesignerNeeded),
)
def change_delivery(
    delivery_id: UUID, body: DeliveryChange, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> DeliveryRead:
    """Change a delivery's note."""
    return _counted(session, service.change_note(session, actor, delivery_id, body.note))


@router.post(
    "/deliveries/{delivery_id}/takes",
    status_code=201,
    response_model=TakeAdded,
    responses=SAME_TAKE
    | STORED_ALONGSIDE
    | problems(
        DeliveryNotFound, UploadNotFound, CueNotFound, DesignerNeeded, InHouseDesignerNeeded, UploadUnfinished,
        VariationUnknown,
    ),
)  # fmt: skip
def add_take(
    delivery_id: UUID,
    body: TakeAdd,
    session: UploadSession,
    actor: Actor = allows(Audience.DESIGNER, build=Scope.DELIVERIES_WRITE),
) -> Response:
    """Turn a finished upload into a take and queue its check; the same upload again is the same take."""
    status, answer = take_of(session, actor, delivery_id, body)
    return Response(answer.model_dump_json(), status, media_type="application/json")


@router.post(
    "/deliveries/{delivery_id}/archives",
    status_code=201,
    response_model=ArchiveRead,
    responses=problems(DeliveryNotFound, UploadNotFound, DesignerNeeded, InHouseDesignerNeeded, UploadUnfinished),
)
def add_archive(
    delivery_id: UUID,
    body: ArchiveAdd,
    session: UploadSession,
    actor: Actor = allows(Audience.DESIGNER, build=Scope.DELIVERIES_WRITE),
) -> ArchiveRead:
    """Keep a finished upload as a ZIP and queue its unpacking; each file in it becomes a take."""
    service.own_delivery(session, actor, delivery_id)
    upload = finished_upload(session, body.upload_id, owner_id=service.uploader(actor), scope=str(delivery_id))
    return _archive_read(service.receive_archive(session, actor, delivery_id, upload=upload, file_name=body.file_name))


@router.get("/projects/{project_id}/takes", response_model=Page[TakeRead], responses=problems(ProjectNotFound))
def list_takes(
    project_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
    state: Annotated[list[TakeState], Query(description="One or several.")] = [],  # noqa: B006  FastAPI copies it
    unmatched: bool | None = None,
    discarded: Annotated[bool, Query(description="Those taken out of list and tray, in place of the others.")] = False,
    cue_id: UUID | None = None,
    cursor: Cursor = None,
    limit: Limit = PAGE,
) -> Page[TakeRead]:
    """List takes, the newest first; a designer's own. `unmatched=true` is the tray."""
    access = project_access(session, actor, project_id)
    takes = queries.takes_of(
        session,
        project_id,
        designer_id=access.only_designer_id,
        states=state,
        unmatched=unmatched,
        discarded=discarded,
        cue_id=cue_id,
        before=uuid_cursor(cursor),
        limit=limit + 1,
    )
    shown = takes[:limit]
    return Page(
        items=service.read_takes(session, access.project, shown),
        next=cursor_of(shown[-1].id) if len(takes) > limit else None,
    )


@router.get("/takes/{take_id}", response_model=TakeDetail, responses=problems(TakeNotFound))
def see_take(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> TakeDetail:
    """Show one take."""
    take, access = service.take_for(session, actor, take_id)
    return service.detailed_take(session, access.project, take)


@router.put("/takes/{take_id}/label", responses=problems(TakeNotFound))
def set_take_label(
    take_id: UUID, body: TakeLabelSet, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> TakeLabelRead:
    """Set the label of a take among alternates, as its designer or for the team."""
    return labels.set_label(session, actor, take_id, body.label)


@router.put(
    "/takes/{take_id}/match",
    response_model=TakeRead,
    responses=problems(TakeNotFound, CueNotFound, WrongState, VariationUnknown),
)
def match_take(take_id: UUID, body: TakeMatch, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> TakeRead:
    """Match a take to a cue; it is checked again as that cue."""
    take, access = service.match_take(session, actor, take_id, body.cue_id, body.variation)
    return service.read_take(session, access.project, take)


@router.get(
    "/takes/{take_id}/master",
    **downloads("application/octet-stream", TakeNotFound, DownloadUnpaid, MasterDeleted, BlobMissing),
)
def download_master(
    take_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Give a take's master exactly as it was delivered; ranges may be asked for."""
    take, _ = service.take_for(session, actor, take_id)
    ensure_open(session, actor, take.cue_id, take.designer_id)
    ensure_master_kept(take.master_deleted_at)
    return stored_file_response(request, runtime, take.studio_id, take.master_sha256, take.file_name)


@router.put(
    "/takes/{take_id}/dry-stem",
    response_model=DryStemRead,
    responses=problems(TakeNotFound, OwnDesignerNeeded, WrongState, UploadNotFound, UploadUnfinished),
)
def add_dry_stem_to_take(
    take_id: UUID, body: DryStemUpload, session: DbSession, actor: Actor = allows(Audience.DESIGNER)
) -> DryStemRead:
    """Add a take's dry stem; the take's reverb is then measured against it."""
    return dry_stems.read_dry_stem(session, dry_stems.add_dry_stem_to_take(session, actor, take_id, body.upload_id))


@router.delete(
    "/takes/{take_id}/dry-stem", status_code=204, responses=problems(TakeNotFound, OwnDesignerNeeded, WrongState)
)
def withdraw_dry_stem(take_id: UUID, session: DbSession, actor: Actor = allows(Audience.DESIGNER)) -> None:
    """Withdraw a take's dry stem; the take is judged without it again."""
    dry_stems.withdraw_dry_stem(session, actor, take_id)


@router.get(
    "/takes/{take_id}/dry-stem",
    **downloads("application/octet-stream", TakeNotFound, DryStemNotFound, DownloadUnpaid, BlobMissing),
)
def download_dry_stem(
    take_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Give a take's dry stem exactly as it was delivered; ranges may be asked for."""
    stem = dry_stems.visible_dry_stem(session, actor, take_id)
    return blob_response(
        request,
        runtime.store,
        stem.studio_id,
        stem.sha256,
        media_type="application/octet-stream",
        file_name=shown_name(base_name(stem.file_name)),
        headers={"Content-Security-Policy": "sandbox", "Cache-Control": "private, no-cache"},  # another may come
    )


def _delivery_read(delivery: Delivery, takes_count: int) -> DeliveryRead:
    own = {name: getattr(delivery, name) for name in DeliveryRead.model_fields if name != "takes_count"}
    return DeliveryRead.model_validate(own | {"takes_count": takes_count})


def _counted(session: Session, delivery: Delivery) -> DeliveryRead:
    return _delivery_read(delivery, queries.takes_counts(session, [delivery.id]).get(delivery.id, 0))


def _archive_read(archive: Archive) -> ArchiveRead:
    return ArchiveRead.model_validate(archive)
