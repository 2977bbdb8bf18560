"""Servers to be killed: on the database that a test names, or on both where each kill is tried many times."""

from collections.abc import Iterator
from pathlib import Path
from typing import cast

import pytest

from tests.kill.processes import ProcessServer, SomeOf, Zygote
from tests.support.postgres import Postgres, running_postgres
from tests.support.server import RunningServer, World


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """Try each kill as often as asked."""
    if "killed_on" not in metafunc.fixturenames:
        return
    runs = int(metafunc.config.getoption("--kill-runs"))
    (marker,) = metafunc.definition.iter_markers("killed_on")
    kinds = [marker.args[0]] if runs == 1 or marker.kwargs.get("only") else ["sqlite", "postgres"]
    tries = [pytest.param(kind, id=f"{kind}-{run}") for kind in kinds for run in range(1, runs + 1)]
    metafunc.parametrize("killed_on", tries)


@pytest.fixture
def some_of(request: pytest.FixtureRequest) -> SomeOf:
    """Choose the points of a kill: every one where kills are tried often, each so-many-th where they are tried once."""
    is_short = request.config.getoption("--kill-runs") == 1
    return lambda points, step: points[1::step] if is_short else points


@pytest.fixture(scope="session")
def zygote() -> Iterator[Zygote]:
    zygote = Zygote()
    yield zygote
    zygote.close()


@pytest.fixture(scope="session")
def durable_postgres() -> Iterator[Postgres]:
    """A PostgreSQL that keeps what it acknowledged through a kill."""
    with running_postgres(durable=True) as server:
        yield server


@pytest.fixture
def database_to_kill(killed_on: str, request: pytest.FixtureRequest) -> Iterator[str]:
    if killed_on == "sqlite":
        yield ""
        return
    server: Postgres = request.getfixturevalue("durable_postgres")
    yield server.new_database("killed")
    server.drop_database("killed")


@pytest.fixture
def server(zygote: Zygote, tmp_path: Path, database_to_kill: str) -> Iterator[ProcessServer]:
    server = ProcessServer(zygote, tmp_path, database_url=database_to_kill)
    yield server
    server.close()


@pytest.fixture
def world(server: ProcessServer) -> World:
    return World(cast(RunningServer, server))
