"""Durable jobs: written in the transaction of their row, run at least once by a worker, resumed after kill -9.

Nothing else imports DBOS. Its tables live in the application's own database.
"""

import contextlib
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Any
from uuid import UUID

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSClient, DBOSConfig, EnqueueOptions
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.orm import Mapped, Session, mapped_column

from app import logs
from app.kit import clock, metrics
from app.kit.db import Base, Database, beyond_reach

if TYPE_CHECKING:
    from app.kit.runtime import Runtime

JOB_QUEUE = "jobs"
QUEUE = "queue"  # key in a session's info: the queue of the database that it is on
# Changes only when a job's steps change incompatibly: DBOS resumes only jobs of the version it runs.
STEPS_VERSION = "1"
APPLICATION = "soundlist"
RUN_JOB = "soundlist.run_job"
ATTEMPTS = 4
FIRST_RETRY_S = 0.5
BACKOFF = 4.0
RECOVERY_ATTEMPTS = 20
URGENT, NORMAL, BULK = 1, 10, 100
BEAT_EVERY_S = 5.0
OPEN_STATES = ["ENQUEUED", "PENDING", "DELAYED"]
FAILED_STATES = ["CANCELLED", "MAX_RECOVERY_ATTEMPTS_EXCEEDED", "ERROR"]
STATE_WORDS = {
    "ENQUEUED": "waiting",
    "DELAYED": "delayed",
    "PENDING": "running",
    "CANCELLED": "parked",
    "MAX_RECOVERY_ATTEMPTS_EXCEEDED": "parked",
    "ERROR": "broken",
}

Payload = dict[str, Any]
Handler = Callable[["Runtime", Payload], None]
_handlers: dict[str, Handler] = {}
_runtime: "Runtime | None" = None  # of the worker in this process: DBOS stores a job's arguments, so it is none of them
log = structlog.get_logger(__name__)


class Heartbeat(Base):
    """When a worker process last said that it lives."""

    __tablename__ = "kit_heartbeats"

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


def job_names() -> frozenset[str]:
    """Return the names of the jobs that this process can run."""
    return frozenset(_handlers)


@dataclass(frozen=True)
class UnfinishedJob:
    """A job that waits, runs or gave up."""

    id: str
    name: str
    studio_id: UUID | None
    state: str
    recoveries: int
    since: datetime


@dataclass(frozen=True)
class JobCount:
    """How many jobs of one name are in one state, and since when the first of them is written down."""

    name: str
    state: str
    jobs: int
    oldest_at: datetime


class JobQueue:
    """Writes jobs into the caller's transaction; needs no running worker."""

    def __init__(self, database: Database) -> None:
        self._database = database
        database.session_info[QUEUE] = self
        self._workflows = _workflows(database)
        self._client = DBOSClient(
            system_database_url=_system_url(database),
            application_name=APPLICATION,
            lazy=True,
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
        options: EnqueueOptions = {
            "workflow_name": RUN_JOB,
            "queue_name": JOB_QUEUE,
            "workflow_id": key,
            "app_version": STEPS_VERSION,
            "priority": priority,
            "attributes": {"job": name, "studio": str(studio_id) if studio_id else None},
        }
        if delay_s:
            options["delay_seconds"] = delay_s
        with beyond_reach(session):  # the jobs are the server's own
            self._client.enqueue_in_transaction(session, options, name, payload, logs.cause())

    def unfinished(self, *, only_failed: bool = False) -> list["UnfinishedJob"]:
        """Return the jobs that wait, run or gave up, oldest first."""
        states = FAILED_STATES if only_failed else OPEN_STATES + FAILED_STATES
        found = self._client.list_workflows(status=states, sort_desc=False, limit=1000, load_output=False)
        return [
            UnfinishedJob(
                id=workflow.workflow_id,
                name=str(workflow.input["args"][0]) if workflow.input else workflow.name,
                studio_id=UUID(studio) if (studio := (workflow.attributes or {}).get("studio")) else None,
                state=STATE_WORDS[workflow.status],
                recoveries=workflow.recovery_attempts or 0,
                since=_instant(workflow.created_at),
            )
            for workflow in found
        ]

    def counts(self, studio_id: UUID | None = None) -> list[JobCount]:
        """Return how many jobs wait, run or gave up, by name; those of one studio where it is given."""
        jobs = self._workflows
        name, state = jobs.c.attributes["job"].as_string(), sa.case(STATE_WORDS, value=jobs.c.status)
        counted = (
            sa.select(name, state, sa.func.count(), sa.func.min(jobs.c.created_at))
            .where(jobs.c.status.in_([*OPEN_STATES, *FAILED_STATES]))
            .group_by(name, state)
            .order_by(name, state)
        )
        if studio_id is not None:
            counted = counted.where(jobs.c.attributes["studio"].as_string() == str(studio_id))
        with self._database.reading() as session:
            return [
                JobCount(name or RUN_JOB, word, jobs, _instant(ms)) for name, word, jobs, ms in session.execute(counted)
            ]

    def heartbeats(self, *, within: timedelta) -> Sequence[Heartbeat]:
        """Return the workers that said lately that they live, in order of their ids."""
        with self._database.reading() as session:
            return session.scalars(
                sa.select(Heartbeat).where(Heartbeat.beat_at > clock.now() - within).order_by(Heartbeat.worker_id)
            ).all()

    def retry(self, job_id: str) -> None:
        """Let a job run again that gave up."""
        self._client.resume_workflow(job_id, queue_name=JOB_QUEUE)

    def close(self) -> None:
        """Close the client's own connections."""
        self._client.destroy()


def queue_of(session: Session) -> JobQueue:
    """Return the queue beside the database that a session is on."""
    queue: JobQueue = session.info[QUEUE]
    return queue


def _workflows(database: Database) -> sa.TableClause:
    """Return DBOS's table of jobs, as far as we read it."""
    return sa.table(
        "workflow_status",
        sa.column("workflow_uuid", sa.Text),
        sa.column("status", sa.Text),
        sa.column("attributes", sa.JSON().with_variant(JSONB(), "postgresql")),
        sa.column("created_at", sa.BigInteger),
        schema=None if database.is_sqlite else "dbos",
    )


def _instant(epoch_ms: int | None) -> datetime:
    return datetime.fromtimestamp((epoch_ms or 0) / 1000, UTC)


def _system_url(database: Database) -> str:
    return database.engine.url.render_as_string(hide_password=False)


def _config(database: Database, worker_id: str, jobs_at_once: int) -> DBOSConfig:
    return {
        "name": APPLICATION,
        "system_database_url": _system_url(database),
        "application_version": STEPS_VERSION,
        "executor_id": worker_id,
        "max_executor_threads": max(8, jobs_at_once * 4),
        "log_level": "WARNING",
        "notification_listener_polling_interval_sec": 1.0,
    }


def create_tables(database: Database) -> None:
    """Create or upgrade DBOS's own tables."""
    DBOS.migrate(system_database_url=_system_url(database))


def _run_job(name: str, payload: Payload, cause: logs.Cause | None = None) -> None:
    begun, outcome = time.perf_counter(), "parked"
    with logs.bound(cause or {}, job=name, job_id=str(DBOS.workflow_id)):
        try:
            _tried(name, payload)
            outcome = "done"
        finally:
            taken_s = time.perf_counter() - begun
            metrics.JOBS.labels(name, outcome).inc()
            metrics.JOB_S.labels(name).observe(taken_s)
            log.info("job ended", outcome=outcome, seconds=round(taken_s, 3))


def _tried(name: str, payload: Payload) -> None:
    handler = _handlers[name]
    runtime = _runtime
    if runtime is None:
        raise RuntimeError("no worker was started in this process")
    for attempt in range(1, ATTEMPTS + 1):
        try:
            handler(runtime, payload)
        except Exception:
            metrics.JOB_FAILURES.labels(name).inc()
            if attempt == ATTEMPTS:
                log.exception("job is parked", attempts=ATTEMPTS)
                DBOS.cancel_workflow(str(DBOS.workflow_id))  # a cancelled job can be resumed, one in error cannot
                raise
            log.warning("job failed", attempt=attempt, attempts=ATTEMPTS, exc_info=True)
            time.sleep(FIRST_RETRY_S * BACKOFF ** (attempt - 1))
        else:
            return


class Worker:
    """Runs jobs in this process until stopped."""

    def __init__(self, runtime: "Runtime", *, worker_id: str, jobs_at_once: int, poll_every_s: float = 0.05) -> None:
        self._runtime = runtime
        self._database = runtime.database
        self._worker_id = worker_id
        self._jobs_at_once = jobs_at_once
        self._poll_every_s = poll_every_s
        self._stopped = threading.Event()
        self._beating = threading.Thread(target=self._beat, name="heartbeat", daemon=True)

    def start(self) -> None:
        """Take up what this worker id left half-done, then whatever waits."""
        global _runtime  # noqa: PLW0603
        _runtime = self._runtime
        DBOS.destroy(destroy_registry=True)
        DBOS(config=_config(self._database, self._worker_id, self._jobs_at_once))
        DBOS.workflow(name=RUN_JOB, max_recovery_attempts=RECOVERY_ATTEMPTS)(_run_job)
        DBOS.launch()
        DBOS.register_queue(
            JOB_QUEUE,
            worker_concurrency=self._jobs_at_once,
            polling_interval_sec=self._poll_every_s,
            on_conflict="always_update",
        )
        self._beating.start()

    def stop(self, *, wait_s: int = 10) -> None:
        """Let running jobs end, then stop; what is not done by then is taken up at the next start."""
        self._stopped.set()
        self._beating.join(timeout=2)
        DBOS.destroy(destroy_registry=True, workflow_completion_timeout_sec=wait_s)

    def _beat(self) -> None:
        while True:
            with contextlib.suppress(sa.exc.SQLAlchemyError), self._database.writing() as session:
                session.merge(Heartbeat(worker_id=self._worker_id, beat_at=clock.now()))
            if self._stopped.wait(BEAT_EVERY_S):
                return
