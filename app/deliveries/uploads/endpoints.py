"""Uploads of takes and references: tus 1.0 for unreliable connections, one PUT for scripts, parts for a bucket.

These endpoints stream a body, so they are `async`, use the database in a thread, and keep no
Idempotency-Key: an upload has an id of its own.
"""

import asyncio
from collections.abc import AsyncIterator
from email.utils import format_datetime
from functools import partial
from typing import Annotated, Any
from uuid import UUID

from fastapi import APIRouter, Header, Query, Request, Response
from starlette.datastructures import MutableHeaders
from starlette.requests import ClientDisconnect
from starlette.types import ASGIApp, Message, Receive, Send
from starlette.types import Scope as AsgiScope

from app.accounts.rules import Actor, Audience, Scope
from app.accounts.web.policies import allows
from app.core.runtime import Runtime
from app.core.storage import StoreUnavailable
from app.core.uploads import (
    CHECKSUMS,
    ChecksumMismatch,
    MinimumRate,
    OffsetMismatch,
    PartsNotTaken,
    PartUnknown,
    SentInParts,
    StoreFull,
    Upload,
    UploadBusy,
    UploadIncomplete,
    UploadNotFound,
    Uploads,
    UploadStalled,
    UploadTooLong,
    UploadUnfinished,
)
from app.core.web.bodies import accepts_body
from app.core.web.http import CurrentRuntime, UploadSlot, problems
from app.deliveries import service
from app.deliveries.errors import (
    AdoptionClosed,
    AdoptionNotFound,
    BadUploadHeader,
    DeliveryClosed,
    DeliveryNotFound,
    InHouseDesignerNeeded,
    LengthRequired,
    UnknownTusVersion,
    WrongContentType,
)
from app.deliveries.rules import MAX_ARCHIVE_BYTES, stored_name
from app.deliveries.schemas import PartsAsk, PartsRead, UploadRead
from app.deliveries.uploads.destinations import Destination, destination_in, ensure_may_continue, ensure_may_send
from app.deliveries.uploads.headers import (
    checksum_of,
    named_values,
    number_of_bytes,
    sha256_in_hex,
    sha256_of_digest,
)
from app.projects.errors import ApproverNeeded, DesignerNeeded, ProjectNotFound, TeamNeeded

TUS_VERSION = "1.0.0"
UPLOADS_PATH = "/v1/uploads"
EXTENSIONS = "creation,creation-with-upload,checksum,termination,expiration"
PARTS_EXTENSION = "soundlist-parts"  # ours: what was created may be sent to the store in parts
BODY_TYPE = "application/offset+octet-stream"

UPLOADS = allows(Audience.PERSON, build=Scope.DELIVERIES_WRITE)
UploadsActor = Annotated[Actor, UPLOADS]
Tus = Annotated[str | None, Header(alias="Tus-Resumable", description="1.0.0")]
BINARY_BODY: dict[str, Any] = {
    "requestBody": {"content": {BODY_TYPE: {"schema": {"type": "string", "format": "binary"}}}}
}


class TusHeaders:
    """Names the version of tus in every answer of an upload's address, refusals included."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: AsgiScope, receive: Receive, send: Send) -> None:
        """Answer, with the headers."""

        async def send_with_version(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                headers["Tus-Resumable"] = TUS_VERSION
                if message["status"] == UnknownTusVersion.status:
                    headers["Tus-Version"] = TUS_VERSION
            await send(message)

        is_upload = scope["type"] == "http" and scope["path"].startswith(UPLOADS_PATH)
        await self._app(scope, receive, send_with_version if is_upload else send)


router = APIRouter(tags=["uploads"])


@router.options("/uploads", status_code=204)
def describe_uploads(runtime: CurrentRuntime, actor: Actor = allows(Audience.ANYONE)) -> Response:  # noqa: ARG001  a policy
    """Return the tus extensions of this server, and whether its store accepts parts."""
    takes_parts = runtime.store.public_origin is not None
    return Response(
        status_code=204,
        headers={
            "Tus-Version": TUS_VERSION,
            "Tus-Extension": f"{EXTENSIONS},{PARTS_EXTENSION}" if takes_parts else EXTENSIONS,
            "Tus-Max-Size": str(MAX_ARCHIVE_BYTES),
            "Tus-Checksum-Algorithm": ",".join(CHECKSUMS),
        },
    )


@router.post(
    "/uploads",
    status_code=201,
    response_class=Response,
    openapi_extra=BINARY_BODY,
    responses=problems(
        AdoptionClosed, AdoptionNotFound, ApproverNeeded, BadUploadHeader, ChecksumMismatch, DeliveryClosed,
        DeliveryNotFound, DesignerNeeded, InHouseDesignerNeeded, ProjectNotFound,
        StoreFull, TeamNeeded, UnknownTusVersion, UploadStalled, UploadTooLong, WrongContentType,
    ),
)  # fmt: skip
@accepts_body(MAX_ARCHIVE_BYTES, streamed=True)
async def begin_upload(
    request: Request,
    slot: UploadSlot,
    runtime: CurrentRuntime,
    actor: UploadsActor,
    tus_resumable: Tus = None,
    upload_length: Annotated[str | None, Header(description="How many bytes the whole file has.")] = None,
    upload_metadata: Annotated[
        str | None,
        Header(
            description="In Base64: `file_name`, `sha256` if known; `delivery_id`, and `take_id` of what a dry stem is "
            "for; or `project_id` of a reference; or `adoption_id`; or `roster_entry_id` of a reel."
        ),
    ] = None,
    upload_checksum: Annotated[str | None, Header()] = None,
) -> Response:
    """Make room for a file in a delivery, or for a reference; bytes may come along."""
    _ensure_tus(tus_resumable)
    length = number_of_bytes("Upload-Length", upload_length)
    metadata = named_values(upload_metadata)
    has_body = request.headers.get("content-type") == BODY_TYPE
    if not has_body and request.headers.get("content-length", "0") != "0":
        raise WrongContentType(f"the bytes of an upload come as {BODY_TYPE}")
    checksum = checksum_of(upload_checksum)
    uploads = _uploads(runtime)
    begin = partial(
        _permitted, runtime, actor, destination_in(metadata), metadata.get("file_name", ""), length,
        sha256_in_hex(metadata.get("sha256")),
    )  # fmt: skip
    if not has_body:
        return await asyncio.to_thread(lambda: _standing(uploads, begin(), 201))
    upload = await asyncio.to_thread(begin)
    slot.release()  # bytes come as slowly as `MinimumRate` lets them
    upload = await uploads.receive(upload, 0, _body(request), announced=_declared(request), checksum=checksum)
    return await _after(uploads, upload, 201)


@router.head(
    "/uploads/{upload_id}",
    status_code=200,
    response_class=Response,
    responses=problems(UploadNotFound, UnknownTusVersion, UploadBusy),
)
def see_upload(upload_id: UUID, runtime: CurrentRuntime, actor: UploadsActor, tus_resumable: Tus = None) -> Response:
    """Return the offset of an upload."""
    _ensure_tus(tus_resumable)
    uploads = _uploads(runtime)
    return _standing(uploads, uploads.find(upload_id, owner_id=service.uploader(actor)), 200)


@router.patch(
    "/uploads/{upload_id}",
    status_code=204,
    response_class=Response,
    openapi_extra=BINARY_BODY,
    responses=problems(
        BadUploadHeader, ChecksumMismatch, OffsetMismatch, SentInParts, StoreFull, StoreUnavailable,
        UnknownTusVersion, UploadBusy, UploadNotFound, UploadStalled, UploadTooLong, WrongContentType,
    ),
)  # fmt: skip
@accepts_body(MAX_ARCHIVE_BYTES, streamed=True)
async def continue_upload(
    upload_id: UUID,
    request: Request,
    slot: UploadSlot,
    runtime: CurrentRuntime,
    actor: UploadsActor,
    tus_resumable: Tus = None,
    upload_offset: Annotated[str | None, Header(description="How many bytes are here already.")] = None,
    upload_checksum: Annotated[
        str | None, Header(description="`sha256` or `sha1`, a space, the digest in Base64.")
    ] = None,
) -> Response:
    """Append bytes to an upload, and answer once they are on the disk."""
    _ensure_tus(tus_resumable)
    if request.headers.get("content-type") != BODY_TYPE:
        raise WrongContentType(f"the bytes of an upload come as {BODY_TYPE}")
    offset = number_of_bytes("Upload-Offset", upload_offset)
    checksum = checksum_of(upload_checksum)
    uploads = _uploads(runtime)
    upload = await asyncio.to_thread(lambda: _own(runtime, actor, upload_id))
    slot.release()
    upload = await uploads.receive(upload, offset, _body(request), announced=_declared(request), checksum=checksum)
    return await _after(uploads, upload, 204)


@router.delete(
    "/uploads/{upload_id}",
    status_code=204,
    response_class=Response,
    responses=problems(UploadNotFound, UnknownTusVersion, UploadBusy),
)
def cancel_upload(upload_id: UUID, runtime: CurrentRuntime, actor: UploadsActor, tus_resumable: Tus = None) -> Response:
    """Delete an unfinished upload."""
    _ensure_tus(tus_resumable)
    uploads = _uploads(runtime)
    uploads.give_up(uploads.find(upload_id, owner_id=service.uploader(actor)))
    return Response(status_code=204)


@router.post(
    "/uploads/{upload_id}/parts",
    response_model=PartsRead,
    responses=problems(UploadNotFound, PartsNotTaken, PartUnknown, StoreUnavailable),
)
def request_parts(upload_id: UUID, body: PartsAsk, runtime: CurrentRuntime, actor: UploadsActor) -> PartsRead:
    """Return the parts of a file in the store, and signed links for others."""
    sha256s = {part.number: bytes.fromhex(part.sha256) for part in body.parts}
    access = _uploads(runtime).parts(_own(runtime, actor, upload_id), sha256s)
    return PartsRead.model_validate(access)


@router.post(
    "/uploads/{upload_id}/finish",
    response_model=UploadRead,
    responses=problems(ChecksumMismatch, StoreUnavailable, UploadBusy, UploadNotFound, UploadUnfinished),
)
def finish_parts(upload_id: UUID, runtime: CurrentRuntime, actor: UploadsActor) -> UploadRead:
    """Finish a file whose parts are all in the store: it is read and hashed there, whatever its sender claims."""
    upload = _uploads(runtime).finish_parts(_own(runtime, actor, upload_id))
    return _upload_read(upload)


@router.put(
    "/uploads",
    status_code=201,
    response_model=UploadRead,
    openapi_extra={
        "requestBody": {"content": {"application/octet-stream": {"schema": {"type": "string", "format": "binary"}}}}
    },
    responses=problems(
        BadUploadHeader, ChecksumMismatch, DeliveryClosed, DeliveryNotFound, DesignerNeeded, InHouseDesignerNeeded,
        LengthRequired, StoreFull, UploadIncomplete, UploadStalled, UploadTooLong,
    ),
)  # fmt: skip
@accepts_body(MAX_ARCHIVE_BYTES, streamed=True)
async def put_upload(
    request: Request,
    slot: UploadSlot,
    runtime: CurrentRuntime,
    actor: UploadsActor,
    delivery_id: UUID,
    file_name: Annotated[str, Query(min_length=1, max_length=100_000)],
    take_id: Annotated[UUID | None, Query(description="Of the take that a dry stem is for.")] = None,
    repr_digest: Annotated[str | None, Header(description="RFC 9530, `sha-256=:…:`")] = None,
    x_content_sha256: Annotated[str | None, Header(description="The file's SHA-256 in hex.")] = None,
) -> UploadRead:
    """Take a whole file in one request: all of it, or nothing."""
    length = _declared(request)
    if length is None:
        raise LengthRequired("say how long the file is: Content-Length is missing")
    expected = sha256_in_hex(x_content_sha256) or sha256_of_digest(repr_digest)
    uploads = _uploads(runtime)
    upload = await asyncio.to_thread(
        _permitted, runtime, actor, Destination(delivery_id, take_id), file_name, length, expected
    )
    slot.release()
    try:
        upload = await uploads.receive(upload, 0, _body(request), announced=length)
        if upload.sha256 is None:
            raise UploadIncomplete(f"fewer than the announced {length} bytes came; send the file again")
    except BaseException:  # its sender does not know its id, so it could not be resumed
        await asyncio.to_thread(uploads.give_up, upload)
        raise
    return _upload_read(upload)


def _upload_read(upload: Upload) -> UploadRead:
    return UploadRead(upload_id=upload.id, offset=upload.length, length=upload.length, sha256=upload.sha256)


async def _body(request: Request) -> AsyncIterator[bytes]:
    """Yield the body as it comes; a dropped line is the sender's, and no fault of ours."""
    try:
        async for chunk in request.stream():
            yield chunk
    except ClientDisconnect:
        raise UploadIncomplete("the connection was lost before the file was complete") from None


def _uploads(runtime: Runtime) -> Uploads:
    settings = runtime.settings
    pace = MinimumRate(settings.upload_min_rate, settings.upload_window_s)
    return Uploads(runtime.database, runtime.store, reserve_bytes=settings.disk_reserve, pace=pace)


def _permitted(
    runtime: Runtime,
    actor: Actor,
    destination: Destination,
    file_name: str,
    length: int,
    expected_sha256: str | None,
) -> Upload:
    """Make room for a file, once it is certain that the caller may send it there."""
    if not file_name:
        raise BadUploadHeader("the upload has no file_name")
    with runtime.database.reading(actor.reach) as session:
        studio_id = ensure_may_send(session, actor, destination, length)
    return _uploads(runtime).create(
        studio_id=studio_id,
        owner_id=service.uploader(actor),
        scope=destination.scope,
        file_name=stored_name(file_name),
        length=length,
        max_length=destination.most_bytes(file_name, runtime.settings.reference_max_bytes),
        expected_sha256=expected_sha256,
    )


def _own(runtime: Runtime, actor: Actor, upload_id: UUID) -> Upload:
    """Return the caller's upload while they still may send to where it goes."""
    upload = _uploads(runtime).find(upload_id, owner_id=service.uploader(actor))
    with runtime.database.reading(actor.reach) as session:
        ensure_may_continue(session, actor, upload.scope)
    return upload


def _standing(uploads: Uploads, upload: Upload, status: int) -> Response:
    """Answer with the upload's offset."""
    headers = {"Upload-Offset": str(uploads.offset(upload)), "Upload-Length": str(upload.length)}
    if (expires_at := uploads.expires_at(upload)) is not None:
        headers["Upload-Expires"] = format_datetime(expires_at, usegmt=True)
    if status == 201:
        headers["Location"] = f"/v1/uploads/{upload.id}"
    return Response(status_code=status, headers=headers)


async def _after(uploads: Uploads, upload: Upload, status: int) -> Response:
    """Answer with where the upload stands after bytes came; a thread is sent only where its file is to be asked."""
    if upload.sha256 is not None:
        return _standing(uploads, upload, status)
    return await asyncio.to_thread(_standing, uploads, upload, status)


def _ensure_tus(version: str | None) -> None:
    if version != TUS_VERSION:
        raise UnknownTusVersion(f"Tus-Resumable is {version or 'missing'}; this server supports {TUS_VERSION}")


def _declared(request: Request) -> int | None:
    value = request.headers.get("content-length")
    return None if value is None else number_of_bytes("Content-Length", value)
