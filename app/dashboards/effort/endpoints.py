"""The endpoints of effort and size."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.errors import ContractNotFound
from app.core.web.http import DbSession, problems
from app.dashboards.effort.schemas import Effort, SizeEstimate
from app.dashboards.effort.service import project_effort
from app.dashboards.effort.service import size_estimate as estimated_size
from app.hiring.errors import PostingNotFound
from app.hiring.schemas import Day
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.sound_lists.errors import KitNotFound

router = APIRouter(prefix="/v1", tags=["dashboards"])


@router.get(
    "/projects/{project_id}/effort", responses=problems(ProjectNotFound, PostingNotFound, ContractNotFound, TeamNeeded)
)
def read_effort(
    project_id: UUID,
    session: DbSession,
    posting_id: UUID | None = None,
    contract_id: UUID | None = None,
    begin_on: Day | None = None,
    due_on: Day | None = None,
    weekly_hours: Annotated[float | None, Query(ge=1, le=168)] = None,
    actor: Actor = allows(Audience.TEAM),
) -> Effort:
    """Return hours of the cues of a posting, a contract or the open list, and the days on which they can be done."""
    return project_effort(
        session,
        actor,
        project_id,
        posting_id=posting_id,
        contract_id=contract_id,
        begin_on=begin_on,
        due_on=due_on,
        weekly_hours=weekly_hours,
    )


@router.get("/projects/{project_id}/size-estimate", responses=problems(ProjectNotFound, TeamNeeded, KitNotFound))
def read_size_estimate(
    project_id: UUID,
    session: DbSession,
    kit: Annotated[str | None, Query(max_length=40, examples=["platformer"])] = None,
    actor: Actor = allows(Audience.TEAM),
) -> SizeEstimate:
    """Return the cues and hours that the answers of the brief lead to, by scene and category."""
    return estimated_size(session, actor, project_id, kit_key=kit)
