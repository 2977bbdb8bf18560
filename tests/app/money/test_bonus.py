"""Bonuses that are calculated: earned, still possible or missed, and one line when they are due."""

import json
from datetime import date, timedelta
from typing import Any

import pytest

from app.agreements.clauses.rules import default_clauses, render
from app.agreements.clauses.terms import BonusWhen, MoneyTerms
from app.agreements.queries import events_of
from app.agreements.rules import ContractKind
from app.core import clock
from app.money.bonuses.rules import BonusCue, BonusState, bonus_status_of
from tests.app.money.agreed import TODAY, Agreed, day, milestone
from tests.app.reviews.making import refused
from tests.support.server import World

BONUS_MINOR = 30_000
DUE = date(2026, 11, 20)
DAY = timedelta(days=1)


def agreed_with(world: World, when: str, **more: Any) -> Agreed:
    return Agreed(world, terms={"bonus_minor": BONUS_MINOR, "bonus_when": when, "bonus_trigger": "it sells", **more})


def bonus(agreed: Agreed, by: Any = None) -> tuple[str, str]:
    """Return what happened to the bonus, and why, as the producer or another person reads it."""
    found = agreed.ledger(by)["bonus"]
    return found["state"], found["because"]


def bonus_lines(agreed: Agreed) -> list[tuple[str, int]]:
    lines = agreed.ledger()["lines"]
    return [(line["kind"], line["amount_minor"]) for line in lines if line["clause"] == "bonus"]


def a_cue(accepted_on: date | None = None, *, due_on: date | None = DUE, has_round: bool = False) -> BonusCue:
    return BonusCue("SW-001 shot", due_on, accepted_on, has_round)


@pytest.mark.parametrize(
    ("cues", "today", "state", "because"),
    [
        ([a_cue(DUE)], DUE, "earned", "every cue was accepted by the date of its milestone"),
        ([a_cue(DUE), a_cue()], DUE, "possible", "1 of 2 cues is accepted"),
        ([a_cue(DUE), a_cue()], DUE + DAY, "missed", "SW-001 shot was not accepted by 20 November 2026"),
        (
            [a_cue(DUE + DAY)],
            DUE + DAY,
            "missed",
            "SW-001 shot was accepted on 21 November 2026; the date was 20 November 2026",
        ),
        ([a_cue(DUE + DAY, due_on=None)], DUE + DAY, "earned", "every cue was accepted by the date of its milestone"),
        ([], DUE, "missed", "no cue of the contract is left"),
    ],
)
def test_on_time_is_to_the_day(cues: list[BonusCue], today: date, state: str, because: str) -> None:
    standing = bonus_status_of(BonusWhen.ON_TIME, cues, today=today, is_running=True, shipped_on=None)
    assert (standing.state, standing.because) == (BonusState(state), because)


def test_a_contract_that_ended_early_earns_nothing_more() -> None:
    for when in (BonusWhen.ON_TIME, BonusWhen.NO_REJECTED_TAKE, BonusWhen.SHIPPED):
        standing = bonus_status_of(when, [a_cue()], today=DUE, is_running=False, shipped_on=None)
        assert (standing.state, standing.because) == (BonusState.MISSED, "the contract ended early")


@pytest.mark.slow
def test_the_last_acceptance_in_time_makes_one_line_due(world: World) -> None:
    agreed = agreed_with(world, "on_time")
    first, second = agreed.cue("one"), agreed.cue("two")
    agreed.agree(milestone("Alpha", first, amount_minor=10_000), milestone("Beta", second, amount_minor=20_000))
    assert bonus(agreed) == bonus(agreed, world.designer) == ("possible", "0 of 2 cues are accepted")
    agreed.approve(agreed.take(first))
    assert (bonus(agreed), bonus_lines(agreed)) == (("possible", "1 of 2 cues is accepted"), [])
    agreed.approve(last := agreed.take(second))
    assert bonus(agreed) == ("earned", "every cue was accepted by the date of its milestone")
    assert bonus_lines(agreed) == [("bonus", BONUS_MINOR)]
    figures = agreed.figures()
    assert (figures["agreed_minor"], figures["due_minor"], figures["open_minor"]) == (60_000, 60_000, 0)
    events = world.server.in_database(lambda session: [*events_of(session, agreed.contract_id)])
    (due,) = [said for event in events if (said := json.loads(event.payload)).get("because") == "bonus"]
    assert due["reason"] == "every cue was accepted by the date of its milestone"

    assert agreed.undo(last).status_code == 200, "what is not earned any more is taken back"
    assert bonus_lines(agreed) == [("bonus", BONUS_MINOR), ("reversed", -BONUS_MINOR)]
    agreed.approve(last)
    assert bonus_lines(agreed)[2:] == [("bonus", BONUS_MINOR)]
    (line,) = [line for line in agreed.invoice()["lines"] if line["text"] == "Bonus"]
    assert line["amount_minor"] == BONUS_MINOR


@pytest.mark.slow
def test_a_date_that_passes_is_a_bonus_missed(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    agreed = agreed_with(world, "on_time")
    cue = agreed.cue("late")
    agreed.agree(milestone("Alpha", cue, amount_minor=10_000, due_on=day(1)))
    take = agreed.take(cue)
    later = clock.now() + timedelta(days=3)
    monkeypatch.setattr(clock, "now", lambda: later)
    state, because = bonus(agreed)
    assert state == "missed"
    assert "late was not accepted by" in because
    agreed.approve(take)
    assert bonus(agreed)[0] == "missed"
    assert bonus_lines(agreed) == []


@pytest.mark.slow
def test_a_round_of_changes_misses_it_and_a_cut_cue_does_not_count(world: World) -> None:
    agreed = agreed_with(world, "no_rejected_take")
    first, second = agreed.cue("one"), agreed.cue("two")
    agreed.agree(milestone("Alpha", first, second, amount_minor=20_000))
    agreed.draft(agreed.take(first))
    assert bonus(agreed)[0] == "possible", "a draft is not a round"
    agreed.send()
    state, because = bonus(agreed)
    assert (state, because.startswith("a round of changes was counted for"), "one" in because) == ("missed", True, True)
    agreed.approve(agreed.take(second))
    assert bonus_lines(agreed) == []
    assert world.producer.post(f"/v1/cues/{first}/cut", json={"reason": "Gone."}).status_code == 200
    assert bonus(agreed) == ("earned", "every cue was accepted without a round of changes")
    assert bonus_lines(agreed) == [("bonus", BONUS_MINOR)]


def shipped(agreed: Agreed, by: Any, on: Any = TODAY) -> Any:
    return by.post(f"/v1/contracts/{agreed.contract_id}/shipped", json={"shipped_on": str(on)})


@pytest.mark.slow
def test_the_studio_says_once_that_the_game_shipped(world: World) -> None:
    agreed = agreed_with(world, "shipped")
    agreed.agree(milestone("Alpha", agreed.cue(), amount_minor=10_000))
    assert bonus(agreed, world.designer) == ("possible", "the studio has not said yet that the game has shipped")
    assert refused(shipped(agreed, world.designer)) == (403, "producer-needed")
    assert refused(shipped(agreed, world.stranger)) == (404, "contract-not-found")
    assert refused(shipped(agreed, world.reviewer)) == (404, "contract-not-found")
    assert refused(shipped(agreed, world.producer, TODAY + timedelta(days=9))) == (422, "day-in-future")
    answer = shipped(agreed, world.producer)
    assert (answer.status_code, answer.json()["bonus"]["state"]) == (200, "earned")
    assert refused(shipped(agreed, world.producer)) == (409, "no-shipping-bonus")
    assert bonus_lines(agreed) == [("bonus", BONUS_MINOR)]
    events = world.server.in_database(lambda session: [*events_of(session, agreed.contract_id)])
    (said,) = [json.loads(event.payload) for event in events if event.kind == "shipped"]
    assert (said["by"], said["shipped_on"]) == ("Producer", TODAY.isoformat())


@pytest.mark.parametrize("when", ["on_time", "no_rejected_take", "other"])
def test_only_a_bonus_for_shipping_waits_for_it(world: World, when: str) -> None:
    agreed = agreed_with(world, when)
    agreed.agree(milestone("Alpha", agreed.cue(), amount_minor=10_000))
    assert refused(shipped(agreed, world.producer)) == (409, "no-shipping-bonus")


@pytest.mark.parametrize("terms", [{"bonus_when": "other"}, {}], ids=["said", "a text of before has no choice"])
def test_a_trigger_in_the_parties_own_words_stays_theirs(world: World, terms: dict[str, str]) -> None:
    agreed = Agreed(world, terms={"bonus_minor": BONUS_MINOR, "bonus_trigger": "it sells", **terms})
    agreed.agree(milestone("Alpha", cue := agreed.cue(), amount_minor=10_000))
    agreed.approve(agreed.take(cue))
    found = agreed.ledger()["bonus"]
    assert (found["when"], found["state"], found["because"]) == ("other", None, "it sells")
    assert bonus_lines(agreed) == []


def test_no_bonus_is_said_where_none_was_agreed(world: World) -> None:
    agreed = Agreed(world)
    agreed.agree(milestone("Alpha", agreed.cue(), amount_minor=10_000))
    assert agreed.ledger()["bonus"] is None


@pytest.mark.parametrize("when", BonusWhen)
def test_the_text_says_what_sets_it_off(when: BonusWhen) -> None:
    clauses, terms = default_clauses(ContractKind.SINGLE)
    assert MoneyTerms.of(terms).bonus_when is BonusWhen.OTHER
    clauses = [clause for clause in clauses if clause.key == "bonus"]
    standing = [type(clause)(clause.key, clause.title, clause.text, stands=True) for clause in clauses]
    text = render("Effects", standing, {**terms, "bonus_minor": 100, "bonus_when": when.value}, {}, "EUR")
    assert "{" not in text
    assert ("100,000 copies" in text) is (when is BonusWhen.OTHER)
