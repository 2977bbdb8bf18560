"""A server without a worker: policies need answers, not jobs, and one process runs one worker at most."""

from collections.abc import Iterator
from dataclasses import dataclass

import pytest
from anyio.from_thread import BlockingPortal, start_blocking_portal
from fastapi.testclient import TestClient

from app.kit.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer


@dataclass
class QuickServer(RunningServer):
    """A server whose browsers share one event loop, where each request would start its own."""

    portal: BlockingPortal

    def browser(self) -> TestClient:
        """Return a client without credentials."""
        client = super().browser()
        client.portal = self.portal
        return client


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[RunningServer]:
    """The application on a database of its own."""
    folder = tmp_path_factory.mktemp("policies")
    runtime = Runtime.of(Settings(data_dir=folder, secret_key="only for tests"))
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield QuickServer(runtime, create_app(runtime), portal)
    runtime.database.dispose()
