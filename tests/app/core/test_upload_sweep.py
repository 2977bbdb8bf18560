"""Uploads that are given up or expire: their bytes go, and nothing else does."""

import fcntl
import os
from collections.abc import Iterator
from datetime import UTC, datetime
from pathlib import Path

import pytest

from app.core.db import Base, Database
from app.core.errors import Conflict
from app.core.storage import FolderStore
from app.core.uploads import (
    Upload,
    UploadNotFound,
    Uploads,
)
from app.core.uploads import (
    staged as uploads,
)
from tests.app.core.test_uploads import CONTENT, SHA256, STUDIO, begun, find, grow_old, send, staged

TOUCHED_AT = datetime(2026, 3, 1, 12, tzinfo=UTC)


@pytest.fixture
def database(tmp_path: Path) -> Iterator[Database]:
    database = Database(f"sqlite:///{tmp_path / 'test.sqlite'}")
    Base.metadata.create_all(database.engine, tables=[Base.metadata.tables["core_uploads"]])
    yield database
    database.dispose()


@pytest.fixture
def store(tmp_path: Path) -> FolderStore:
    return FolderStore(tmp_path / "blobs")


@pytest.fixture
def incoming(database: Database, store: FolderStore) -> Uploads:
    return Uploads(database, store)


def test_given_up_is_gone(incoming: Uploads, store: FolderStore) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT[:100])
    incoming.give_up(upload)
    assert staged(store) == []
    with pytest.raises(UploadNotFound):
        find(incoming, upload)
    with pytest.raises(UploadNotFound):
        send(incoming, upload, 100, CONTENT[100:])


def test_a_finished_file_cannot_be_given_up(incoming: Uploads, store: FolderStore) -> None:
    upload = send(incoming, begun(incoming), 0, CONTENT)
    with pytest.raises(Conflict):
        incoming.give_up(upload)
    assert store.read(STUDIO, SHA256) == CONTENT


@pytest.mark.slow
def test_the_sweep_takes_what_expired_and_nothing_else(incoming: Uploads, store: FolderStore) -> None:
    week_s = uploads.KEPT_FOR.total_seconds()
    expired, fresh, busy = (send(incoming, begun(incoming), 0, CONTENT[:9]) for _ in range(3))
    finished = send(incoming, begun(incoming), 0, CONTENT)
    paths = {path.name: path for path in staged(store)}
    grow_old(paths[str(expired.id)], week_s + 60)
    grow_old(paths[str(fresh.id)], week_s - 60)
    grow_old(paths[str(busy.id)], week_s + 60)
    crashed_put = store.root / ".put-crashed"
    crashed_put.write_bytes(b"half")
    half_made, being_made = store.root / ".making-crashed", store.root / ".making-now"
    for folder in (half_made, being_made):
        folder.mkdir()
        (folder / "render.wav").write_bytes(b"half")
    for orphaned in (crashed_put, half_made):
        grow_old(orphaned, uploads.ORPHANED_AFTER.total_seconds() + 60)
    with paths[str(busy.id)].open("rb") as held:
        fcntl.flock(held, fcntl.LOCK_EX)
        assert incoming.sweep() == 3
    assert {path.name for path in staged(store)} == {str(fresh.id), str(busy.id)}
    assert not crashed_put.exists()
    assert not half_made.exists()
    assert (being_made / "render.wav").exists()
    with pytest.raises(UploadNotFound):
        find(incoming, expired)
    assert find(incoming, finished).sha256 == SHA256
    assert incoming.offset(find(incoming, fresh)) == 9


def test_the_sweep_forgets_rows_whose_file_was_never_made(
    incoming: Uploads, store: FolderStore, database: Database
) -> None:
    lost, fresh = begun(incoming), begun(incoming)
    for path in staged(store):
        path.unlink()
    with database.writing() as session:
        session.get_one(Upload, lost.id).created_at -= uploads.ROWS_KEPT_FOR
    incoming.sweep()
    with database.reading() as session:
        assert session.get(Upload, lost.id) is None
        assert session.get(Upload, fresh.id) is not None


def test_the_file_says_when_it_expires(incoming: Uploads, store: FolderStore) -> None:
    upload = begun(incoming)
    [path] = staged(store)
    os.utime(path, (TOUCHED_AT.timestamp(),) * 2)
    assert incoming.expires_at(upload) == TOUCHED_AT + uploads.KEPT_FOR
