"""Jobs are written with their row, run once in effect, parked when they keep failing, and retried by hand."""

import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app.kit import queue
from app.kit.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings

pytestmark = pytest.mark.xdist_group("one-worker-a-process")
calls: list[str] = []
broken = {"is": True}


@queue.job("tests.note")
def note(_runtime: Runtime, payload: queue.Payload) -> None:
    calls.append(payload["word"])


@queue.job("tests.fail_while_broken")
def fail_while_broken(_runtime: Runtime, payload: queue.Payload) -> None:
    calls.append(payload["word"])
    if broken["is"]:
        raise OSError("the disk is full")


@pytest.fixture
def runtime(tmp_path: Path) -> Iterator[Runtime]:
    runtime = Runtime.of(Settings(data_dir=tmp_path))
    migrate(runtime.database)
    calls.clear()
    yield runtime
    runtime.close()


@pytest.fixture
def worker(runtime: Runtime, monkeypatch: pytest.MonkeyPatch) -> Iterator[queue.Worker]:
    monkeypatch.setattr(queue, "FIRST_RETRY_S", 0.01)
    worker = queue.Worker(runtime, worker_id="tests", jobs_at_once=2)
    worker.start()
    yield worker
    worker.stop(wait_s=2)


def until(condition: Callable[[], object], seconds: float = 20) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "it did not come about"
        time.sleep(0.02)


def enqueue(runtime: Runtime, job: str, word: str, **more: object) -> None:
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, job, {"word": word}, key=f"key of {word}", **more)  # type: ignore[arg-type]


def test_a_job_of_a_transaction_that_failed_never_was(runtime: Runtime, worker: queue.Worker):
    def begin_and_fail() -> None:
        with runtime.database.writing() as session:
            runtime.queue.enqueue(session, "tests.note", {"word": "never"}, key="never")
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        begin_and_fail()
    enqueue(runtime, "tests.note", "later")
    until(lambda: calls)
    assert calls == ["later"]


def test_the_same_key_is_the_same_job(runtime: Runtime, worker: queue.Worker):
    enqueue(runtime, "tests.note", "once")
    enqueue(runtime, "tests.note", "once")
    enqueue(runtime, "tests.note", "last")
    until(lambda: "last" in calls)
    assert calls.count("once") == 1


def test_a_delayed_job_waits(runtime: Runtime, worker: queue.Worker):
    begun = time.monotonic()
    enqueue(runtime, "tests.note", "patience", delay_s=1.0)
    until(lambda: calls)
    assert time.monotonic() - begun >= 1.0


def test_what_keeps_failing_is_parked_and_runs_when_retried(runtime: Runtime, worker: queue.Worker):
    broken["is"] = True
    enqueue(runtime, "tests.fail_while_broken", "stubborn")
    until(lambda: runtime.queue.unfinished(only_failed=True))
    parked = runtime.queue.unfinished(only_failed=True)[0]
    assert (parked.name, parked.state) == ("tests.fail_while_broken", "parked")
    assert len(calls) == queue.ATTEMPTS
    broken["is"] = False
    runtime.queue.retry(parked.id)
    until(lambda: len(calls) == queue.ATTEMPTS + 1)
    until(lambda: not runtime.queue.unfinished())
    assert not runtime.queue.unfinished(only_failed=True)


def test_jobs_wait_for_a_worker(runtime: Runtime):
    enqueue(runtime, "tests.note", "patient")
    assert [job.state for job in runtime.queue.unfinished()] == ["waiting"]
    worker = queue.Worker(runtime, worker_id="tests", jobs_at_once=1)
    worker.start()
    until(lambda: calls)
    worker.stop(wait_s=2)
    assert calls == ["patient"]
