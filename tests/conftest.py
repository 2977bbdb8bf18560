"""Which database and store the tests of rooms and journeys run on; the others need none or bring their own."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import settings

from tests.support.postgres import Postgres, running_postgres
from tests.support.s3 import S3Server, run_s3

if TYPE_CHECKING:
    from tests.support.server import RunningServer

SQLITE, POSTGRES = "sqlite", "postgres"
FOLDER, S3 = "folder", "s3"

settings.register_profile("unhurried", deadline=None)  # how long an example takes says how busy the machine is
settings.load_profile("unhurried")


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption(
        "--database", choices=(SQLITE, POSTGRES), default=SQLITE, help="what the rooms and journeys run on"
    )
    parser.addoption(
        "--kill-runs", type=int, default=1, help="how often each kill is tried; more than once, on both databases"
    )
    parser.addoption("--store", choices=(FOLDER, S3), default=FOLDER, help="where the rooms and journeys keep sounds")


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """On PostgreSQL leave out what would only run again as it ran on SQLite; on S3, what wants a folder."""
    there = items[:]
    if config.getoption("--database") == POSTGRES:
        there = [item for item in there if "database_url" in getattr(item, "fixturenames", ())]
    other = "on_folder" if config.getoption("--store") == S3 else "on_s3"
    there = [item for item in there if item.get_closest_marker(other) is None]
    config.hook.pytest_deselected(items=[item for item in items if item not in there])
    items[:] = there


@pytest.fixture(scope="session")
def postgres() -> Iterator[Postgres]:
    """A PostgreSQL server, started by the first test of this process that asks for it."""
    with running_postgres() as server:
        yield server


@pytest.fixture(scope="session")
def database_url(request: pytest.FixtureRequest) -> str:
    """The value of SOUNDLIST_DATABASE_URL for the server under test; empty for the embedded default."""
    if request.config.getoption("--database") == SQLITE:
        return ""
    server: Postgres = request.getfixturevalue("postgres")
    return server.new_database("soundlist")


@pytest.fixture(scope="session")
def s3(tmp_path_factory: pytest.TempPathFactory) -> Iterator[S3Server]:
    """A real S3 server, started by the first test of this process that asks for it."""
    with run_s3(tmp_path_factory.mktemp("s3")) as server:
        yield server


@pytest.fixture(scope="session")
def store_settings(request: pytest.FixtureRequest) -> dict[str, Any]:
    """The settings that name the store of the server under test; none for the embedded default."""
    if request.config.getoption("--store") == FOLDER:
        return {}
    server: S3Server = request.getfixturevalue("s3")
    return server.settings()


@pytest.fixture(scope="session")
def server(
    tmp_path_factory: pytest.TempPathFactory, database_url: str, store_settings: dict[str, Any]
) -> "Iterator[RunningServer]":
    """The application on a database and store with a worker: one for rooms and journeys, as a process has one worker.

    Every test has studios of its own, so nothing needs cleaning.
    """
    from tests.support.server import run_server  # seconds that tests of sounds alone do without

    with run_server(tmp_path_factory.mktemp("server"), database_url=database_url, **store_settings) as running:
        yield running
