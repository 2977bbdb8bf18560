"""One migration history, equal to the models, up and down; and no table of ours is DBOS's."""

from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic import command

from app.kit import queue
from app.kit.db import Base, Database
from app.migrate import alembic_config, migrate
from app.reviews.models import GivenReason
from app.row_security import PERSONAL, SERVERS_OWN, UNGUARDED
from benchmarks.bulk import filling
from benchmarks.studios import ProjectMaker, make_team
from tests.support.postgres import Postgres

NOT_IN_THE_FIRST = {"reviews_given_reasons": 0}  # tables that go on the way down, with their rows
ROOMS = (
    "accounts",
    "briefs",
    "builds",
    "conformance",
    "contracts",
    "deliveries",
    "hiring",
    "kit",
    "notifications",
    "projects",
    "references",
    "renders",
    "reviews",
    "scenes",
    "shares",
    "sound_lists",
    "voice_lines",
    "webhooks",
)


@pytest.fixture(params=["sqlite", "postgres"])
def database(request: pytest.FixtureRequest, tmp_path: Path):
    if request.param == "sqlite":
        database = Database(f"sqlite:///{tmp_path / 'soundlist.sqlite'}")
        yield database
    else:
        postgres: Postgres = request.getfixturevalue("postgres")
        postgres.drop_database("migrations")
        database = Database(postgres.new_database("migrations"))
        yield database
    database.dispose()


def tables_of(database: Database) -> set[str]:
    return set(sa.inspect(database.engine).get_table_names())


def test_the_history_ends_at_the_models(database: Database):
    migrate(database)
    command.check(alembic_config(database))


def test_down_and_up_again(database: Database):
    migrate(database)
    full = tables_of(database)
    command.downgrade(alembic_config(database), "base")
    assert not tables_of(database) & set(Base.metadata.tables)
    migrate(database)
    assert tables_of(database) == full


def test_rows_live_through_every_step_down_and_up(database: Database):
    migrate(database)
    with filling(database) as bulk:
        ProjectMaker(bulk, make_team(bulk, "Team"), takes=60, seed=1).make()
    before = rows_in(database)
    command.downgrade(alembic_config(database), "0027")  # the first
    migrate(database)
    assert rows_in(database) == before | NOT_IN_THE_FIRST
    assert before["deliveries_takes"] >= 60
    if database.is_sqlite:
        with database.engine.connect() as connection:
            assert connection.exec_driver_sql("PRAGMA foreign_keys").scalar() == 1


def test_a_reason_that_was_given_before_gets_the_cue_and_the_designer_of_its_version(database: Database):
    migrate(database)
    with filling(database) as bulk:
        ProjectMaker(bulk, make_team(bulk, "Team"), takes=60, seed=1).make()
    columns = (GivenReason.verdict_id, GivenReason.reason, GivenReason.cue_id, GivenReason.designer_id)
    asked = sa.select(*columns).order_by(GivenReason.verdict_id, GivenReason.reason)
    with database.engine.connect() as connection:
        before = connection.execute(asked).all()
    command.downgrade(alembic_config(database), "0077")
    migrate(database)
    with database.engine.connect() as connection:
        assert connection.execute(asked).all() == before
    assert len(before) >= 10


def rows_in(database: Database) -> dict[str, int]:
    with database.engine.connect() as connection:
        return {
            name: connection.scalar(sa.select(sa.func.count()).select_from(table)) or 0
            for name, table in Base.metadata.tables.items()
        }


def test_no_table_of_ours_is_one_of_the_queue(database: Database):
    queue.create_tables(database)
    theirs = set(sa.inspect(database.engine).get_table_names(schema=None if database.is_sqlite else "dbos"))
    assert "workflow_status" in theirs
    assert not theirs & set(Base.metadata.tables)


def test_tables_are_named_after_their_room():
    for table in Base.metadata.tables:
        assert table.startswith(tuple(f"{room}_" for room in ROOMS)), table


def test_every_tenant_table_names_its_studio():
    global_tables = UNGUARDED | SERVERS_OWN | PERSONAL | {"accounts_studios"}
    for name, table in Base.metadata.tables.items():
        if name not in global_tables and not name.startswith("kit_"):
            assert "studio_id" in table.columns, name
