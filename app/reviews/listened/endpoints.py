"""The endpoint by which a person's browser reports what they have heard."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.reviews.listened.service import record_heard_takes
from app.reviews.schemas import HeardTakes

router = APIRouter(prefix="/v1", tags=["reviews"])


@router.post("/projects/{project_id}/heard-takes", status_code=204, responses=problems(ProjectNotFound, TeamNeeded))
def add_heard_takes(
    project_id: UUID, body: HeardTakes, session: DbSession, actor: Actor = allows(Audience.TEAM)
) -> None:
    """Record the versions that the caller has heard, for the caller alone; ids of other projects are passed over."""
    record_heard_takes(session, actor, project_id, body.take_ids)
