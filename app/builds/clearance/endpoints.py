"""The endpoints of clearance sheets."""

from uuid import UUID

from fastapi import APIRouter, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.builds.clearance import service as clearance
from app.builds.clearance.sheet import clearance_pdf, clearance_xlsx
from app.builds.endpoints import PDFS, XLSX, Target
from app.builds.errors import PackNotFound, PackNotSealed
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession
from app.core.web.per_user_limit import TooManyAtOnce
from app.projects.errors import ProducerNeeded, ProjectNotFound, TeamNeeded
from app.renders.errors import TargetUnknown

router = APIRouter(prefix="/v1", tags=["builds"])
PDF_FAILS = (DocumentTooLarge, TypesettingBusy, TooManyAtOnce)


@router.get(
    "/projects/{project_id}/clearance-sheet.xlsx",
    **downloads(XLSX, ProjectNotFound, ProducerNeeded, TargetUnknown),
)
def get_clearance_sheet_xlsx(
    project_id: UUID, session: DbSession, target: Target = None, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return the maker, sources and contract of each sound of the pack, as a workbook."""
    _, rows = clearance.clearance_of_project(session, actor, project_id, target)
    return _file(clearance_xlsx(rows), XLSX, "xlsx")


@router.get(
    "/projects/{project_id}/clearance-sheet.pdf",
    **downloads("application/pdf", ProjectNotFound, ProducerNeeded, TargetUnknown, *PDF_FAILS),
)
def get_clearance_sheet_pdf(
    project_id: UUID, session: DbSession, target: Target = None, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return the maker, sources and contract of each sound of the pack, to read and to print."""
    title, rows = clearance.clearance_of_project(session, actor, project_id, target)
    with PDFS.of(actor.person):
        return _file(clearance_pdf(rows, title=title), "application/pdf", "pdf")


@router.get(
    "/packs/{pack_id}/clearance-sheet.xlsx",
    **downloads(XLSX, PackNotFound, TeamNeeded, ProducerNeeded, PackNotSealed),
)
def get_pack_clearance_sheet_xlsx(
    pack_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return the clearance sheet of a sealed pack as a workbook."""
    _, rows = clearance.clearance_of_pack(session, actor, pack_id)
    return _file(clearance_xlsx(rows), XLSX, "xlsx")


@router.get(
    "/packs/{pack_id}/clearance-sheet.pdf",
    **downloads("application/pdf", PackNotFound, TeamNeeded, ProducerNeeded, PackNotSealed, *PDF_FAILS),
)
def get_pack_clearance_sheet_pdf(
    pack_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> Response:
    """Return the clearance sheet of a sealed pack, to read and to print."""
    title, rows = clearance.clearance_of_pack(session, actor, pack_id)
    with PDFS.of(actor.person):
        return _file(clearance_pdf(rows, title=title), "application/pdf", "pdf")


def _file(content: bytes, media_type: str, ending: str) -> Response:
    return file_response(content, media_type, f"clearance-sheet.{ending}")
