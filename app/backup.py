"""A copy of everything a server keeps, in one folder, and a new server out of it.

The database is copied first and the blobs after it: a blob is stored before a row names it and never changes,
so whatever the copied database names is there. Blobs that were copied before are not copied again, but a share of them
is read each time. A blob that nothing names any more goes when no copied database is left that named it.
"""

import json
import os
import shutil
import sqlite3
import subprocess
from contextlib import closing, suppress
from dataclasses import dataclass, field
from datetime import UTC, datetime
from pathlib import Path
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy.engine import URL

from app.core import clock
from app.core.backups import record_backup
from app.core.db import Database
from app.core.plural import counted
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing, FolderStore, Store
from app.core.web.health import NotReady
from app.migrate import CannotUpgrade, ensure_at_head, ensure_upgradable, migrate
from app.operations.scrubbing import queries as blob_queries
from app.row_security import make_request_role

BLOBS = "blobs"
PREFIX = "database-"
SQLITE, POSTGRES = ".sqlite", ".dump"
PARTIAL = ".partial"
UNNAMED = "unnamed.json"  # since when no row names a blob of the backup
STAMP = "%Y%m%dT%H%M%S.%fZ"
SHARES = 14  # of the blobs that were copied before, one in so many is read again


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
    healed: list[str] = field(default_factory=list)  # were damaged in the backup, and are copied again
    lost: list[str] = field(default_factory=list)  # named by the database, and in neither place
    expired: int = 0  # of the backup, which no copied database names any more


@dataclass
class RestoredSounds:
    """The counts of blobs stored again, and those that the backup could not give."""

    blobs: int = 0
    size_bytes: int = 0
    whole: int = 0
    damaged: list[str] = field(default_factory=list)


def back_up(runtime: Runtime, folder: Path, *, keep: int) -> Copied:
    """Copy database and blobs into a folder; of databases copied before keep so many, and the blobs that they name.

    Raises BackupRefused where the database cannot be copied. A blob that is not what its name says is left out.
    """
    folder.mkdir(parents=True, exist_ok=True)
    suffix = SQLITE if runtime.database.is_sqlite else POSTGRES
    now = clock.now()
    target = folder / f"{PREFIX}{now:{STAMP}}{suffix}"
    named = _named(runtime)
    partial = target.with_name(target.name + PARTIAL)
    try:
        _dump(runtime.database, partial)
        partial.replace(target)
    finally:
        partial.unlink(missing_ok=True)
    copied = Copied(target)
    blobs = FolderStore(folder / BLOBS)
    _reread_share(runtime.store, blobs, now.toordinal() % SHARES, copied)
    in_store = _copy_blobs(runtime.store, blobs, copied)
    for old in _databases(folder)[:-keep]:
        old.unlink()
    still_named = _named(runtime)
    if named is None or still_named is None:
        record_backup(runtime.database, len(copied.damaged))
        return copied
    in_backup = {(studio_id, blob.sha256) for studio_id, blob in blobs.blobs()}
    copied.lost = sorted(f"{studio_id}/{sha256}" for studio_id, sha256 in (named & still_named) - in_backup)
    copied.lost = [blob for blob in copied.lost if blob not in copied.damaged]
    _expire(folder, blobs, in_backup - in_store - named - still_named, now, copied)
    record_backup(runtime.database, len(copied.damaged) + len(copied.lost))
    return copied


def restore_sounds(runtime: Runtime, folder: Path) -> RestoredSounds:
    """Store again every blob that the database names and the store lacks, or holds altered, out of a backup."""
    if not (folder / BLOBS).is_dir():
        raise BackupRefused(f"{folder} holds no backup; name the folder that `soundlist backup` wrote to")
    if (named := _named(runtime)) is None:
        raise BackupRefused("the database has not the tables of this version; run: soundlist migrate")
    backup, restored = FolderStore(folder / BLOBS), RestoredSounds()
    for studio_id, sha256 in sorted(named):
        try:
            runtime.store.verify(studio_id, sha256)
            restored.whole += 1
            continue
        except (BlobMissing, BlobAltered):
            pass
        try:
            restored.size_bytes += runtime.store.put(studio_id, backup.stream(studio_id, sha256)).size_bytes
            restored.blobs += 1
        except (BlobMissing, BlobAltered):
            restored.damaged.append(f"{studio_id}/{sha256}")
    return restored


def _named(runtime: Runtime) -> set[tuple[UUID, str]] | None:
    """Return the blobs that rows name; None where the tables are not those of this version."""
    try:
        ensure_at_head(runtime)
    except NotReady:
        return None
    with runtime.database.reading() as session:
        return {
            (studio_id, sha256)
            for studio_id in blob_queries.studio_ids(session)
            for sha256 in blob_queries.named_blobs(session, studio_id)
        }


def _reread_share(store: Store, backup: FolderStore, share: int, copied: Copied) -> None:
    """Read a share of the blobs of a backup; one that is damaged and whole in the store is copied again."""
    for studio_id, blob in backup.blobs():
        if int(blob.sha256[:8], 16) % SHARES != share:
            continue
        try:
            backup.verify(studio_id, blob.sha256)
            continue
        except BlobAltered:
            pass
        try:
            backup.put(studio_id, store.stream(studio_id, blob.sha256))
            copied.healed.append(f"{studio_id}/{blob.sha256}")
        except (BlobAltered, BlobMissing):
            copied.damaged.append(f"{studio_id}/{blob.sha256}")


def _expire(folder: Path, blobs: FolderStore, unnamed: set[tuple[UUID, str]], now: datetime, copied: Copied) -> None:
    """Delete the blobs of a backup that were unnamed before the oldest database in it was copied."""
    file, oldest = folder / UNNAMED, _databases(folder)[0].name.removeprefix(PREFIX).partition("Z")[0]
    backups_kept = json.loads(file.read_text()) if file.exists() else {}
    since = {
        f"{studio_id}/{sha256}": backups_kept.get(f"{studio_id}/{sha256}", now.isoformat())
        for studio_id, sha256 in unnamed
    }
    for studio_id, sha256 in unnamed:
        if datetime.fromisoformat(since[f"{studio_id}/{sha256}"]) < datetime.strptime(f"{oldest}Z", STAMP).replace(
            tzinfo=UTC
        ):
            blobs.delete(studio_id, sha256)
            del since[f"{studio_id}/{sha256}"]
            copied.expired += 1
    partial = file.with_name(UNNAMED + PARTIAL)
    partial.write_text(json.dumps(since))
    partial.replace(file)


def restore(runtime: Runtime, folder: Path, database: Path | None = None) -> Copied:
    """Fill an empty database and a store from a backup; the newest database in it unless one is named.

    Raises BackupRefused where there is no backup, this version cannot read it, or something is there.
    """
    databases = _databases(folder)
    if database is None and not databases:
        raise BackupRefused(f"{folder} holds no backup; name the folder that `soundlist backup` wrote to")
    source = database or databases[-1]
    database_file = SQLITE if runtime.database.is_sqlite else POSTGRES
    if source.suffix != database_file:
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


def _copy_blobs(source: Store, target: Store, copied: Copied) -> set[tuple[UUID, str]]:
    """Copy the blobs that the target has not; return all that the source has."""
    there = {(studio_id, blob) for studio_id, blob in target.blobs()}
    in_source = set()
    for studio_id, blob in source.blobs():
        in_source.add((studio_id, blob.sha256))
        if (studio_id, blob) in there:
            copied.there_before += 1
            continue
        try:
            target.put(studio_id, source.stream(studio_id, blob.sha256))
        except BlobAltered:
            copied.damaged.append(f"{studio_id}/{blob.sha256}")
        else:
            copied.blobs += 1
            copied.size_bytes += blob.size_bytes
    return in_source


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
