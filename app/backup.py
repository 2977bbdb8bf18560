"""A copy of everything a server keeps, in one folder, and a new server out of it.

The database is copied first and the blobs after it: a blob is stored before a row names it and never changes,
so whatever the copied database names is there. Blobs that were copied before are not copied again.
"""

import os
import shutil
import sqlite3
import subprocess
from contextlib import closing, suppress
from dataclasses import dataclass, field
from pathlib import Path

import sqlalchemy as sa
from sqlalchemy.engine import URL

from app.kit import clock
from app.kit.db import Database
from app.kit.plural import counted
from app.kit.runtime import Runtime
from app.kit.storage import FolderStore, Store
from app.migrate import CannotUpgrade, ensure_upgradable, migrate
from app.row_security import make_request_role

BLOBS = "blobs"
PREFIX = "database-"
SQLITE, POSTGRES = ".sqlite", ".dump"
PARTIAL = ".partial"


class BackupRefused(Exception):
    """A backup that cannot be made or put back: says what was found, what was wanted, how to fix it."""


@dataclass
class Copied:
    """The counts of a copy, and the blobs whose content does not match their names."""

    database: Path
    blobs: int = 0
    size_bytes: int = 0
    there_before: int = 0
    damaged: list[str] = field(default_factory=list)


def back_up(runtime: Runtime, folder: Path, *, keep: int) -> Copied:
    """Copy database and blobs into a folder; of databases copied before keep so many, of blobs all.

    Raises BackupRefused where the database cannot be copied. A blob that is not what its name says is left out.
    """
    folder.mkdir(parents=True, exist_ok=True)
    suffix = SQLITE if runtime.database.is_sqlite else POSTGRES
    target = folder / f"{PREFIX}{clock.now():%Y%m%dT%H%M%S.%fZ}{suffix}"
    partial = target.with_name(target.name + PARTIAL)
    try:
        _dump(runtime.database, partial)
        partial.replace(target)
    finally:
        partial.unlink(missing_ok=True)
    copied = Copied(target)
    _copy_blobs(runtime.store, FolderStore(folder / BLOBS), copied)
    for old in _databases(folder)[:-keep]:
        old.unlink()
    return copied


def restore(runtime: Runtime, folder: Path, database: Path | None = None) -> Copied:
    """Fill an empty database and a store from a backup; the newest database in it unless one is named.

    Raises BackupRefused where there is no backup, this version cannot read it, or something is there.
    """
    found = _databases(folder)
    if database is None and not found:
        raise BackupRefused(f"{folder} holds no backup; name the folder that `soundlist backup` wrote to")
    source = database or found[-1]
    wanted = SQLITE if runtime.database.is_sqlite else POSTGRES
    if source.suffix != wanted:
        raise BackupRefused(
            f"{source.name} is of another kind of database than SOUNDLIST_DATABASE_URL names; a backup goes back into "
            "the kind that it was made of"
        )
    with runtime.database.engine.connect() as connection:
        tables = sa.inspect(connection).get_table_names()
    if tables:
        raise BackupRefused(
            f"the database holds {counted(len(tables), 'table')} already; name an empty one in SOUNDLIST_DATABASE_URL "
            "or SOUNDLIST_DATA_DIR"
        )
    try:
        ensure_upgradable(_revision_of(runtime.database, source))
    except CannotUpgrade as error:
        raise BackupRefused(f"{source.name} cannot be restored: {error}") from None
    copied = Copied(source)
    _copy_blobs(FolderStore(folder / BLOBS), runtime.store, copied)
    _load(runtime.database, source)
    migrate(runtime.database)
    return copied


def _databases(folder: Path) -> list[Path]:
    """Return the databases in a backup, the oldest first."""
    return sorted(path for path in folder.glob(f"{PREFIX}*") if path.suffix in (SQLITE, POSTGRES))


def _copy_blobs(source: Store, target: Store, copied: Copied) -> None:
    there = {(studio_id, blob) for studio_id, blob in target.blobs()}
    for studio_id, blob in source.blobs():
        if (studio_id, blob) in there:
            copied.there_before += 1
        elif target.put(studio_id, source.stream(studio_id, blob.sha256)) != blob:
            copied.damaged.append(f"{studio_id}/{blob.sha256}")
        else:
            copied.blobs += 1
            copied.size_bytes += blob.size_bytes


def _dump(database: Database, target: Path) -> None:
    url = database.engine.url
    if database.is_sqlite:
        with closing(sqlite3.connect(url.database or "")) as source, closing(sqlite3.connect(target)) as copy:
            source.backup(copy)
            copy.execute("pragma journal_mode = delete")  # one file, which can be read where nothing can be written
    else:
        _run("pg_dump", url, "--format=custom", "--no-owner", f"--file={target}")


def _revision_of(database: Database, source: Path) -> str | None:
    """Return the revision of the tables in a copy."""
    if not database.is_sqlite:
        arguments = ("--data-only", "--table=alembic_version", "--file=-", str(source))
        _, _, rows = _run("pg_restore", None, *arguments).partition("FROM stdin;\n")
        return rows.partition("\n")[0] or None
    uri = f"{source.resolve().as_uri()}?mode=ro"
    with closing(sqlite3.connect(uri, uri=True)) as copy, suppress(sqlite3.OperationalError):  # of an empty database
        (revision,) = copy.execute("select version_num from alembic_version").fetchone()
        return str(revision)
    return None


def _load(database: Database, source: Path) -> None:
    url = database.engine.url
    if database.is_sqlite:
        database.dispose()
        with (
            closing(sqlite3.connect(f"{source.resolve().as_uri()}?mode=ro", uri=True)) as copy,
            closing(sqlite3.connect(url.database or "")) as target,
        ):
            copy.backup(target)
        return
    with database.engine.begin() as connection:
        make_request_role(connection)  # the copy grants to it, and roles belong to no database
    _run("pg_restore", url, "--exit-on-error", "--no-owner", "--single-transaction", str(source))


def _run(program: str, url: URL | None, *arguments: str) -> str:
    """Run one of PostgreSQL's programs and return its output; the password goes by the environment, unlisted."""
    if shutil.which(program) is None:
        raise BackupRefused(
            f"{program} is not installed; install PostgreSQL's client: apt-get install postgresql-client"
        )
    environment, command = dict(os.environ), [program]
    if url is not None:
        environment |= {"PGPASSWORD": str(url.password)} if url.password else {}
        shown = url.set(drivername="postgresql", password=None).render_as_string()
        command.append(f"--dbname={shown}")
    ran = subprocess.run([*command, *arguments], env=environment, capture_output=True, text=True, check=False)
    if ran.returncode:
        raise BackupRefused(f"{program} failed: {ran.stderr.strip().splitlines()[-1]}")
    return ran.stdout
