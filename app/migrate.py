"""Brings a database to the tables that this version wants."""

import re
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING

import sqlalchemy as sa

from app import tables  # noqa: F401  every model, for the comparison
from app.core.db import Database
from app.core.jobs import queue
from app.core.runtime import Runtime
from app.core.web.health import NotReady
from app.row_security import ensure_rows_are_guarded, guard_rows

if TYPE_CHECKING:
    from alembic.config import Config

MIGRATIONS = Path(__file__).resolve().parent.parent / "migrations"
NAMED = re.compile(r"""^(revision|down_revision) = (?:["'](\w+)["']|None)""", re.MULTILINE)
BEFORE_RELEASE = re.compile(r"00\d\d|0001_[0-9a-f]{8}")  # revisions that versions before 1.0 gave


class CannotUpgrade(Exception):
    """The database is at a revision that this version does not know."""


class MadeBeforeRelease(CannotUpgrade):
    """The database was made by a version before 1.0, whose tables no version upgrades."""


def alembic_config(database: Database) -> "Config":
    """Return Alembic's configuration for a database; there is no ini file."""
    from alembic.config import Config  # 8 MiB that web process and worker do without

    config = Config()
    config.set_main_option("script_location", str(MIGRATIONS))
    config.attributes["engine"] = database.engine
    return config


def migrate(database: Database) -> None:
    """Upgrade our tables and those of the job queue; raise CannotUpgrade where the database's revision is unknown."""
    from alembic import command

    ensure_upgradable(current_revision(database))
    queue.create_tables(database)
    command.upgrade(alembic_config(database), "head")
    guard_rows(database)


def login_warning(database: Database) -> str | None:
    """Return the fault of a login that may do more than it needs; None where there is none."""
    if database.is_sqlite:
        return None
    with database.engine.connect() as connection:
        is_superuser = connection.scalar(sa.text("select rolsuper from pg_roles where rolname = session_user"))
    if not is_superuser:
        return None
    return (
        f"the login {database.engine.url.username} is a superuser of PostgreSQL, who may read files and run programs "
        "on its machine; Soundlist needs none. docs/reference/settings.md, Database, says how to create another login"
    )


def current_revision(database: Database) -> str | None:
    """Return the revision of a database's tables; None where it has none."""
    with database.engine.connect() as connection:
        return revision_by(connection)


def revision_by(connection: sa.Connection) -> str | None:
    """Return the revision that Alembic wrote into a connection's database; None where it never did."""
    if not sa.inspect(connection).has_table("alembic_version"):
        return None
    revision: str | None = connection.scalar(sa.text("select version_num from alembic_version"))
    return revision


def ensure_upgradable(revision: str | None) -> None:
    """Raise CannotUpgrade unless this version knows a database's revision, or it has none."""
    ensure_made_since_release(revision)
    if revision is not None and revision not in _history():
        raise CannotUpgrade(
            f"the database is at revision {revision}, and this version knows those up to {_history()[0]}: a newer "
            "version made it; update Soundlist, or name another database in SOUNDLIST_DATABASE_URL or another "
            "folder in SOUNDLIST_DATA_DIR"
        )


def ensure_made_since_release(revision: str | None) -> None:
    """Raise MadeBeforeRelease where a revision is of a version before 1.0, and not this one."""
    if revision is None or revision in _history() or not BEFORE_RELEASE.fullmatch(revision):
        return
    raise MadeBeforeRelease(
        f"the database is at revision {revision}, which a version before 1.0 made, and this version wants "
        f"{_history()[0]}; no version upgrades it, and nothing in it was changed. Keep it, name an empty database in "
        "SOUNDLIST_DATABASE_URL or an empty folder in SOUNDLIST_DATA_DIR, and run: soundlist migrate"
    )


@cache
def _history() -> tuple[str, ...]:
    """Return the revisions that this version knows, the newest first."""
    return history_in(MIGRATIONS / "versions")


def history_in(folder: Path) -> tuple[str, ...]:
    """Return the revisions of a folder of migrations, the newest first; each but the first follows one other."""
    named = [dict(NAMED.findall(path.read_text(encoding="utf-8"))) for path in folder.glob("*.py")]
    followers = {migration["down_revision"]: migration["revision"] for migration in named}
    history: list[str] = []
    while newest := followers.get(history[-1] if history else ""):
        history.append(newest)
    return tuple(reversed(history))


def ensure_at_head(runtime: Runtime) -> None:
    """Raise NotReady where the database lacks tables of this version; one that a newer version changed will do."""
    with runtime.database.reading() as session:
        revision = revision_by(session.connection())
    revisions = _history()
    try:
        ensure_made_since_release(revision)
    except MadeBeforeRelease as error:
        raise NotReady(str(error)) from None
    if revision in revisions[1:] or revision is None:
        raise NotReady(
            f"the database is at revision {revision or 'none'}, and this version wants {revisions[0]}; "
            "run: soundlist migrate"
        )
    ensure_rows_are_guarded(runtime)
