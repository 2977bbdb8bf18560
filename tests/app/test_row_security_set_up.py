"""The second lock at start: logins and roles that do not fit are named."""

from collections.abc import Iterator
from pathlib import Path

import psycopg
import pytest
import sqlalchemy as sa

from app import tables  # noqa: F401
from app.core.db import Database
from app.core.runtime import Runtime
from app.core.web.health import NotReady
from app.migrate import migrate
from app.row_security import (
    CannotGuardRows,
    ensure_rows_are_guarded,
    guard_rows,
)
from app.settings import Settings
from tests.support.postgres import OWNER, Postgres


@pytest.fixture(scope="module")
def runtime(postgres: Postgres, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Runtime]:
    url = postgres.new_database("set_up")
    runtime = Runtime.of(Settings(data_dir=tmp_path_factory.mktemp("data"), database_url=url))
    migrate(runtime.database)
    yield runtime
    runtime.close()


class TestSetUp:
    """What is wrong with logins and roles is said in words."""

    @pytest.mark.slow
    def test_a_guarded_database_is_ready_and_left_as_it_is(self, runtime: Runtime):
        ensure_rows_are_guarded(runtime)
        said: list[str] = []
        sa.event.listen(
            runtime.database.engine, "before_cursor_execute", lambda _c, _k, statement, *_: said.append(statement)
        )
        guard_rows(runtime.database)
        assert said
        assert not [statement for statement in said if "create policy" in statement]

    @pytest.mark.slow
    @pytest.mark.usefixtures("runtime")
    def test_another_login_is_noticed(self, postgres: Postgres, tmp_path: Path):
        with postgres.superuser("set_up") as connection:
            connection.execute("create role stranger login in role soundlist_request")
        url = postgres.url("set_up").replace(OWNER, "stranger", 1)
        other = Runtime.of(Settings(data_dir=tmp_path, database_url=url))
        with pytest.raises(NotReady, match="does not own the tables"):
            ensure_rows_are_guarded(other)
        other.close()

    def test_lost_policies_are_noticed(self, postgres: Postgres, runtime: Runtime):
        with postgres.superuser("set_up") as connection:
            connection.execute("alter table accounts_studios disable row level security")
        with pytest.raises(NotReady, match="run: soundlist migrate"):
            ensure_rows_are_guarded(runtime)

    @pytest.mark.slow
    def test_a_login_without_the_right_says_what_an_administrator_types(self, postgres: Postgres):
        with postgres.superuser() as connection:
            connection.execute("create role modest login")
        postgres.new_database("modest")
        with postgres.superuser("modest") as connection:
            connection.execute("alter database modest owner to modest")
        database = Database(postgres.url("modest").replace(OWNER, "modest", 1))
        with pytest.raises(CannotGuardRows, match='grant soundlist_request to "modest"') as refusal:
            guard_rows(database)
        typed = str(refusal.value).partition(": ")[2].partition(";")[2]
        with psycopg.connect(host=str(postgres.folder), user="postgres", dbname="modest", autocommit=True) as admin:
            admin.execute(typed)
        migrate(database)
        database.dispose()
