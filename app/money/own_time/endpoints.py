"""The endpoints of time without a contract."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems
from app.hiring.errors import PostingNotFound
from app.money.errors import DayInFuture, OwnTimeNotFound, WorkNotNamed
from app.money.own_time import service
from app.money.own_time.schemas import OwnTimeAdd, OwnTimeRead, OwnTimes
from app.projects.errors import ProjectNotFound
from app.sound_lists.errors import CueNotFound

router = APIRouter(prefix="/v1", tags=["money"])


@router.get("/projects/{project_id}/own-time", responses=problems(ProjectNotFound, PostingNotFound))
def list_own_time(
    project_id: UUID,
    session: DbSession,
    posting_id: UUID | None = None,
    actor: Actor = allows(Audience.PROJECT),
) -> OwnTimes:
    """Return the caller's time without a contract, and how long a cue takes them; nobody else sees it."""
    return service.own_times(session, actor, project_id, posting_id=posting_id)


@router.post(
    "/projects/{project_id}/own-time",
    status_code=201,
    responses=problems(ProjectNotFound, PostingNotFound, CueNotFound, DayInFuture, WorkNotNamed),
)
def log_own_time(
    project_id: UUID, body: OwnTimeAdd, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> OwnTimeRead:
    """Note time that went into a cue, a bid or a project without a contract."""
    return service.log_own_time(session, actor, project_id, body)


@router.delete("/own-time/{own_time_id}", status_code=204, responses=problems(OwnTimeNotFound))
def drop_own_time(own_time_id: UUID, session: DbSession, actor: Actor = allows(Audience.PERSON)) -> None:
    """Remove an entry of the caller's."""
    service.drop_own_time(session, actor, own_time_id)
