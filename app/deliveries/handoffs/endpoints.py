"""The endpoints of hand-offs."""

from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.storage import BlobMissing
from app.core.web.downloads import downloads
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.deliveries.errors import (
    DownloadUnpaid,
    HandoffNotFound,
    MasterDeleted,
    NextMakerUnknown,
    NothingToHandOff,
    SourceFileNotFound,
    TakeNotFound,
)
from app.deliveries.handoffs import service
from app.deliveries.schemas import HandoffAdd, HandoffRead, NextMaker
from app.deliveries.web.stored_files import stored_file_response
from app.projects.errors import ProducerNeeded
from app.sound_lists.errors import CueNotFound

router = APIRouter()


@router.get("/cues/{cue_id}/handoffs", response_model=list[HandoffRead], responses=problems(CueNotFound))
def list_handoffs(cue_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> list[HandoffRead]:
    """List the hand-offs of a cue between makers, the newest first; a designer's from or to them."""
    return service.list_handoffs(session, actor, cue_id)


@router.post(
    "/cues/{cue_id}/handoffs",
    status_code=201,
    response_model=HandoffRead,
    responses=problems(CueNotFound, ProducerNeeded, NothingToHandOff),
)
def hand_off_cue(
    cue_id: UUID, body: HandoffAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> HandoffRead:
    """Hand off a cue with what is done and what is missing, as its maker or for one as a producer."""
    return service.hand_off(session, actor, cue_id, body)


@router.put(
    "/handoffs/{handoff_id}/next-maker",
    response_model=HandoffRead,
    responses=problems(HandoffNotFound, ProducerNeeded, NextMakerUnknown),
)
def name_next_maker(
    handoff_id: UUID, body: NextMaker, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> HandoffRead:
    """Name the designer who continues a cue; they see the hand-off with its versions from then on."""
    return service.name_next_maker(session, actor, handoff_id, body.designer_id)


@router.get(
    "/handoffs/{handoff_id}/takes/{take_id}/master",
    **downloads("application/octet-stream", HandoffNotFound, TakeNotFound, DownloadUnpaid, MasterDeleted, BlobMissing),
)
def download_handed_master(
    handoff_id: UUID,
    take_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Give the master of a take in a hand-off exactly as it was delivered; ranges may be asked for."""
    take = service.handed_take(session, actor, handoff_id, take_id)
    return stored_file_response(request, runtime, take.studio_id, take.master_sha256, take.file_name)


@router.get(
    "/handoffs/{handoff_id}/source-files/{source_file_id}",
    **downloads("application/octet-stream", SourceFileNotFound, DownloadUnpaid, BlobMissing),
)
def download_handed_source_file(
    handoff_id: UUID,
    source_file_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PROJECT),
) -> Response:
    """Give a source file of a hand-off exactly as it was delivered; ranges may be asked for."""
    file = service.handed_source_file(session, actor, handoff_id, source_file_id)
    return stored_file_response(request, runtime, file.studio_id, file.sha256, file.file_name)
