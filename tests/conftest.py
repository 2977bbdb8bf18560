"""Which database and store the tests of rooms and journeys run on; the others need none or bring their own."""

import gc
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import settings

from tests.support.postgres import Postgres, running_postgres
from tests.support.s3 import BUILT_WITHIN_S, S3Server, run_s3
from tests.support.statements import Recorder, fewest, recorded

if TYPE_CHECKING:
    from tests.support.server import RunningServer

SQLITE, POSTGRES = "sqlite", "postgres"
FOLDER, S3 = "folder", "s3"
RECORDER: pytest.StashKey[Recorder] = pytest.StashKey()

gc.disable()  # until all is collected: what is imported is never freed

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

    parser.addoption("--record", type=Path, metavar="FOLDER", help="record there what each test sends to SQLite")
    parser.addoption(
        "--recorded", type=Path, metavar="FOLDER",
        help="on PostgreSQL, run the tests marked both_databases and the fewest others that send all that is recorded",
    )  # fmt: skip


def pytest_configure(config: pytest.Config) -> None:
    """Record into a file for each process, and begin with none."""
    folder: Path | None = config.getoption("--record")
    if folder is None:
        return
    worker = getattr(config, "workerinput", None)
    if worker is None:
        folder.mkdir(parents=True, exist_ok=True)
        for file in folder.glob("*.jsonl"):
            file.unlink()
    recorder = Recorder(folder / f"{worker['workerid'] if worker else 'alone'}.jsonl")
    config.stash[RECORDER] = recorder
    config.pluginmanager.register(recorder)


@pytest.hookimpl(tryfirst=True)  # before pytest selects by markers
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """Leave out what this database and store do not need."""
    kept = items[:]
    if config.getoption("--database") == POSTGRES:
        kept = [item for item in kept if "database_url" in getattr(item, "fixturenames", ())]
    other = "on_folder" if config.getoption("--store") == S3 else "on_s3"
    kept = [item for item in kept if item.get_closest_marker(other) is None]
    if config.getoption("--recorded"):
        kept = needed(kept, config.getoption("--recorded"))
    kept_ids = {id(item) for item in kept}
    config.hook.pytest_deselected(items=[item for item in items if id(item) not in kept_ids])
    items[:] = kept
    for item in items:
        if "s3" in getattr(item, "fixturenames", ()):  # its server is built from source, which takes minutes
            item.add_marker(pytest.mark.slow)
            item.add_marker(pytest.mark.timeout(BUILT_WITHIN_S + float(config.getini("timeout"))))


def pytest_collection_finish() -> None:
    """Keep what is imported by now out of garbage collection, which would go through all of it again and again."""
    gc.collect()
    gc.freeze()
    gc.enable()


def needed(items: list[pytest.Item], folder: Path) -> list[pytest.Item]:
    """Return the marked tests, those without a record, and the fewest others that send all that is recorded."""
    ids = {item.nodeid for item in items}
    sent = {test: what for test, what in recorded(folder).items() if test in ids}
    always = {item.nodeid for item in items if item.get_closest_marker("both_databases")}
    chosen = fewest(sent, always) | always | (ids - sent.keys())
    return [item for item in items if item.nodeid in chosen]


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
    request: pytest.FixtureRequest,
    tmp_path_factory: pytest.TempPathFactory,
    database_url: str,
    store_settings: dict[str, Any],
) -> "Iterator[RunningServer]":
    """The application on a database and store with a worker: one for rooms and journeys, as a process has one worker.

    Every test has studios of its own, so nothing needs cleaning.
    """
    from tests.support.server import run_server  # seconds that tests of sounds alone do without

    with run_server(tmp_path_factory.mktemp("server"), database_url=database_url, **store_settings) as running:
        running.recorder = request.config.stash.get(RECORDER, None)
        if running.recorder:
            running.recorder.watch(running.runtime.database.engine)
        yield running
