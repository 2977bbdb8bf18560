"""The endpoints of this room."""

from typing import Any
from uuid import UUID

from fastapi import Response

from app.accounts.endpoints import allows
from app.accounts.rules import Actor, Sight
from app.conformance import mends, service
from app.conformance.errors import CheckNotFound, MendNotMade, NothingToMend, NothingToWaive
from app.conformance.schemas import CheckRead, MendOffer, MendRead, WaiverAdd
from app.deliveries.errors import MakerNeeded, TakeNotFound, WrongState
from app.deliveries.schemas import TakeRead
from app.deliveries.service import read_take, take_for
from app.kit.http import DbSession, Route, Router, problems
from app.projects.errors import DeciderNeeded, ProjectNotFound

router = Router(prefix="/v1", tags=["conformance"], route_class=Route)
SAME_TAKE: dict[int | str, dict[str, Any]] = {
    200: {"model": TakeRead, "description": "The mend was used before; this is its take."}
}


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


@router.get("/projects/{project_id}/mends", response_model=list[MendOffer], responses=problems(ProjectNotFound))
def list_mends(project_id: UUID, session: DbSession, actor: Actor = allows(Sight.PROJECT)) -> list[MendOffer]:
    """List the takes of which a mend would be enough, longest waiting first; a designer's own."""
    return mends.mends_offered(session, actor, project_id)


@router.get("/takes/{take_id}/mend", response_model=MendRead, responses=problems(TakeNotFound))
def see_mend(take_id: UUID, session: DbSession, actor: Actor = allows(Sight.PROJECT)) -> MendRead:
    """Show what a mend can do, or did, about a take."""
    return mends.mend_for(session, actor, take_id)


@router.post(
    "/takes/{take_id}/mend",
    status_code=202,
    response_model=MendRead,
    responses=problems(TakeNotFound, MakerNeeded, NothingToMend),
)
def ask_for_mend(take_id: UUID, session: DbSession, actor: Actor = allows(Sight.DESIGNER)) -> MendRead:
    """Have a mended copy made, to see and to hear before it is used."""
    return mends.ask_for_mend(session, actor, take_id)


@router.post(
    "/takes/{take_id}/mend/use",
    status_code=201,
    response_model=TakeRead,
    responses=SAME_TAKE | problems(TakeNotFound, MakerNeeded, NothingToMend, MendNotMade),
)
def use_mend(take_id: UUID, response: Response, session: DbSession, actor: Actor = allows(Sight.DESIGNER)) -> TakeRead:
    """Make the mended copy a new version, with the consent of its designer; no round counts."""
    made, already_here, standing = mends.use_mend(session, actor, take_id)
    response.status_code = 200 if already_here else 201
    return read_take(session, standing.project, made).model_copy(update={"already_here": already_here})
