"""What the processes count of their own work, who may read it, and what the log carries on from request to job."""

import contextlib
import json
import logging
from collections.abc import Iterator
from uuid import uuid4

import httpx
import pytest
from prometheus_client.parser import text_string_to_metric_families

from app import logs
from app.core import metrics
from app.core.jobs import queue
from app.core.runtime import Runtime
from tests.app.core.test_queue import until
from tests.support.server import RunningServer, World

pytestmark = pytest.mark.both_databases

TOKEN = "figures for machines only"
Figures = dict[tuple[str, frozenset[tuple[str, str]]], float]


def read(text: str) -> Figures:
    """Return every sample by its name and labels."""
    return {
        (sample.name, frozenset(sample.labels.items())): sample.value
        for family in text_string_to_metric_families(text)
        for sample in family.samples
    }


def figure(figures: Figures, name: str, **labels: str) -> float:
    return figures.get((name, frozenset(labels.items())), 0.0)


@pytest.fixture
def scrape(server: RunningServer, monkeypatch: pytest.MonkeyPatch):
    """Return what Prometheus would read now."""
    monkeypatch.setattr(server.runtime.settings, "metrics_token", type(server.runtime.settings.metrics_token)(TOKEN))
    browser = server.browser()

    def ask() -> Figures:
        answer = browser.get("/metrics", headers={"Authorization": f"Bearer {TOKEN}"})
        assert answer.status_code == 200
        return read(answer.text)

    return ask


def test_figures_want_their_token(server: RunningServer, scrape):
    browser = server.browser()
    for headers in ({}, {"Authorization": "Bearer something else"}, {"Authorization": f"Basic {TOKEN}"}):
        assert browser.get("/metrics", headers=headers).json()["code"] == "metrics-token-needed"


def test_without_a_token_there_are_no_metrics(server: RunningServer):
    answer = server.browser().get("/metrics", headers={"Authorization": "Bearer "})
    assert (answer.status_code, answer.json()["code"]) == (404, "no-metrics-here")


@pytest.mark.slow
def test_requests_count_by_route_and_status_and_never_by_what_is_in_the_address(scrape, world: World):
    before = scrape()
    secret = f"secret-{uuid4()}"
    for _ in range(3):
        assert world.nobody.get(f"/v1/invitations/{secret}").status_code == 404
    world.producer.get(f"/v1/projects/{world.project_id}/sound-list")
    after = scrape()

    def grown(name: str, **labels: str) -> float:
        return figure(after, name, **labels) - figure(before, name, **labels)

    assert grown("soundlist_requests_total", method="GET", route="/v1/invitations/{secret}", status="404") == 3
    the_list = "/v1/projects/{project_id}/sound-list"
    assert grown("soundlist_requests_total", method="GET", route=the_list, status="200") == 1
    assert grown("soundlist_request_seconds_count", method="GET", route=the_list) == 1
    assert not any(secret in value for _, labels in after for _, value in labels)


@pytest.mark.slow
def test_an_invented_method_is_counted_with_the_others(scrape, world: World):
    world.nobody.request("BREW", "/v1/me")
    methods = {value for _, labels in scrape() for name, value in labels if name == "method"}
    assert "BREW" not in methods
    assert "other" in methods


@queue.job("counting.count_me")
def count_me(_runtime: Runtime, payload: queue.Payload) -> None:
    if payload["fails"]:
        raise OSError("the disk is full")
    logging.getLogger("app.tests").warning("counted")


def enqueue(runtime: Runtime, *, fails: bool, studio_id=None) -> str:
    key = str(uuid4())
    with runtime.database.writing() as session:
        runtime.queue.enqueue(session, "counting.count_me", {"fails": fails}, key=key, studio_id=studio_id)
    return key


@pytest.mark.slow
def test_jobs_count_by_outcome_and_the_parked_stay_in_sight(server: RunningServer, scrape, monkeypatch):
    monkeypatch.setattr(queue, "RETRY_DELAYS_S", (0.01,))
    runtime, before, studio_id = server.runtime, scrape(), uuid4()
    enqueue(runtime, fails=False)
    enqueue(runtime, fails=True, studio_id=studio_id)
    until(lambda: runtime.queue.counts(studio_id) and runtime.queue.counts(studio_id)[0].state == "parked")
    until(lambda: figure(scrape(), "soundlist_jobs_run_total", job="counting.count_me", outcome="parked"))
    after = scrape()

    def grown(name: str, **labels: str) -> float:
        return figure(after, name, **labels) - figure(before, name, **labels)

    assert grown("soundlist_jobs_run_total", job="counting.count_me", outcome="done") == 1
    assert grown("soundlist_jobs_run_total", job="counting.count_me", outcome="parked") == 1
    assert grown("soundlist_jobs_run_total", job="counting.count_me", outcome="failed") == 1
    assert grown("soundlist_job_seconds_count", job="counting.count_me") == 3
    assert grown("soundlist_job_failures_total", job="counting.count_me") == 2
    assert grown("soundlist_jobs", job="counting.count_me", state="parked") == 1
    (count,) = runtime.queue.counts(studio_id)
    assert (count.name, count.state, count.jobs) == ("counting.count_me", "parked", 1)


@pytest.mark.slow
def test_a_worker_that_lives_is_reported(scrape, server: RunningServer):
    (heartbeat,) = server.runtime.queue.heartbeats(within=queue.timedelta(seconds=20))
    assert figure(scrape(), "soundlist_worker_silent_seconds", worker=heartbeat.worker_id) < 20


@pytest.mark.slow
def test_connections_in_use_are_reported(scrape, server: RunningServer):
    def in_use() -> float:
        return figure(scrape(), "soundlist_database_connections", state="in use")

    with contextlib.ExitStack() as held:
        for _ in range(4):  # more than the server itself ever takes while nobody asks
            held.enter_context(server.runtime.database.reading()).connection()
        assert in_use() >= 4
    assert in_use() < 4


@pytest.fixture
def own_port() -> Iterator[metrics.MetricsServer]:
    listener = metrics.MetricsServer("127.0.0.1", 0, TOKEN, [])
    listener.start()
    yield listener
    listener.stop()


@pytest.mark.slow
def test_a_worker_serves_its_figures_on_a_port_of_its_own(own_port: metrics.MetricsServer):
    address = f"http://127.0.0.1:{own_port.port}"
    assert httpx.get(f"{address}/metrics").status_code == 401
    answer = httpx.get(f"{address}/metrics", headers={"Authorization": f"Bearer {TOKEN}"})
    assert answer.headers["content-type"] == metrics.CONTENT_TYPE
    assert "process_resident_memory_bytes" in answer.text
    assert httpx.get(f"{address}/other").status_code == 404


def test_a_port_that_is_in_use_is_reported(own_port: metrics.MetricsServer):
    with pytest.raises(metrics.CannotListen, match=f"127.0.0.1:{own_port.port}.*its own SOUNDLIST_METRICS_PORT"):
        metrics.MetricsServer("127.0.0.1", own_port.port, TOKEN, [])


# The log


@pytest.fixture
def lines() -> Iterator[list[str]]:
    """What would be written, one JSON object a line."""
    written: list[str] = []
    root = logging.getLogger()
    formatter = root.handlers[0].formatter
    ours = logging.getLogger(logs.OURS)

    class Keep(logging.Handler):
        def emit(self, record: logging.LogRecord) -> None:
            written.append(self.format(record))

    keeper = Keep()
    keeper.setFormatter(formatter)
    root.addHandler(keeper)
    level, ours.level = ours.level, logging.INFO
    ours.manager._clear_cache()
    yield written
    root.removeHandler(keeper)
    ours.setLevel(level)


def test_a_request_is_one_line_with_its_id_and_its_route(world: World, lines: list[str]):
    secret = f"secret-{uuid4()}"
    answer = world.nobody.get(f"/v1/invitations/{secret}")
    (line,) = [json.loads(each) for each in lines if '"event": "request"' in each]
    assert line["request_id"] == answer.headers["x-request-id"]
    assert (line["method"], line["route"], line["status"]) == ("GET", "/v1/invitations/{secret}", 404)
    assert line["seconds"] >= 0
    assert not any(secret in each for each in lines)


@pytest.mark.parametrize(
    ("given", "is_taken"),
    [("from-the-proxy-0001", True), ("short", False), ("with a space in it", False), ("x" * 129, False), ("", False)],
)
def test_an_id_from_outside_is_kept_where_it_is_fit_for_a_log(world: World, given: str, is_taken: bool):
    answer = world.nobody.get("/healthz", headers={"X-Request-ID": given})
    assert (answer.headers["x-request-id"] == given) is is_taken


def test_a_failed_request_is_logged_with_its_traceback_and_its_id(
    server: RunningServer, world: World, lines, monkeypatch
):
    def fail(*_args: object, **_more: object) -> None:
        raise ZeroDivisionError("a fault of ours")

    monkeypatch.setattr("app.dashboards.service.me", fail)
    answer = world.producer.get("/v1/me", headers={"X-Request-ID": "the-failed-one"})
    assert (answer.status_code, answer.json()["code"]) == (500, "our-fault")
    assert answer.headers["x-request-id"] == answer.json()["request_id"] == "the-failed-one"
    (line,) = [json.loads(each) for each in lines if '"event": "request failed"' in each]
    assert line["request_id"] == "the-failed-one"
    assert line["exception"][0]["exc_type"] == "ZeroDivisionError"
    assert "locals" not in json.dumps(line["exception"])  # they may hold what nobody should read in a log


def test_a_job_carries_the_id_of_the_request_that_asked_for_it(server: RunningServer, lines: list[str]):
    with logs.bound({logs.REQUEST_ID: "asked-for-it"}):
        key = enqueue(server.runtime, fails=False)
    until(lambda: any("counted" in line for line in lines))
    scrape = [json.loads(line) for line in lines]
    (line,) = [each for each in scrape if each["event"] == "counted"]
    assert (line["request_id"], line["job"], line["job_id"]) == ("asked-for-it", "counting.count_me", key)
    until(lambda: any("job ended" in line for line in lines))


def test_what_a_job_asks_for_carries_the_same_id(server: RunningServer, world: World, lines: list[str]):
    answer = world.producer.post(
        f"/v1/projects/{world.project_id}/cues",
        json={"cues": [{"name": "Door"}]},
        headers={"X-Request-ID": "one-click-many-jobs"},
    )
    assert answer.status_code == 201
    server.wait_for_jobs()

    def ended() -> set[str]:
        scrape = [json.loads(line) for line in lines if "job ended" in line]
        return {each["job"] for each in scrape if each.get("request_id") == "one-click-many-jobs"}

    # the mail is asked for by the job that the new revision asked for
    until(lambda: ended() >= {"notifications.notify_list_revised"})
