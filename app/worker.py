"""The worker process: runs the jobs that the rooms asked for."""

import importlib
import signal
import threading
from types import FrameType

import structlog

from app import rooms
from app.kit import events
from app.kit.queue import Worker, job_names
from app.kit.runtime import Runtime
from app.kit.uploads import Uploads
from app.notifications.jobs import send_waiting

CHORES_EVERY_S = 300.0
log = structlog.get_logger(__name__)


def sweep_uploads(runtime: Runtime) -> None:
    """Clear away uploads that nobody finished in time."""
    Uploads(runtime.database, runtime.store).sweep()


CHORES = (sweep_uploads, send_waiting)


def start_worker(runtime: Runtime) -> Worker:
    """Start running jobs in this process."""
    for module in rooms.JOB_MODULES:
        importlib.import_module(module)
    wanted = {name for names in rooms.SUBSCRIBERS.values() for name in names}
    if missing := wanted - job_names():
        raise RuntimeError(f"nobody does the jobs {', '.join(sorted(missing))}")
    events.connect(rooms.SUBSCRIBERS)
    settings = runtime.settings
    worker = Worker(runtime, jobs_at_once=settings.worker_jobs, silent_s=settings.worker_silent_s)
    worker.start()
    return worker


def _do_chores(runtime: Runtime) -> None:
    """Do what no event asks for: clear away abandoned uploads, send mails that a dead server left behind."""
    for chore in CHORES:
        try:
            chore(runtime)
        except Exception:
            log.exception("a chore failed", chore=chore.__name__)


def run(runtime: Runtime) -> None:
    """Run jobs until SIGTERM or SIGINT."""
    stopped = threading.Event()

    def stop(_signal: int, _frame: FrameType | None) -> None:
        stopped.set()

    signal.signal(signal.SIGTERM, stop)
    signal.signal(signal.SIGINT, stop)
    worker = start_worker(runtime)
    _do_chores(runtime)
    while not stopped.wait(CHORES_EVERY_S):
        _do_chores(runtime)
    worker.stop()
    runtime.close()
