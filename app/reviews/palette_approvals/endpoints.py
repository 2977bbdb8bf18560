"""The endpoint of the palette's approval."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ApproverNeeded, ProjectNotFound
from app.reviews.errors import PaletteIncomplete
from app.reviews.models import PaletteApproval
from app.reviews.palette_approvals import service
from app.reviews.palette_approvals.schemas import PaletteApprovalRead

router = APIRouter(prefix="/v1", tags=["reviews"])


@router.post(
    "/projects/{project_id}/palette-approval",
    status_code=201,
    response_model=PaletteApprovalRead,
    responses=problems(ProjectNotFound, ApproverNeeded, PaletteIncomplete),
)
def approve_palette(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.APPROVER)) -> PaletteApproval:
    """Approve the palette as a set, once each of its sounds is accepted; the next phase opens with it."""
    return service.approve_palette(session, actor, project_id)
