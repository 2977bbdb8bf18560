"""One server with its worker per test process; every test has studios of its own, so nothing needs cleaning."""

from collections.abc import Iterator
from typing import Any

import pytest

from tests.support.server import RunningServer, World, run_server


@pytest.fixture(scope="session")
def server(
    tmp_path_factory: pytest.TempPathFactory, database_url: str, store_settings: dict[str, Any]
) -> Iterator[RunningServer]:
    """The application on a real database and store with a real worker, in this process."""
    with run_server(tmp_path_factory.mktemp("server"), database_url=database_url, **store_settings) as running:
        yield running


@pytest.fixture
def world(server: RunningServer) -> World:
    """A new studio with a producer, an audio director who decides, a designer, a project, and strangers."""
    return World(server)
