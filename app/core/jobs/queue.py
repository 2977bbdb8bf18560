"""Durable jobs: written in the transaction of their row, run at least once by one of any number of workers.

Nothing but this and `workers` imports DBOS, by its public interface alone. Its tables live in the application's own
database.

Order: a job's position in the queue is a number, the lowest first. It is as far behind the head of
the queue, or behind the last job of its own lane (one studio, one urgency), as its urgency costs. So lanes take
turns, urgent ones more often, and a studio with few jobs never waits for all jobs of a studio with many.
"""

from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple
from uuid import UUID

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSClient, DBOSPortableJSONSerializer, EnqueueOptions
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.orm import Mapped, Session, mapped_column

from app import logs
from app.core import clock
from app.core.db import Base, Database, bypass_row_policies

if TYPE_CHECKING:
    from app.core.runtime import Runtime

JOB_QUEUE = "jobs"
QUEUE = "queue"  # key in a session's info: the queue of the database that it is on
# Changes only when a job's steps change incompatibly: DBOS resumes only jobs of the version it runs.
STEPS_VERSION = "1"
CLIENT_CONNECTIONS = 1  # to park and to resume jobs; what is enqueued is written on the caller's connection
APPLICATION = "soundlist"
RUN_JOB = "soundlist.run_job"
SERIALIZER = DBOSPortableJSONSerializer()  # the arguments of a job are stored as JSON
RETRY_DELAYS_S = (1.0, 10.0, 60.0, 300.0, 900.0)  # between the attempts at a job that fails; then it is parked
URGENT, NORMAL, BULK = 1, 10, 100  # what a job costs its lane: ten urgent ones get the turns of one normal one
URGENCY_WORDS = {URGENT: "urgent", NORMAL: "normal", BULK: "bulk"}
NOBODY = "nobody"  # in place of a studio
LAST_PLACE = 2**31 - 1
MAX_RECOVERIES = 5  # a job that loses its worker so often is parked
OPEN_STATES = ["ENQUEUED", "PENDING", "DELAYED"]
FAILED_STATES = ["ERROR", "CANCELLED", "MAX_RECOVERY_ATTEMPTS_EXCEEDED"]
INDEXED_CONDITIONS = {  # conditions of DBOS's partial indexes, and the states that each is for
    "status in ('ENQUEUED', 'PENDING')": ("ENQUEUED", "PENDING"),
    "status = 'DELAYED'": ("DELAYED",),
    "status in ('ERROR', 'CANCELLED', 'MAX_RECOVERY_ATTEMPTS_EXCEEDED')": FAILED_STATES,
}
STATE_WORDS = {
    "ENQUEUED": "waiting",
    "DELAYED": "delayed",
    "PENDING": "running",
    "CANCELLED": "parked",
    "MAX_RECOVERY_ATTEMPTS_EXCEEDED": "parked",
    "ERROR": "broken",  # none of ours ends so: what fails is tried again, then parked
}

Payload = dict[str, Any]
REASON_LENGTH = 500
DELETED_PER_BATCH = 500
ATTEMPT_MARK = "~"
Handler = Callable[["Runtime", Payload], None]
_handlers: dict[str, Handler] = {}
log = structlog.get_logger(__name__)


class Heartbeat(Base):
    """The last heartbeat of a worker process."""

    __tablename__ = "core_heartbeats"

    worker_id: Mapped[str] = mapped_column(primary_key=True)
    beat_at: Mapped[datetime]


def job(name: str) -> Callable[[Handler], Handler]:
    """Register a function as the job of that name (`room.verb_noun`)."""

    def register(handler: Handler) -> Handler:
        if name in _handlers:
            raise ValueError(f"two jobs are called {name}")
        _handlers[name] = handler
        return handler

    return register


def handler_of(name: str) -> Handler:
    """Return the function that was registered as the job of that name."""
    return _handlers[name]


def job_names() -> frozenset[str]:
    """Return the names of the jobs that this process can run."""
    return frozenset(_handlers)


@dataclass(frozen=True)
class UnfinishedJob:
    """A job that waits, runs or is parked, and its last failure, if any."""

    id: str
    name: str
    studio_id: UUID | None
    state: str
    tries: int
    since: datetime
    reason: str | None
    cursor: str  # where a list continues after it


@dataclass(frozen=True)
class JobCount:
    """The number of jobs of one name in one state, and the time of the oldest."""

    name: str
    state: str
    jobs: int
    oldest_at: datetime


@dataclass(frozen=True)
class FairnessPartition:
    """The jobs of one studio and one urgency, which take turns with those of every other lane."""

    studio_id: UUID | None
    urgency: str
    waiting: int = 0
    running: int = 0
    delayed: int = 0
    oldest_at: datetime | None = None  # of those that wait


class Work(NamedTuple):
    """The arguments of a job as they are stored."""

    name: str
    payload: Payload
    cause: logs.Cause
    lane: str
    attempt: int = 1


class JobQueue:
    """Writes jobs into the caller's transaction; needs no running worker."""

    def __init__(self, database: Database) -> None:
        self._database = database
        database.session_info[QUEUE] = self
        self._workflows = workflows(is_sqlite=database.is_sqlite)
        self._client = DBOSClient(
            system_database_url=system_url(database),
            application_name=APPLICATION,
            serializer=SERIALIZER,
            system_database_pool_size=CLIENT_CONNECTIONS,
            lazy=True,
            retry_connection_errors=False,
        )

    def enqueue(
        self,
        session: Session,
        name: str,
        payload: Payload,
        *,
        key: str,
        studio_id: UUID | None,
        priority: int = NORMAL,
        delay_s: float = 0,
    ) -> None:
        """Write one job, to be run after the delay; a second with the same key is the same job."""
        lane = f"{studio_id or NOBODY}:{priority}"
        self._write(session, key, Work(name, payload, logs.cause(), lane), delay_s=delay_s)

    def _write(self, session: Session, key: str, work: Work, *, delay_s: float = 0, reason: str | None = None) -> None:
        studio, _, cost = work.lane.partition(":")
        options: EnqueueOptions = {
            "workflow_name": RUN_JOB,
            "queue_name": JOB_QUEUE,
            "workflow_id": key,
            "app_version": STEPS_VERSION,
            "queue_partition_key": work.lane,
            "attributes": {"job": work.name, "studio": None if studio == NOBODY else studio, "reason": reason},
        }
        with bypass_row_policies(session):  # the jobs are the server's own
            if delay_s:
                options["delay_seconds"] = delay_s
                options["priority"] = int(cost)  # has waited: at the head, once it is due
            else:
                options["priority"] = self._next_priority(session, work.lane, int(cost))
            self._client.enqueue_in_transaction(session, options, *work)

    def _next_priority(self, session: Session, lane: str, cost: int) -> int:
        """Return the place in the line of the next job of a lane."""
        ahead = session.connection().execute(self._ahead, {"lane": lane}).one()
        return min(max(priority or 0 for priority in ahead) + cost, LAST_PLACE)

    @cached_property
    def _ahead(self) -> sa.Select[int | None, int | None]:
        """The places of the head of the line and of the last job of a lane: two reads at the ends of indices."""
        jobs = self._workflows
        waiting = sa.select(jobs.c.priority).where(
            jobs.c.queue_name == JOB_QUEUE,
            jobs.c.status == "ENQUEUED",
            sa.literal_column("status in ('ENQUEUED', 'PENDING')"),  # as in the indices
        )
        head = waiting.order_by(jobs.c.priority).limit(1).scalar_subquery()
        last = (
            waiting.where(jobs.c.queue_partition_key == sa.bindparam("lane"))
            .order_by(jobs.c.priority.desc())
            .limit(1)
            .scalar_subquery()
        )
        return sa.select(head, last)

    def schedule_retry(self, job_id: str, work: Work, error: Exception) -> bool:
        """Write the next attempt at a job that failed; return False, and park it, where that was the last."""
        reason = f"{type(error).__name__}: {error}"[:REASON_LENGTH]
        if work.attempt > len(RETRY_DELAYS_S):
            self._client.update_workflow_attributes(job_id, {"reason": reason}, merge=True)
            self._client.cancel_workflow(job_id)  # a cancelled job can be resumed, one in error cannot
            return False
        attempt = work.attempt + 1
        key = f"{job_id.partition(ATTEMPT_MARK)[0]}{ATTEMPT_MARK}{attempt}"
        with self._database.writing() as session:
            self._write(
                session, key, work._replace(attempt=attempt), delay_s=RETRY_DELAYS_S[work.attempt - 1], reason=reason
            )
        return True

    def unfinished(
        self,
        *,
        only_failed: bool = False,
        state: str | None = None,
        studio_id: UUID | None = None,
        after: tuple[int, str] | None = None,
        limit: int = 1000,
    ) -> list[UnfinishedJob]:
        """Return the jobs that wait, run or are parked, oldest first; in one state or of one studio if given.

        `after` is the cursor of the last one read: its instant in milliseconds, and its id.
        """
        shown = FAILED_STATES if only_failed else OPEN_STATES + FAILED_STATES
        jobs = self._not_done(
            [shown_state for shown_state in shown if state in (None, STATE_WORDS[shown_state])], studio_id
        )
        # A sum: SQLite would rather walk through all jobs in the order of their index than sort a few.
        order = (jobs.c.created_at + 0, jobs.c.workflow_uuid)
        query = sa.select(jobs).order_by(*order).limit(limit)
        if after is not None:
            query = query.where(sa.tuple_(*order) > sa.tuple_(*after))
        with self._database.reading() as session:
            return [_unfinished(row) for row in session.execute(query)]

    def unfinished_job(self, job_id: str) -> UnfinishedJob | None:
        """Return one job that waits, runs or is parked; None for one that is done."""
        jobs = self._workflows
        query = sa.select(jobs).where(jobs.c.workflow_uuid == job_id, jobs.c.status.in_(STATE_WORDS))
        with self._database.reading() as session:
            row = session.execute(query.where(jobs.c.name == RUN_JOB)).one_or_none()
        return _unfinished(row) if row else None

    def counts(self, studio_id: UUID | None = None) -> list[JobCount]:
        """Return the numbers of jobs waiting, running or parked, by name; those of one studio if given."""
        jobs = self._not_done(OPEN_STATES + FAILED_STATES, studio_id)
        name, state = jobs.c.attributes["job"].as_string(), sa.case(STATE_WORDS, value=jobs.c.status)
        counted = (
            sa.select(name, state, sa.func.count(), sa.func.min(jobs.c.created_at))
            .group_by(name, state)
            .order_by(name, state)
        )
        with self._database.reading() as session:
            return [
                JobCount(name or RUN_JOB, word, jobs, _instant(ms)) for name, word, jobs, ms in session.execute(counted)
            ]

    def lanes(self, studio_id: UUID | None = None) -> list[FairnessPartition]:
        """Return counts of waiting and running jobs in each lane that has any, the longest first."""
        jobs = self._not_done(OPEN_STATES, studio_id)
        lane, state = jobs.c.queue_partition_key, jobs.c.status
        counted = sa.select(lane, state, sa.func.count(), sa.func.min(jobs.c.created_at)).group_by(lane, state)
        partitions: dict[str, FairnessPartition] = {}
        with self._database.reading() as session:
            for key, status, count, oldest_ms in session.execute(counted.where(lane.is_not(None))):
                lane_so_far = partitions.get(key) or _empty_lane(key)
                changed: dict[str, Any] = {STATE_WORDS[status]: count}
                if status == "ENQUEUED":
                    changed["oldest_at"] = _instant(oldest_ms)
                partitions[key] = replace(lane_so_far, **changed)
        return sorted(
            partitions.values(), key=lambda lane: (-lane.waiting - lane.running, -lane.delayed, str(lane.studio_id))
        )

    def job_ids_claimed_by(self, worker_id: str) -> set[str]:
        """Return the jobs recorded as run by a worker."""
        jobs = self._workflows
        held = sa.select(jobs.c.workflow_uuid).where(
            jobs.c.queue_name == JOB_QUEUE, sa.literal_column("status = 'PENDING'"), jobs.c.executor_id == worker_id
        )
        with self._database.reading() as session:
            return set(session.scalars(held))

    def running_jobs_by_worker(self) -> dict[str, int]:
        """Return the number of running jobs of each worker that has any."""
        jobs = self._workflows
        running = sa.select(jobs.c.executor_id, sa.func.count()).where(
            jobs.c.queue_name == JOB_QUEUE, sa.literal_column("status = 'PENDING'")
        )
        with self._database.reading() as session:
            return {worker: count for worker, count in session.execute(running.group_by(jobs.c.executor_id)) if worker}

    def _not_done(self, states: Sequence[str], studio_id: UUID | None) -> sa.Subquery:
        """Return the jobs in these states; each part has the condition of an index of DBOS.

        Done jobs are kept for a month: a read without an index would scan them all.
        """
        jobs, parts = self._workflows, []
        for condition, some in INDEXED_CONDITIONS.items():
            if not set(some) & set(states):
                continue
            part = sa.select(jobs).where(
                sa.literal_column(condition), jobs.c.status.in_(states), jobs.c.name == RUN_JOB
            )
            if studio_id is not None:
                part = part.where(jobs.c.attributes["studio"].as_string() == str(studio_id))
            parts.append(part)
        return sa.union_all(*parts).subquery()

    def heartbeats(self, *, within: timedelta) -> Sequence[Heartbeat]:
        """Return the workers with a recent heartbeat, in order of their ids."""
        with self._database.reading() as session:
            return session.scalars(
                sa.select(Heartbeat).where(Heartbeat.beat_at > clock.now() - within).order_by(Heartbeat.worker_id)
            ).all()

    def retry(self, job_id: str) -> bool:
        """Run a parked job again, at its old position in the queue; return False if it is not parked."""
        job = self.unfinished_job(job_id)
        if job is None or job.state != "parked":
            return False
        self._client.update_workflow_attributes(job_id, {"recoveries": 0}, merge=True)
        self._client.resume_workflow(job_id, queue_name=JOB_QUEUE)
        return True

    def requeue(self, job_ids: Collection[str]) -> None:
        """Put jobs that lost their worker back into the queue, and park those that lost too many."""
        if not job_ids:
            return
        for lost in self._client.list_workflows(
            workflow_ids=list(job_ids), status="PENDING", load_input=False, load_output=False
        ):
            recoveries = (lost.attributes or {}).get("recoveries", 0) + 1
            attributes: dict[str, Any] = {"recoveries": recoveries}
            if recoveries < MAX_RECOVERIES:
                self._client.update_workflow_attributes(lost.workflow_id, attributes, merge=True)
                self._client.resume_workflow(lost.workflow_id, queue_name=JOB_QUEUE)
            else:
                attributes["reason"] = f"its worker ended before the job did, {recoveries} times"
                self._client.update_workflow_attributes(lost.workflow_id, attributes, merge=True)
                self._client.cancel_workflow(lost.workflow_id)
                log.error("job is parked", job_id=lost.workflow_id, error=attributes["reason"])

    def register(self, *, jobs_at_once: int, poll_every_s: float) -> None:
        """Record the queue for its workers: the number of slots of each, and the interval of their polls."""
        self._client.register_queue(
            JOB_QUEUE,
            worker_concurrency=jobs_at_once,
            polling_interval_sec=poll_every_s,
            on_conflict="always_update",
        )

    def delete_finished(self, before: datetime) -> int:
        """Clear away jobs that were done before an instant; return how many went."""
        jobs, gone = self._workflows, 0
        done = sa.select(jobs.c.workflow_uuid).where(
            jobs.c.status == "SUCCESS", jobs.c.completed_at < int(before.timestamp() * 1000)
        )
        while True:
            with self._database.reading() as session:
                ids = list(session.scalars(done.limit(DELETED_PER_BATCH)))
            if not ids:
                return gone
            self._client.delete_workflows(ids)
            gone += len(ids)

    def close(self) -> None:
        """Close the client's own connections."""
        self._client.destroy()


def queue_of(session: Session) -> JobQueue:
    """Return the queue of the database that a session is on."""
    queue: JobQueue = session.info[QUEUE]
    return queue


def workflows(*, is_sqlite: bool) -> sa.TableClause:
    """Return the documented columns of DBOS's table of jobs that are read here."""
    return sa.table(
        "workflow_status",
        sa.column("workflow_uuid", sa.Text),
        sa.column("status", sa.Text),
        sa.column("name", sa.Text),
        sa.column("queue_name", sa.Text),  # null once a job is parked
        sa.column("queue_partition_key", sa.Text),
        sa.column("priority", sa.Integer),
        sa.column("executor_id", sa.Text),
        sa.column("attributes", sa.JSON().with_variant(JSONB(), "postgresql")),
        sa.column("created_at", sa.BigInteger),
        sa.column("completed_at", sa.BigInteger),
        sa.column("recovery_attempts", sa.BigInteger),
        schema=None if is_sqlite else "dbos",
    )


def _unfinished(row: sa.Row[Any]) -> UnfinishedJob:
    attributes = row.attributes or {}
    return UnfinishedJob(
        id=row.workflow_uuid,
        name=attributes.get("job") or RUN_JOB,
        studio_id=UUID(attributes["studio"]) if attributes.get("studio") else None,
        state=STATE_WORDS[row.status],
        tries=_attempt(row.workflow_uuid) - 1 + attributes.get("recoveries", 0) + (row.recovery_attempts or 0),
        since=_instant(row.created_at),
        reason=attributes.get("reason"),
        cursor=f"{row.created_at or 0}.{row.workflow_uuid}",
    )


def _empty_lane(key: str) -> FairnessPartition:
    studio, _, cost = key.partition(":")
    return FairnessPartition(None if studio == NOBODY else UUID(studio), URGENCY_WORDS[int(cost)])


def _attempt(job_id: str) -> int:
    return int(job_id.partition(ATTEMPT_MARK)[2] or 1)


def _instant(epoch_ms: int | None) -> datetime:
    return datetime.fromtimestamp((epoch_ms or 0) / 1000, UTC)


def system_url(database: Database) -> str:
    """Return the address under which DBOS finds its tables."""
    return database.engine.url.render_as_string(hide_password=False)


def create_tables(database: Database) -> None:
    """Create or upgrade DBOS's own tables."""
    DBOS.migrate(system_database_url=system_url(database))
