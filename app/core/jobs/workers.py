"""Runs the jobs of the queue in a worker process, and takes over unfinished jobs of dead workers."""

import logging
import os
import secrets
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from datetime import datetime
from typing import TYPE_CHECKING, Any, TypeVar

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSConfig

from app import logs
from app.core import clock, metrics
from app.core.db import BUSY_TIMEOUT_MS, Database, ensure_open, is_unavailable
from app.core.jobs import queue
from app.core.jobs.queue import Heartbeat, Payload, Work

if TYPE_CHECKING:
    from app.core.runtime import Runtime

UNAVAILABLE_PAUSE_S = 1.0
BEATS_UNTIL_SILENT = 3
HEARTBEAT = "heartbeat"  # name of a thread
POLL_EVERY_S = 0.1  # for work
REPEATED_EVERY_S = 10.0  # a warning of DBOS: without a database each poll would write two
FIRST_LANE = f"{queue.NOBODY}:{queue.NORMAL}"  # of jobs written before there were lanes
Result = TypeVar("Result")
_stopping = threading.Event()  # the worker in this process ends
_worker: "Worker | None" = None  # the one here; its runtime is not an argument of a job, since DBOS stores those
_written: dict[tuple[str, int], float] = {}  # by line of DBOS: when it last warned
log = structlog.get_logger(__name__)


class Worker:
    """Runs jobs in this process until stopped, and takes over what dead workers left half-done."""

    def __init__(self, runtime: "Runtime", *, jobs_at_once: int, silent_s: float) -> None:
        # Globally unique: two processes with one id would run a job twice.
        self.id = f"{socket.gethostname()}-{os.getpid()}-{secrets.token_hex(3)}"
        self.runtime = runtime
        self._database = runtime.database
        self._jobs_at_once = jobs_at_once
        self._silent_s = silent_s
        self._stopped = threading.Event()
        self._watched: dict[str, tuple[datetime | None, float]] = {}  # others' last beats, and since when we know them
        self._running: set[str] = set()  # jobs
        self._unheld: set[str] = set()  # jobs recorded as run by this worker that it did not run at the last beat
        self._slots = threading.BoundedSemaphore(jobs_at_once)
        self.engine = _engine(self._database, connections=_pool_size(jobs_at_once))
        self._beating = threading.Thread(target=self._live, name=HEARTBEAT, daemon=True)

    def start(self) -> None:
        """Record a heartbeat, then run waiting jobs; a process has one worker at most, as it has one DBOS."""
        global _worker  # noqa: PLW0603
        if _worker is not None and not _worker.has_stopped:
            raise RuntimeError("a worker runs in this process; stop it, or start the other one in another process")
        _stopping.clear()
        self._beat()
        _worker = self
        self.runtime.queue.register(jobs_at_once=self._jobs_at_once, poll_every_s=POLL_EVERY_S)
        DBOS.logger.addFilter(_is_news)
        DBOS(config=_config(self.engine, self.id))
        DBOS.workflow(name=queue.RUN_JOB)(_run_job)
        DBOS.launch()
        self._beating.start()

    def stop(self, *, wait_s: int = 10) -> None:
        """Let running jobs end, then stop; what is not done by then another worker takes over."""
        _stopping.set()
        DBOS.destroy(destroy_registry=True, workflow_completion_timeout_sec=wait_s)
        self.engine.dispose()
        self._stopped.set()
        self._beating.join(timeout=2)
        try:
            self._forget(self.id)
        except sa.exc.SQLAlchemyError as error:
            log.warning("a worker could not record its stop", error=str(error))

    @property
    def has_stopped(self) -> bool:
        """Whether it was started and has ended since."""
        return self._stopped.is_set()

    @contextmanager
    def slot(self, job_id: str) -> Iterator[None]:
        """Hold one of the slots for a job.

        All workers share the number of slots that the queue has, and the last worker to start sets it.
        """
        self._running.add(job_id)
        try:
            with self._slots:
                yield
        finally:
            self._running.discard(job_id)

    def _live(self) -> None:
        while not self._stopped.wait(self._silent_s / BEATS_UNTIL_SILENT):
            try:
                self._beat()
                if not _stopping.is_set():
                    self._take_over()
                    self._requeue_lost_jobs()
            except Exception as error:
                # A worker that could not read heartbeats cannot judge whose are missing: start again.
                self._watched.clear()
                log.warning("a worker could not record its heartbeat", error=str(error))

    def _beat(self) -> None:
        with self._database.writing() as session:
            session.merge(Heartbeat(worker_id=self.id, beat_at=clock.now()))

    def _take_over(self) -> None:
        """Put the jobs of workers that have been silent for too long back into the queue."""
        for worker_id, beat_at in self._silent().items():
            if not self._claim_silent(worker_id, beat_at):
                continue
            log.warning("a worker is silent; its jobs are taken over", worker=worker_id)
            self.runtime.queue.requeue(self.runtime.queue.job_ids_claimed_by(worker_id))
            self._forget(worker_id)
            del self._watched[worker_id]

    def _claim_silent(self, worker_id: str, beat_at: datetime | None) -> bool:
        """Return whether this worker is the one to take over from a silent one.

        It renews the last heartbeat, so the others wait once more, and look again if this worker dies meanwhile.
        """
        try:
            with self._database.writing() as session:
                if beat_at is None:
                    session.add(Heartbeat(worker_id=worker_id, beat_at=clock.now()))
                    return True
                renewed = sa.update(Heartbeat).where(Heartbeat.worker_id == worker_id, Heartbeat.beat_at == beat_at)
                return bool(session.execute(renewed.values(beat_at=clock.now()).returning(Heartbeat.worker_id)).all())
        except sa.exc.IntegrityError:  # another worker was first
            return False

    def _requeue_lost_jobs(self) -> None:
        """Put jobs back into the queue that are recorded as run by this worker but are not running.

        DBOS drops a job if the database becomes unavailable just as the job's end is written.
        """
        unheld = self.runtime.queue.job_ids_claimed_by(self.id) - self._running
        if lost := unheld & self._unheld:  # at two beats: between claim and start a job is in no list
            log.warning("ends of jobs were not written; they run again", job_ids=sorted(lost))
            self.runtime.queue.requeue(lost)
        self._unheld = unheld - lost

    def _silent(self) -> dict[str, datetime | None]:
        """Return the others whose beat has stood still, by this process's own clock, for too long; and that beat."""
        with self._database.reading() as session:
            beats = dict(session.execute(sa.select(Heartbeat.worker_id, Heartbeat.beat_at)).all())
        heard: dict[str, datetime | None] = dict.fromkeys(self.runtime.queue.running_jobs_by_worker()) | beats
        heard.pop(self.id, None)
        now = time.monotonic()
        self._watched = {
            worker_id: watched if (watched := self._watched.get(worker_id)) and watched[0] == beat else (beat, now)
            for worker_id, beat in heard.items()
        }
        return {worker_id: beat for worker_id, (beat, since) in self._watched.items() if now - since >= self._silent_s}

    def _forget(self, worker_id: str) -> None:
        with self._database.writing() as session:
            session.execute(sa.delete(Heartbeat).where(Heartbeat.worker_id == worker_id))


def _engine(database: Database, *, connections: int) -> sa.Engine:
    """Return DBOS's own connections, so that it never waits for one that a job holds."""
    engine = sa.create_engine(database.engine.url, pool_size=connections, max_overflow=0, pool_use_lifo=True)
    if database.is_sqlite:
        sa.event.listen(engine, "connect", _prepare_sqlite)
    else:
        sa.event.listen(engine, "connect", _prepare_postgresql)
        sa.event.listen(engine, "checkout", ensure_open)
    return engine


def _prepare_sqlite(connection: Any, _record: Any) -> None:
    """Set DBOS's own settings, and let SQLite sync progress together with the next commit that must be durable.

    After a power failure the job runs again. Jobs themselves are written in our transactions.
    """
    connection.isolation_level = "IMMEDIATE"
    connection.execute(f"PRAGMA busy_timeout={BUSY_TIMEOUT_MS}")
    connection.execute("PRAGMA foreign_keys=ON")
    connection.execute("PRAGMA synchronous=NORMAL")


def _prepare_postgresql(connection: Any, _record: Any) -> None:
    """Keep the plan of a statement that is sent a second time, and bound how long a suspended worker keeps locks."""
    connection.prepare_threshold = 1
    connection.execute("SET idle_in_transaction_session_timeout = '60s'")
    connection.commit()


def _is_news(record: logging.LogRecord) -> bool:
    """Return False for a warning that the same line of DBOS has written a moment ago."""
    now, line = time.monotonic(), (record.module, record.lineno)
    if record.levelno == logging.WARNING and now - _written.get(line, -REPEATED_EVERY_S) < REPEATED_EVERY_S:
        return False
    _written[line] = now
    return True


def _pool_size(jobs_at_once: int) -> int:
    return jobs_at_once + 2  # each job's progress, the search for work, and what DBOS does in the background


def engine_connections(jobs_at_once: int) -> int:
    """Return the most connections of the engine of jobs, with the one that listens for notifications."""
    return _pool_size(jobs_at_once) + 1


def _config(engine: sa.Engine, worker_id: str) -> DBOSConfig:
    return {
        "name": queue.APPLICATION,
        "system_database_engine": engine,
        "run_migrations": False,  # `soundlist migrate` does
        "application_version": queue.STEPS_VERSION,
        "executor_id": worker_id,
        "serializer": queue.SERIALIZER,
        "log_level": "WARNING",
        "notification_listener_polling_interval_sec": 1.0,
        "notification_coalesce_sec": 1.0,  # nothing of ours waits for a notification: it would look 100 times a second
    }


def _run_job(
    name: str,
    payload: Payload,
    cause: logs.Cause | None = None,
    lane: str = FIRST_LANE,
    attempt: int = 1,
) -> None:
    work, job_id, worker = Work(name, payload, cause or {}, lane, attempt), str(DBOS.workflow_id), _worker_here()
    with worker.slot(job_id), logs.bound(work.cause, job=name, job_id=job_id):
        begun, outcome = time.perf_counter(), "failed"
        try:
            _when_available(lambda: queue.handler_of(name)(worker.runtime, payload))
            outcome = "done"
        except Exception as error:
            metrics.JOB_FAILURES.labels(name).inc()
            log.warning("job failed", attempt=attempt, attempts=len(queue.RETRY_DELAYS_S) + 1, exc_info=True)
            failure = error
            if not _when_available(lambda: worker.runtime.queue.schedule_retry(job_id, work, failure)):
                outcome = "parked"
                log.error("job is parked", error=str(error))
                raise
        finally:
            taken_s = time.perf_counter() - begun
            metrics.JOBS.labels(name, outcome).inc()
            metrics.JOB_S.labels(name).observe(taken_s)
            log.info("job ended", outcome=outcome, seconds=round(taken_s, 3))


def _worker_here() -> Worker:
    if _worker is None:
        raise RuntimeError("no worker was started in this process")
    return _worker


def _when_available(call: Callable[[], Result]) -> Result:
    """Return a call's result; while the database is away wait for it, since that is not a fault of the job."""
    while True:
        try:
            return call()
        except Exception as error:
            if not is_unavailable(error) or _stopping.wait(UNAVAILABLE_PAUSE_S):
                raise
            log.warning("the database does not answer; a job waits for it", error=str(error))
