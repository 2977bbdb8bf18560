"""Compose's database login owns its database and no more; a superuser is named by `soundlist migrate`."""

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import psycopg
import pytest
from sqlalchemy.engine import make_url

from app.core.db import Database
from app.migrate import login_warning, migrate
from tests.support.postgres import OWNER, SUPERUSER, Postgres, _programs, running_postgres

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def initialised() -> Iterator[Postgres]:
    """A server as the image leaves it: its superuser, and what our script makes."""
    with running_postgres() as server:
        with server.superuser() as connection:
            connection.execute(f"drop role {OWNER}")  # which the tests' own server has made
        subprocess.run(
            ["/bin/sh", str(ROOT / "deploy/postgres.sh")],
            env={
                "PATH": f"{_programs()}:{os.environ['PATH']}",
                "PGHOST": str(server.folder),
                "POSTGRES_USER": SUPERUSER,
                "POSTGRES_PASSWORD": "it's a 'secret'",
            },
            check=True,
        )
        yield server


@pytest.mark.slow
def test_the_login_owns_its_database_and_may_do_nothing_else(initialised: Postgres):
    with initialised.superuser() as connection:
        roles = (
            "select rolcanlogin, array[rolsuper, rolcreatedb, rolcreaterole, rolreplication, rolbypassrls]"
            " from pg_roles where rolname = %s"
        )
        assert connection.execute(roles, [OWNER]).fetchone() == (True, [False] * 5)
        assert connection.execute(roles, ["soundlist_request"]).fetchone() == (False, [False] * 5)
        owner = "select pg_get_userbyid(datdba) from pg_database where datname = 'soundlist'"
        assert connection.execute(owner).fetchone() == (OWNER,)
        passwords = dict(connection.execute("select rolname, rolpassword from pg_authid where rolcanlogin").fetchall())
    assert passwords[SUPERUSER] is None
    assert passwords[OWNER].startswith("SCRAM-SHA-256$")


@pytest.mark.slow
def test_it_suffices_to_migrate_and_to_guard_rows(initialised: Postgres):
    database = Database(initialised.url("soundlist"))
    migrate(database)
    assert login_warning(database) is None
    database.dispose()


@pytest.mark.slow
def test_it_reads_no_file_of_the_server(initialised: Postgres):
    with (
        psycopg.connect(host=str(initialised.folder), user=OWNER, dbname="soundlist") as connection,
        pytest.raises(psycopg.errors.InsufficientPrivilege),
    ):
        connection.execute("copy (select 1) to program 'id'")


@pytest.mark.slow
def test_a_superuser_is_named(initialised: Postgres):
    url = make_url(initialised.url("soundlist")).set(username=SUPERUSER)
    database = Database(url.render_as_string(hide_password=False))
    warning = login_warning(database)
    database.dispose()
    assert warning is not None
    assert warning.startswith(f"the login {SUPERUSER} is a superuser of PostgreSQL")


@pytest.mark.slow
def test_compose_runs_the_script_where_its_volume_is_empty():
    compose = (ROOT / "docker-compose.yml").read_text()
    assert "./deploy/postgres.sh:/docker-entrypoint-initdb.d/soundlist.sh:ro" in compose
    assert "POSTGRES_USER: postgres" in compose
    assert "postgresql://soundlist:" in compose
