"""What an erasure deletes, what stays and why, and that a neighbour loses nothing."""

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
from app.kit import clock
from app.kit.runtime import Runtime
from app.operations import blob_queries, erasure, jobs, scopes, scrubbing
from app.operations.errors import ErasureRefused
from app.references.models import Reference, ReferenceVersion
from app.references.rules import PreviewState, ReferenceKind
from app.tables import Base
from tests.house.objects import House
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
    assert any("delivered version" in kept and "contract" in kept for kept in erased.kept), erased.kept


def test_the_file_of_a_removed_reference_leaves_the_disk(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    runtime = world.server.runtime
    blob = runtime.store.put(world.studio_id, [b"a film still"])
    of = {"studio_id": world.studio_id, "project_id": world.project_id}

    def add(session: Any) -> UUID:
        reference = Reference(**of, caption="", terms="", newest_number=1, added_by=world.producer_id)
        session.add(reference)
        session.flush()
        session.add(
            ReferenceVersion(
                **of, reference_id=reference.id, number=1, kind=ReferenceKind.PICTURE, media_type="image/png",
                file_name="still.png", sha256=blob.sha256, file_bytes=blob.size_bytes, excerpt="",
                preview=PreviewState.NONE, added_by=world.producer_id,
            )
        )  # fmt: skip
        return reference.id

    reference_id = world.server.in_database(add)

    def is_named() -> bool:
        with runtime.database.reading() as session:
            return blob_queries.is_named(session, world.studio_id, blob.sha256)

    assert is_named()
    assert world.producer.delete(f"/v1/references/{reference_id}").status_code == 204
    assert not is_named()
    later = clock.now() + scrubbing.ORPHANS_KEPT + timedelta(hours=1)
    monkeypatch.setattr(clock, "now", lambda: later)
    assert blob.sha256 in {gone.sha256 for _, gone in scrubbing.delete_orphans(runtime, scrubbing.ORPHANS_KEPT)}


def test_every_table_without_a_studio_is_known_to_the_erasure_of_people() -> None:
    of_nobody = {
        *("accounts_people", "accounts_studios", "accounts_rate_limits", "accounts_sign_ups"),
        *("kit_backups", "kit_heartbeats", "kit_saved_responses", "operations_scrubs"),
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
