"""A server moved to another database and store, and a studio exported and imported: the same afterwards, or nothing."""

import json
import zipfile
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa
from anyio.from_thread import start_blocking_portal
from typer.testing import CliRunner

from app.accounts.authentication import SESSION_COOKIE, sha256_of
from app.accounts.models import Person, SignIn
from app.amendments import verification
from app.cli import cli
from app.core import clock
from app.core.db import new_id
from app.core.runtime import Runtime
from app.main import create_app
from app.migrate import migrate
from app.operations.erasure import scope_queries as scopes
from app.operations.scrubbing import queries as blob_queries
from app.settings import Settings
from app.transfers import rows
from app.transfers.move import LEFT, Moved, _copy_rows, move, unfinished_jobs
from app.transfers.refusal import TransferRefused
from app.transfers.studio_files import LEFT_OUT, export_studio, import_studio
from app.worker import start_worker
from tests.app.agreements.conftest import Contracts
from tests.app.test_backup import contents, lived_in
from tests.house.objects import House
from tests.support.blobs import blob_file
from tests.support.s3 import S3Server
from tests.support.server import RunningServer, World
from tests.support.waiting import until

pytestmark = pytest.mark.slow
Opened = Callable[..., AbstractContextManager[RunningServer]]


@pytest.fixture(autouse=True)
def only_worker(server: RunningServer) -> Iterator[None]:
    """Stop the worker that all tests share, as a process has one worker at most, and start it again afterwards."""
    if server.worker:
        server.worker.stop()
    yield
    server.worker = start_worker(server.runtime)


@pytest.fixture
def opened(request: pytest.FixtureRequest, tmp_path: Path) -> Opened:
    """Open a web process on a database and a store of the kinds asked for; each server has its own secret key."""

    @contextmanager
    def open_server(name: str, database: str, store: str, *, worker: bool = False) -> Iterator[RunningServer]:
        settings: dict[str, Any] = {}
        if store == "s3":
            s3: S3Server = request.getfixturevalue("s3")
            settings |= s3.settings()
        if database == "postgres":
            settings["database_url"] = request.getfixturevalue("postgres").new_database(f"{name}_{new_id().hex}")
        runtime = Runtime.of(Settings(data_dir=tmp_path / name, secret_key=f"the key of {name}, for tests", **settings))
        migrate(runtime.database)
        running = start_worker(runtime) if worker else None
        try:
            with start_blocking_portal() as portal:
                yield RunningServer(runtime, create_app(runtime), portal, running)
        finally:
            if running:
                running.stop()  # once more does nothing
            runtime.close()

    return open_server


def agreed_studio(server: RunningServer) -> World:
    """Return a studio with an approved sound and a sealed contract, and no job left."""
    world = lived_in(server)
    contracts = Contracts(world)
    contracts.agree(contracts.begin())
    let_jobs_end(server)
    return world


def let_jobs_end(server: RunningServer) -> None:
    """Wait for every job, those that begin some seconds later too; mails wait for a mail server."""
    until(lambda: not unfinished_jobs(server.runtime))


def whole_records(runtime: Runtime) -> tuple[int, list[str]]:
    """Return how many records there are, and the faults of all, as `soundlist verify` finds them."""
    verified = list(verification.verify_all(runtime.database, runtime.store))
    return len(verified), [fault for each in verified for fault in each.faults]


def at_rest(server: RunningServer) -> None:
    """Let the worker finish, stop it, and forget it."""
    assert server.worker is not None
    let_jobs_end(server)
    server.worker.stop()
    server.in_database(lambda session: session.execute(sa.text("delete from core_heartbeats")))


def rows_of(runtime: Runtime, *, without: frozenset[str] = LEFT) -> dict[str, rows.Digest]:
    with runtime.database.reading() as session:
        return {table.name: rows.digest(session, table) for table in scopes.tables() if table.name not in without}


@pytest.mark.parametrize(
    ("before", "after"),
    [(("sqlite", "folder"), ("postgres", "s3")), (("postgres", "s3"), ("sqlite", "folder"))],
    ids=["to PostgreSQL and a bucket", "to SQLite and a folder"],
)
def test_a_moved_server_is_the_same(opened: Opened, before: tuple[str, str], after: tuple[str, str]):
    with opened("old", *before, worker=True) as old, opened("new", *after) as new:
        world = agreed_studio(old)
        known = contents(world, old)
        with pytest.raises(TransferRefused, match="a worker runs on this server"):
            move(old.runtime, new.runtime, database=True, store=True)
        at_rest(old)
        moved = move(old.runtime, new.runtime, database=True, store=True)
        assert (moved.tables, moved.blobs) == (len(scopes.tables()) - len(LEFT), len(list(old.runtime.store.blobs())))
        assert rows_of(new.runtime) == rows_of(old.runtime)
        assert sorted(new.runtime.store.blobs(), key=str) == sorted(old.runtime.store.blobs(), key=str)
        assert whole_records(new.runtime) == (1, [])
        assert contents(world, new) == known
        with pytest.raises(TransferRefused, match="is not empty: it has rows in"):
            move(old.runtime, new.runtime, database=True, store=True)


@pytest.mark.parametrize(("before", "after"), [("sqlite", "postgres"), ("postgres", "sqlite")])
def test_one_of_everything_is_the_same_in_both_databases(opened: Opened, before: str, after: str):
    with opened("old", before, "folder") as old, opened("new", after, "folder") as new:
        House(old)
        with pytest.raises(TransferRefused, match="still to be done"):
            move(old.runtime, new.runtime, database=True, store=False)
        _copy_rows(old.runtime, new.runtime, Moved())
        assert rows_of(new.runtime) == rows_of(old.runtime)


def test_a_damaged_file_stops_a_move_and_an_export_before_anything_is_written(opened: Opened, tmp_path: Path):
    with opened("old", "sqlite", "folder", worker=True) as old, opened("new", "sqlite", "folder") as new:
        world = agreed_studio(old)
        at_rest(old)
        with old.runtime.database.reading() as session:
            sha256 = next(iter(blob_queries.named_blobs(session, world.studio_id)))
        blob_file(old.runtime.store, world.studio_id, sha256).unlink()
        with pytest.raises(TransferRefused, match=rf"1 stored file missing or altered, such as .*{sha256}"):
            move(old.runtime, new.runtime, database=True, store=True)
        assert rows_of(new.runtime)["accounts_studios"].rows == 0
        with pytest.raises(TransferRefused, match="is not in the store"):
            export_studio(old.runtime, world.studio_id, tmp_path / "studio.zip")
        assert not list(tmp_path.glob("studio.zip*"))


@pytest.mark.parametrize(("before", "after"), [("sqlite", "postgres"), ("postgres", "sqlite")])
def test_an_imported_studio_is_the_same(opened: Opened, tmp_path: Path, before: str, after: str):
    file = tmp_path / "studio.zip"
    with opened("old", before, "folder", worker=True) as old, opened("new", after, "s3") as new:
        World(old)  # another studio, which stays
        world = agreed_studio(old)
        known = contents(world, old)
        exported = export_studio(old.runtime, world.studio_id, file)
        neighbour = World(new)
        before_import = rows_of(new.runtime)
        imported = import_studio(new.runtime, file)
        assert (imported.rows, imported.blobs, imported.people) == (exported.rows, exported.blobs, exported.people)
        with old.runtime.database.reading() as there, new.runtime.database.reading() as here:
            for table in scopes.tables():
                where = scopes.of_studio(table, world.studio_id)
                if where is not None and table.name not in LEFT_OUT:
                    assert rows.digest(here, table, where) == rows.digest(there, table, where), table.name
            person = here.get_one(Person, world.producer_id)
            assert (person.password_hash, person.email_verified_at) == (None, None)
        assert whole_records(new.runtime) == (1, [])
        secret = str(world.producer.cookies[SESSION_COOKIE])  # no sign-in comes along: the producer signs in here
        sign_in = SignIn(
            person_id=world.producer_id,
            secret_sha256=sha256_of(secret),
            expires_at=clock.now() + timedelta(days=1),
        )
        new.in_database(lambda session: session.add(sign_in))
        assert contents(world, new) == known
        assert neighbour.producer.get(f"/v1/takes/{known['delivery']['takes'][0]['id']}/master").status_code == 404
        with pytest.raises(TransferRefused, match="is on this server already"):
            import_studio(new.runtime, file)
        assert rows_of(new.runtime)["accounts_studios"].rows == before_import["accounts_studios"].rows + 1


def test_an_import_is_all_or_nothing(opened: Opened, tmp_path: Path):
    file = tmp_path / "studio.zip"
    with opened("old", "sqlite", "folder", worker=True) as old, opened("new", "sqlite", "folder") as new:
        world = agreed_studio(old)
        export_studio(old.runtime, world.studio_id, file)
        empty = rows_of(new.runtime)

        def refused(match: str, path: Path = file, **how: bool) -> None:
            with pytest.raises(TransferRefused, match=match):
                import_studio(new.runtime, path, **how)
            assert rows_of(new.runtime) == empty
            assert list(new.runtime.store.blobs()) == []

        def altered(name: str, change: Callable[[bytes], bytes | None]) -> Path:
            """Write the file anew with one entry changed or left out."""
            changed = tmp_path / "altered.zip"
            with zipfile.ZipFile(file) as source, zipfile.ZipFile(changed, "w") as target:
                for entry in source.namelist():
                    content = change(source.read(entry)) if entry.startswith(name) else source.read(entry)
                    if content is not None:
                        target.writestr(entry, content)
            return changed

        with zipfile.ZipFile(file) as archive:
            sound = next(name for name in archive.namelist() if name.startswith("blobs/"))
        refused("holds no studio", altered("soundlist.json", lambda _: None))
        refused(
            "is of the tables", altered("soundlist.json", lambda text: text.replace(b'"format": 1', b'"format": 2'))
        )
        refused("has other bytes", altered(sound, lambda content: content + b"x"))
        refused("lacks 1 stored file", altered(sound, lambda _: None))
        cues = "tables/sound_lists_cues.jsonl"
        refused(
            "sound_lists_cues is not what was exported", altered(cues, lambda line: line.replace(b"Laser", b"Maser"))
        )
        refused(
            "a row of sound_lists_cues cannot be read", altered(cues, lambda line: line.replace(b'"name"', b'"nom"'))
        )
        another = str(new_id()).encode()
        refused("is another studio's", altered(cues, lambda line: line.replace(str(world.studio_id).encode(), another)))
        (tmp_path / "notes.txt").write_text("hello")
        refused("cannot be read", tmp_path / "notes.txt")

        # A person whose address has another account here.
        email = f"{world.designer_id}@example.test"
        new.in_database(lambda session: session.add(Person(email=email, name="The same designer")))
        empty = rows_of(new.runtime)
        refused(f"{email}: another account of this server has this address; with --keep-apart")
        import_studio(new.runtime, file, keep_apart=True)
        assert whole_records(new.runtime) == (1, [])


def test_the_commands(opened: Opened, tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def ran(*command: str) -> tuple[int, str]:
        done = CliRunner().invoke(cli, [*command])
        return done.exit_code, done.output

    with opened("old", "sqlite", "folder", worker=True) as old:
        world = agreed_studio(old)
        at_rest(old)
    monkeypatch.setenv("SOUNDLIST_SECRET_KEY", "the key of old, for tests, and as long as one must be")
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "old"))
    assert ran("move")[0] == 2
    code, output = ran("move", "--data-dir", str(tmp_path / "moved"))
    assert (code, "equal in both databases" in output) == (0, True), output
    assert ran("move", "--data-dir", str(tmp_path / "moved"))[0] == 2
    file = str(tmp_path / "studio.zip")
    assert ran("export", str(new_id()), file)[0] == 2
    code, output = ran("export", str(world.studio_id), file)
    assert (code, output.startswith("exported: Test studio")) == (0, True), output
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "third"))
    assert ran("migrate")[0] == 0
    code, output = ran("import", file)
    assert (code, output.startswith("imported: Test studio")) == (0, True), output
    assert ran("verify")[0] == 0
    code, output = ran("import", file)
    assert (code, "already" in output) == (2, True), output
    assert json.loads(zipfile.ZipFile(file).read("soundlist.json"))["studio"]["id"] == str(world.studio_id)
