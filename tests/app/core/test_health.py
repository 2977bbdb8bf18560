"""Readiness is tried, part by part, and what is wrong is said in words."""

from pathlib import Path

import pytest
import sqlalchemy as sa
from fastapi.testclient import TestClient

from app.core.runtime import Runtime
from app.core.web import health
from app.core.web.health import Readiness
from app.main import create_app
from app.migrate import migrate
from app.settings import Settings
from tests.support.server import RunningServer

PARTS = {"database", "store", "worker", "migrations"}


def test_every_part_is_named(server: RunningServer):
    answer = server.browser().get("/readyz")
    assert answer.status_code == 200
    assert answer.json() == {"status": "ready", **dict.fromkeys(PARTS, "ok")}


@pytest.fixture
def runtime(tmp_path: Path):
    """A database and a store of this test, and nobody who works."""
    runtime = Runtime.of(Settings(data_dir=tmp_path, secret_key="only for tests"))
    migrate(runtime.database)
    yield runtime
    runtime.close()


def asked(runtime: Runtime) -> tuple[int, dict[str, str]]:
    answer = TestClient(create_app(runtime)).get("/readyz")
    return answer.status_code, answer.json()


@pytest.mark.slow
def test_a_load_balancer_keeps_a_web_process_while_no_worker_runs(runtime: Runtime):
    client = TestClient(create_app(runtime))
    answer = client.get("/readyz/web")
    assert (answer.status_code, answer.json()) == (200, {"status": "ready", **dict.fromkeys(PARTS - {"worker"}, "ok")})
    assert client.get("/readyz").status_code == 503


@pytest.mark.slow
def test_without_a_worker_the_server_is_not_ready(runtime: Runtime):
    status, parts = asked(runtime)
    assert status == 503
    assert parts.pop("worker") == "no worker has sent a heartbeat for 20 s; start one with: soundlist worker"
    assert parts == {"status": "not ready", **dict.fromkeys(PARTS - {"worker"}, "ok")}


@pytest.mark.slow
def test_a_database_without_our_tables_wants_to_be_migrated(runtime: Runtime):
    migrate(runtime.database)
    with runtime.database.writing() as session:
        session.execute(sa.text("delete from alembic_version"))
    _, parts = asked(runtime)
    assert "at revision none" in parts["migrations"]
    assert "soundlist migrate" in parts["migrations"]


@pytest.mark.slow
def test_a_database_from_before_the_release_is_not_ready(runtime: Runtime):
    with runtime.database.writing() as session:
        session.execute(sa.text("update alembic_version set version_num = '0078'"))
    code, parts = asked(runtime)
    assert code == 503
    assert "at revision 0078, which a version before 1.0 made" in parts["migrations"]
    assert "name an empty database" in parts["migrations"]


@pytest.mark.slow
def test_a_database_that_a_newer_version_migrated_will_do(runtime: Runtime):
    with runtime.database.writing() as session:
        session.execute(sa.text("update alembic_version set version_num = 'of_a_later_version'"))
    assert asked(runtime)[1]["migrations"] == "ok"  # else a rolling upgrade would stop the servers still running


@pytest.mark.slow
def test_a_store_that_cannot_be_written_is_reported(runtime: Runtime):
    runtime.store.root.parent.mkdir(parents=True, exist_ok=True)
    runtime.store.root.write_text("a file where a folder is wanted")
    _, parts = asked(runtime)
    assert parts["store"].startswith("the store cannot be written to")
    assert str(runtime.store.root) not in parts["store"]  # anyone may ask


@pytest.mark.slow
def test_a_missing_database_is_reported_with_what_depends_on_it(runtime: Runtime, tmp_path: Path):
    for file in tmp_path.glob("soundlist.sqlite*"):
        file.unlink()
    runtime.database.dispose()
    (tmp_path / "soundlist.sqlite").mkdir()
    status, parts = asked(runtime)
    assert status == 503
    assert "the database does not answer" in parts["database"]
    assert parts["worker"] == parts["migrations"] == "cannot be known while the database does not answer"
    assert str(tmp_path) not in str(parts)


@pytest.mark.slow
def test_many_who_ask_share_one_try(runtime: Runtime):
    tried = []
    readiness = Readiness(runtime, {"part": lambda _: tried.append("once")})
    assert [readiness.parts() for _ in range(5)] == [{"part": "ok"}] * 5
    assert tried == ["once"]


@pytest.mark.slow
def test_a_broken_probe_is_not_taken_for_readiness(runtime: Runtime):
    def probe(_runtime: Runtime) -> None:
        raise ZeroDivisionError

    assert health.tried(probe, runtime) == "could not be tried; the log says why"
