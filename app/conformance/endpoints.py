"""The endpoints of this room."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.endpoints import allows
from app.accounts.rules import Actor, Sight
from app.conformance import service
from app.conformance.errors import CheckNotFound, NothingToWaive
from app.conformance.schemas import CheckRead, WaiverAdd
from app.deliveries.errors import TakeNotFound, WrongState
from app.deliveries.schemas import TakeRead
from app.deliveries.service import read_take, take_for
from app.kit.http import DbSession, Route, problems
from app.projects.errors import DeciderNeeded

router = APIRouter(prefix="/v1", tags=["conformance"], route_class=Route)


@router.get("/takes/{take_id}/check", response_model=CheckRead, responses=problems(TakeNotFound, CheckNotFound))
def see_check(take_id: UUID, session: DbSession, actor: Actor = allows(Sight.PROJECT)) -> CheckRead:
    """Show what the newest check says of a take."""
    return service.check_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/waiver",
    status_code=201,
    response_model=CheckRead,
    responses=problems(TakeNotFound, DeciderNeeded, NothingToWaive),
)
def waive_findings(
    take_id: UUID, body: WaiverAdd, session: DbSession, actor: Actor = allows(Sight.DECIDER)
) -> CheckRead:
    """Let a returned take through with its findings, for a reason."""
    return service.waive(session, actor, take_id, body.reason)


@router.post(
    "/takes/{take_id}/recheck",
    status_code=202,
    response_model=TakeRead,
    responses=problems(TakeNotFound, WrongState),
)
def recheck_take(take_id: UUID, session: DbSession, actor: Actor = allows(Sight.PROJECT)) -> TakeRead:
    """Have a take that is not decided upon checked again."""
    take = service.recheck(session, actor, take_id)
    _, standing = take_for(session, actor, take_id)
    return read_take(session, standing.project, take)
