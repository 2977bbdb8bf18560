"""Jobs are written with their row, run once in effect, take turns, outlive workers, and are parked and retried."""

import logging
import threading
import time
from datetime import UTC, datetime, timedelta
from pathlib import Path
from types import SimpleNamespace
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from dbos import DBOSClient, DBOSPortableJSONSerializer

from app import worker
from app.core.db import Database, new_id
from app.core.jobs import queue, workers
from app.core.runtime import Runtime
from app.settings import Settings
from tests.support.server import RunningServer
from tests.support.waiting import until

pytestmark = pytest.mark.both_databases

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


running: set[str] = set()
together: list[int] = []  # for each job: the jobs that ran while it did, at most


@queue.job("tests.meet")
def meet(_runtime: Runtime, _payload: queue.Payload) -> None:
    me = threading.current_thread().name
    running.add(me)
    deadline = time.monotonic() + 0.3
    most = 0
    while time.monotonic() < deadline:
        most = max(most, len(running))
        time.sleep(0.01)
    running.discard(me)
    together.append(most)


@pytest.fixture
def runtime(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> Runtime:
    """The running server's; its worker runs these jobs too, with short pauses between attempts."""
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", (0.01, 0.01))
    server.wait_for_jobs()
    calls.clear()
    return server.runtime


def enqueue(runtime: Runtime, job: str, word: str, **more: Any) -> None:
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, job, {"word": word}, key=f"key of {word}", studio_id=None, **more)


def enqueue_many(runtime: Runtime, *jobs: tuple[UUID, int, str]) -> None:
    """Write jobs in one transaction, so that they come into sight at once: studio, urgency, word."""
    with runtime.database.writing() as session:
        for studio_id, priority, word in jobs:
            runtime.queue.enqueue(
                session, "tests.note", {"word": word}, key=str(new_id()), studio_id=studio_id, priority=priority
            )


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


@pytest.mark.slow
def test_what_keeps_failing_is_parked_with_its_reason_and_runs_when_retried(runtime: Runtime):
    broken["is"] = True
    enqueue(runtime, "tests.fail_while_broken", "stubborn")
    until(lambda: parked(runtime))
    (stuck,) = parked(runtime)
    assert (stuck.name, stuck.state, stuck.tries) == ("tests.fail_while_broken", "parked", 3)
    assert stuck.reason == "OSError: the disk is full"
    assert len(calls) == 3

    runtime.queue.retry(stuck.id)  # too early: it fails again, and is parked again
    until(lambda: len(calls) == 4)
    until(lambda: [each.state for each in parked(runtime)] == ["parked"])

    broken["is"] = False
    runtime.queue.retry(stuck.id)
    until(lambda: len(calls) == 5)
    until(lambda: not parked(runtime))


def test_a_job_that_failed_once_waits_without_holding_up_others(runtime: Runtime, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", (3600.0,))
    broken["is"] = True
    for number in range(4):  # more than run at once
        enqueue(runtime, "tests.fail_while_broken", f"fails {number}")
    enqueue(runtime, "tests.note", "goes on")
    until(lambda: "goes on" in calls)
    failed = "tests.fail_while_broken"
    until(lambda: [each.state for each in runtime.queue.unfinished() if each.name == failed] == ["delayed"] * 4)
    assert len(calls) == 5


@pytest.mark.slow
def test_a_few_files_do_not_wait_for_anothers_thousands(runtime: Runtime):
    crowd, few = new_id(), new_id()
    enqueue_many(
        runtime,
        *((crowd, queue.NORMAL, f"crowd {number}") for number in range(100)),
        *((few, queue.NORMAL, f"few {number}") for number in range(10)),
    )
    until(lambda: sum(word.startswith("few") for word in calls) == 10)
    last = max(place for place, word in enumerate(calls) if word.startswith("few"))
    assert last < 30, "turn by turn: ten and ten, and what runs meanwhile"
    enqueue_many(runtime, (few, queue.NORMAL, "one more"))  # and again while the crowd is still there
    place = len(calls)
    until(lambda: "one more" in calls)
    assert calls.index("one more") - place <= 15
    until(lambda: len(calls) == 111)


@pytest.mark.slow
def test_one_upload_goes_before_its_own_studios_thousands_of_renders(runtime: Runtime):
    studio = new_id()
    enqueue_many(
        runtime,
        *((studio, queue.BULK, f"render {number}") for number in range(40)),
        (studio, queue.NORMAL, "upload"),
        (studio, queue.URGENT, "click"),
    )
    until(lambda: len(calls) == 42)
    assert calls.index("click") <= 5
    assert calls.index("upload") <= 5


@pytest.mark.slow
def test_what_is_not_urgent_is_done_all_the_same(runtime: Runtime):
    crowd, few = new_id(), new_id()
    enqueue_many(
        runtime,
        *((crowd, queue.NORMAL, f"upload {number}") for number in range(60)),
        (few, queue.BULK, "render"),
    )
    until(lambda: len(calls) == 61)
    assert 5 <= calls.index("render") <= 20, "ten of one for one of the other"


@pytest.mark.slow
def test_what_a_silent_worker_holds_is_taken_over(runtime: Runtime, server: RunningServer):
    jobs = queue.workflows(is_sqlite=runtime.database.is_sqlite)
    with runtime.database.writing() as session:
        session.add(queue.Heartbeat(worker_id="dead", beat_at=queue.clock.now()))
        for holder in ("dead", "never-beat"):
            key = f"held by {holder}"
            runtime.queue.enqueue(session, "tests.note", {"word": key}, key=key, studio_id=None, delay_s=3600)
            held = sa.update(jobs).where(jobs.c.workflow_uuid == key)
            session.execute(held.values(status="PENDING", executor_id=holder))
    until(lambda: len(calls) == 2)
    assert sorted(calls) == ["held by dead", "held by never-beat"]
    until(lambda: "dead" not in {each.worker_id for each in runtime.queue.heartbeats(within=queue.timedelta(days=1))})
    server.wait_for_jobs()


def test_one_worker_takes_over_from_a_silent_one(runtime: Runtime, server: RunningServer):
    assert server.worker is not None
    beat_at = queue.clock.now()
    with runtime.database.writing() as session:
        session.add(queue.Heartbeat(worker_id="just died", beat_at=beat_at))
    claims = [server.worker._claim_silent("just died", beat_at) for _ in range(2)]
    assert claims == [True, False], "the second looks at a heartbeat that the first has renewed"
    assert [server.worker._claim_silent("died before it beat", None) for _ in range(2)] == [True, False]
    with runtime.database.writing() as session:
        session.execute(sa.delete(queue.Heartbeat).where(queue.Heartbeat.worker_id.like("%died%")))


def test_a_job_that_loses_five_workers_is_parked_and_can_be_retried(runtime: Runtime):
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, "tests.note", {"word": "poison"}, key="poison", studio_id=None, delay_s=3600)
    runtime.queue._client.update_workflow_attributes("poison", {"recoveries": queue.MAX_RECOVERIES - 1}, merge=True)
    table = queue.workflows(is_sqlite=runtime.database.is_sqlite)
    with runtime.database.writing() as session:
        session.execute(sa.update(table).where(table.c.workflow_uuid == "poison").values(status="PENDING"))
    runtime.queue.requeue(["poison"])
    (poison,) = parked(runtime)
    assert poison.reason == "its worker ended before the job did, 5 times"
    assert runtime.queue.retry("poison")
    assert not runtime.queue.retry("poison"), "it is not parked any more"
    until(lambda: calls == ["poison"])


def test_a_job_whose_end_its_worker_could_not_write_runs_again(runtime: Runtime, server: RunningServer):
    """It is held by a worker that lives and does not run it."""
    (worker,) = runtime.queue.heartbeats(within=queue.timedelta(days=1))
    jobs = queue.workflows(is_sqlite=runtime.database.is_sqlite)
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, "tests.note", {"word": "again"}, key="held", studio_id=None, delay_s=3600)
        held = sa.update(jobs).where(jobs.c.workflow_uuid == "held")
        session.execute(held.values(status="PENDING", executor_id=worker.worker_id))
    until(lambda: calls == ["again"])
    server.wait_for_jobs()


def test_a_process_has_one_worker(runtime: Runtime):
    def known() -> set[str]:
        return {beat.worker_id for beat in runtime.queue.heartbeats(within=timedelta(minutes=1))}

    before = known()
    with pytest.raises(RuntimeError, match="a worker runs in this process"):
        worker.start_worker(runtime)
    assert known() <= before


def test_a_job_that_an_older_version_wrote_is_done(runtime: Runtime):
    """What is stored only grows at its end; and every version claims jobs under the same constant."""
    client = DBOSClient(system_database_url=queue.system_url(runtime.database), application_name=queue.APPLICATION)
    options: Any = {
        "workflow_name": queue.RUN_JOB,
        "queue_name": queue.JOB_QUEUE,
        "app_version": "1",
        "priority": queue.NORMAL,
    }
    client.enqueue(options, "tests.note", {"word": "two arguments"})
    client.enqueue(options, "tests.note", {"word": "three arguments"}, {"request_id": "long ago"})
    client.destroy()
    until(lambda: len(calls) == 2)


def test_arguments_are_stored_as_json(runtime: Runtime, server: RunningServer):
    enqueue(runtime, "tests.note", "plain")
    until(lambda: calls == ["plain"])
    server.wait_for_jobs()
    client = DBOSClient(
        system_database_url=queue.system_url(runtime.database),
        application_name=queue.APPLICATION,
        serializer=DBOSPortableJSONSerializer(),
    )
    (stored,) = client.list_workflows(workflow_ids=["key of plain"])
    assert stored.input["args"][:2] == ("tests.note", {"word": "plain"})
    table = queue.workflows(is_sqlite=runtime.database.is_sqlite)
    with runtime.database.reading() as session:
        by_key = sa.select(sa.column("serialization")).select_from(table).where(table.c.workflow_uuid == "key of plain")
        assert session.scalar(by_key) == "portable_json"


def test_only_what_is_promised_to_nobody_is_synced_later(runtime: Runtime, server: RunningServer, tmp_path: Path):
    if not runtime.database.is_sqlite:
        pytest.skip("SQLite's own")
    assert server.worker is not None
    synced = []
    as_served = Database(f"sqlite:///{tmp_path / 'test.sqlite'}")  # the server of tests syncs nothing
    for engine in (as_served.engine, server.worker.engine):
        with engine.connect() as connection:
            synced.append(connection.exec_driver_sql("PRAGMA synchronous").scalar_one())
    assert synced == [2, 1], "FULL and NORMAL"


def test_a_worker_runs_no_more_jobs_than_it_has_slots(runtime: Runtime):
    """Also where another worker, which has more, has set the number of the queue that they share."""
    settings = runtime.settings
    runtime.queue.register(jobs_at_once=3 * settings.worker_jobs, poll_every_s=0.05)
    try:
        together.clear()
        with runtime.database.writing() as session:
            for number in range(3 * settings.worker_jobs):
                key = f"beside {number}"
                runtime.queue.enqueue(session, "tests.meet", {}, key=key, studio_id=None)
        until(lambda: len(together) == 3 * settings.worker_jobs)
        assert max(together) == settings.worker_jobs
    finally:
        runtime.queue.register(jobs_at_once=settings.worker_jobs, poll_every_s=0.05)


def test_done_jobs_are_forgotten_after_a_while(runtime: Runtime):
    enqueue(runtime, "tests.note", "long ago")
    until(lambda: calls == ["long ago"])
    enqueue(runtime, "tests.note", "waits", delay_s=3600)
    jobs = queue.workflows(is_sqlite=runtime.database.is_sqlite)

    def kept() -> set[str]:
        with runtime.database.reading() as session:
            return set(session.scalars(sa.select(jobs.c.workflow_uuid).where(jobs.c.workflow_uuid.like("key of %"))))

    now = queue.clock.now()
    runtime.queue.delete_finished(now - queue.timedelta(days=1))
    assert {"key of long ago", "key of waits"} <= kept()
    until(lambda: runtime.queue.delete_finished(now + queue.timedelta(days=1)))
    assert "key of waits" in kept()
    assert "key of long ago" not in kept()


@pytest.mark.slow
def test_a_chore_is_one_job_however_many_workers_ask(runtime: Runtime, monkeypatch: pytest.MonkeyPatch):
    done: list[int] = []
    monkeypatch.setitem(queue._handlers, "server.sweep_uploads", lambda _runtime, _payload: done.append(1))
    with monkeypatch.context() as then:
        then.setattr(worker.clock, "now", lambda: datetime(2001, 1, 1, tzinfo=UTC))  # a turn of this test's own
        for _ in range(4):
            worker.request_chores(runtime)
    until(lambda: done)
    enqueue(runtime, "tests.note", "after")
    until(lambda: "after" in calls)
    assert done == [1]


def test_a_warning_of_the_engine_is_written_once_in_a_while(monkeypatch: pytest.MonkeyPatch):
    """Each of its polls warns while the database is away."""
    now_s = [100.0]
    monkeypatch.setattr(workers, "time", SimpleNamespace(monotonic=lambda: now_s[0]))
    warning, error = (logging.LogRecord("dbos", level, "queue.py", 1, "away", (), None) for level in (30, 40))
    written = []
    for now_s[0] in (100.0, 100.1, 109.0, 110.1):
        written.append(workers._is_news(warning))
    assert written == [True, False, False, True]
    assert [workers._is_news(error) for _ in range(2)] == [True, True]


def test_the_longest_silence_allowed_is_over_within_half_a_minute():
    longest_s = next(limit.le for limit in Settings.model_fields["worker_silent_s"].metadata if hasattr(limit, "le"))
    beat_s = longest_s / workers.BEATS_UNTIL_SILENT
    assert beat_s + longest_s + beat_s <= 30, "since the last beat: until it is noticed, and until others look"
