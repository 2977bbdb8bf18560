"""While the database is away requests are refused in words, and nothing needs a restart when it is back."""

import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, as_completed

import httpx
import psycopg
import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal
from sqlalchemy.orm import Session

from app import logs
from app.core.db import Database, ensure_open, is_unavailable
from app.core.runtime import Runtime
from app.core.web import concurrency
from app.main import create_app
from app.migrate import migrate
from app.projects import queries
from app.settings import Settings
from tests.support.deliver import TUS, metadata
from tests.support.postgres import Postgres, running_postgres
from tests.support.server import RunningServer, World
from tests.support.waiting import until

CROWD = 90
WITHIN_S = 240.0
AT_IT_S = 0.3  # an upload that waits for nobody is done by then


@pytest.fixture(scope="module")
def own_postgres() -> Iterator[Postgres]:
    """A server of its own that may be killed, and that still knows then who is signed in."""
    with running_postgres(durable=True) as server:
        yield server


@pytest.fixture(scope="module")
def world(own_postgres: Postgres, tmp_path_factory: pytest.TempPathFactory) -> Iterator[World]:
    settings = Settings(
        data_dir=tmp_path_factory.mktemp("data"),
        secret_key="only for tests",
        database_url=own_postgres.new_database("away"),
    )
    logs.configure()
    runtime = Runtime.of(settings)
    migrate(runtime.database)
    with start_blocking_portal() as portal:
        yield World(RunningServer(runtime, create_app(runtime), portal))
    runtime.close()


@pytest.mark.slow
def test_a_connection_that_drops_in_the_middle_is_reported(
    world: World, own_postgres: Postgres, monkeypatch: pytest.MonkeyPatch
):
    def cut(session: Session, *_: object, **__: object) -> None:
        session.execute(sa.text("select 1"))
        with own_postgres.superuser() as connection:
            connection.execute("select pg_terminate_backend(pid) from pg_stat_activity where datname = 'away'")
        session.execute(sa.text("select 1"))

    with monkeypatch.context() as during:
        during.setattr(queries, "projects_seen", cut)
        asked = world.producer.get("/v1/projects")
        during.setattr(queries, "access_facts", cut)
        sent = world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={})
    assert (asked.status_code, asked.headers["retry-after"]) == (503, "5")
    assert asked.headers["content-type"] == "application/problem+json"
    assert asked.json()["code"] == sent.json()["code"] == "database-away"
    assert asked.json()["detail"] == "the database does not answer"
    assert sent.status_code == 503
    assert "it is not known whether your change was saved" in sent.json()["detail"]
    assert world.producer.get("/v1/projects").status_code == 200


@pytest.mark.slow
def test_a_database_that_comes_back_is_used_again(world: World, own_postgres: Postgres):
    assert world.producer.get("/v1/projects").status_code == 200
    own_postgres.kill()
    answer = world.producer.get("/v1/projects")
    assert (answer.status_code, answer.json()["code"]) == (503, "database-away")
    assert "does not answer" in world.nobody.get("/readyz").json()["database"]
    own_postgres.start()
    assert world.producer.get("/v1/projects").status_code == 200


@pytest.mark.slow
def test_a_line_that_was_ended_while_nobody_used_it_is_not_used(world: World, own_postgres: Postgres):
    assert world.producer.get("/v1/projects").status_code == 200
    with own_postgres.superuser() as connection:
        connection.execute("select pg_terminate_backend(pid, 10000) from pg_stat_activity where datname = 'away'")
    assert world.producer.get("/v1/projects").status_code == 200


@pytest.mark.slow
def test_what_the_queue_keeps_of_its_own_lines_is_asked_only_where_something_came(own_postgres: Postgres):
    events = [(ensure_open, "checkout")]
    engine = sa.create_engine(Database(own_postgres.url("postgres")).engine.url, pool_size=1, pool_events=events)
    own_pid = sa.text("select pg_backend_pid()")
    with engine.begin() as connection:
        first = connection.scalar(own_pid)
    with engine.begin() as connection:
        assert connection.scalar(own_pid) == first, "a line that is there is used again"
    with own_postgres.superuser() as superuser:
        superuser.execute("select pg_terminate_backend(%s, 10000)", [first])
    with engine.begin() as connection:
        assert connection.scalar(own_pid) != first
    engine.dispose()


def test_what_is_our_own_fault_is_not_the_databases(world: World, monkeypatch: pytest.MonkeyPatch):
    def stumble(session: Session, *_: object, **__: object) -> None:
        session.execute(sa.text("select nothing from nowhere"))

    monkeypatch.setattr(queries, "projects_seen", stumble)
    answer = world.producer.get("/v1/projects")
    assert (answer.status_code, answer.json()["code"]) == (500, "our-fault")


@pytest.mark.parametrize(
    ("raised", "away"),
    [
        (psycopg.errors.TooManyConnections("too many"), True),
        (psycopg.errors.CannotConnectNow("starting up"), True),
        (psycopg.errors.ConnectionException("lost"), True),
        (psycopg.OperationalError("connection refused"), True),
        (psycopg.errors.DiskFull("disk full"), False),
        (psycopg.errors.QueryCanceled("too long"), False),
        (psycopg.errors.DeadlockDetected("deadlock"), False),
    ],
)
def test_which_errors_say_that_it_is_away(raised: psycopg.Error, away: bool):
    assert is_unavailable(sa.exc.OperationalError("select 1", {}, raised)) is away


def test_a_locked_sqlite_database_is_away_too(tmp_path):
    url = f"sqlite:///{tmp_path / 'busy.sqlite'}"
    one, other = Database(url), Database(url)
    with one.writing() as first:
        first.execute(sa.text("create table t (x)"))
        with other.engine.connect() as second:
            second.exec_driver_sql("pragma busy_timeout = 1")
            with pytest.raises(sa.exc.OperationalError) as busy:
                second.exec_driver_sql("create table u (x)")
    assert is_unavailable(busy.value)
    one.dispose()
    other.dispose()


@pytest.mark.slow
def test_a_crowd_is_answered_without_waiting_for_itself(world: World):
    # More than there are threads and connections, all for one row: each needs a thread again while it has a connection.
    def open_one(_number: int) -> int:
        return world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={}).status_code

    with ThreadPoolExecutor(CROWD) as crowd:
        statuses = list(crowd.map(open_one, range(CROWD)))
    assert statuses == [201] * CROWD, "requests waited until the pool of connections gave up"


@pytest.mark.slow
def test_a_request_that_waits_too_long_for_a_slot_is_refused(world: World, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(concurrency, "MAX_WAIT_S", 0.3)
    held = sa.text("SELECT 1 FROM projects_projects WHERE id = :id FOR UPDATE")

    def open_one(_number: int) -> httpx.Response:
        return world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={})

    with ThreadPoolExecutor(concurrency.MAX_CONCURRENT_OF_CALLER + 1) as crowd:
        with world.server.runtime.database.writing() as session:
            session.execute(held, {"id": world.project_id})  # each request that runs waits for this row
            coming = [crowd.submit(open_one, number) for number in range(concurrency.MAX_CONCURRENT_OF_CALLER + 1)]
            turned_away = next(as_completed(coming, timeout=WITHIN_S)).result()
            assert world.designer.get("/v1/projects").status_code == 200, "who reads has other seats"
        statuses = sorted(one.result(WITHIN_S).status_code for one in coming)
    assert (turned_away.json()["code"], turned_away.headers["Retry-After"]) == ("overloaded", "5")
    assert statuses == [201] * concurrency.MAX_CONCURRENT_OF_CALLER + [503]
    assert open_one(0).status_code == 201, "the seats are free again"


def requests_that_wait(own_postgres: Postgres) -> int:
    """Return how many transactions wait for a lock of another."""
    waiting = "select count(*) from pg_stat_activity where datname = 'away' and wait_event_type = 'Lock'"
    with own_postgres.superuser() as connection:
        return int(connection.execute(waiting).fetchone()[0])


@pytest.mark.slow
def test_an_upload_gives_way_to_other_requests_but_not_for_long(
    world: World, own_postgres: Postgres, monkeypatch: pytest.MonkeyPatch
):
    delivery_id = world.designer.post(f"/v1/projects/{world.project_id}/deliveries", json={}).json()["id"]
    held = sa.text("SELECT 1 FROM projects_projects WHERE id = :id FOR UPDATE")
    headers = TUS | {"Upload-Length": "3", "Upload-Metadata": metadata(delivery_id=delivery_id, file_name="a.wav")}

    def begin(_number: int = 0) -> int:
        return world.designer.post("/v1/uploads", headers=headers).status_code

    with ThreadPoolExecutor(CROWD + 1) as crowd:
        with world.server.runtime.database.writing() as session:
            session.execute(held, {"id": world.project_id})
            person = crowd.submit(world.designer.post, f"/v1/projects/{world.project_id}/deliveries", json={})
            until(lambda: requests_that_wait(own_postgres) == 1)
            monkeypatch.setattr(concurrency, "YIELD_TO_PEOPLE_S", 60.0)
            first = crowd.submit(begin)
            time.sleep(AT_IT_S)
            assert not first.done(), "it waits for the person"
            assert world.designer.get("/v1/projects").status_code == 200, "people do not"
        assert (person.result(WITHIN_S).status_code, first.result(WITHIN_S)) == (201, 201)
        monkeypatch.setattr(concurrency, "YIELD_TO_PEOPLE_S", 0.01)
        with world.server.runtime.database.writing() as session:
            session.execute(held, {"id": world.project_id})
            person = crowd.submit(world.designer.post, f"/v1/projects/{world.project_id}/deliveries", json={})
            until(lambda: requests_that_wait(own_postgres) == 1)
            assert list(crowd.map(begin, range(CROWD))) == [201] * CROWD, "none waits for a person without end"
            assert not person.done()
        assert person.result(WITHIN_S).status_code == 201
