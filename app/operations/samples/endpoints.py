"""The endpoints of the sample project."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import ProducerNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.core.web.http import CurrentRuntime, DbSession, problems
from app.operations.errors import ErasureRefused, NotASample
from app.operations.samples import service
from app.operations.samples.schemas import SampleProjectRead
from app.projects.errors import ProjectNotFound
from app.projects.models import Project

router = APIRouter(prefix="/v1", tags=["projects"])


@router.post(
    "/studios/{studio_id}/sample",
    status_code=201,
    response_model=SampleProjectRead,
    responses=problems(StudioNotFound, ProducerNeeded),
)
def open_sample(
    studio_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> Project:
    """Return the sample project of a studio: 24 cues and a delivery of six sounds, made now where there is none."""
    return service.open_sample(session, actor, studio_id, runtime.store)


@router.delete(
    "/projects/{project_id}/sample",
    status_code=204,
    responses=problems(ProjectNotFound, ProducerNeeded, NotASample, ErasureRefused),
)
def delete_sample(project_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> None:
    """Delete a sample project with everything in it, at once."""
    service.delete_sample(session, actor, project_id)
