"""Masters are deleted when their contracts' retention period is over: announced, carried out, on record."""

from datetime import date, datetime, timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.amendments import verification
from app.core import clock
from app.core.storage import BlobMissing
from app.deliveries.models import Take
from app.notifications.models import Mail, Notice
from app.operations import jobs
from app.operations.queries import storage
from app.operations.retention.rules import announced_day, end_of_masters, is_to_be_announced, years_after
from app.operations.schemas import KeptKind
from app.operations.scrubbing import queries as blob_queries
from app.operations.scrubbing import service as scrubbing
from tests.app.agreements.conftest import Contracts
from tests.app.projects.test_members import add_producer, limit
from tests.support.deliver import add_cues, deliver
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

YEARS = 5  # of the clause, as the library has it


@pytest.mark.parametrize(
    ("day", "years", "end"),
    [
        (date(2026, 11, 29), 5, date(2031, 11, 29)),
        (date(2024, 2, 29), 4, date(2028, 2, 29)),
        (date(2024, 2, 29), 1, date(2025, 3, 1)),
    ],
)
def test_years_after_a_day(day: date, years: int, end: date) -> None:
    assert years_after(day, years) == end


def test_years_count_from_the_last_delivery_and_notice_has_thirty_days() -> None:
    signed, delivered = date(2026, 1, 10), date(2026, 3, 20)
    assert end_of_masters(delivered, signed, 2) == date(2028, 3, 20)
    assert end_of_masters(signed, delivered, 2) == date(2028, 3, 20), "sounds from before the contract count from it"
    ends_on = date(2028, 3, 20)
    assert not is_to_be_announced(ends_on, date(2028, 2, 18))
    assert is_to_be_announced(ends_on, date(2028, 2, 19))
    assert announced_day(ends_on, date(2028, 2, 19)) == ends_on
    assert announced_day(ends_on, date(2029, 1, 1)) == date(2029, 1, 31), (
        "a server that was off gives notice all the same"
    )


class Keeping(Contracts):
    """A delivered master under a contract that names years, and a clock to pass them."""

    def __init__(self, world: World, monkeypatch: pytest.MonkeyPatch, **planned: Any) -> None:
        super().__init__(world)
        self._monkeypatch = monkeypatch
        [self.cue] = add_cues(world, {"name": "Laser fire", "state": "locked"})
        self.draft = self.begin()
        if planned:
            alpha = {"name": "Alpha", "due_on": "2026-12-24", "cues": [{"cue_id": self.cue["id"]}], **planned}
            path = f"/contracts/{self.draft['id']}/milestones"
            self.ask(world.producer, "PUT", path, json={"milestones": [alpha]})
        self.path = f"/contracts/{self.draft['id']}/master-retention"
        self.take: dict[str, Any] = {}

    def sign_and_deliver(self) -> None:
        """Have both sign, and deliver a sound."""
        self.agree(self.draft)
        self.take = deliver(self.world, "laser_fire.wav", wav_bytes(sine(hz=997, seconds=0.2, rate=44_100), bits=16))
        self.world.server.wait_for_jobs()

    def after(self, days: int) -> None:
        """Run the daily job so many days after the years are over."""
        today = clock.now()
        later = datetime.combine(years_after(today.date(), YEARS), today.timetz()) + timedelta(days=days)
        with self._monkeypatch.context() as patched:
            patched.setattr(clock, "now", lambda: later)
            jobs.end_masters(self.world.server.runtime, {})

    def read(self) -> dict[str, Any]:
        """Return the retention as the producer reads it."""
        read: dict[str, Any] = self.ask(self.world.producer, "GET", self.path)
        return read

    def keep(self, keep: bool) -> dict[str, Any]:
        """Keep the masters longer, or no longer, as the producer."""
        kept: dict[str, Any] = self.ask(self.world.producer, "PUT", self.path, json={"keep": keep})
        return kept

    def kinds(self) -> list[str]:
        """Return the kinds of entries of the record that are about masters."""
        return [entry["kind"] for entry in self.entries(self.draft) if entry["kind"].startswith("masters_")]

    def mailed(self, subject: str) -> set[str]:
        """Return the addresses of the people who have a mail and a notice of a subject from the studio."""
        of_studio = self.world.studio_id
        with self.world.server.runtime.database.reading() as session:
            mails = sa.select(Mail.recipient).where(Mail.studio_id == of_studio, Mail.subject.contains(subject))
            notices = sa.select(Notice.person_id).where(Notice.studio_id == of_studio, Notice.subject.contains(subject))
            mailed = set(session.scalars(mails))
            assert {f"{person_id}@example.test" for person_id in session.scalars(notices)} == mailed
        return mailed

    @property
    def has_master(self) -> bool:
        """Return whether the designer can download the master."""
        return self.world.designer.get(f"/v1/takes/{self.take['id']}/master").status_code == 200


@pytest.fixture
def keeping(world: World, monkeypatch: pytest.MonkeyPatch) -> Keeping:
    return Keeping(world, monkeypatch)


@pytest.mark.both_databases
def test_masters_are_deleted_after_the_years_and_a_notice(keeping: Keeping, monkeypatch: pytest.MonkeyPatch) -> None:
    world, runtime = keeping.world, keeping.world.server.runtime
    keeping.sign_and_deliver()
    end = years_after(clock.now().date(), YEARS)
    before = keeping.read()
    assert (before["years"], before["masters"], before["announced_at"]) == (YEARS, 1, None)
    assert (before["ends_on"], before["obstacles"]) == (end.isoformat(), [])
    keeping.after(-31)
    assert keeping.kinds() == []

    keeping.after(-30)
    assert keeping.kinds() == ["masters_end_announced"]
    parties = {f"{person_id}@example.test" for person_id in (world.producer_id, world.designer_id)}
    assert keeping.mailed(f"masters will be deleted on {end.day} ") == parties
    keeping.after(-1)
    assert keeping.has_master

    keeping.after(0)
    assert keeping.kinds() == ["masters_end_announced", "masters_deleted"]
    assert keeping.mailed("masters were deleted") == parties
    refused = world.designer.get(f"/v1/takes/{keeping.take['id']}/master")
    assert (refused.status_code, refused.json()["code"]) == (410, "master-deleted")
    assert "use its game files" in refused.json()["fix"]
    after = keeping.read()
    assert (after["masters"], after["ends_on"]) == (0, None)
    assert after["deleted_at"] is not None

    sha256 = keeping.take["master_sha256"]
    upload_is_forgotten = clock.now() + blob_queries.UPLOADS_NAME_FOR
    monkeypatch.setattr(clock, "now", lambda: upload_is_forgotten)
    with runtime.database.reading() as session:
        assert not blob_queries.is_named(session, world.studio_id, sha256)
        kept = {files.kind for studio in storage(session, world.studio_id) for files in studio.kept}
        assert KeptKind.MASTERS not in kept
    assert sha256 in {blob.sha256 for _, blob in scrubbing.delete_orphans(runtime, timedelta(0))}
    with pytest.raises(BlobMissing):
        runtime.store.size_bytes(world.studio_id, sha256)
    verified = {
        report.contract_id: report.faults for report in verification.verify_all(runtime.database, runtime.store)
    }
    assert [faults for contract_id, faults in verified.items() if str(contract_id) == keeping.draft["id"]] == [[]]
    monkeypatch.undo()
    keeping.after(400)
    assert len(keeping.kinds()) == 2, "done once"


@pytest.mark.slow
def test_nothing_is_deleted_while_money_is_open(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    keeping = Keeping(world, monkeypatch, amount_minor=50_000)
    keeping.sign_and_deliver()
    assert keeping.read()["obstacles"] == ["money is open in Effects for Alpha"]
    keeping.after(-30)
    keeping.after(100)
    assert keeping.kinds() == ["masters_end_announced"]
    assert keeping.has_master
    keeping.ask(world.producer, "POST", f"/contracts/{keeping.draft['id']}/ending/notice", json={"reason": "Cut."})
    assert keeping.read()["obstacles"] == ["the termination of Effects for Alpha is not settled"]


@pytest.mark.slow
def test_a_producer_keeps_masters_longer_by_one_press(keeping: Keeping) -> None:
    world = keeping.world
    keeping.sign_and_deliver()
    keeping.after(-30)
    kept = keeping.keep(True)
    assert (kept["kept_by"], kept["ends_on"], kept["announced_at"]) == ("Producer", None, None)
    assert keeping.keep(True)["kept_by"] == "Producer"  # twice is once
    keeping.after(400)
    assert keeping.has_master
    assert keeping.kinds() == ["masters_end_announced", "masters_kept_longer"]

    assert keeping.keep(False)["kept_by"] is None
    keeping.after(400)
    assert keeping.kinds()[2:] == ["masters_not_kept_longer", "masters_end_announced"]
    keeping.after(429)
    assert keeping.has_master, "the days of notice begin again"
    keeping.after(430)
    assert not keeping.has_master
    for client, status in ((world.designer, 403), (world.reviewer, 404), (world.stranger, 404)):
        assert client.put(f"/v1{keeping.path}", json={"keep": True}).status_code == status


@pytest.mark.slow
def test_a_later_delivery_postpones_the_end(keeping: Keeping) -> None:
    keeping.sign_and_deliver()
    keeping.after(-30)
    again = deliver(keeping.world, "laser_fire.wav", wav_bytes(sine(hz=700, seconds=0.2, rate=44_100), bits=16))
    later = clock.now() + timedelta(days=200)
    received_later = sa.update(Take).where(Take.id == UUID(again["id"])).values(received_at=later)
    keeping.world.server.in_database(lambda session: session.execute(received_later))
    keeping.after(0)
    assert keeping.kinds() == ["masters_end_announced", "masters_end_postponed"]
    assert keeping.has_master
    assert keeping.read()["masters"] == 2


@pytest.mark.slow
def test_a_contract_without_years_sets_no_end(keeping: Keeping) -> None:
    clauses = keeping.draft["version"]["clauses"]
    clauses = [clause | {"stands": clause["stands"] and clause["key"] != "retention"} for clause in clauses]
    keeping.draft = keeping.save(keeping.draft, clauses=clauses)
    keeping.sign_and_deliver()
    assert (keeping.read()["years"], keeping.read()["ends_on"]) == (None, None)
    keeping.after(4_000)
    assert keeping.has_master


@pytest.mark.slow
def test_the_end_of_masters_is_told_to_producers_who_see_the_project(keeping: Keeping) -> None:
    world = keeping.world
    add_producer(world)
    keeping.sign_and_deliver()
    limit(world)
    end = years_after(clock.now().date(), YEARS)
    keeping.after(-30)
    parties = {f"{person_id}@example.test" for person_id in (world.producer_id, world.designer_id)}
    assert keeping.mailed(f"masters will be deleted on {end.day} ") == parties
