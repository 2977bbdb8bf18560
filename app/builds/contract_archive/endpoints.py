"""The endpoints of handovers: what has no designer now, and the pack for the next one."""

from uuid import UUID

from fastapi import APIRouter, Request
from fastapi.responses import StreamingResponse

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.accounts.web.recorded_downloads import record_download
from app.agreements.errors import ContractNotFound, SamePersonOnBothSides
from app.builds.contract_archive.service import handover_pack, open_handovers
from app.builds.endpoints import BINARY, stream_zip
from app.builds.errors import BlobDamaged, ContractNotEnded
from app.builds.schemas import OpenHandover
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.projects.errors import ProducerNeeded, ProjectNotFound

router = APIRouter(prefix="/v1", tags=["builds"])


@router.get(
    "/contracts/{contract_id}/handover",
    response_class=StreamingResponse,
    responses={
        **problems(ContractNotFound, ProducerNeeded, SamePersonOnBothSides, ContractNotEnded, BlobDamaged),
        200: {"content": {"application/zip": BINARY}},
    },
)
def download_handover(
    contract_id: UUID,
    request: Request,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PRODUCER),
) -> StreamingResponse:
    """Stream the handover of an ended contract to the next designer: approved masters, cues, brief, open rounds."""
    project, name, entries = handover_pack(session, runtime.store, actor, contract_id)
    record_download(request, session, actor, project.studio_id, project.id, name)
    return stream_zip(name, entries)


@router.get("/projects/{project_id}/handovers", responses=problems(ProjectNotFound, ProducerNeeded))
def list_handovers(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> list[OpenHandover]:
    """Return the ended contracts whose cues have no designer now, the newest first."""
    return open_handovers(session, actor, project_id)
