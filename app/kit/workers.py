"""Runs the jobs of the queue in a worker process, and takes over unfinished jobs of dead workers."""

import os
import secrets
import socket
import threading
import time
from collections.abc import Callable
from concurrent.futures import Future
from datetime import datetime
from typing import TYPE_CHECKING, Any, TypeVar

import sqlalchemy as sa
import structlog
from dbos import DBOS, DBOSConfig

from app import logs
from app.kit import clock, dbos_internals, metrics, queue
from app.kit.db import Database, ensure_open, is_unavailable
from app.kit.queue import Heartbeat, Payload, Work

if TYPE_CHECKING:
    from app.kit.runtime import Runtime

RECOVERY_ATTEMPTS = 5  # a job that kills its worker so often is parked
UNAVAILABLE_PAUSE_S = 1.0
BEATS_UNTIL_SILENT = 3
HEARTBEAT, LOOKING = "heartbeat", "looking for work"  # names of threads
POLL_EVERY_S, IDLE_LOOK_EVERY_S = 0.05, 0.2  # for work: after there was some, and once there has been none for long
IDLE_POLL_FACTOR = 1.25  # from one to the other, by so much each time
GATHER_S = 0.2  # after a job has ended, for one look to fill half of the seats: a look costs more than what it begins
FIRST_LANE = f"{queue.NOBODY}:{queue.NORMAL}"  # of jobs written before there were lanes
Result = TypeVar("Result")
_stopping = threading.Event()  # the worker in this process ends
_worker: "Worker | None" = None  # the one here; its runtime is not an argument of a job, since DBOS stores those
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
        self._unheld: set[str] = set()  # jobs that stood as run here at the last beat, and were not
        self._beating = threading.Thread(target=self._live, name=HEARTBEAT, daemon=True)
        self._begun: set[Future[Any]] = set()
        self._seat_free = threading.Event()
        self._poller = threading.Thread(target=self._poll, name=LOOKING, daemon=True)

    def start(self) -> None:
        """Record a heartbeat, then run waiting jobs; a process has one worker at most, as it has one DBOS."""
        global _worker  # noqa: PLW0603
        if _worker is not None and not _worker.has_stopped:
            raise RuntimeError("a worker runs in this process; stop it, or start the other one in another process")
        _stopping.clear()
        self._beat()
        _worker = self
        self._dbos = DBOS(config=_config(self._database, self.id, self._jobs_at_once))
        DBOS.workflow(name=queue.RUN_JOB, max_recovery_attempts=RECOVERY_ATTEMPTS)(_run_job)
        DBOS.listen_queues([])  # it would ask five times where we ask once, and leave a seat empty until the next look
        DBOS.launch()
        self._queue = DBOS.register_queue(
            queue.JOB_QUEUE,
            worker_concurrency=self._jobs_at_once,
            polling_interval_sec=POLL_EVERY_S,
            on_conflict="always_update",
        )
        self._beating.start()
        self._poller.start()

    def stop(self, *, wait_s: int = 10) -> None:
        """Let running jobs end, then stop; what is not done by then another worker takes over."""
        _stopping.set()
        self._seat_free.set()
        self._poller.join(timeout=wait_s)
        DBOS.destroy(destroy_registry=True, workflow_completion_timeout_sec=wait_s)
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

    def _poll(self) -> None:
        """Fill free seats with jobs: as soon as one is free while work waits, else now and then."""
        pause_s = POLL_EVERY_S
        while not _stopping.is_set():
            self._seat_free.clear()
            free, claimed = self._jobs_at_once - len(self._begun), 0
            try:
                claimed = self._claim() if free > 0 else 0
            except Exception as error:
                if not is_unavailable(error):
                    log.exception("a worker cannot look for work")
            pause_s = POLL_EVERY_S if claimed or free <= 0 else min(pause_s * IDLE_POLL_FACTOR, IDLE_LOOK_EVERY_S)
            # With all slots full more jobs may wait: finished jobs wake this loop; the pause covers a missed wake-up.
            if self._seat_free.wait(UNAVAILABLE_PAUSE_S if claimed >= free else pause_s):
                self._gather()

    def _gather(self) -> None:
        """Return once half of the seats are free, or after a while; the others are at work meanwhile."""
        until = time.monotonic() + GATHER_S
        while 2 * len(self._begun) > self._jobs_at_once and (left_s := until - time.monotonic()) > 0:
            self._seat_free.clear()
            if _stopping.is_set():
                return
            self._seat_free.wait(left_s)

    def _claim(self) -> int:
        """Begin the jobs at the head of the line that there are seats for; return how many."""
        begun = 0
        for job in dbos_internals.begin_jobs(
            self._dbos, self._queue, self.id, version=queue.STEPS_VERSION, running=len(self._begun)
        ):
            begun += 1
            if job is not None:
                self._begun.add(job)
                job.add_done_callback(self._end)
        return begun

    def _end(self, begun: "Future[Any]") -> None:
        self._begun.discard(begun)
        self._seat_free.set()

    def _live(self) -> None:
        while not self._stopped.wait(self._silent_s / BEATS_UNTIL_SILENT):
            try:
                self._beat()
                if not _stopping.is_set():
                    self._take_over()
                    self._take_back()
            except Exception as error:
                # A worker that could not read heartbeats cannot judge whose are missing: start again.
                self._watched.clear()
                log.warning("a worker could not record its heartbeat", error=str(error))

    def _beat(self) -> None:
        with self._database.writing() as session:
            session.merge(Heartbeat(worker_id=self.id, beat_at=clock.now()))

    def _take_over(self) -> None:
        """Put back into the line what workers hold that have been silent for too long; a job is put back once."""
        for worker_id in self._silent():
            log.warning("a worker is silent; its jobs are taken over", worker=worker_id)
            dbos_internals.take_over(worker_id)
            self._forget(worker_id)
            del self._watched[worker_id]

    def _take_back(self) -> None:
        """Put jobs back into the queue that are recorded as run by this worker but are not running.

        DBOS drops a job if the database becomes unavailable just as the job's end is written.
        """
        unheld = self.runtime.queue.held_by(self.id) - dbos_internals.running_jobs(self._dbos)
        for job_id in unheld & self._unheld:  # at two beats: between claim and start a job is in no list
            log.warning("a job's end was not written; it runs again", job_id=job_id)
            dbos_internals.requeue(self._dbos, job_id, worker_id=self.id, queue_name=queue.JOB_QUEUE)
        self._unheld = unheld

    def _silent(self) -> list[str]:
        """Return the others whose beat has stood still, by this process's own clock, for too long."""
        with self._database.reading() as session:
            beats = dict(session.execute(sa.select(Heartbeat.worker_id, Heartbeat.beat_at)).all())
        heard: dict[str, datetime | None] = dict.fromkeys(self.runtime.queue.in_hand()) | beats
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


def _sync_later(connection: Any, _record: Any) -> None:
    """Let SQLite sync a job's progress together with the next commit that must be durable.

    After a power failure the job runs again. Jobs themselves are written in our transactions.
    """
    connection.execute("PRAGMA synchronous=NORMAL")


def _prepare_soon(connection: Any, _record: Any) -> None:
    """Have PostgreSQL keep the plan of a statement that is sent a second time, as our own connections do."""
    connection.prepare_threshold = 1


def _pool_size(jobs_at_once: int) -> int:
    return jobs_at_once + 2  # each job's progress, the search for work, and what takes over from dead workers


def engine_connections(jobs_at_once: int) -> int:
    """Return the most connections of the engine of jobs, with the one that listens for notifications."""
    return _pool_size(jobs_at_once) + 1


def _config(database: Database, worker_id: str, jobs_at_once: int) -> DBOSConfig:
    return {
        "name": queue.APPLICATION,
        "system_database_url": queue.system_url(database),
        "application_version": queue.STEPS_VERSION,
        "executor_id": worker_id,
        "serializer": dbos_internals.SERIALIZER,
        "sys_db_pool_size": _pool_size(jobs_at_once),
        "db_engine_kwargs": {
            "pool_pre_ping": False,
            "pool_use_lifo": True,  # the connection that was used last has its statements prepared
            "pool_events": [(_sync_later, "connect")]
            if database.is_sqlite
            else [(ensure_open, "checkout"), (_prepare_soon, "connect")],
        },
        "max_executor_threads": max(8, jobs_at_once * 4),
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
    work, job_id = Work(name, payload, cause or {}, lane, attempt), str(DBOS.workflow_id)
    begun, outcome = time.perf_counter(), "failed"
    with logs.bound(work.cause, job=name, job_id=job_id):
        try:
            _when_available(lambda: queue.handler_of(name)(_runs_in(), payload))
            outcome = "done"
        except Exception as error:
            metrics.JOB_FAILURES.labels(name).inc()
            log.warning("job failed", attempt=attempt, attempts=len(queue.RETRY_DELAYS_S) + 1, exc_info=True)
            failure = error
            if not _when_available(lambda: _runs_in().queue.schedule_retry(job_id, work, failure)):
                outcome = "parked"
                log.error("job is parked", error=str(error))
                raise
        finally:
            taken_s = time.perf_counter() - begun
            metrics.JOBS.labels(name, outcome).inc()
            metrics.JOB_S.labels(name).observe(taken_s)
            log.info("job ended", outcome=outcome, seconds=round(taken_s, 3))


def _runs_in() -> "Runtime":
    if _worker is None:
        raise RuntimeError("no worker was started in this process")
    return _worker.runtime


def _when_available(call: Callable[[], Result]) -> Result:
    """Return what a call gives; while the database is away wait for it, since that is not a fault of the job."""
    while True:
        try:
            return call()
        except Exception as error:
            if not is_unavailable(error) or _stopping.wait(UNAVAILABLE_PAUSE_S):
                raise
            log.warning("the database does not answer; a job waits for it", error=str(error))
