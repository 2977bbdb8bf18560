"""A new server out of a backup serves the same, whatever the database, and whichever store it goes to."""

import io
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

from app.backup import SHARES, BackupRefused, back_up, restore
from app.cli import cli
from app.core import clock
from app.core.db import new_id
from app.core.runtime import Runtime
from app.core.uploads.model import Upload
from app.main import create_app
from app.migrate import ensure_at_head, migrate
from app.renders.take_jobs import prepare_take
from app.settings import Settings
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, deliver
from tests.support.s3 import S3Server
from tests.support.server import RunningServer, World
from tests.support.waves import sine, wav_bytes

pytestmark = pytest.mark.both_databases

SECRET_KEY = "only for tests, and only here"
Opened = Callable[..., AbstractContextManager[RunningServer]]


@pytest.fixture
def opened(request: pytest.FixtureRequest, database_url: str, s3: S3Server, tmp_path: Path) -> Opened:
    """Open a web process on a database of its own; no worker runs beside it."""

    @contextmanager
    def open_server(name: str, *, store: str = "folder") -> Iterator[RunningServer]:
        settings: dict[str, Any] = s3.settings() if store == "s3" else {}
        if database_url:
            settings["database_url"] = request.getfixturevalue("postgres").new_database(f"{name}_{new_id().hex}")
        runtime = Runtime.of(Settings(data_dir=tmp_path / name, secret_key=SECRET_KEY, **settings))
        with start_blocking_portal() as portal:
            yield RunningServer(runtime, create_app(runtime), portal)
        runtime.close()

    return open_server


def lived_in(server: RunningServer) -> World:
    """Return a studio in which a sound was delivered, checked, rendered and approved."""
    migrate(server.runtime.database)
    world = World(server)
    [cue] = add_cues(world, {"name": "Laser fire"})
    take = deliver(world, "laser_fire.wav", wav_bytes(sine(hz=997, seconds=0.2, rate=44_100), rate=44_100, bits=16))
    payload = {"take_id": take["id"], "event_id": str(new_id()), "studio_id": str(world.studio_id)}
    prepare_take(server.runtime, payload)
    verdict = world.approver.post(f"/v1/takes/{take['id']}/verdict", json={"kind": "approve", "note": "Good."})
    assert verdict.status_code in (200, 201), verdict.text
    assert cue["id"]
    return world


def contents(world: World, server: RunningServer) -> dict[str, Any]:
    """Return what a server says of the studio, as the producer reads it."""
    client = server.browser()
    client.cookies = world.producer.cookies
    project = f"/v1/projects/{world.project_id}"
    takes = client.get(f"{project}/deliveries").json()["items"]
    delivery = client.get(f"/v1/deliveries/{takes[0]['id']}").json()
    [take] = delivery["takes"]
    pack = client.get(f"{project}/pack.zip", params={"masters": True})
    assert pack.status_code == 200, pack.text
    return {
        "list": client.get(f"{project}/sound-list.csv").text,
        "delivery": delivery,
        "check": client.get(f"/v1/takes/{take['id']}/check").json(),
        "sounds": client.get(f"/v1/takes/{take['id']}/sounds").json(),
        "master": client.get(f"/v1/takes/{take['id']}/master").content,
        "pack": {entry.filename: entry.CRC for entry in zipfile.ZipFile(io.BytesIO(pack.content)).infolist()},
    }


@pytest.mark.slow
@pytest.mark.parametrize(("before", "after"), [("folder", "s3"), ("s3", "folder")])
def test_a_new_server_out_of_a_backup_serves_the_same(opened: Opened, tmp_path: Path, before: str, after: str):
    folder = tmp_path / "backup"
    with opened("old", store=before) as old:
        world = lived_in(old)
        copied = back_up(old.runtime, folder, keep=2)
        blobs = sorted(old.runtime.store.blobs(), key=str)
        assert (copied.blobs, copied.damaged) == (len(blobs), [])
        known = contents(world, old)
        assert len(known["pack"]) == 6  # game file, master, three documentation keys, sums
        with opened("new", store=after) as new:
            assert restore(new.runtime, folder).blobs == len(blobs)
            ensure_at_head(new.runtime)
            assert contents(world, new) == known
            assert sorted(new.runtime.store.blobs(), key=str) == blobs


@pytest.mark.slow
def test_blobs_are_copied_once_and_old_databases_go(opened: Opened, tmp_path: Path):
    folder = tmp_path / "backup"
    with opened("old") as old:
        migrate(old.runtime.database)
        world = World(old)
        old.runtime.store.put(world.studio_id, [b"a sound"])
        assert back_up(old.runtime, folder, keep=2).blobs == 1
        old.runtime.store.put(world.studio_id, [b"another"])
        second = back_up(old.runtime, folder, keep=2)
        assert (second.blobs, second.size_bytes, second.there_before) == (1, 7, 1)
        back_up(old.runtime, folder, keep=2)
    assert len(list(folder.glob("database-*"))) == 2


@pytest.mark.slow
def test_an_altered_blob_is_named_and_left_out(opened: Opened, tmp_path: Path):
    with opened("old") as old:
        migrate(old.runtime.database)
        world = World(old)
        sha256 = old.runtime.store.put(world.studio_id, [b"a sound"]).sha256
        file = blob_file(old.runtime.store, world.studio_id, sha256)
        file.chmod(0o640)
        file.write_bytes(b"a sOund")
        copied = back_up(old.runtime, tmp_path / "backup", keep=1)
    assert copied.damaged == [f"{world.studio_id}/{sha256}"]
    assert not list((tmp_path / "backup").rglob(sha256))


@pytest.mark.slow
def test_a_damaged_copy_is_read_again_within_two_weeks_and_made_good(
    opened: Opened, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    folder = tmp_path / "backup"
    with opened("old") as old:
        migrate(old.runtime.database)
        world = World(old)
        sha256 = old.runtime.store.put(world.studio_id, [b"a sound"]).sha256
        back_up(old.runtime, folder, keep=1)
        [file] = folder.rglob(sha256)
        file.chmod(0o640)
        file.write_bytes(b"a sOund")
        healed = []
        for day in range(SHARES):
            now = clock.now() + timedelta(days=1) if day else clock.now()
            monkeypatch.setattr(clock, "now", lambda now=now: now)
            healed += back_up(old.runtime, folder, keep=1).healed
        assert healed == [f"{world.studio_id}/{sha256}"]
        assert file.read_bytes() == b"a sound"


@pytest.mark.slow
def test_what_nothing_names_leaves_the_backup_with_the_last_database_that_named_it(opened: Opened, tmp_path: Path):
    folder = tmp_path / "backup"
    with opened("old") as old:
        migrate(old.runtime.database)
        world = World(old)
        sha256 = old.runtime.store.put(world.studio_id, [b"a sound"]).sha256
        upload = Upload(
            studio_id=world.studio_id, owner_id=world.producer_id, scope="test", file_name="a.wav", length=7,
            sha256=sha256, finished_at=clock.now(),
        )  # fmt: skip
        old.in_database(lambda session: session.add(upload))
        back_up(old.runtime, folder, keep=2)
        old.in_database(lambda session: session.execute(sa.delete(Upload)))
        old.runtime.store.delete(world.studio_id, sha256)
        assert [back_up(old.runtime, folder, keep=2).expired for _ in range(4)] == [0, 0, 1, 0]
        assert list(folder.rglob(sha256)) == []


@pytest.mark.slow
def test_nothing_is_put_over_what_is_there(opened: Opened, tmp_path: Path):
    with opened("old") as old:
        migrate(old.runtime.database)
        back_up(old.runtime, tmp_path / "backup", keep=1)
        with pytest.raises(BackupRefused, match="tables already; name an empty one"):
            restore(old.runtime, tmp_path / "backup")
    with opened("new") as new:
        with pytest.raises(BackupRefused, match="holds no backup"):
            restore(new.runtime, tmp_path)
        other = tmp_path / ("database-1.sqlite" if not new.runtime.database.is_sqlite else "database-1.dump")
        with pytest.raises(BackupRefused, match="of another kind of database"):
            restore(new.runtime, tmp_path, other)


@pytest.mark.slow
def test_a_copy_from_before_the_release_is_refused_before_anything_is_written(opened: Opened, tmp_path: Path):
    folder = tmp_path / "backup"
    with opened("old") as old:
        migrate(old.runtime.database)
        with old.runtime.database.writing() as session:
            session.execute(sa.text("update alembic_version set version_num = '0078'"))
        old.runtime.store.put(new_id(), [b"a sound"])
        back_up(old.runtime, folder, keep=1)
    with opened("new") as new:
        with pytest.raises(BackupRefused, match=r"cannot be restored: .* revision 0078, which a version before"):
            restore(new.runtime, folder)
        assert sa.inspect(new.runtime.database.engine).get_table_names() == []
        assert list(new.runtime.store.blobs()) == []


@pytest.mark.slow
def test_the_commands_say_what_they_did(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    def ran(*command: str) -> Any:
        return CliRunner().invoke(cli, [*command])

    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "old"))
    assert ran("migrate").exit_code == 0
    done = ran("backup", str(tmp_path / "backup"))
    assert (done.exit_code, done.output.partition(":")[0]) == (0, "backed up"), done.output
    refused = ran("restore", str(tmp_path / "backup"))
    assert (refused.exit_code, "tables already" in refused.output) == (2, True)
    monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(tmp_path / "new"))
    [database] = (tmp_path / "backup").glob("database-*")
    assert database.read_bytes()[18:20] == b"\x01\x01"  # no log beside it: it is read from where nothing can be written
    done = ran("restore", str(tmp_path / "backup"))
    assert (done.exit_code, done.output.partition(":")[0]) == (0, "restored"), done.output
