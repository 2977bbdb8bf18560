"""Durable jobs: written in the transaction of their row, run at least once by one of any number of workers.

Nothing else imports DBOS. Its tables live in the application's own database.

Whose turn it is: a job's place in the line is a number, the lowest first. It stands as far behind the head of
the line, or behind the last job of its own lane (one studio, one urgency), as its urgency costs. So lanes take
turns, urgent ones more often, and whoever comes with little never waits for all of whoever came with much.
"""

import os
import secrets
import socket
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from datetime import UTC, datetime, timedelta
from typing import TYPE_CHECKING, Any, NamedTuple, TypeVar
from uuid import UUID

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSClient, DBOSConfig, EnqueueOptions
from sqlalchemy.dialects.postgresql import JSONB
from sqlalchemy.orm import Mapped, Session, mapped_column

from app import logs
from app.kit import clock, metrics
from app.kit.db import Base, Database, beyond_reach, is_away

if TYPE_CHECKING:
    from app.kit.runtime import Runtime

JOB_QUEUE = "jobs"
QUEUE = "queue"  # key in a session's info: the queue of the database that it is on
# Changes only when a job's steps change incompatibly: DBOS resumes only jobs of the version it runs.
STEPS_VERSION = "1"
APPLICATION = "soundlist"
RUN_JOB = "soundlist.run_job"
PAUSES_S = (1.0, 10.0, 60.0, 300.0, 900.0)  # between the attempts at a job that fails; then it is parked
RECOVERY_ATTEMPTS = 5  # a job that kills its worker so often is parked
URGENT, NORMAL, BULK = 1, 10, 100  # what a job costs its lane: ten urgent ones get the turns of one normal one
URGENCY_WORDS = {URGENT: "urgent", NORMAL: "normal", BULK: "bulk"}
NOBODY = "nobody"  # in place of a studio
LAST_PLACE = 2**31 - 1
AWAY_PAUSE_S = 1.0
BEATS_WHILE_SILENT = 3
HEARTBEAT = "heartbeat"  # name of the thread
OPEN_STATES = ["ENQUEUED", "PENDING", "DELAYED"]
FAILED_STATES = ["CANCELLED", "MAX_RECOVERY_ATTEMPTS_EXCEEDED", "ERROR"]
STATE_WORDS = {
    "ENQUEUED": "waiting",
    "DELAYED": "delayed",
    "PENDING": "running",
    "CANCELLED": "parked",
    "MAX_RECOVERY_ATTEMPTS_EXCEEDED": "parked",
    "ERROR": "broken",  # none of ours ends so: what fails is tried again, then parked
}

NOT_DONE = {  # conditions of DBOS's partial indices, and the states that each is for
    "status in ('ENQUEUED', 'PENDING')": ("ENQUEUED", "PENDING"),
    "status = 'DELAYED'": ("DELAYED",),
    "status in ('ERROR', 'CANCELLED', 'MAX_RECOVERY_ATTEMPTS_EXCEEDED')": FAILED_STATES,
}

Payload = dict[str, Any]
REASON_LENGTH = 500
FORGOTTEN_AT_ONCE = 500
ATTEMPT_MARK = "~"
Handler = Callable[["Runtime", Payload], None]
_handlers: dict[str, Handler] = {}
Result = TypeVar("Result")
_stopping = threading.Event()  # the worker in this process ends
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
    """A job that waits, runs or gave up, and why it failed last where it did."""

    id: str
    name: str
    studio_id: UUID | None
    state: str
    tries: int
    since: datetime
    reason: str | None
    cursor: str  # where a list goes on after it


@dataclass(frozen=True)
class JobCount:
    """How many jobs of one name are in one state, and since when the first of them is written down."""

    name: str
    state: str
    jobs: int
    oldest_at: datetime


@dataclass(frozen=True)
class Lane:
    """The jobs of one studio and one urgency, which take turns with those of every other lane."""

    studio_id: UUID | None
    urgency: str
    waiting: int = 0
    running: int = 0
    delayed: int = 0
    oldest_at: datetime | None = None  # of those that wait


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

    def _write(
        self, session: Session, key: str, work: "Work", *, delay_s: float = 0, reason: str | None = None
    ) -> None:
        studio, _, cost = work.lane.partition(":")
        options: EnqueueOptions = {
            "workflow_name": RUN_JOB,
            "queue_name": JOB_QUEUE,
            "workflow_id": key,
            "app_version": STEPS_VERSION,
            "queue_partition_key": work.lane,
            "attributes": {"job": work.name, "studio": None if studio == NOBODY else studio, "reason": reason},
        }
        with beyond_reach(session):  # the jobs are the server's own
            if delay_s:
                options["delay_seconds"] = delay_s
                options["priority"] = int(cost)  # has waited: at the head, once it is due
            else:
                options["priority"] = self._place(session, work.lane, int(cost))
            self._client.enqueue_in_transaction(session, options, *work)

    def _place(self, session: Session, lane: str, cost: int) -> int:
        """Return the place in the line of the next job of a lane: two reads at the ends of indices."""
        jobs = self._workflows
        waiting = sa.select(jobs.c.priority).where(
            jobs.c.queue_name == JOB_QUEUE,
            jobs.c.status == "ENQUEUED",
            sa.literal_column("status in ('ENQUEUED', 'PENDING')"),  # as the indices say it
        )
        head = waiting.order_by(jobs.c.priority).limit(1).scalar_subquery()
        last = (
            waiting.where(jobs.c.queue_partition_key == lane)
            .order_by(jobs.c.priority.desc())
            .limit(1)
            .scalar_subquery()
        )
        ahead = session.connection().execute(sa.select(head, last)).one()
        return min(max(place or 0 for place in ahead) + cost, LAST_PLACE)

    def try_again(self, job_id: str, work: "Work", error: Exception) -> bool:
        """Write the next attempt at a job that failed; return False, and park it, where that was the last."""
        reason = f"{type(error).__name__}: {error}"[:REASON_LENGTH]
        if work.attempt > len(PAUSES_S):
            self._client.update_workflow_attributes(job_id, {"reason": reason}, merge=True)
            self._client.cancel_workflow(job_id)  # a cancelled job can be resumed, one in error cannot
            return False
        attempt = work.attempt + 1
        key = f"{job_id.partition(ATTEMPT_MARK)[0]}{ATTEMPT_MARK}{attempt}"
        with self._database.writing() as session:
            self._write(session, key, work._replace(attempt=attempt), delay_s=PAUSES_S[work.attempt - 1], reason=reason)
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
        """Return the jobs that wait, run or gave up, oldest first; in one state or of one studio where it is given.

        `after` is the cursor of the last one read: its instant in milliseconds, and its id.
        """
        shown = FAILED_STATES if only_failed else OPEN_STATES + FAILED_STATES
        jobs = self._not_done([one for one in shown if state in (None, STATE_WORDS[one])], studio_id)
        # A sum: SQLite would rather walk through all jobs in the order of their index than sort a few.
        order = (jobs.c.created_at + 0, jobs.c.workflow_uuid)
        query = sa.select(jobs).order_by(*order).limit(limit)
        if after is not None:
            query = query.where(sa.tuple_(*order) > sa.tuple_(*after))
        with self._database.reading() as session:
            return [_unfinished(row) for row in session.execute(query)]

    def unfinished_job(self, job_id: str) -> UnfinishedJob | None:
        """Return one job that waits, runs or gave up; None for one that is done."""
        jobs = self._workflows
        query = sa.select(jobs).where(jobs.c.workflow_uuid == job_id, jobs.c.status.in_(STATE_WORDS))
        with self._database.reading() as session:
            row = session.execute(query.where(jobs.c.name == RUN_JOB)).one_or_none()
        return _unfinished(row) if row else None

    def counts(self, studio_id: UUID | None = None) -> list[JobCount]:
        """Return how many jobs wait, run or gave up, by name; those of one studio where it is given."""
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

    def lanes(self, studio_id: UUID | None = None) -> list[Lane]:
        """Return how many jobs wait and run in each lane that has any, the longest first."""
        jobs = self._not_done(OPEN_STATES, studio_id)
        lane, state = jobs.c.queue_partition_key, jobs.c.status
        counted = sa.select(lane, state, sa.func.count(), sa.func.min(jobs.c.created_at)).group_by(lane, state)
        found: dict[str, Lane] = {}
        with self._database.reading() as session:
            for key, status, count, oldest_ms in session.execute(counted.where(lane.is_not(None))):
                known = found.get(key) or _empty_lane(key)
                changed: dict[str, Any] = {STATE_WORDS[status]: count}
                if status == "ENQUEUED":
                    changed["oldest_at"] = _instant(oldest_ms)
                found[key] = replace(known, **changed)
        return sorted(
            found.values(), key=lambda lane: (-lane.waiting - lane.running, -lane.delayed, str(lane.studio_id))
        )

    def in_hand(self) -> dict[str, int]:
        """Return how many jobs each worker runs that runs any."""
        jobs = self._workflows
        running = sa.select(jobs.c.executor_id, sa.func.count()).where(
            jobs.c.queue_name == JOB_QUEUE, sa.literal_column("status = 'PENDING'")
        )
        with self._database.reading() as session:
            return {worker: count for worker, count in session.execute(running.group_by(jobs.c.executor_id)) if worker}

    def _not_done(self, states: Sequence[str], studio_id: UUID | None) -> sa.Subquery:
        """Return the jobs in these states; each part says its condition as an index of DBOS does.

        What is done is kept for a month: a read that no index answers would go through all of it.
        """
        jobs, parts = self._workflows, []
        for condition, some in NOT_DONE.items():
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
        """Return the workers that said lately that they live, in order of their ids."""
        with self._database.reading() as session:
            return session.scalars(
                sa.select(Heartbeat).where(Heartbeat.beat_at > clock.now() - within).order_by(Heartbeat.worker_id)
            ).all()

    def retry(self, job_id: str) -> bool:
        """Let a job run again that gave up, at the head of the line; return False where it does not lie parked."""
        jobs, parked = self._workflows, [state for state, word in STATE_WORDS.items() if word == "parked"]
        found = sa.update(jobs).where(jobs.c.workflow_uuid == job_id, jobs.c.status.in_(parked))
        with self._database.writing() as session:
            if not session.execute(found.values(priority=URGENT).returning(jobs.c.workflow_uuid)).all():
                return False
        self._client.resume_workflow(job_id, queue_name=JOB_QUEUE)
        return True

    def forget_done(self, before: datetime) -> int:
        """Clear away jobs that were done before an instant; return how many went."""
        jobs, gone = self._workflows, 0
        done = sa.select(jobs.c.workflow_uuid).where(
            jobs.c.status == "SUCCESS", jobs.c.completed_at < int(before.timestamp() * 1000)
        )
        while True:
            with self._database.reading() as session:
                ids = list(session.scalars(done.limit(FORGOTTEN_AT_ONCE)))
            if not ids:
                return gone
            self._client.delete_workflows(ids)
            gone += len(ids)

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
        sa.column("name", sa.Text),
        sa.column("queue_name", sa.Text),  # null once a job is parked
        sa.column("queue_partition_key", sa.Text),
        sa.column("priority", sa.Integer),
        sa.column("executor_id", sa.Text),
        sa.column("attributes", sa.JSON().with_variant(JSONB(), "postgresql")),
        sa.column("created_at", sa.BigInteger),
        sa.column("completed_at", sa.BigInteger),
        sa.column("recovery_attempts", sa.BigInteger),
        schema=None if database.is_sqlite else "dbos",
    )


def _unfinished(row: sa.Row[Any]) -> UnfinishedJob:
    said = row.attributes or {}
    return UnfinishedJob(
        id=row.workflow_uuid,
        name=said.get("job") or RUN_JOB,
        studio_id=UUID(said["studio"]) if said.get("studio") else None,
        state=STATE_WORDS[row.status],
        tries=_attempt(row.workflow_uuid) - 1 + (row.recovery_attempts or 0),
        since=_instant(row.created_at),
        reason=said.get("reason"),
        cursor=f"{row.created_at or 0}.{row.workflow_uuid}",
    )


def _empty_lane(key: str) -> Lane:
    studio, _, cost = key.partition(":")
    return Lane(None if studio == NOBODY else UUID(studio), URGENCY_WORDS[int(cost)])


def _attempt(job_id: str) -> int:
    return int(job_id.partition(ATTEMPT_MARK)[2] or 1)


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
        "sys_db_pool_size": 5 + jobs_at_once,
        "max_executor_threads": max(8, jobs_at_once * 4),
        "log_level": "WARNING",
        "notification_listener_polling_interval_sec": 1.0,
    }


def create_tables(database: Database) -> None:
    """Create or upgrade DBOS's own tables."""
    DBOS.migrate(system_database_url=_system_url(database))


class Work(NamedTuple):
    """The arguments of a job as they are stored; fields are only ever added, at the end and with a default."""

    name: str
    payload: Payload
    cause: logs.Cause
    lane: str
    attempt: int = 1


def _run_job(
    name: str, payload: Payload, cause: logs.Cause | None = None, lane: str = f"{NOBODY}:{NORMAL}", attempt: int = 1
) -> None:
    work, job_id = Work(name, payload, cause or {}, lane, attempt), str(DBOS.workflow_id)
    begun, outcome = time.perf_counter(), "failed"
    with logs.bound(work.cause, job=name, job_id=job_id):
        try:
            _patiently(lambda: _handlers[name](_runs_in(), payload))
            outcome = "done"
        except Exception as error:
            metrics.JOB_FAILURES.labels(name).inc()
            log.warning("job failed", attempt=attempt, attempts=len(PAUSES_S) + 1, exc_info=True)
            failure = error
            if not _patiently(lambda: _runs_in().queue.try_again(job_id, work, failure)):
                outcome = "parked"
                log.error("job is parked", error=str(error))
                raise
        finally:
            taken_s = time.perf_counter() - begun
            metrics.JOBS.labels(name, outcome).inc()
            metrics.JOB_S.labels(name).observe(taken_s)
            log.info("job ended", outcome=outcome, seconds=round(taken_s, 3))


def _runs_in() -> "Runtime":
    if _runtime is None:
        raise RuntimeError("no worker was started in this process")
    return _runtime


def _patiently(call: Callable[[], Result]) -> Result:
    """Return what a call gives; while the database is away wait for it, since that is no fault of the job."""
    while True:
        try:
            return call()
        except Exception as error:
            if not is_away(error) or _stopping.wait(AWAY_PAUSE_S):
                raise
            log.warning("the database does not answer; a job waits for it", error=str(error))


class Worker:
    """Runs jobs in this process until stopped, and takes over what dead workers left half-done."""

    def __init__(self, runtime: "Runtime", *, jobs_at_once: int, silent_s: float, poll_every_s: float = 0.05) -> None:
        # Unique for ever: two processes with one id would run a job twice.
        self.id = f"{socket.gethostname()}-{os.getpid()}-{secrets.token_hex(3)}"
        self._runtime = runtime
        self._database = runtime.database
        self._jobs_at_once = jobs_at_once
        self._silent_s = silent_s
        self._poll_every_s = poll_every_s
        self._stopped = threading.Event()
        self._watched: dict[str, tuple[datetime | None, float]] = {}  # others' last beats, and since when we know them
        self._beating = threading.Thread(target=self._live, name=HEARTBEAT, daemon=True)

    def start(self) -> None:
        """Say that this worker lives, then take up whatever waits."""
        global _runtime  # noqa: PLW0603
        _runtime = self._runtime
        _stopping.clear()
        self._beat()
        DBOS.destroy(destroy_registry=True)
        DBOS(config=_config(self._database, self.id, self._jobs_at_once))
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
        """Let running jobs end, then stop; what is not done by then another worker takes over."""
        _stopping.set()
        DBOS.destroy(destroy_registry=True, workflow_completion_timeout_sec=wait_s)
        self._stopped.set()
        self._beating.join(timeout=2)
        try:
            self._forget(self.id)
        except sa.exc.SQLAlchemyError as error:
            log.warning("a worker stopped without saying so", error=str(error))

    def _live(self) -> None:
        while not self._stopped.wait(self._silent_s / BEATS_WHILE_SILENT):
            try:
                self._beat()
                if not _stopping.is_set():
                    self._take_over()
            except Exception as error:
                # Who could not listen cannot say who was silent: begin to watch anew.
                self._watched.clear()
                log.warning("a worker cannot say that it lives", error=str(error))

    def _beat(self) -> None:
        with self._database.writing() as session:
            session.merge(Heartbeat(worker_id=self.id, beat_at=clock.now()))

    def _take_over(self) -> None:
        """Put back into the line what workers hold that have been silent for too long; a job is put back once."""
        for worker_id in self._silent():
            log.warning("a worker is silent; its jobs are taken over", worker=worker_id)
            DBOS._recover_pending_workflows([worker_id])
            self._forget(worker_id)
            del self._watched[worker_id]

    def _silent(self) -> list[str]:
        """Return the others whose beat has stood still, by this process's own clock, for too long."""
        with self._database.reading() as session:
            beats = dict(session.execute(sa.select(Heartbeat.worker_id, Heartbeat.beat_at)).all())
        heard: dict[str, datetime | None] = dict.fromkeys(self._runtime.queue.in_hand()) | beats
        heard.pop(self.id, None)
        now = time.monotonic()
        self._watched = {
            worker_id: known if (known := self._watched.get(worker_id)) and known[0] == beat else (beat, now)
            for worker_id, beat in heard.items()
        }
        return [worker_id for worker_id, (_, since) in self._watched.items() if now - since >= self._silent_s]

    def _forget(self, worker_id: str) -> None:
        with self._database.writing() as session:
            session.execute(sa.delete(Heartbeat).where(Heartbeat.worker_id == worker_id))
