"""Small files: upload and take in one request, one transaction and one write to the disk."""

import asyncio
import hashlib
from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Header, Query, Request, Response
from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core import clock, metrics
from app.core.db import new_id
from app.core.plural import counted
from app.core.uploads import ChecksumMismatch, StoreFull, Upload, UploadIncomplete, finished_upload
from app.core.web.bodies import LARGE_BODY_BYTES, accepts_body, content_length
from app.core.web.concurrency import limiter
from app.core.web.http import CurrentRuntime, UploadSlot, Whole, problems, transaction
from app.deliveries import dry_stems, service
from app.deliveries.errors import (
    BadUploadHeader,
    DeliveryClosed,
    DeliveryNotFound,
    InHouseDesignerNeeded,
    LengthRequired,
    VariationUnknown,
)
from app.deliveries.models import Delivery
from app.deliveries.rules import stored_name
from app.deliveries.schemas import DryStemRead, GivenName, TakeAdd, TakeAdded
from app.deliveries.uploads.headers import sha256_in_hex
from app.deliveries.uploads.quotas import ensure_upload_fits
from app.projects.errors import DesignerNeeded
from app.sound_lists.errors import CueNotFound

MAX_SMALL_FILE_BYTES = LARGE_BODY_BYTES  # held in memory; a larger file is worth resuming, by tus
FILE_BODY = {
    "requestBody": {"content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}}
}

router = APIRouter(tags=["uploads"])
FilesActor = Annotated[Actor, allows(Audience.DESIGNER, build=Scope.DELIVERIES_WRITE)]


@router.post(
    "/deliveries/{delivery_id}/files",
    status_code=201,
    response_model=TakeAdded,
    openapi_extra=FILE_BODY,
    responses={
        200: {"model": TakeAdded, "description": "The same file was here before; this is its take."},
        202: {"model": DryStemRead, "description": "It is named `…__dry`: the dry stem of the take so named."},
        **problems(
            BadUploadHeader, ChecksumMismatch, CueNotFound, DeliveryClosed, DeliveryNotFound, DesignerNeeded,
            InHouseDesignerNeeded, LengthRequired, StoreFull, UploadIncomplete, VariationUnknown,
        ),
    },
)  # fmt: skip
@accepts_body(MAX_SMALL_FILE_BYTES)
async def add_file(
    delivery_id: UUID,
    request: Request,
    seat: UploadSlot,
    runtime: CurrentRuntime,
    actor: FilesActor,
    file_name: Annotated[GivenName, Query()],
    cue_id: Annotated[UUID | None, Query(description="Without it the name says which cue it is for.")] = None,
    variation: Annotated[Whole | None, Query()] = None,
    received_name: Annotated[GivenName | None, Query(description="Its name before it was renamed.")] = None,
    x_content_sha256: Annotated[str | None, Header(description="The file's SHA-256 in hex.")] = None,
) -> Response:
    """Deliver a file of at most 8 MiB in one request; the same bytes again are the same take."""
    length = content_length(request.scope)
    if length is None:
        raise LengthRequired("say how long the file is: Content-Length is missing")
    expected_sha256 = sha256_in_hex(x_content_sha256)

    def ensure_permitted() -> None:
        with runtime.database.reading(actor.reach) as session:
            studio_id = service.ensure_may_upload(session, actor, delivery_id).studio_id
            ensure_upload_fits(session, studio_id, length)

    await asyncio.to_thread(ensure_permitted)
    seat.release()  # bytes come as slowly as they like
    content = await request.body()
    if len(content) != length:
        raise UploadIncomplete(f"{len(content)} of the announced {counted(length, 'byte')} came; send the file again")

    def receive() -> Response:
        sha256 = hashlib.sha256(content).hexdigest()
        if expected_sha256 not in (None, sha256):
            raise ChecksumMismatch(
                f"the file's SHA-256 is {sha256}, announced was {expected_sha256}", fix="send it again"
            )
        with transaction(request) as session:
            delivery, _ = service.own_delivery(session, actor, delivery_id)
            upload = _finished(actor, delivery, received_name or file_name, sha256, length)
            session.add(upload)
            session.flush()
            body = TakeAdd(upload_id=upload.id, file_name=file_name, cue_id=cue_id, variation=variation)
            status, answer = take_of(session, actor, delivery_id, body)
            json = answer.model_dump_json()
            # Last, so that what is refused leaves no bytes; before the commit, so that no row names bytes not stored.
            runtime.store.put(delivery.studio_id, [content])
        metrics.UPLOADED.inc(length)
        return Response(json, status, media_type="application/json")

    async with limiter().for_upload_finish():
        return await asyncio.to_thread(receive)


def _finished(actor: Actor, delivery: Delivery, file_name: str, sha256: str, length: int) -> Upload:
    now = clock.now()
    return Upload(
        id=new_id(),
        studio_id=delivery.studio_id,
        owner_id=service.uploader(actor),
        scope=str(delivery.id),
        file_name=stored_name(file_name),
        length=length,
        sha256=sha256,
        created_at=now,
        finished_at=now,
    )


def take_of(session: Session, actor: Actor, delivery_id: UUID, body: TakeAdd) -> tuple[int, TakeAdded | DryStemRead]:
    """Turn a finished upload into a take, or a dry stem by its name; return the answer's status with it."""
    delivery, access = service.own_delivery(session, actor, delivery_id)
    upload = finished_upload(session, body.upload_id, owner_id=service.uploader(actor), scope=str(delivery_id))
    stem = dry_stems.stem_for_name(session, delivery, body.file_name)
    if stem is not None:
        kept = dry_stems.receive_dry_stem(
            session, actor, delivery_id, upload=upload, file_name=body.file_name, stem=stem
        )
        return 202, dry_stems.read_dry_stem(session, kept)
    take, already_here = service.receive_take(
        session,
        access,
        delivery,
        upload=upload,
        file_name=body.file_name,
        cue_id=body.cue_id,
        variation=body.variation,
        note=body.note,
    )
    status = 200 if already_here else 201
    return status, service.added_take(access.project, take, already_here=already_here)
