"""The worker process: runs the jobs that the rooms asked for."""

import importlib
import signal
import threading
from datetime import timedelta
from types import FrameType

import structlog
from sqlalchemy.exc import SQLAlchemyError

from app import registry, tables  # noqa: F401  every model, which relations name
from app.accounts import rate_limits
from app.accounts.security_log import service as security_log
from app.core import clock
from app.core.jobs.queue import Payload, job, job_names
from app.core.jobs.workers import Worker
from app.core.runtime import Runtime
from app.core.uploads import Uploads
from app.notifications.mail_jobs import send_pending

CHORES_EVERY_S = 300
JOBS_KEPT_FOR = timedelta(days=30)  # so long their keys detect repeated jobs
log = structlog.get_logger(__name__)


@job("server.sweep_uploads")
def sweep_uploads(runtime: Runtime, _payload: Payload) -> None:
    """Delete uploads that were not finished in time."""
    Uploads(runtime.database, runtime.store).sweep()


@job("server.send_pending")
def send_waiting_mails(runtime: Runtime, _payload: Payload) -> None:
    """Send waiting mails that no job will send: those that a dead server, or one without SMTP, left behind."""
    send_pending(runtime)


@job("server.delete_finished_jobs")
def delete_finished_jobs(runtime: Runtime, _payload: Payload) -> None:
    """Clear away jobs that were done long ago."""
    runtime.queue.delete_finished(clock.now() - JOBS_KEPT_FOR)


@job("server.delete_expired_rate_limits")
def delete_expired_rate_limits(runtime: Runtime, _payload: Payload) -> None:
    """Delete counts of tries that no longer limit anything."""
    with runtime.database.writing() as session:
        rate_limits.delete_expired(session)


@job("server.delete_old_security_events")
def delete_old_security_events(runtime: Runtime, _payload: Payload) -> None:
    """Delete lines that are older than the security log goes back."""
    with runtime.database.writing() as session:
        security_log.delete_old(session)


def start_worker(runtime: Runtime) -> Worker:
    """Start running jobs in this process."""
    settings = runtime.settings
    rooms = registry.rooms_in_use(is_commercial=settings.commercial)
    for module in rooms.job_modules:
        importlib.import_module(module)
    subscribers = {name for names in rooms.subscribers.values() for name in names}
    if missing := subscribers - job_names():
        raise RuntimeError(f"no worker runs the jobs {', '.join(sorted(missing))}")
    rooms.connect()
    worker = Worker(runtime, jobs_at_once=settings.worker_jobs, silent_s=settings.worker_silent_s)
    worker.start()
    return worker


def request_chores(runtime: Runtime) -> None:
    """Write down what no event asks for; however many workers do so, each is one job in its five minutes."""
    turn = int(clock.now().timestamp()) // CHORES_EVERY_S
    with runtime.database.writing() as session:
        for chore in registry.rooms_in_use(is_commercial=runtime.settings.commercial).chores:
            runtime.queue.enqueue(session, chore, {}, key=f"{chore}@{turn}", studio_id=None)


def run(runtime: Runtime) -> None:
    """Run jobs until SIGTERM or SIGINT."""
    stopped = threading.Event()

    def stop(_signal: int, _frame: FrameType | None) -> None:
        stopped.set()

    signal.signal(signal.SIGTERM, stop)
    signal.signal(signal.SIGINT, stop)
    worker = start_worker(runtime)
    while True:
        try:
            request_chores(runtime)
        except SQLAlchemyError as error:
            log.warning("maintenance jobs could not be queued", error=str(error))
        if stopped.wait(CHORES_EVERY_S):
            break
    worker.stop()
    runtime.close()
