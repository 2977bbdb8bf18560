"""The worker process: runs the jobs that the rooms asked for."""

import importlib
import signal
import threading
from types import FrameType

from app import rooms
from app.kit import events
from app.kit.queue import Worker, job_names
from app.kit.runtime import Runtime


def start_worker(runtime: Runtime) -> Worker:
    """Start running jobs in this process."""
    for module in rooms.JOB_MODULES:
        importlib.import_module(module)
    wanted = {name for names in rooms.SUBSCRIBERS.values() for name in names}
    if missing := wanted - job_names():
        raise RuntimeError(f"nobody does the jobs {', '.join(sorted(missing))}")
    events.connect(runtime.queue, rooms.SUBSCRIBERS)
    worker = Worker(runtime, worker_id=runtime.settings.worker_id, jobs_at_once=runtime.settings.worker_jobs)
    worker.start()
    return worker


def run(runtime: Runtime) -> None:
    """Run jobs until SIGTERM or SIGINT."""
    stopped = threading.Event()

    def stop(_signal: int, _frame: FrameType | None) -> None:
        stopped.set()

    signal.signal(signal.SIGTERM, stop)
    signal.signal(signal.SIGINT, stop)
    worker = start_worker(runtime)
    stopped.wait()
    worker.stop()
    runtime.close()
