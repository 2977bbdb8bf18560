"""Jobs by state, storage and workers. A producer sees those of their studio, an operator those of the server."""

from collections.abc import Mapping, Sequence
from datetime import timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.core.db import bypass_row_policies
from app.core.jobs.queue import FairnessPartition, JobCount, JobQueue, UnfinishedJob
from app.core.storage import Store
from app.core.web.bodies import LARGEST_INTEGER
from app.core.web.http import Page, bad_cursor, number_in
from app.operations import queries
from app.operations.errors import JobNotFound, JobNotParked
from app.operations.models import Scrub
from app.operations.schemas import (
    JobCountRead,
    JobRead,
    JobState,
    LaneRead,
    ScrubRead,
    ServerOperations,
    ServerStorage,
    StorageRead,
    StudioOperations,
    Urgency,
    WorkerRead,
)
from app.operations.scrubbing import queries as blob_queries

WORKERS_SHOWN = timedelta(hours=1)
LANES_SHOWN = 50
PAGE_JOBS = 50


def studio_operations(
    session: Session, actor: Actor, studio_id: UUID, *, queue: JobQueue, alive_within: timedelta
) -> StudioOperations:
    """Return a studio's jobs to its producer."""
    studio = ensure_producer_of(session, actor, studio_id)
    return StudioOperations(
        counts=_counts_read(queue.counts(studio_id)),
        lanes=_lanes_read(queue.lanes(studio_id), {studio_id: studio.name}),
        workers=len(queue.heartbeats(within=alive_within)),
    )


def studio_storage(session: Session, actor: Actor, studio_id: UUID) -> StorageRead:
    """Return a studio's storage to its producer."""
    ensure_producer_of(session, actor, studio_id)
    with bypass_row_policies(
        session
    ):  # sums over the whole studio; asked of each row, policies would cost more than they
        (storage,) = queries.storage(session, studio_id)
    return storage


def studio_jobs(
    session: Session, actor: Actor, studio_id: UUID, *, queue: JobQueue, state: JobState | None, cursor: str | None
) -> Page[JobRead]:
    """Return a studio's unfinished jobs to its producer, the oldest first."""
    studio = ensure_producer_of(session, actor, studio_id)
    jobs, following = _page(queue, studio_id, state, cursor)
    return Page(items=[_job_read(job, studio.name, whole=False) for job in jobs], next=following)


def parked_studio_job(session: Session, actor: Actor, studio_id: UUID, job_id: str, *, queue: JobQueue) -> JobRead:
    """Return a job of a studio that gave up, for its producer to try again."""
    studio = ensure_producer_of(session, actor, studio_id)
    return _job_read(_parked(queue, job_id, studio_id), studio.name, whole=False)


def server_operations(session: Session, *, queue: JobQueue, alive_within: timedelta) -> ServerOperations:
    """Return the whole server's jobs and workers to its operator."""
    lanes, running_jobs_by_worker = queue.lanes()[:LANES_SHOWN], queue.running_jobs_by_worker()
    alive = {beat.worker_id for beat in queue.heartbeats(within=alive_within)}
    return ServerOperations(
        counts=_counts_read(queue.counts()),
        lanes=_lanes_read(lanes, _names_of(session, lanes)),
        workers=[
            WorkerRead(
                id=beat.worker_id,
                beat_at=beat.beat_at,
                is_alive=beat.worker_id in alive,
                running=running_jobs_by_worker.get(beat.worker_id, 0),
            )
            for beat in queue.heartbeats(within=WORKERS_SHOWN)
        ],
    )


def server_storage(session: Session, *, store: Store) -> ServerStorage:
    """Return every studio's storage to the operator."""
    with bypass_row_policies(session):  # sums over every studio, and no row of any
        storage, scrub = queries.storage(session), blob_queries.newest_scrub(session)
    return ServerStorage(studios=storage, free_bytes=store.free_bytes(), scrub=scrub and _scrub_read(scrub))


def server_jobs(
    session: Session,
    *,
    queue: JobQueue,
    state: JobState | None,
    cursor: str | None,
) -> Page[JobRead]:
    """Return every unfinished job to the operator, the oldest first."""
    jobs, following = _page(queue, None, state, cursor)
    names = _names_of(session, jobs)
    items = [_job_read(job, names.get(job.studio_id) if job.studio_id else None, whole=True) for job in jobs]
    return Page(items=items, next=following)


def parked_job(session: Session, job_id: str, *, queue: JobQueue) -> JobRead:
    """Return any job that gave up, for the operator to try again."""
    job = _parked(queue, job_id, None)
    return _job_read(job, _names_of(session, [job]).get(job.studio_id) if job.studio_id else None, whole=True)


def retry(queue: JobQueue, job: JobRead) -> JobRead:
    """Let a job that gave up run again; the queue writes for itself, so no session may be open for writing."""
    if not queue.retry(job.id):
        raise JobNotParked("someone else has just restarted this job")
    return job.model_copy(update={"state": JobState.WAITING})


def _names_of(session: Session, works: Sequence[UnfinishedJob | FairnessPartition]) -> dict[UUID, str]:
    with bypass_row_policies(session):  # an operator need not be a member of the studios whose jobs these are
        return queries.studio_names(session, {work.studio_id for work in works if work.studio_id})


def _page(
    queue: JobQueue, studio_id: UUID | None, state: JobState | None, cursor: str | None
) -> tuple[list[UnfinishedJob], str | None]:
    after = None
    if cursor is not None:
        instant_ms, _, job_id = cursor.partition(".")
        if (begun_ms := number_in(instant_ms, LARGEST_INTEGER)) is None or not job_id:
            raise bad_cursor(cursor)
        after = (begun_ms, job_id)
    jobs = queue.unfinished(state=state.value if state else None, studio_id=studio_id, after=after, limit=PAGE_JOBS + 1)
    page = jobs[:PAGE_JOBS]
    return page, page[-1].cursor if len(jobs) > PAGE_JOBS else None


def _parked(queue: JobQueue, job_id: str, studio_id: UUID | None) -> UnfinishedJob:
    job = queue.unfinished_job(job_id)
    if job is None or (studio_id is not None and job.studio_id != studio_id):
        raise JobNotFound(f"no unfinished job {job_id}")
    if job.state != JobState.PARKED:
        raise JobNotParked(f"this job is {job.state}; only a failed job can be tried again")
    return job


def _scrub_read(scrub: Scrub) -> ScrubRead:
    return ScrubRead(
        started_at=scrub.started_at,
        finished_at=scrub.finished_at,
        files=scrub.blobs,
        size_bytes=scrub.size_bytes,
        missing=scrub.missing,
        altered=scrub.altered,
        orphaned=scrub.orphaned,
        orphaned_bytes=scrub.orphaned_bytes,
    )


def _counts_read(counts: Sequence[JobCount]) -> list[JobCountRead]:
    return [
        JobCountRead(job=count.name, state=JobState(count.state), jobs=count.jobs, oldest_at=count.oldest_at)
        for count in counts
    ]


def _lanes_read(lanes: Sequence[FairnessPartition], names: Mapping[UUID, str]) -> list[LaneRead]:
    return [
        LaneRead(
            studio_id=lane.studio_id,
            studio_name=names.get(lane.studio_id) if lane.studio_id else None,
            urgency=Urgency(lane.urgency),
            waiting=lane.waiting,
            running=lane.running,
            delayed=lane.delayed,
            oldest_at=lane.oldest_at,
        )
        for lane in lanes
    ]


def _job_read(job: UnfinishedJob, studio_name: str | None, *, whole: bool) -> JobRead:
    # What follows the kind of a failure may name what is not the studio's: paths, hosts, addresses.
    reason = job.reason if whole or job.reason is None else job.reason.partition(":")[0]
    return JobRead(
        id=job.id,
        job=job.name,
        studio_id=job.studio_id,
        studio_name=studio_name,
        state=JobState(job.state),
        tries=job.tries,
        since=job.since,
        reason=reason,
    )
