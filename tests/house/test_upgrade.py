"""A database that an earlier version filled: this one upgrades it, shows what is in it, and does what was left to do.

`older/0027.sql.gz` holds a database at revision 0027, the first of the history: a project of 34 takes, and one that
had just come in, whose check nobody had done. A change that cannot read what it holds fails here; the file is never
replaced.
"""

import gzip
import hashlib
import os
import sqlite3
import subprocess
import sys
import time
import wave
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest
import sqlalchemy as sa
from alembic.migration import MigrationContext
from anyio.from_thread import start_blocking_portal

from app.accounts.authentication import CSRF_HEADER, SESSION_COOKIE, csrf_token, sha256_of
from app.accounts.models import SignIn
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.kit import clock
from app.kit.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.projects.models import ApproverChange, Project
from app.settings import Settings
from tests.support.server import RunningServer

ROOT = Path(__file__).resolve().parents[2]
OLDER = Path(__file__).parent / "older" / "0027.sql.gz"
TAKES, HALF_DONE = 34, "half_done.wav"
WITHIN_S = 120.0  # most of it for a new process to import what it needs, where others want the processors
SECRET_KEY = "only for tests, nowhere else"
SECRET = "secret of one who decided before"


@pytest.fixture(scope="module")
def rows_before(upgraded_folder: Path) -> dict[str, int]:
    """How many rows each table held."""
    with sqlite3.connect(upgraded_folder / "before.sqlite") as before:
        tables = [name for (name,) in before.execute("select name from sqlite_master where type = 'table'")]
        return {name: before.execute(f'select count(*) from "{name}"').fetchone()[0] for name in tables}  # noqa: S608


@pytest.fixture(scope="module")
def upgraded_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("older")
    script = gzip.decompress(OLDER.read_bytes()).decode()
    for name in ("before.sqlite", "soundlist.sqlite"):
        with sqlite3.connect(folder / name) as database:
            database.executescript(script)
    return folder


@pytest.fixture(scope="module")
def server(upgraded_folder: Path) -> Iterator[RunningServer]:
    """This version on the older one's data, which it migrates; a worker beside it takes up what waits."""
    runtime = Runtime.of(Settings(data_dir=upgraded_folder, secret_key=SECRET_KEY))
    with runtime.database.reading() as session:
        assert MigrationContext.configure(session.connection()).get_current_revision() == "0027"
        studio_id, sha256 = session.execute(
            sa.text("select studio_id, master_sha256 from deliveries_takes where file_name = :name"),
            {"name": HALF_DONE},
        ).one()
    master = upgraded_folder / "master.wav"
    write_square_wave(master)
    assert hashlib.sha256(master.read_bytes()).hexdigest() == sha256
    runtime.store.put_file(sa.Uuid().result_processor(sa.dialects.sqlite.dialect(), None)(studio_id), master)
    migrate(runtime.database)
    with working(upgraded_folder), start_blocking_portal() as portal:
        yield RunningServer(runtime, create_app(runtime), portal)
    runtime.close()


@contextmanager
def working(folder: Path) -> Iterator[None]:
    """Run a worker in a process of its own."""
    environment = os.environ | {"SOUNDLIST_DATA_DIR": str(folder), "SOUNDLIST_SECRET_KEY": SECRET_KEY}
    process = subprocess.Popen([sys.executable, "-m", "app", "worker"], cwd=ROOT, env=environment)
    try:
        yield
    finally:
        process.kill()  # what it leaves is not looked at, and an orderly stop waits for its jobs
        process.wait(WITHIN_S)


def write_square_wave(path: Path) -> None:
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(3)
        file.setframerate(48_000)
        steps = (1_000_000 if frame // 50 % 2 else -1_000_000 for frame in range(9_600))
        file.writeframes(b"".join(step.to_bytes(3, "little", signed=True) for step in steps))


def test_every_row_is_still_there(server: RunningServer, rows_before: dict[str, int]) -> None:
    ours = {
        name: rows for name, rows in rows_before.items() if "_" in name and not name.startswith(("kit_", "sqlite_"))
    }
    assert ours["deliveries_takes"] == TAKES + 1
    with server.runtime.database.reading() as session:
        for name in sorted(set(ours) & set(sa.inspect(session.connection()).get_table_names())):
            now = session.scalar(sa.select(sa.func.count()).select_from(sa.table(name)))
            assert now >= ours[name], f"{name} had {ours[name]} rows and has {now}"


def test_what_was_left_to_do_is_done(server: RunningServer) -> None:
    deadline = time.monotonic() + WITHIN_S
    while (state := _half_done(server)) is TakeState.RECEIVED and time.monotonic() < deadline:
        time.sleep(0.1)
    assert state in (TakeState.CONFORMING, TakeState.RETURNED), server.runtime.queue.unfinished()


def _half_done(server: RunningServer) -> TakeState:
    with server.runtime.database.reading() as session:
        return session.scalars(sa.select(Take.state).where(Take.file_name == HALF_DONE)).one()


def test_its_screens_answer(server: RunningServer) -> None:
    with server.runtime.database.writing() as session:
        project_id = session.scalars(sa.select(Project.id)).one()
        approver_id = session.scalars(sa.select(ApproverChange.person_id)).one()
        expires_at = clock.now().replace(year=clock.now().year + 1)
        session.add(SignIn(person_id=approver_id, secret_sha256=sha256_of(SECRET), expires_at=expires_at))
        take_ids = session.scalars(sa.select(Take.id).limit(5)).all()
    approver = server.browser()
    approver.cookies.set(SESSION_COOKIE, SECRET)
    approver.headers[CSRF_HEADER] = csrf_token(server.runtime.settings, SECRET)
    project = f"/v1/projects/{project_id}"
    screens = [
        project,
        f"{project}/sound-list",
        f"{project}/sound-list/progress",
        f"{project}/takes",
        "/v1/review-queue",
    ]
    screens += [
        f"/v1/takes/{take_id}{what}" for take_id in take_ids for what in ("", "/sounds", "/comments", "/history")
    ]
    for address in screens:
        answer = approver.get(address)
        assert answer.status_code == 200, f"{address}: {answer.text}"
    assert approver.get("/readyz").json()["migrations"] == "ok"
    listed = approver.get(f"{project}/sound-list").json()
    assert "half done" in [cue["name"] for cue in listed["cues"]], sorted(listed)
