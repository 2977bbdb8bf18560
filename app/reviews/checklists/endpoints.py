"""The endpoints of checklists, and of what blocks approval."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.deliveries.errors import TakeNotFound
from app.projects.errors import ProducerNeeded, ProjectNotFound, TeamNeeded
from app.reviews.checklists import service as checklists
from app.reviews.checklists.schemas import ApprovalBlockersSet, ApprovalSettingsRead, ChecklistSet, ItemCheckSet
from app.reviews.errors import ChecklistInvalid, ChecklistItemNotFound, TooManyChecklists

router = APIRouter(prefix="/v1", tags=["reviews"])


@router.get("/projects/{project_id}/approval-settings", responses=problems(ProjectNotFound, TeamNeeded))
def get_approval_settings(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> ApprovalSettingsRead:
    """Return the checklists of a project, and what blocks approval there."""
    return checklists.approval_settings(session, actor, project_id)


@router.put(
    "/projects/{project_id}/checklist",
    responses=problems(ProjectNotFound, ProducerNeeded, ChecklistInvalid, TooManyChecklists),
)
def set_checklist(
    project_id: UUID, body: ChecklistSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> ApprovalSettingsRead:
    """Write the checklist for the versions of one category, or of every cue."""
    return checklists.set_checklist(session, actor, project_id, category=body.category, items=body.items)


@router.put("/projects/{project_id}/approval-blockers", responses=problems(ProjectNotFound, ProducerNeeded))
def set_approval_blockers(
    project_id: UUID, body: ApprovalBlockersSet, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> ApprovalSettingsRead:
    """Set the things to close before a version is approved: notes, items of the checklist, both or nothing."""
    return checklists.set_blockers(session, actor, project_id, body.blockers)


@router.put(
    "/takes/{take_id}/checklist/{checklist_item_id}",
    status_code=204,
    responses=problems(TakeNotFound, TeamNeeded, ChecklistItemNotFound),
)
def check_item(
    take_id: UUID,
    checklist_item_id: UUID,
    body: ItemCheckSet,
    session: DbSession,
    actor: Actor = allows(Audience.TEAM),
) -> None:
    """Check an item of the checklist for a version, or take that back."""
    checklists.check_item(session, actor, take_id, checklist_item_id, is_checked=body.is_checked)
