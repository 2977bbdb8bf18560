"""The endpoints of this room."""

from typing import Annotated
from uuid import UUID

from fastapi import APIRouter, Query

from app.accounts.errors import MemberNotFound, OperatorNeeded, ProducerNeeded, StudioNotFound
from app.accounts.rules import Actor, Audience, Role
from app.accounts.web.policies import allows
from app.core.web.health import WORKER_SILENT_AFTER
from app.core.web.http import BadCursor, CurrentRuntime, DbSession, Page, problems
from app.operations import departures, quotas, service
from app.operations.errors import JobNotFound, JobNotParked
from app.operations.schemas import (
    DepartureItem,
    JobRead,
    JobState,
    QuotaRead,
    ServerOperations,
    ServerStorage,
    StorageRead,
    StudioOperations,
    StudioQuotas,
)

router = APIRouter(prefix="/v1", tags=["operations"])


@router.get("/studios/{studio_id}/operations", responses=problems(StudioNotFound, ProducerNeeded))
def read_studio_operations(
    studio_id: UUID, session: DbSession, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> StudioOperations:
    """Return the numbers of the studio's jobs that wait, run or failed, and whether a worker is running."""
    return service.studio_operations(session, actor, studio_id, queue=runtime.queue, alive_within=WORKER_SILENT_AFTER)


@router.get(
    "/studios/{studio_id}/people/{person_id}/departure",
    responses=problems(StudioNotFound, ProducerNeeded, MemberNotFound),
)
def read_departure(
    studio_id: UUID,
    person_id: UUID,
    session: DbSession,
    roles: Annotated[
        list[Role], Query(default_factory=list, description="The roles that the member keeps; none: they leave.")
    ],
    actor: Actor = allows(Audience.PRODUCER),
) -> list[DepartureItem]:
    """Return the rights and access that end when a member leaves or changes roles, and those to hand over first."""
    return departures.departure(session, actor, studio_id, person_id, roles)


@router.get("/studios/{studio_id}/storage", responses=problems(StudioNotFound, ProducerNeeded))
def read_studio_storage(studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)) -> StorageRead:
    """Return the storage of the studio."""
    return service.studio_storage(session, actor, studio_id)


@router.get("/studios/{studio_id}/jobs", responses=problems(StudioNotFound, ProducerNeeded, BadCursor))
def list_studio_jobs(
    studio_id: UUID,
    session: DbSession,
    runtime: CurrentRuntime,
    state: JobState | None = None,
    cursor: str | None = None,
    actor: Actor = allows(Audience.PRODUCER),
) -> Page[JobRead]:
    """Return the studio's jobs that wait, run or gave up, the oldest first."""
    return service.studio_jobs(session, actor, studio_id, queue=runtime.queue, state=state, cursor=cursor)


@router.post(
    "/studios/{studio_id}/jobs/{job_id}/retry",
    responses=problems(StudioNotFound, ProducerNeeded, JobNotFound, JobNotParked),
)
def retry_studio_job(
    studio_id: UUID, job_id: str, runtime: CurrentRuntime, actor: Actor = allows(Audience.PRODUCER)
) -> JobRead:
    """Let a job of the studio run again that gave up."""
    with runtime.database.reading(actor.reach) as session:
        job = service.parked_studio_job(session, actor, studio_id, job_id, queue=runtime.queue)
    return service.retry(runtime.queue, job)


@router.get("/operations", responses=problems(OperatorNeeded))
def read_operations(
    session: DbSession, runtime: CurrentRuntime, _actor: Actor = allows(Audience.OPERATOR)
) -> ServerOperations:
    """Return the whole server's jobs and workers."""
    return service.server_operations(
        session,
        queue=runtime.queue,
        alive_within=WORKER_SILENT_AFTER,
    )


@router.get("/studios/{studio_id}/quotas", responses=problems(StudioNotFound, ProducerNeeded))
def read_studio_quotas(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> list[QuotaRead]:
    """Return a studio's use of its limits."""
    return quotas.studio_quotas(session, actor, studio_id)


@router.get("/operations/quotas", responses=problems(OperatorNeeded, BadCursor))
def read_quotas(
    session: DbSession, cursor: str | None = None, _actor: Actor = allows(Audience.OPERATOR)
) -> Page[StudioQuotas]:
    """Return studios' use of their limits, fifty a page, the nearest to one first."""
    return quotas.server_quotas(session, cursor)


@router.get("/operations/storage", responses=problems(OperatorNeeded))
def read_storage(
    session: DbSession, runtime: CurrentRuntime, _actor: Actor = allows(Audience.OPERATOR)
) -> ServerStorage:
    """Return the storage of every studio."""
    return service.server_storage(session, store=runtime.store)


@router.get("/operations/jobs", responses=problems(OperatorNeeded, BadCursor))
def list_jobs(
    session: DbSession,
    runtime: CurrentRuntime,
    state: JobState | None = None,
    cursor: str | None = None,
    _actor: Actor = allows(Audience.OPERATOR),
) -> Page[JobRead]:
    """Return every job that waits, runs or gave up, the oldest first."""
    return service.server_jobs(session, queue=runtime.queue, state=state, cursor=cursor)


@router.post("/operations/jobs/{job_id}/retry", responses=problems(OperatorNeeded, JobNotFound, JobNotParked))
def retry_job(job_id: str, runtime: CurrentRuntime, actor: Actor = allows(Audience.OPERATOR)) -> JobRead:
    """Let any job run again that gave up."""
    with runtime.database.reading(actor.reach) as session:
        job = service.parked_job(session, job_id, queue=runtime.queue)
    return service.retry(runtime.queue, job)
