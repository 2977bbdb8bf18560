"""A whole server to another database, another store, or both; equal afterwards, or nothing is there."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field

import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.core.db import Database
from app.core.plural import counted
from app.core.runtime import Runtime
from app.core.storage import BlobAltered, BlobMissing
from app.core.web.health import WORKER_SILENT_AFTER, NotReady
from app.migrate import ensure_at_head, migrate
from app.operations.erasure import scope_queries as scopes
from app.operations.scrubbing import queries as blob_queries
from app.transfers import rows
from app.transfers.refusal import TransferRefused

# What tells a running server of changes and of its workers, and means nothing elsewhere.
LEFT = frozenset({"core_changed_rooms", "core_heartbeats"})


@dataclass
class Moved:
    """The counts of a move."""

    tables: int = 0
    rows: int = 0
    blobs: int = 0
    size_bytes: int = 0
    there_before: int = 0
    parked_jobs: list[str] = field(default_factory=list)  # which stay where they were


def move(source: Runtime, target: Runtime, *, database: bool, store: bool) -> Moved:
    """Copy blobs and then rows to an empty database and a store, and compare them.

    Raises TransferRefused where a worker still runs, jobs wait, the target is not empty, a file is damaged, or
    the source changed meanwhile.
    """
    try:
        ensure_at_head(source)
    except NotReady as error:
        raise TransferRefused(str(error)) from None
    moved = Moved()
    _ensure_at_rest(source, moved)
    if database:
        _ensure_empty(target.database)
    if store:
        _copy_blobs(source, target, moved)
    if database:
        migrate(target.database)
        _copy_rows(source, target, moved)
    return moved


def unfinished_jobs(runtime: Runtime, is_concerned: Callable[[object], bool] = lambda _studio_id: True) -> list[str]:
    """Return the jobs that wait or run, but for mails, which the outbox sends without them."""
    return [
        job.name
        for job in runtime.queue.unfinished()
        if job.state != "parked" and job.name != "notifications.send_mail" and is_concerned(job.studio_id)
    ]


def _ensure_at_rest(source: Runtime, moved: Moved) -> None:
    if source.queue.heartbeats(within=WORKER_SILENT_AFTER):
        raise TransferRefused("a worker runs on this server; stop its web processes and workers, then move it")
    if waiting := unfinished_jobs(source):
        raise TransferRefused(
            f"{counted(len(waiting), 'job')} still to be done, such as {waiting[0]}; stop the web processes, let a "
            "worker finish, stop it, then move the server"
        )
    moved.parked_jobs = [f"{job.name} {job.id}" for job in source.queue.unfinished(only_failed=True)]


def _ensure_empty(database: Database) -> None:
    with database.engine.connect() as connection:
        names = set(sa.inspect(connection).get_table_names())
        for table in scopes.tables():
            if table.name in names and connection.execute(sa.select(sa.literal(1)).select_from(table).limit(1)).first():
                raise TransferRefused(
                    f"the target database is not empty: it has rows in {table.name}; name an empty one"
                )


def _copy_blobs(source: Runtime, target: Runtime, moved: Moved) -> None:
    with source.database.reading() as session:
        studios = {studio: blob_queries.named_blobs(session, studio) for studio in blob_queries.studio_ids(session)}
    there = {(studio_id, blob.sha256) for studio_id, blob in target.store.blobs()}
    damaged = []
    for studio_id, named in studios.items():
        for sha256 in sorted(named):
            if (studio_id, sha256) in there:
                target.store.verify(studio_id, sha256)
                moved.there_before += 1
                continue
            try:
                blob = target.store.put(studio_id, source.store.stream(studio_id, sha256))
            except (BlobMissing, BlobAltered):
                damaged.append(f"{studio_id}/{sha256}")
                continue
            moved.blobs += 1
            moved.size_bytes += blob.size_bytes
    if damaged:
        raise TransferRefused(
            f"{counted(len(damaged), 'stored file')} missing or altered, such as {damaged[0]}; `soundlist scrub` names "
            "all, `soundlist restore FOLDER --sounds` brings them back"
        )


def _copy_rows(source: Runtime, target: Runtime, moved: Moved) -> None:
    tables = [table for table in scopes.tables() if table.name not in LEFT]
    with target.database.writing() as written:
        digests: dict[str, rows.Digest] = {}
        with source.database.reading() as session:
            for table in tables:
                digests[table.name] = digest = rows.Digest()
                moved.rows += rows.write(written, table, _counted(session, table, digest))
        for table in tables:
            if rows.digest(written, table) != digests[table.name]:
                raise TransferRefused(f"{table.name} is not the same in both databases; nothing was moved")
        with source.database.reading() as session:
            for table in tables:
                if rows.digest(session, table) != digests[table.name]:
                    raise TransferRefused(
                        f"{table.name} changed while it was copied; stop the web processes and workers, then try again"
                    )
    moved.tables = len(tables)


def _counted(session: Session, table: sa.Table, digest: rows.Digest) -> Iterator[rows.Row]:
    for row in rows.read(session, table):
        digest.add(table, row)
        yield row
