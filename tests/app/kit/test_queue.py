"""Jobs are written with their row, run once in effect, parked when they keep failing, and retried by hand."""

import time
from collections.abc import Callable
from typing import Any

import pytest

from app.kit import queue
from app.kit.runtime import Runtime
from tests.support.server import RunningServer

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
def runtime(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> Runtime:
    """The running server's; its worker runs these jobs too, with short pauses between tries."""
    monkeypatch.setattr(queue, "FIRST_RETRY_S", 0.01)
    calls.clear()
    return server.runtime


def until(condition: Callable[[], object], seconds: float = 20) -> None:
    deadline = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < deadline, "it did not come about"
        time.sleep(0.02)


def enqueue(runtime: Runtime, job: str, word: str, **more: Any) -> None:
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, job, {"word": word}, key=f"key of {word}", studio_id=None, **more)


def parked(runtime: Runtime) -> list[queue.UnfinishedJob]:
    return [each for each in runtime.queue.unfinished(only_failed=True) if each.name.startswith("tests.")]


def test_a_job_of_a_transaction_that_failed_never_was(runtime: Runtime):
    def begin_and_fail() -> None:
        with runtime.database.writing() as session:
            runtime.queue.enqueue(session, "tests.note", {"word": "never"}, key="never", studio_id=None)
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        begin_and_fail()
    enqueue(runtime, "tests.note", "later")
    until(lambda: calls)
    assert calls == ["later"]


def test_the_same_key_is_the_same_job(runtime: Runtime):
    enqueue(runtime, "tests.note", "once")
    enqueue(runtime, "tests.note", "once")
    enqueue(runtime, "tests.note", "last")
    until(lambda: "last" in calls)
    assert calls.count("once") == 1


def test_a_delayed_job_waits(runtime: Runtime):
    begun = time.monotonic()
    enqueue(runtime, "tests.note", "patience", delay_s=1.0)
    until(lambda: calls)
    assert time.monotonic() - begun >= 1.0


def test_what_keeps_failing_is_parked_and_runs_when_retried(runtime: Runtime):
    broken["is"] = True
    enqueue(runtime, "tests.fail_while_broken", "stubborn")
    until(lambda: parked(runtime))
    (stuck,) = parked(runtime)
    assert (stuck.name, stuck.state) == ("tests.fail_while_broken", "parked")
    assert len(calls) == queue.ATTEMPTS
    broken["is"] = False
    runtime.queue.retry(stuck.id)
    until(lambda: len(calls) == queue.ATTEMPTS + 1)
    until(lambda: not parked(runtime))
