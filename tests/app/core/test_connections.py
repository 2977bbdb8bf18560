"""A process has no more connections to PostgreSQL than the operator allows it, whatever it does at once."""

import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack
from pathlib import Path
from uuid import uuid4

import pytest
import sqlalchemy as sa
from pydantic import ValidationError

from app.core.jobs.workers import engine_connections
from app.core.runtime import Runtime
from app.migrate import migrate
from app.settings import Settings
from app.worker import start_worker
from tests.support.postgres import Postgres

ROOT = Path(__file__).parents[3]
WAIT_S = 0.01  # for a connection that nobody gives back


@pytest.fixture
def settings(postgres: Postgres, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Settings]:
    name = f"connections_{uuid4().hex}"
    yield Settings(
        data_dir=tmp_path_factory.mktemp("data"), secret_key="only for tests", database_url=postgres.new_database(name)
    )
    postgres.drop_database(name)


def exhaust(engine: sa.Engine, kept: ExitStack) -> None:
    """Take every connection that a pool gives."""
    assert isinstance(engine.pool, sa.QueuePool)
    engine.pool._timeout = WAIT_S
    while True:
        try:
            kept.enter_context(engine.connect())
        except sa.exc.TimeoutError:
            return


def opened(postgres: Postgres, settings: Settings) -> int:
    """Return how many connections PostgreSQL counts."""
    name = sa.make_url(settings.database_url).database
    count = "select count(*) from pg_stat_activity where datname = %s and backend_type = 'client backend'"
    with postgres.superuser() as connection:
        row = connection.execute(count, [name]).fetchone()
    assert row is not None
    return int(row[0])


@pytest.mark.slow
def test_a_web_process_opens_as_many_as_it_may(postgres: Postgres, settings: Settings):
    runtime = Runtime.of(settings)
    with ExitStack() as kept:
        assert opened(postgres, settings) == 0, "before anything is asked"
        exhaust(runtime.database.engine, kept)
        runtime.queue._client.check_connection()
        assert opened(postgres, settings) == settings.database_connections == 16
    runtime.close()


def run_worker_and_wait(settings: str) -> None:
    """Run a worker that takes every connection it may, until something comes in: a process has one worker at most."""
    runtime_settings = Settings.model_validate_json(settings)
    runtime = Runtime.of(runtime_settings, engine_connections=engine_connections(runtime_settings.worker_jobs))
    migrate(runtime.database)
    worker = start_worker(runtime)
    with ExitStack() as kept:
        exhaust(runtime.database.engine, kept)
        exhaust(worker.engine, kept)
        runtime.queue._client.check_connection()
        sys.stdout.write("all are taken\n")
        sys.stdout.flush()
        sys.stdin.readline()
    worker.stop()
    runtime.close()


@pytest.mark.slow
def test_a_worker_opens_as_many_as_it_may(postgres: Postgres, settings: Settings):
    program = f"import sys\nfrom {__name__} import run_worker_and_wait\nrun_worker_and_wait(sys.argv[1])"
    given = settings.model_dump_json(include={"data_dir", "database_url"})
    command = [sys.executable, "-c", program, given]
    with subprocess.Popen(command, cwd=ROOT, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as running:
        assert running.stdout is not None
        assert any("all are taken" in line for line in running.stdout)
        count = opened(postgres, settings)
        running.communicate("go on\n")
    assert running.returncode == 0
    assert 1 < count <= settings.database_connections


def test_jobs_that_need_more_connections_are_refused_in_numbers():
    address = "postgresql://soundlist@db/soundlist"
    with pytest.raises(ValidationError, match="need 24 connections; SOUNDLIST_DATABASE_CONNECTIONS is 16"):
        Settings(database_url=address, worker_jobs=8)
    assert Settings(database_url=address, worker_jobs=8, database_connections=24).worker_jobs == 8
    assert Settings(worker_jobs=64).database_url == "", "the embedded database has no server to spare"
