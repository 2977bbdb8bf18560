"""The OpenAPI document over HTTP."""

import threading
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from anyio.from_thread import start_blocking_portal

from app.kit.runtime import Runtime
from app.main import create_app
from app.settings import Settings
from tests.house.routes import document
from tests.support.server import RunningServer

MORE_THAN_THREADS = 50  # of the pool that answers requests, which has 40
SOON_S = 60.0


@pytest.fixture
def fresh(tmp_path: Path) -> Iterator[RunningServer]:
    """An application that was not asked for its document yet."""
    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    with start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


def test_requests_are_answered_while_many_wait_for_the_document(fresh: RunningServer, monkeypatch: pytest.MonkeyPatch):
    begun, finish, builds = threading.Event(), threading.Event(), []

    def slow() -> dict[str, str]:
        builds.append(1)
        begun.set()
        finish.wait(2 * SOON_S)
        return {"openapi": "é"}

    monkeypatch.setattr(fresh.application, "openapi", slow)
    with ThreadPoolExecutor(MORE_THAN_THREADS + 1) as pool:
        try:
            asked = [pool.submit(fresh.browser().get, "/v1/openapi.json") for _ in range(MORE_THAN_THREADS)]
            assert begun.wait(SOON_S)
            assert pool.submit(fresh.browser().get, "/healthz").result(SOON_S).status_code == 200
        finally:
            finish.set()
        assert {one.result().text for one in asked} == {'{"openapi":"é"}'}
    assert builds == [1]


def test_the_document_is_the_applications(fresh: RunningServer):
    answer = fresh.browser().get("/v1/openapi.json")
    assert answer.headers["content-type"] == "application/json"
    assert answer.json()["paths"] == document()["paths"]
    assert fresh.browser().head("/v1/openapi.json").status_code == 200
