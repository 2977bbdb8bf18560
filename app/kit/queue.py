"""Durable jobs: written in the transaction of their row, run at least once by a worker, resumed after kill -9.

Nothing else imports DBOS. Its tables live in the application's own database.
"""

import contextlib
import logging
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, datetime
from typing import TYPE_CHECKING, Any
from uuid import UUID

import sqlalchemy as sa
from dbos import DBOS, DBOSClient, DBOSConfig, EnqueueOptions
from sqlalchemy.orm import Mapped, Session, mapped_column

from app import logs
from app.kit import clock
from app.kit.db import Base, Database

if TYPE_CHECKING:
    from app.kit.runtime import Runtime

JOB_QUEUE = "jobs"
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
    "DELAYED": "waiting",
    "PENDING": "running",
    "CANCELLED": "parked",
    "MAX_RECOVERY_ATTEMPTS_EXCEEDED": "parked",
    "ERROR": "broken",
}

Payload = dict[str, Any]
Handler = Callable[["Runtime", Payload], None]
_handlers: dict[str, Handler] = {}
_runtime: "Runtime | None" = None  # of the worker in this process: DBOS stores a job's arguments, so it is none of them
log = logging.getLogger(__name__)


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


class JobQueue:
    """Writes jobs into the caller's transaction; needs no running worker."""

    def __init__(self, database: Database) -> None:
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
                since=datetime.fromtimestamp((workflow.created_at or 0) / 1000, UTC),
            )
            for workflow in found
        ]

    def retry(self, job_id: str) -> None:
        """Let a job run again that gave up."""
        self._client.resume_workflow(job_id, queue_name=JOB_QUEUE)

    def close(self) -> None:
        """Close the client's own connections."""
        self._client.destroy()


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
    with logs.bound(cause or {}, job=name, job_id=str(DBOS.workflow_id)):
        _tried(name, payload)


def _tried(name: str, payload: Payload) -> None:
    handler = _handlers[name]
    runtime = _runtime
    if runtime is None:
        raise RuntimeError("no worker was started in this process")
    for attempt in range(1, ATTEMPTS + 1):
        try:
            handler(runtime, payload)
        except Exception:
            if attempt == ATTEMPTS:
                log.exception("job %s is parked", name)
                DBOS.cancel_workflow(str(DBOS.workflow_id))  # a cancelled job can be resumed, one in error cannot
                raise
            log.warning("job %s failed, attempt %d of %d", name, attempt, ATTEMPTS, exc_info=True)
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
