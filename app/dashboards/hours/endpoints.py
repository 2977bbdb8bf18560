"""The endpoint of hours."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.dashboards.hours.schemas import ProjectHours
from app.dashboards.hours.service import project_hours
from app.projects.errors import ProducerNeeded, ProjectNotFound, TeamNeeded

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get("/projects/{project_id}/hours", responses=problems(ProjectNotFound, TeamNeeded, ProducerNeeded))
def read_project_hours(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> ProjectHours:
    """Return hours wanted, done and there, by designer, week and category; cues without an estimate are counted."""
    return project_hours(session, actor, project_id)
