"""What an erasure deletes, what stays and why, and that a neighbour loses nothing."""

import os
import subprocess
import sys
from collections.abc import Callable
from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from typer.testing import CliRunner

from app.accounts.models import Membership, Person
from app.agreements.models import Contract
from app.agreements.rules import ContractState
from app.cli import cli, erasing
from app.core import clock
from app.core.runtime import Runtime
from app.core.uploads.errors import UploadNotFound
from app.core.uploads.model import FINISHED_KEPT_FOR, Upload, finished_upload
from app.operations import jobs
from app.operations.erasure import scope_queries as scopes
from app.operations.erasure import service as erasure
from app.operations.errors import ErasureRefused
from app.operations.scrubbing import queries as blob_queries
from app.operations.scrubbing import service as scrubbing
from app.tables import Base
from tests.app.hiring.test_roster import WAV, send_sound
from tests.app.hiring.test_roster import add as add_to_roster
from tests.house.objects import House
from tests.support.references import uploaded
from tests.support.server import RunningServer, World

pytestmark = pytest.mark.both_databases


@pytest.fixture
def house(server: RunningServer) -> House:
    """A studio with one of everything."""
    return House(server)


def counts(runtime: Runtime, studio_id: UUID) -> dict[str, int]:
    """Return how many rows of a studio each table has."""
    with runtime.database.reading() as session:
        return {
            table.name: session.scalar(sa.select(sa.func.count()).select_from(table).where(where)) or 0
            for table in scopes.tables()
            if (where := scopes.of_studio(table, studio_id)) is not None
        }


def unsign(house: House) -> None:
    """Make drafts of the studio's contracts."""
    drafts = sa.update(Contract).where(Contract.studio_id == house.studio_id)
    house.server.in_database(
        lambda session: session.execute(drafts.values(state=ContractState.DRAFT, agreed_at=None, ended_at=None))
    )


def mentions(runtime: Runtime, value: Any) -> list[str]:
    """Return every text column of the database in which a text stands."""
    found = []
    with runtime.database.reading() as session:
        for table in scopes.tables():
            for column in table.columns:
                if isinstance(column.type, sa.String) and not isinstance(column.type, sa.Enum):
                    holds = sa.select(sa.literal(1)).select_from(table).where(column.contains(value)).limit(1)
                    if session.execute(holds).first():
                        found.append(f"{table.name}.{column.name}")
    return found


@pytest.mark.slow
def test_a_signed_contract_keeps_project_and_studio(house: House) -> None:
    signed = sa.update(Contract).where(Contract.studio_id == house.studio_id)
    house.server.in_database(
        lambda session: session.execute(signed.values(state=ContractState.AGREED, agreed_at=clock.now(), ended_at=None))
    )
    house.server.wait_for_jobs()  # which write notices
    before = counts(house.server.runtime, house.studio_id)
    for erase, id_ in ((erasure.erase_project, house.project_id), (erasure.erase_studio, house.studio_id)):
        with pytest.raises(ErasureRefused, match=r"signed contract.*kept as evidence") as refused:
            house.server.in_database(lambda session, erase=erase, id_=id_: erase(session, id_))
        assert "export the studio" in (refused.value.fix or "")
    assert counts(house.server.runtime, house.studio_id) == before


@pytest.mark.slow
def test_an_erased_studio_leaves_no_row_and_its_files_go(house: House, monkeypatch: pytest.MonkeyPatch) -> None:
    runtime, neighbour = house.server.runtime, World(house.server)
    unsign(house)
    house.server.wait_for_jobs()
    before, others = counts(runtime, house.studio_id), counts(runtime, neighbour.studio_id)
    assert len([name for name, count in before.items() if count]) > 80  # one of everything
    house.server.in_database(lambda session: erasure.erase_studio(session, house.studio_id))
    assert {name: count for name, count in counts(runtime, house.studio_id).items() if count} == {}
    assert counts(runtime, neighbour.studio_id) == others
    assert house.producer.get(f"/v1/projects/{house.project_id}").status_code == 404

    later = clock.now() + scrubbing.ORPHANS_KEPT + timedelta(hours=1)
    monkeypatch.setattr(clock, "now", lambda: later)
    deleted = {studio_id for studio_id, _ in scrubbing.delete_orphans(runtime, scrubbing.ORPHANS_KEPT)}
    assert house.studio_id in deleted
    assert house.studio_id not in {studio_id for studio_id, _ in runtime.store.blobs()}


@pytest.mark.slow
def test_an_erased_project_leaves_the_studio_as_it_was(house: House) -> None:
    runtime = house.server.runtime
    unsign(house)
    house.server.wait_for_jobs()
    erased = house.server.in_database(lambda session: erasure.erase_project(session, house.project_id))
    assert (erased.name, erased.rows > 80) == ("Shield Wing", True)
    with runtime.database.reading() as session:
        for table in scopes.tables():
            where = scopes.of_project(table, house.project_id)
            if where is not None:
                assert session.scalar(sa.select(sa.func.count()).select_from(table).where(where)) == 0, table.name
    after = counts(runtime, house.studio_id)
    assert after["accounts_studios"] == 1
    assert after["accounts_memberships"] >= 3
    assert after["hiring_roster_entries"] == 1


@pytest.mark.slow
def test_an_erased_person_is_a_pseudonym_everywhere_but_in_evidence(house: House) -> None:
    server, person_id = house.server, house.reviewer_id
    email = f"{person_id}@example.test"
    with pytest.raises(ErasureRefused, match="is a member of Test studio: a producer removes them first"):
        server.in_database(lambda session: erasure.erase_person(session, email))
    assert house.reviewer.get("/v1/me").status_code == 200
    left = sa.delete(Membership).where(Membership.person_id == person_id)
    server.in_database(lambda session: session.execute(left))
    erased = server.in_database(lambda session: erasure.erase_person(session, email))
    assert erased.name == "Composer"
    assert mentions(server.runtime, email) == []
    assert house.reviewer.get("/v1/me").status_code == 401
    with server.runtime.database.reading() as session:
        person = session.get_one(Person, person_id)
    assert person.name.startswith("Former user ")
    assert (person.password_hash, person.picture_sha256, person.email_proof) == (None, None, None)
    with pytest.raises(ErasureRefused, match="no account has the address"):
        server.in_database(lambda session: erasure.erase_person(session, email))


@pytest.mark.slow
def test_a_party_of_a_running_contract_and_an_operator_are_refused(house: House) -> None:
    signed = sa.update(Contract).where(Contract.studio_id == house.studio_id)
    house.server.in_database(
        lambda session: session.execute(signed.values(state=ContractState.AGREED, agreed_at=clock.now(), ended_at=None))
    )
    with pytest.raises(ErasureRefused, match=r"is a party of the running contract .*: end it first"):
        house.server.in_database(lambda session: erasure.erase_person(session, f"{house.designer_id}@example.test"))
    ended = signed.values(state=ContractState.ENDED, ended_at=clock.now())
    house.server.in_database(lambda session: session.execute(ended))
    erased = house.server.in_database(
        lambda session: erasure.erase_person(session, f"{house.designer_id}@example.test")
    )
    assert any("delivered version" in kept.name and "contract" in kept.reason for kept in erased.kept), erased.kept


def reference_of(world: World) -> tuple[str, str]:
    """Add a reference by an upload, and return its path and that of the upload's answer."""
    upload_id = uploaded(world, "still.txt", b"a film still, in words")
    made = world.producer.post(f"/v1/projects/{world.project_id}/references", json={"upload_id": upload_id})
    assert made.status_code == 201, made.text
    return f"/v1/references/{made.json()['id']}", upload_id


def release_of(world: World) -> tuple[str, str]:
    """Add a performer's release by an upload."""
    upload_id = uploaded(world, "release.pdf", b"%PDF-1.7 signed")
    release = {"performer": "Captain", "upload_id": upload_id, "valid_from": "2026-01-01", "synthetic_use": "no"}
    made = world.producer.post(f"/v1/projects/{world.project_id}/voice-releases", json=release)
    assert made.status_code == 201, made.text
    (performer,) = world.producer.get(f"/v1/projects/{world.project_id}/voice-releases").json()["performers"]
    return f"/v1/voice-releases/{performer['releases'][0]['id']}", upload_id


def reel_sound_of(world: World) -> tuple[str, str]:
    """Add a sound to a reel of the roster by an upload."""
    entry_id = add_to_roster(world).json()["id"]
    upload_id = send_sound(world, entry_id, WAV).headers["location"].rpartition("/")[2]
    sent = {"upload_id": upload_id, "title": "Weapons"}
    (sound,) = world.producer.post(f"/v1/roster/{entry_id}/reel", json=sent).json()["reel"]
    return f"/v1/reel-sounds/{sound['id']}", upload_id


@pytest.mark.parametrize("add", [reference_of, release_of, reel_sound_of])
def test_the_file_of_what_was_removed_leaves_the_disk(
    world: World, monkeypatch: pytest.MonkeyPatch, add: Callable[[World], tuple[str, str]]
) -> None:
    runtime = world.server.runtime
    path, upload_id = add(world)
    with runtime.database.reading() as session:
        upload = session.get_one(Upload, UUID(upload_id))
    assert upload.sha256 is not None
    assert world.producer.delete(path).is_success

    def deleted_after(age: timedelta) -> bool:
        later = clock.now() + age
        with monkeypatch.context() as patched:
            patched.setattr(clock, "now", lambda: later)
            deleted = {
                (studio_id, blob.sha256)
                for studio_id, blob in scrubbing.delete_orphans(runtime, scrubbing.ORPHANS_KEPT)
            }
            if age > FINISHED_KEPT_FOR:  # nothing can be made of the upload any more
                with runtime.database.writing() as session, pytest.raises(UploadNotFound, match="has expired"):
                    finished_upload(session, upload.id, owner_id=upload.owner_id, scope=upload.scope)
        return (world.studio_id, upload.sha256) in deleted

    assert not deleted_after(FINISHED_KEPT_FOR - timedelta(hours=1))
    assert deleted_after(blob_queries.UPLOADS_NAME_FOR + timedelta(hours=1))
    kept = {(studio_id, blob.sha256) for studio_id, blob in runtime.store.blobs()}  # others may have sent the same
    assert (world.studio_id, upload.sha256) not in kept


def test_every_table_without_a_studio_is_known_to_the_erasure_of_people() -> None:
    of_nobody = {
        *("accounts_people", "accounts_studios", "accounts_rate_limits", "accounts_sign_ups"),
        *("core_backups", "core_heartbeats", "core_saved_responses", "operations_scrubs"),
    }
    without = {table.name for table in Base.metadata.sorted_tables if "studio_id" not in table.c}
    personal = {name for name in without if "person_id" in Base.metadata.tables[name].c}
    assert without - personal == of_nobody
    assert jobs.SCRUB_EVERY < scrubbing.ORPHANS_KEPT


@pytest.mark.slow
def test_the_commands_ask_first_and_say_what_they_did(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> None:
    def ran(*command: str, answer: str = "") -> tuple[int, str]:
        done = CliRunner().invoke(cli, [*command], input=answer)
        return done.exit_code, done.output

    world = World(server)
    monkeypatch.setattr(erasing, "read_settings_or_exit", lambda: server.runtime.settings)
    assert ran("erase", "project", str(world.project_id), answer="n\n")[0] == 1
    code, output = ran("erase", "project", str(world.project_id), answer="y\n")
    assert (code, "erased: Shield Wing" in output) == (0, True), output
    assert ran("erase", "project", str(world.project_id), "--yes")[0] == 2
    code, output = ran("erase", "person", f"{world.producer_id}@example.test", "--yes")
    assert (code, "is a member of Test studio" in output) == (2, True), output
    code, output = ran("erase", "studio", str(world.studio_id), "--yes")
    assert (code, "erased: Test studio" in output) == (0, True), output
    code, output = ran("erase", "person", f"{world.producer_id}@example.test", "--yes")
    assert (code, "erased: Producer" in output) == (0, True), output


@pytest.mark.slow
def test_a_command_in_a_process_of_its_own_knows_every_table(server: RunningServer) -> None:
    world = World(server)
    settings = server.runtime.settings
    done = subprocess.run(
        [sys.executable, "-m", "app", "erase", "project", str(world.project_id), "--yes"],
        env=os.environ
        | {"SOUNDLIST_DATA_DIR": str(settings.data_dir), "SOUNDLIST_DATABASE_URL": settings.database_url},
        capture_output=True,
        text=True,
    )
    assert (done.returncode, "erased: Shield Wing" in done.stdout) == (0, True), done.stdout + done.stderr
