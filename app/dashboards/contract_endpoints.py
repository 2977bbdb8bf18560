"""Endpoints that join contracts, money and hiring with a project."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.dashboards import money, schemas
from app.dashboards.studio_record.schemas import StudioRecord
from app.dashboards.studio_record.service import studio_record
from app.dashboards.track_record.schemas import WorkFigures
from app.dashboards.track_record.service import work_of_entry
from app.hiring.errors import PostingNotFound, RosterEntryNotFound
from app.money.errors import MilestoneNotFound
from app.projects.errors import ProjectNotFound, TeamNeeded

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/roster/{roster_entry_id}/work", responses=problems(RosterEntryNotFound, TeamNeeded))
def read_roster_work(
    roster_entry_id: UUID, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> WorkFigures | None:
    """Return the facts known of a designer on file from work for this studio; null where there was none."""
    return work_of_entry(session, actor, roster_entry_id)


@router.get("/postings/{posting_id}/studio-record", responses=problems(PostingNotFound, TeamNeeded))
def read_studio_record(posting_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> StudioRecord:
    """Return the record of a posting's studio with its designers so far, to its team and to candidates."""
    return studio_record(session, actor, posting_id)


@router.get("/projects/{project_id}/money", responses=problems(ProjectNotFound, TeamNeeded))
def read_project_money(
    project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.ProjectMoney:
    """Return the money of a project; a designer sees that of their own contracts."""
    return money.project_money(session, actor, project_id)


@router.get("/milestones/{milestone_id}", responses=problems(MilestoneNotFound))
def read_milestone(
    milestone_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> schemas.MilestoneSheet:
    """Return a milestone with its cues, how late it is, its estimates and its money."""
    return money.milestone_sheet(session, actor, milestone_id)
