"""The endpoint that holds the list against the brief."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound
from app.projects.service import project_access
from app.sound_lists.coverage.schemas import CoverageRead
from app.sound_lists.coverage.service import list_coverage

router = APIRouter(prefix="/v1", tags=["sound-lists"])


@router.get("/projects/{project_id}/sound-list/coverage", responses=problems(ProjectNotFound))
def read_coverage(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)) -> CoverageRead:
    """Return the scenes, categories and priority sounds that the brief names and the list lacks."""
    return CoverageRead.model_validate(list_coverage(session, project_access(session, actor, project_id)))
