"""Brings a database to the tables that this version wants."""

from functools import cache
from pathlib import Path

import sqlalchemy as sa
from alembic import command
from alembic.config import Config
from alembic.migration import MigrationContext
from alembic.script import ScriptDirectory

from app import tables  # noqa: F401  every model, for the comparison
from app.kit import queue
from app.kit.db import Database
from app.kit.health import NotReady
from app.kit.runtime import Runtime
from app.row_security import ensure_rows_are_guarded, guard_rows

MIGRATIONS = Path(__file__).resolve().parent.parent / "migrations"


def alembic_config(database: Database) -> Config:
    """Return Alembic's configuration for a database; there is no ini file."""
    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS))
    config.attributes["engine"] = database.engine
    return config


def migrate(database: Database, revision: str = "head") -> None:
    """Upgrade our tables and those of the job queue."""
    queue.create_tables(database)
    command.upgrade(alembic_config(database), revision)
    if revision == "head":
        guard_rows(database)


def login_warning(database: Database) -> str | None:
    """Return what is wrong with a login that may do more than it needs; None where nothing is."""
    if database.is_sqlite:
        return None
    with database.engine.connect() as connection:
        is_superuser = connection.scalar(sa.text("select rolsuper from pg_roles where rolname = session_user"))
    if not is_superuser:
        return None
    return (
        f"the login {database.engine.url.username} is a superuser of PostgreSQL, who may read files and run programs "
        "on its machine; Soundlist needs none. docs/operate.md, PostgreSQL, explains how to create a separate login"
    )


@cache
def _history() -> tuple[str, ...]:
    """Return the revisions that this version knows, the newest first."""
    script = ScriptDirectory(str(MIGRATIONS))
    return tuple(revision.revision for revision in script.walk_revisions())


def ensure_at_head(runtime: Runtime) -> None:
    """Raise NotReady where the database lacks tables of this version; one that a newer version changed will do."""
    with runtime.database.reading() as session:
        found = MigrationContext.configure(session.connection()).get_current_revision()
    known = _history()
    if found in known[1:] or found is None:
        raise NotReady(
            f"the database is at revision {found or 'none'}, and this version wants {known[0]}; run: soundlist migrate"
        )
    ensure_rows_are_guarded(runtime)
