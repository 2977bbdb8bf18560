"""What a silent studio means: reminders, and acceptance when the days of the contract are over."""

import json
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from types import SimpleNamespace
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.clauses.deemed_acceptance import DeemedAcceptance
from app.agreements.clauses.rules import default_clauses, terms_in_force
from app.agreements.deemed_acceptance import jobs
from app.agreements.models import Contract, ContractEvent
from app.agreements.queries import events_of
from app.agreements.record.service import WRITTEN
from app.agreements.rules import ContractKind
from app.deliveries.models import Take
from app.sound_lists.models import Question
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of, refused
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
        """Return who was reminded or notified of silence, under which subject, and with which text."""
        world = self.agreed.world
        world.server.wait_for_jobs()
        mails = body_of(world.producer.get(f"/v1/studios/{world.studio_id}/outbox"))["mails"]
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
        events: Sequence[ContractEvent] = self.agreed.world.server.in_database(
            lambda session: events_of(session, contract_id)
        )
        return [event for event in events if event.kind != WRITTEN]


@pytest.fixture
def moved(world: World, monkeypatch: pytest.MonkeyPatch) -> MovedClock:
    return MovedClock(Agreed(world, terms=CLAUSE), monkeypatch)


def days(count: int) -> timedelta:
    return timedelta(days=count)


@pytest.mark.slow
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


@pytest.mark.slow
def test_todays_deputy_of_the_categorys_approver_is_reminded_too(moved: MovedClock) -> None:
    world = moved.agreed.world
    project = f"/v1/projects/{world.project_id}"
    assert world.producer.put(f"{project}/liaisons/{world.reviewer_id}").status_code == 200
    named = {"category": "ui", "person_id": str(world.reviewer_id)}
    assert world.producer.put(f"{project}/category-approvers", json=named).status_code == 200
    today = datetime.now(UTC).date()
    deputy = {"person_id": str(world.reviewer_id), "deputy_id": str(world.producer_id)}
    span = {"from_on": str(today - days(2)), "until_on": str(today + days(2))}
    assert world.producer.post(f"{project}/deputies", json=deputy | span).status_code == 201
    cue = moved.agreed.cue(category="ui")
    moved.agree(cue, moved.agreed.take(cue))
    moved.apply_deemed(FRIDAY + days(5))
    reminded = {recipient for recipient, subject, _ in moved.mails() if "review soon" in subject}
    assert reminded == {str(world.reviewer_id), str(world.producer_id)}
    assert moved.entries() == ["planned", "reminded", "reminded"]


@pytest.mark.slow
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
    lately = body_of(world.producer.get(f"/v1/projects/{world.project_id}/overview"))["lately"]
    assert {one["who"] for one in lately if one["kind"] == "approved"} == {"The clause on silence"}

    assert moved.entries()[-3:] == ["judged", "accepted", "due"]
    assert moved.authors()[-3:] == [("Soundlist", "server")] * 3, "nobody said anything"
    review = agreed.review(cue)
    (verdict,) = review["verdicts"]
    assert (review["accepted"], verdict["kind"], verdict["by_deemed_acceptance"]) == (True, "approve", True)
    assert verdict["given_by"] is None, "it bears no person's name"
    assert line["by"] == "Soundlist"
    assert verdict["note"] == "Auto-accepted: no response within 10 working days, until 2026-12-04 (Effects)"
    history = world.designer.get(f"/v1/takes/{take}/history").json()
    assert [(one["kind"], one["by"], one["by_deemed_acceptance"]) for one in history][-1] == ("approve", None, True)
    notified_of = {recipient for recipient, subject, _ in moved.mails() if "sounds auto-accepted" in subject}
    assert notified_of == {str(world.designer_id), str(world.approver_id), str(world.producer_id)}


@pytest.mark.slow
def test_a_verdict_in_time_leaves_nothing_to_silence(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    moved.agreed.draft(take)
    moved.agreed.send()
    moved.apply_deemed(FRIDAY + days(60))
    assert moved.agreed.states(take) == ["change_requested"]
    assert moved.mails() == []


@pytest.mark.slow
def test_the_approver_may_still_reverse_it_and_the_money_goes_back(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    moved.apply_deemed(FRIDAY + days(60))
    moved.agreed.draft(take, seen_state="approved")
    sent = moved.agreed.send()
    assert sent["rounds"][0]["number"] is None, "a reversal is not a round"
    assert moved.agreed.owed() == [("accepted", 18_000), ("reversed", -18_000)]


@pytest.mark.slow
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


@pytest.mark.slow
def test_of_two_files_between_which_nobody_chose_none_is_accepted_until_somebody_does(moved: MovedClock) -> None:
    agreed, world = moved.agreed, moved.agreed.world
    cue = agreed.cue()
    first = agreed.take(cue, file_name="steps_02.wav")
    second = agreed.take(cue, file_name="Steps 02 FINAL (2).wav")
    moved.agree(cue, first, second)
    for _ in range(2):
        moved.apply_deemed(FRIDAY + days(30))
    assert agreed.owed() == []
    assert agreed.states(first, second) == ["conforming", "conforming"]
    ((_, subject, text),) = moved.mails()
    assert subject == "Shield Wing: sounds to review soon"
    assert "steps_02.wav and Steps 02 FINAL (2).wav" in text
    assert "not accepted automatically" in text
    assert moved.entries() == ["planned", "reminded"]
    assert [item["silence_paused_by"] for item in agreed.queue()] == ["undecided_versions"]

    discarded = world.designer.post(f"/v1/projects/{world.project_id}/takes/discard", json={"take_ids": [str(first)]})
    assert discarded.status_code in (200, 201), discarded.text
    moved.apply_deemed(FRIDAY + days(30))
    assert agreed.states(second) == ["approved"]


@pytest.mark.slow
def test_another_version_restarts_the_studios_days(moved: MovedClock) -> None:
    cue = moved.agreed.cue()
    first = moved.agreed.take(cue)
    moved.agree(cue, first)
    second = moved.agreed.take(cue, state_since=FRIDAY + days(14))
    moved.apply_deemed(FRIDAY + days(15))
    assert moved.agreed.states(first, second) == ["conforming", "conforming"]
    moved.apply_deemed(FRIDAY + days(29))
    assert moved.agreed.states(first, second) == ["set_aside", "approved"]


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
def test_screens_say_until_when_a_cue_waits(moved: MovedClock) -> None:
    cue, other = moved.agreed.cue(), moved.agreed.cue("radar_ping")
    moved.agree(cue, moved.agreed.take(cue))
    moved.agreed.take(other)
    shown = {item["cue"]["name"]: item["accepted_after"] for item in moved.agreed.queue()}
    assert shown == {"shield_hit": "2026-12-04", "radar_ping": None}
    assert moved.agreed.review(cue)["accepted_after"] == "2026-12-04"


def test_it_is_one_of_the_chores() -> None:
    from app import commercial

    assert "agreements.apply_deemed_acceptance" in commercial.CHORES


BY_CALENDAR = {**CLAUSE, "silence_calendar": "studio"}


@pytest.fixture
def by_calendar(world: World, monkeypatch: pytest.MonkeyPatch) -> MovedClock:
    return MovedClock(Agreed(world, terms=BY_CALENDAR), monkeypatch)


@pytest.mark.slow
def test_a_question_of_the_designer_pauses_it_until_it_is_answered(by_calendar: MovedClock) -> None:
    agreed, world = by_calendar.agreed, by_calendar.agreed.world
    cue = agreed.cue()
    take = agreed.take(cue)
    by_calendar.agree(cue, take)
    asked = world.designer.post(f"/v1/cues/{cue}/questions", json={"text": "Wood or steel?"}).json()
    assert agreed.review(cue)["silence_paused_by"] == "question"
    (item,) = agreed.queue()
    assert item["silence_paused_by"] == "question"
    by_calendar.apply_deemed(FRIDAY + days(400))
    assert agreed.states(take) == ["conforming"]
    answered = world.approver.post(f"/v1/questions/{asked['id']}/answer", json={"text": "Steel.", "joins": False})
    assert answered.is_success, answered.text
    assert agreed.review(cue)["silence_paused_by"] is None

    def open_from_tuesday_to_thursday(session: Session) -> None:
        question = session.get_one(Question, UUID(asked["id"]))
        question.asked_at, question.answered_at = FRIDAY + days(4), FRIDAY + days(6)

    world.server.in_database(open_from_tuesday_to_thursday)
    by_calendar.apply_deemed(datetime(2026, 12, 9, 23, 59, tzinfo=UTC))
    assert agreed.states(take) == ["conforming"]
    by_calendar.apply_deemed(datetime(2026, 12, 10, tzinfo=UTC))
    assert agreed.states(take) == ["approved"]


@pytest.mark.slow
def test_a_question_of_the_team_or_another_designer_pauses_nothing(by_calendar: MovedClock) -> None:
    agreed, world = by_calendar.agreed, by_calendar.agreed.world
    cue = agreed.cue()
    by_calendar.agree(cue, agreed.take(cue))
    of = {"studio_id": world.studio_id, "project_id": world.project_id, "cue_id": cue}
    world.server.in_database(
        lambda session: session.add(Question(**of, text="How loud?", asked_by=world.other_designer_id))
    )
    assert agreed.review(cue)["silence_paused_by"] is None


@pytest.mark.slow
def test_a_text_that_names_no_calendar_is_paused_by_nothing(moved: MovedClock) -> None:
    agreed, world = moved.agreed, moved.agreed.world
    cue = agreed.cue()
    take = agreed.take(cue)
    moved.agree(cue, take)
    assert world.designer.post(f"/v1/cues/{cue}/questions", json={"text": "Wood or steel?"}).is_success
    moved.apply_deemed(datetime(2026, 12, 5, tzinfo=UTC))
    assert agreed.states(take) == ["approved"]


@pytest.mark.slow
def test_an_open_change_order_pauses_every_cue_of_its_contract(by_calendar: MovedClock) -> None:
    agreed, world = by_calendar.agreed, by_calendar.agreed.world
    cue = agreed.cue()
    by_calendar.agree(cue, agreed.take(cue))
    path = f"/v1/contracts/{agreed.contract_id}/change-orders"
    changes = [{"kind": "reprice_cue", "cue_id": str(cue), "price_minor": 20_000}]
    proposed = world.producer.post(path, json={"changes": changes, "reason": "It grew."})
    assert proposed.is_success, proposed.text
    assert agreed.review(cue)["silence_paused_by"] == "change_order"
    answer = world.designer.post(f"{path}/1/refuse", json={"reason": "No."})
    assert answer.is_success, answer.text
    assert agreed.review(cue)["silence_paused_by"] is None


@pytest.mark.slow
def test_without_the_sources_that_the_contract_wants_it_does_not_wait(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    terms = {**BY_CALENDAR, "sources_needed": "before_acceptance"}
    moved = MovedClock(Agreed(world, terms=terms), monkeypatch)
    cue = moved.agreed.cue()
    take = moved.agreed.take(cue)
    moved.agree(cue, take)
    assert moved.agreed.review(cue)["accepted_after"] is None
    moved.apply_deemed(FRIDAY + days(60))
    assert moved.agreed.states(take) == ["conforming"]
    body_of(world.designer.put(f"/v1/takes/{take}/sources", json={"from_scratch": True}))
    assert moved.agreed.review(cue)["accepted_after"] is not None


def test_the_library_leaves_it_out_until_it_is_wanted() -> None:
    clauses, terms = default_clauses(ContractKind.SINGLE)
    assert [clause.stands for clause in clauses if clause.key == "silence"] == [False]
    assert DeemedAcceptance.of(terms_in_force(clauses, terms)) is None


@pytest.mark.slow
def test_a_producer_keeps_the_calendar_and_both_sides_see_it(world: World) -> None:
    path = f"/v1/studios/{world.studio_id}/calendar"
    assert body_of(world.reviewer.get(path)) == {"time_zone": "UTC", "holidays": []}
    christmas = {"day": "2026-12-25", "name": "Christmas Day"}
    saved = body_of(world.producer.put(path, json={"time_zone": "Europe/Berlin", "holidays": [christmas]}))
    boxing = {"day": "2026-12-26", "name": "Boxing Day"}
    again = body_of(
        world.producer.put(
            path, json={"time_zone": "Europe/Berlin", "holidays": [boxing, {**christmas, "name": "Christmas"}]}
        )
    )
    assert [one["name"] for one in again["holidays"]] == ["Christmas", "Boxing Day"]
    assert again["holidays"][0]["created_at"] == saved["holidays"][0]["created_at"], "it was there before"
    assert body_of(world.designer.get(f"/v1/projects/{world.project_id}/studio-calendar")) == again
    assert world.designer.get(path).status_code == 404
    assert refused(world.reviewer.put(path, json={"time_zone": "UTC"})) == (403, "producer-needed")
    assert refused(world.producer.put(path, json={"time_zone": "Mars/Olympus"})) == (422, "time-zone-unknown")
    twice = {"time_zone": "UTC", "holidays": [christmas, christmas]}
    assert refused(world.producer.put(path, json=twice)) == (422, "day-named-twice")
