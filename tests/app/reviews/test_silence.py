"""What a silent studio means: reminders, and acceptance when the days of the contract are over."""

import json
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from types import SimpleNamespace
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.deemed_acceptance import DeemedAcceptance
from app.agreements.models import Contract, ContractEvent
from app.agreements.queries import events_of
from app.deliveries.models import Take
from app.reviews import jobs
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import told
from tests.support.server import World

CLAUSE = {"silence_days": 10, "silence_reminder_days": 3}
FRIDAY = datetime(2026, 11, 20, 14, tzinfo=UTC)


class MovedClock:
    """Lets the job see another time than the server."""

    def __init__(self, agreed: Agreed, monkeypatch: pytest.MonkeyPatch) -> None:
        self.agreed, self._patch = agreed, monkeypatch

    def agree(self, cue_id: UUID, *takes: UUID, at: datetime = FRIDAY) -> None:
        """Agree on a cue for 180.00, as if at that time, when its takes began to wait."""
        self.agreed.agree(milestone("Alpha", cue_id, amount_minor=18_000))

        def set_times(session: Session) -> None:
            session.get_one(Contract, self.agreed.contract_id).agreed_at = at
            for take_id in takes:
                session.get_one(Take, take_id).state_since = at

        self.agreed.world.server.in_database(set_times)

    def apply_deemed(self, at: datetime) -> None:
        """Do what is done every five minutes, at that time."""
        self._patch.setattr(jobs, "clock", SimpleNamespace(now=lambda: at))
        jobs.apply_deemed_acceptance(self.agreed.world.server.runtime, {})

    def mails(self) -> list[tuple[str, str, str]]:
        """Return who was reminded or told of silence, under which subject, and what was said."""
        world = self.agreed.world
        world.server.wait_for_jobs()
        mails = told(world.producer.get(f"/v1/studios/{world.studio_id}/outbox"))["mails"]
        return [
            (mail["recipient"].split("@")[0], mail["subject"], mail["text"])
            for mail in mails
            if "review soon" in mail["subject"] or "auto-accepted" in mail["subject"]
        ]

    def entries(self) -> list[str]:
        """Return what the contract's record says, by kind."""
        return [event.kind for event in self._events()]

    def authors(self) -> list[tuple[str, str]]:
        """Return who did what the contract's record says, and as what."""
        said = [json.loads(event.payload) for event in self._events()]
        return [(one["by"], one["role"]) for one in said]

    def _events(self) -> Sequence[ContractEvent]:
        contract_id = self.agreed.contract_id
        found: Sequence[ContractEvent] = self.agreed.world.server.in_database(
            lambda session: events_of(session, contract_id)
        )
        return found


@pytest.fixture
def moved(world: World, monkeypatch: pytest.MonkeyPatch) -> MovedClock:
    return MovedClock(Agreed(world, terms=CLAUSE), monkeypatch)


def days(count: int) -> timedelta:
    return timedelta(days=count)


@pytest.mark.parametrize(
    ("since", "last_day"),
    [
        (FRIDAY, "2026-12-04"),  # Monday to Friday, twice
        (FRIDAY + days(1), "2026-12-04"),  # what comes on a weekend waits from Monday
        (FRIDAY + days(2), "2026-12-04"),
        (FRIDAY + days(3), "2026-12-07"),  # Tuesday is the first day
        (datetime.fromisoformat("2026-11-20T23:30:00-02:00"), "2026-12-04"),  # Saturday by UTC
    ],
)
def test_ten_working_days_are_two_weeks(since: datetime, last_day: str) -> None:
    silence = DeemedAcceptance(days=10, reminder_days=3)
    assert silence.last_day(since).isoformat() == last_day
    midnight = datetime.fromisoformat(f"{last_day}T00:00:00+00:00") + days(1)
    assert not silence.is_over(since, midnight - timedelta(microseconds=1))
    assert silence.is_over(since, midnight)


def test_reminders_come_on_every_third_working_day_before_the_last() -> None:
    silence = DeemedAcceptance(days=10, reminder_days=3)
    counted = [silence.reminders(FRIDAY, FRIDAY + days(day)) for day in range(16)]
    #                  fr sa su mo tu we th fr sa su mo tu we th fr sa
    assert counted == [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3]
    assert DeemedAcceptance(days=6, reminder_days=3).reminders(FRIDAY, FRIDAY + days(60)) == 1


def test_the_approver_is_reminded_once_each_time(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    moved.agree(cue, moved.agreed.take(cue))
    moved.apply_deemed(FRIDAY + days(4))
    assert moved.mails() == []
    moved.apply_deemed(FRIDAY + days(5))
    moved.apply_deemed(FRIDAY + days(6))
    ((recipient, subject, text),) = moved.mails()
    assert (recipient, subject) == (str(moved.agreed.world.approver_id), "Shield Wing: sounds to review soon")
    assert text.count("accepted automatically after Friday 4 December 2026") == 1
    moved.apply_deemed(FRIDAY + days(10))
    ((_, _, text),) = moved.mails()
    assert text.count("accepted automatically after") == 2, "news of one kind is one mail until it goes out"
    assert moved.entries() == ["planned", "reminded", "reminded"]
    assert moved.agreed.owed() == []


def test_when_the_days_are_over_the_cue_is_accepted_as_by_an_approval(moved: MovedClock) -> None:
    agreed, world = moved.agreed, moved.agreed.world
    cue = agreed.cue()
    take = agreed.take(cue)
    moved.agree(cue, take)
    moved.apply_deemed(datetime(2026, 12, 4, 23, 59, tzinfo=UTC))
    assert agreed.owed() == []
    for _ in range(2):  # again is once
        moved.apply_deemed(datetime(2026, 12, 5, tzinfo=UTC))
    assert agreed.states(take) == ["approved"]
    (line,) = agreed.ledger()["lines"]
    assert (line["kind"], line["amount_minor"], line["clause"]) == ("accepted", 18_000, "silence")

    assert moved.entries()[-3:] == ["judged", "accepted", "due"]
    assert moved.authors()[-3:] == [("Soundlist", "server")] * 3, "nobody said anything"
    review = agreed.review(cue)
    (verdict,) = review["verdicts"]
    assert (review["accepted"], verdict["kind"], verdict["by_deemed_acceptance"]) == (True, "approve", True)
    assert verdict["note"] == "Auto-accepted: no response within 10 working days, until 2026-12-04 (Effects)"
    history = world.designer.get(f"/v1/takes/{take}/history").json()
    assert [(one["kind"], one["by_deemed_acceptance"]) for one in history][-1] == ("approve", True)
    told_of = {recipient for recipient, subject, _ in moved.mails() if "sounds auto-accepted" in subject}
    assert told_of == {str(world.designer_id), str(world.approver_id), str(world.producer_id)}


def test_a_verdict_in_time_leaves_nothing_to_silence(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    moved.agreed.draft(take)
    moved.agreed.send()
    moved.apply_deemed(FRIDAY + days(60))
    assert moved.agreed.states(take) == ["change_requested"]
    assert moved.mails() == []


def test_the_approver_may_still_reverse_it_and_the_money_goes_back(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    moved.apply_deemed(FRIDAY + days(60))
    moved.agreed.draft(take, seen_state="approved")
    sent = moved.agreed.send()
    assert sent["rounds"][0]["number"] is None, "a reversal is no round"
    assert moved.agreed.owed() == [("accepted", 18_000), ("reversed", -18_000)]


def test_a_set_is_accepted_whole_and_waits_since_its_last_variation(moved: MovedClock) -> None:
    agreed = moved.agreed
    steps = agreed.cue("steps", variations=2)
    first = agreed.take(steps)
    moved.agree(steps, first)
    moved.apply_deemed(FRIDAY + days(60))
    assert agreed.states(first) == ["conforming"], "half a set is not accepted"
    second = agreed.take(steps, 2, state_since=FRIDAY + days(7))
    moved.apply_deemed(FRIDAY + days(15))
    assert agreed.states(first, second) == ["conforming", "conforming"]
    moved.apply_deemed(FRIDAY + days(22))
    assert agreed.states(first, second) == ["approved", "approved"]
    assert agreed.owed() == [("accepted", 18_000)]


def test_another_version_gives_the_studio_its_days_anew(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    first = moved.agreed.take(cue)
    moved.agree(cue, first)
    second = moved.agreed.take(cue, state_since=FRIDAY + days(14))
    moved.apply_deemed(FRIDAY + days(15))
    assert moved.agreed.states(first, second) == ["conforming", "conforming"]
    moved.apply_deemed(FRIDAY + days(29))
    assert moved.agreed.states(first, second) == ["set_aside", "approved"]


def test_what_was_delivered_before_waits_from_the_agreement_on(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue, state_since=FRIDAY - days(300))
    moved.agree(cue)
    moved.apply_deemed(FRIDAY + days(14))
    assert moved.agreed.states(take) == ["conforming"]
    moved.apply_deemed(FRIDAY + days(15))
    assert moved.agreed.states(take) == ["approved"]


@pytest.mark.parametrize(
    "facts", [{"is_rendered": False}, {"is_drawn": False}, {"state": "returned"}], ids=lambda facts: next(iter(facts))
)
def test_only_what_stands_in_the_queue_counts(moved: MovedClock, facts: dict[str, Any]) -> None:
    cue = moved.agreed.cue()
    moved.agree(cue, take := moved.agreed.take(cue, **facts))
    before = moved.agreed.states(take)
    moved.apply_deemed(FRIDAY + days(60))
    assert moved.agreed.states(take) == before


@pytest.mark.parametrize("terms", [{}, {"silence_days": 10}], ids=["struck", "kept by the parties"])
def test_without_the_clause_nothing_happens(
    world: World, monkeypatch: pytest.MonkeyPatch, terms: dict[str, int]
) -> None:
    moved = MovedClock(Agreed(world, terms=terms), monkeypatch)
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    moved.apply_deemed(FRIDAY + days(400))
    assert moved.agreed.states(take) == ["conforming"]
    assert moved.mails() == []


def test_of_another_designer_nothing_is_accepted(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue, designer_id=moved.agreed.world.other_designer_id)
    moved.agree(cue, take)
    moved.apply_deemed(FRIDAY + days(60))
    assert moved.agreed.states(take) == ["conforming"]


def test_screens_say_until_when_a_cue_waits(moved: MovedClock) -> None:
    cue, other = moved.agreed.cue(), moved.agreed.cue("radar_ping")
    moved.agree(cue, moved.agreed.take(cue))
    moved.agreed.take(other)
    shown = {item["cue"]["name"]: item["accepted_after"] for item in moved.agreed.queue()}
    assert shown == {"shield_hit": "2026-12-04", "radar_ping": None}
    assert moved.agreed.review(cue)["accepted_after"] == "2026-12-04"


def test_it_is_one_of_the_chores() -> None:
    from app import worker

    assert "reviews.apply_deemed_acceptance" in worker.CHORES
