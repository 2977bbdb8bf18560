"""Stored files against the rows that name them: what is missing, altered or named by nothing, and what heals it."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from typer.testing import CliRunner

from app.cli import cli
from app.core import clock, metrics
from app.core.db import new_id
from app.core.runtime import Runtime
from app.core.storage import FolderStore
from app.migrate import migrate
from app.operations import jobs
from app.operations.figures import web_collectors
from app.operations.models import BlobState
from app.operations.scrubbing import queries as blob_queries
from app.operations.scrubbing import service as scrubbing
from app.renders.take_jobs import prepare_take
from app.tables import Base
from tests.app.test_backup import Opened, opened
from tests.support.blobs import blob_file
from tests.support.deliver import add_cues, deliver
from tests.support.server import RunningServer, World
from tests.support.waves import sine, wav_bytes

pytestmark = pytest.mark.both_databases
__all__ = ["opened"]

# Hashes that name no stored file: of secrets, of texts and rows, of decoded samples, and copies of another column.
NAMES_NO_BLOB = {
    "accounts_people.picture_sha256",  # kept in the database
    "accounts_pictures.sha256",
    "core_uploads.expected_sha256",
    "projects_specs.sha256",
    "projects_engagements.nda_sha256",
    "contracts_contracts.record_sha256",
    *("contracts_events.previous_sha256", "contracts_events.sha256"),
    "contracts_seals.key_sha256",
    "contracts_notices.statement_sha256",
    "conformance_waivers.master_sha256",  # of the take that was waived
    "shares_guest_copies.preview_sha256",  # of the preview that it is a copy of
    "scenes_comparisons.against_sha256",
    *("operations_damaged_blobs.sha256", "operations_scrubs.last_sha256"),
}


def test_every_column_of_a_hash_names_a_blob_or_is_known_not_to():
    hashes = {
        f"{table.name}.{column.name}"
        for table in Base.metadata.sorted_tables
        for column in table.columns
        if "sha256" in column.name
        and not column.name.startswith(("secret_", "code_", "request_", "text_", "pcm_", "sound_"))
    }
    columns = [source.sha256 for source in blob_queries.NAMING]
    named = {f"{column.class_.__tablename__}.{column.key}" for column in columns}
    assert named - hashes == set()
    assert hashes - named == NAMES_NO_BLOB


@pytest.fixture(params=["folder", pytest.param("s3", marks=pytest.mark.slow)])
def server(request: pytest.FixtureRequest, opened: Opened) -> Iterator[RunningServer]:
    """A server of its own: a pass goes over all studios."""
    with opened("scrubbed", store=request.param) as running:
        migrate(running.runtime.database)
        yield running


def delivered(server: RunningServer) -> tuple[World, dict[str, str]]:
    """Return a studio with one checked take, and the take."""
    world = World(server)
    add_cues(world, {"name": "Laser fire"})
    take = deliver(world, "laser_fire.wav", wav_bytes(sine(hz=997, seconds=0.2, rate=44_100), rate=44_100, bits=16))
    prepare_take(server.runtime, {"take_id": take["id"], "event_id": str(new_id()), "studio_id": str(world.studio_id)})
    return world, take


def flip(file: Path) -> None:
    """Change one bit of a file."""
    file.chmod(0o640)
    content = bytearray(file.read_bytes())
    content[len(content) // 2] ^= 1
    file.write_bytes(content)


def scrubbed(runtime: Runtime) -> list[scrubbing.Damage]:
    return list(scrubbing.run(runtime, scrubbing.begin(runtime.database), rate=scrubbing.RateLimit(None)))


def master_of(server: RunningServer, world: World, take: dict[str, str]) -> tuple[str, bytes]:
    answer = world.producer.get(f"/v1/takes/{take['id']}/master")
    assert answer.status_code == 200, answer.text
    return answer.headers["etag"].strip('"'), answer.content


@pytest.mark.slow
def test_rot_is_found_refused_named_and_healed(server: RunningServer, tmp_path: Path):
    runtime = server.runtime
    world, take = delivered(server)
    assert scrubbed(runtime) == []
    assert list(scrubbing.orphans(runtime)) == []
    sha256, content = master_of(server, world, take)
    [sounds] = world.producer.get(f"/v1/takes/{take['id']}/sounds").json()["renders"][:1] or [None]
    assert sounds

    flip(blob_file(runtime.store, world.studio_id, sha256))
    ranges = [{"Range": "bytes=0-9"}] if isinstance(runtime.store, FolderStore) else []  # whose times are exact
    for headers in ({}, *ranges):
        answer = world.producer.get(f"/v1/takes/{take['id']}/master", headers=headers)
        assert (answer.status_code, answer.json()["code"]) == (500, "blob-altered")
        assert "upload the same file again" in answer.json()["fix"]
    [damage] = scrubbed(runtime)
    assert (damage.sha256, damage.state, damage.kind) == (sha256, BlobState.ALTERED, "masters")
    shown = metrics.exposition(web_collectors(runtime)).decode()
    assert 'soundlist_damaged_blobs{state="altered"} 1.0' in shown

    runtime.store.put(world.studio_id, [content])  # as an upload of the same file does
    assert master_of(server, world, take) == (sha256, content)
    assert scrubbed(runtime) == []
    assert 'soundlist_damaged_blobs{state="altered"} 0.0' in metrics.exposition(web_collectors(runtime)).decode()

    blob_file(runtime.store, world.studio_id, sha256).unlink()
    [damage] = scrubbed(runtime)
    assert damage.state is BlobState.MISSING


@pytest.mark.slow
def test_a_pass_is_done_in_steps_and_begins_again_after_a_day(server: RunningServer, monkeypatch: pytest.MonkeyPatch):
    runtime = server.runtime
    delivered(server)
    delivered(server)
    monkeypatch.setattr(jobs, "SCRUB_BYTES", 1)  # one file a step
    for _ in range(100):
        jobs.scrub_blobs(runtime, {})
        with runtime.database.reading() as session:
            scrub = blob_queries.newest_scrub(session)
        assert scrub is not None
        if scrub.finished_at:
            break
    stored = sum(1 for _ in runtime.store.blobs())
    assert (scrub.blobs, scrub.missing, scrub.altered, scrub.orphaned) == (stored, 0, 0, 0)
    jobs.scrub_blobs(runtime, {})
    with runtime.database.reading() as session:
        assert blob_queries.newest_scrub(session).id == scrub.id
    later = clock.now() + jobs.SCRUB_EVERY
    monkeypatch.setattr(clock, "now", lambda: later)
    jobs.scrub_blobs(runtime, {})
    with runtime.database.reading() as session:
        assert blob_queries.newest_scrub(session).id != scrub.id


def orphan(runtime: Runtime, monkeypatch: pytest.MonkeyPatch) -> str:
    """Store a blob that nothing names, and let two days pass."""
    sha256 = runtime.store.put(new_id(), [b"nobody's"]).sha256
    later = clock.now() + 2 * scrubbing.ORPHANED_AFTER
    monkeypatch.setattr(clock, "now", lambda: later)
    return sha256


def test_what_nothing_names_is_counted_and_deleted_on_request(server: RunningServer, monkeypatch: pytest.MonkeyPatch):
    runtime = server.runtime
    fresh = runtime.store.put(new_id(), [b"just stored, its row comes later"])
    assert list(scrubbing.orphans(runtime)) == []
    runtime.store.delete(next(runtime.store.blobs())[0], fresh.sha256)
    sha256 = orphan(runtime, monkeypatch)
    scrubbed(runtime)
    with runtime.database.reading() as session:
        scrub = blob_queries.newest_scrub(session)
    assert scrub is not None
    assert (scrub.orphaned, scrub.orphaned_bytes) == (1, 8)
    assert [blob.sha256 for _, blob in scrubbing.delete_orphans(runtime)] == [sha256]
    assert list(runtime.store.blobs()) == []


@pytest.mark.slow
def test_the_command_names_damage_and_exits_1(tmp_path: Path, opened: Opened, monkeypatch: pytest.MonkeyPatch):
    def ran(*command: str) -> tuple[int, str]:
        done = CliRunner().invoke(cli, [*command])
        return done.exit_code, done.output

    with opened("served") as server:
        monkeypatch.setenv("SOUNDLIST_DATA_DIR", str(server.runtime.settings.data_dir))
        monkeypatch.setenv("SOUNDLIST_DATABASE_URL", server.runtime.settings.database_url or "")
        migrate(server.runtime.database)
        world, take = delivered(server)
        sha256, content = master_of(server, world, take)
        backup = str(tmp_path / "backup")
        assert ran("backup", backup)[0] == 0
        assert ran("scrub", "--rate", "0")[0] == 0
        flip(blob_file(server.runtime.store, world.studio_id, sha256))
        code, output = ran("scrub")
        assert (code, f"altered: masters, {world.studio_id}/{sha256}" in output) == (1, True), output
        code, output = ran("backup", backup)  # which has it, from before
        assert code == 0, output
        code, output = ran("restore", backup, "--sounds")
        assert (code, output.startswith("restored: 1 blobs")) == (0, True), output
        assert master_of(server, world, take) == (sha256, content)

        blob_file(server.runtime.store, world.studio_id, sha256).unlink()
        assert "missing: masters" in ran("scrub")[1]
        assert ran("restore", backup, "--sounds")[0] == 0
        assert ran("scrub")[0] == 0

        # What is lost in both places is named.
        blob_file(server.runtime.store, world.studio_id, sha256).unlink()
        [copy] = (tmp_path / "backup").rglob(sha256)
        copy.unlink()
        code, output = ran("backup", backup)
        assert (code, f"neither in the store nor in the backup: {world.studio_id}/{sha256}" in output) == (1, True)
        code, output = ran("restore", backup, "--sounds")
        assert (code, f"not in the backup, or damaged there: {world.studio_id}/{sha256}" in output) == (1, True)
