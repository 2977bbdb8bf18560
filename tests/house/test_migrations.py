"""One migration, equal to the models; what cannot be upgraded is refused; and no table of ours is DBOS's."""

import shutil
import subprocess
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from alembic.script import ScriptDirectory

from app.core.db import CONSTRAINT_NAMES, Base, Database
from app.core.jobs import queue
from app.migrate import CannotUpgrade, MadeBeforeRelease, alembic_config, history_in, migrate
from app.row_security import PERSONAL, SERVERS_OWN, UNGUARDED
from migrations.write_initial import INITIAL, release_of, write_initial
from tests.support.postgres import Postgres

ROOMS = (
    "accounts",
    "briefs",
    "builds",
    "conformance",
    "contracts",
    "deliveries",
    "hiring",
    "core",
    "notifications",
    "operations",
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


@pytest.mark.slow
def test_the_history_ends_at_the_models(database: Database):
    migrate(database)
    command.check(alembic_config(database))


def test_the_history_is_the_one_that_alembic_reads(tmp_path: Path):
    config, folder = Config(), tmp_path / "versions"
    folder.mkdir()
    shutil.copy(INITIAL, folder)
    for name in ("script.py.mako", "env.py"):
        shutil.copy(INITIAL.parent.parent / name, tmp_path)
    config.set_main_option("script_location", str(tmp_path))
    command.revision(config, "second")
    command.revision(config, "third")
    walked = [script.revision for script in ScriptDirectory(str(tmp_path)).walk_revisions()]
    assert len(walked) == 3
    assert list(history_in(folder)) == walked


@pytest.mark.slow
@pytest.mark.skipif(release_of(INITIAL.parent) is not None, reason="later migrations change its tables")
def test_the_initial_migration_is_the_one_that_the_models_make(tmp_path: Path):
    write_initial(tmp_path / "initial.py")
    assert INITIAL.read_text() == (tmp_path / "initial.py").read_text(), "run: make migration"


@pytest.mark.slow
def test_other_tables_have_another_revision(tmp_path: Path):
    write_initial(tmp_path / "initial.py")
    with_one_more = sa.MetaData(naming_convention=CONSTRAINT_NAMES)
    for table in Base.metadata.tables.values():
        table.to_metadata(with_one_more)
    with_one_more.tables["accounts_people"].append_column(sa.Column("height_cm", sa.Integer))
    write_initial(tmp_path / "other.py", with_one_more)
    revisions = {line for path in tmp_path.iterdir() for line in path.read_text().splitlines() if "revision =" in line}
    assert len([line for line in revisions if line.startswith("revision")]) == 2


def test_a_released_migration_is_not_written_anew(tmp_path: Path):
    git = ["git", "-C", str(tmp_path), "-c", "user.name=x", "-c", "user.email=x@example.com"]
    for arguments in (["init", "-q"], ["commit", "-q", "--allow-empty", "-m", "x"], ["tag", "other"]):
        subprocess.run([*git, *arguments], check=True)
    assert release_of(tmp_path) is None
    for tag in ("v1.10.0", "v1.9.0"):
        subprocess.run([*git, "tag", tag], check=True)
    assert release_of(tmp_path) == "v1.9.0"


@pytest.mark.parametrize("revision", ["0078", "0001_ffffffff"])
def test_a_database_from_before_the_release_is_refused_and_left_as_it_is(database: Database, revision: str):
    at_revision(database, revision)
    with pytest.raises(MadeBeforeRelease, match=rf"at revision {revision}, .* wants 0001_.* run: soundlist migrate"):
        migrate(database)
    assert tables_of(database) == {"alembic_version"}


def test_a_database_of_a_newer_version_is_refused_and_left_as_it_is(database: Database):
    at_revision(database, "1f2e3d4c5b6a")
    with pytest.raises(CannotUpgrade, match=r"at revision 1f2e3d4c5b6a, .* a newer version made it; update Soundlist"):
        migrate(database)
    assert tables_of(database) == {"alembic_version"}


def at_revision(database: Database, revision: str) -> None:
    with database.engine.begin() as connection:
        connection.exec_driver_sql("create table alembic_version (version_num varchar(32) not null)")
        connection.execute(sa.text("insert into alembic_version values (:revision)"), {"revision": revision})


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
        if name not in global_tables and not name.startswith("core_"):
            assert "studio_id" in table.columns, name
