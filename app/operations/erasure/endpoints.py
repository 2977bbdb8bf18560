"""The endpoints of erasures: a person's own account, a project, a studio."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import NotInDemo, ProducerNeeded, RecentSignInNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.operations.erasure import requests as erasure_requests
from app.operations.errors import ConfirmationMismatch, ErasureRefused
from app.operations.schemas import ErasureRead, ErasureRequest
from app.projects.errors import ProjectNotFound

router = APIRouter(prefix="/v1", tags=["erasure"])


@router.get("/me/erasure")
def read_my_erasure(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> ErasureRead:
    """Return the plan of erasing the caller's account: deleted rows, kept rows with reasons, and obstacles."""
    return erasure_requests.read_my_erasure(session, actor)


@router.post(
    "/me/erasure",
    status_code=204,
    responses=problems(NotInDemo, RecentSignInNeeded, ConfirmationMismatch, ErasureRefused),
)
def erase_me(
    body: ErasureRequest,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PERSON, recent_sign_in=True),
) -> None:
    """Erase the caller's account at once; what law and contracts require stays under a pseudonym."""
    erasure_requests.erase_me(session, actor, body.confirmation, base_url=runtime.settings.base_url)


@router.get("/projects/{project_id}/erasure", responses=problems(ProjectNotFound, ProducerNeeded))
def read_project_erasure(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> ErasureRead:
    """Return the plan of erasing a project: deleted rows, kept rows with reasons, obstacles, and its request."""
    return erasure_requests.read_project_erasure(session, actor, project_id)


@router.post(
    "/projects/{project_id}/erasure",
    responses=problems(ProjectNotFound, ProducerNeeded, RecentSignInNeeded, ConfirmationMismatch, ErasureRefused),
)
def request_project_erasure(
    project_id: UUID,
    body: ErasureRequest,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> ErasureRead:
    """Request that a project be erased after the days of grace; those concerned are mailed."""
    return erasure_requests.request_project_erasure(
        session, actor, project_id, body.confirmation, base_url=runtime.settings.base_url
    )


@router.delete("/projects/{project_id}/erasure", status_code=204, responses=problems(ProjectNotFound, ProducerNeeded))
def cancel_project_erasure(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> None:
    """Cancel the erasure of a project; those concerned are mailed."""
    erasure_requests.cancel_project_erasure(session, actor, project_id)


@router.get("/studios/{studio_id}/erasure", responses=problems(StudioNotFound, ProducerNeeded))
def read_studio_erasure(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> ErasureRead:
    """Return the plan of erasing a studio: deleted rows, kept rows with reasons, obstacles, and its request."""
    return erasure_requests.read_studio_erasure(session, actor, studio_id)


@router.post(
    "/studios/{studio_id}/erasure",
    responses=problems(StudioNotFound, ProducerNeeded, RecentSignInNeeded, ConfirmationMismatch, ErasureRefused),
)
def request_studio_erasure(
    studio_id: UUID,
    body: ErasureRequest,
    session: DbSession,
    runtime: CurrentRuntime,
    actor: Actor = allows(Audience.PRODUCER, recent_sign_in=True),
) -> ErasureRead:
    """Request that a studio be erased with all its projects after the days of grace; those concerned are mailed."""
    return erasure_requests.request_studio_erasure(
        session, actor, studio_id, body.confirmation, base_url=runtime.settings.base_url
    )


@router.delete("/studios/{studio_id}/erasure", status_code=204, responses=problems(StudioNotFound, ProducerNeeded))
def cancel_studio_erasure(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> None:
    """Cancel the erasure of a studio; those concerned are mailed."""
    erasure_requests.cancel_studio_erasure(session, actor, studio_id)
