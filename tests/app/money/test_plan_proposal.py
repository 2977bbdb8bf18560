"""Milestones proposed from dates and categories of the sound list, which draw no warning of the plan's own check."""

import itertools
from datetime import date, timedelta
from typing import Any
from uuid import UUID, uuid4

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.plan.proposal import WantedCue, propose_milestones
from app.agreements.plan.validation import PlannedPayment, check_plan
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

TODAY = date(2026, 11, 2)
FIRST, SECOND = date(2026, 12, 4), date(2027, 1, 15)


def wanted(category: str = "", due_on: date | None = None, weight: int = 1) -> WantedCue:
    return WantedCue(uuid4(), category, due_on, weight)


def named(cues: list[WantedCue], **more: Any) -> list[tuple[str, date | None, int]]:
    return [
        (propose_milestone.name, propose_milestone.due_on, len(propose_milestone.cue_ids))
        for propose_milestone in propose_milestones(cues, today=TODAY, **more)
    ]


def test_parts_are_named_by_categories_and_come_in_order() -> None:
    cues = [
        wanted("weapon"),
        wanted("ui", SECOND),
        wanted("ui", FIRST),
        wanted("ui", FIRST),
        wanted("weapon"),
        wanted(),
    ]
    first, *_, last = named(cues)
    assert first[0] == "UI, part 1"
    assert last[1] == SECOND, "what has no day is needed by the last one"
    assert sum(count for _, _, count in named(cues)) == len(cues)


def test_days_within_two_weeks_are_one_part() -> None:
    near = [wanted("ui", FIRST), wanted("weapon", FIRST + timedelta(days=3))]
    days = [day for _, day, _ in named(near)]
    assert days == [FIRST + timedelta(days=3 - 14), FIRST + timedelta(days=3)], "it is parted where that leaves weeks"


def test_no_part_is_due_before_the_work_begins_and_no_name_has_a_day() -> None:
    begins_on, ends_on = date(2027, 1, 4), date(2027, 2, 26)
    cues = [wanted(category) for category in ("weapon", "voice", "doors", "ui", "steps", "music")]
    parts = propose_milestones(cues, today=TODAY, begins_on=begins_on, ends_on=ends_on)
    assert [part.due_on for part in parts] == [date(2027, 1, 29), date(2027, 2, 12), ends_on]
    assert [part.name for part in parts] == ["Weapon and Voice", "Doors and UI", "Steps and Music"]
    days = [part.due_on for part in propose_milestones(cues, today=TODAY, begins_on=date(2026, 1, 4), ends_on=ends_on)]
    assert min(day for day in days if day) > TODAY, "a first day that is past counts as today"


def test_a_price_includes_its_deposit_and_the_last_part_is_the_largest() -> None:
    cues = [wanted("ui", weight=7), wanted("ui"), wanted("weapon"), wanted("weapon")]
    deposit, *parts = propose_milestones(cues, today=TODAY, total_minor=639_000)
    assert (deposit.is_deposit, deposit.amount_minor, deposit.cue_ids) == (True, 127_800, [])
    amounts = [part.amount_minor or 0 for part in parts]
    assert 127_800 + sum(amounts) == 639_000
    assert amounts == sorted(amounts)
    assert amounts == [159_750, 159_750, 191_700], "25, 25 and 30 % of the price"


def test_without_a_price_nothing_has_an_amount() -> None:
    assert [
        propose_milestone.amount_minor for propose_milestone in propose_milestones([wanted("ui")], today=TODAY)
    ] == [None]


def test_no_cues_are_no_milestones() -> None:
    assert propose_milestones([], today=TODAY, total_minor=100) == []


DAYS = st.none() | st.dates(TODAY - timedelta(days=20), TODAY + timedelta(days=400))
CUES = st.lists(st.tuples(DAYS, st.integers(0, 500)), min_size=1, max_size=40)


@pytest.mark.slow
@given(
    cues=CUES,
    total_minor=st.integers(100, 10**9),
    ends_on=DAYS,
    deposit_bp=st.sampled_from([2_000, 2_500, 3_333, 4_000]),
)
def test_what_is_proposed_draws_no_warning(
    cues: list[tuple[date | None, int]], total_minor: int, ends_on: date | None, deposit_bp: int
) -> None:
    asked = [wanted("ui", due_on, weight) for due_on, weight in cues]
    proposed = propose_milestones(asked, today=TODAY, ends_on=ends_on, total_minor=total_minor, deposit_bp=deposit_bp)
    payments = [
        PlannedPayment(one.name, one.amount_minor or 0, one.due_on, len(one.cue_ids), is_deposit=one.is_deposit)
        for one in proposed
    ]
    assert check_plan(payments, "EUR") == []
    assert sum(payment.amount_minor for payment in payments) == total_minor
    parts = [one for one in proposed if not one.is_deposit]
    assert sorted(cue for part in parts for cue in part.cue_ids) == sorted(cue.cue_id for cue in asked)
    assert parts[-1].amount_minor == max(part.amount_minor or 0 for part in parts)
    if len(parts) > 2 and total_minor > 10_000:
        assert all((part.amount_minor or 0) <= 0.3 * total_minor + len(parts) for part in parts)


@pytest.mark.slow
@given(cues=st.integers(3, 60), weeks=st.integers(6, 60), total_minor=st.integers(1_000, 10**8))
def test_three_parts_and_more_are_two_weeks_apart(cues: int, weeks: int, total_minor: int) -> None:
    ends_on = TODAY + timedelta(weeks=weeks)
    _, *parts = propose_milestones(
        [wanted() for _ in range(cues)], today=TODAY, ends_on=ends_on, total_minor=total_minor
    )
    days = [part.due_on for part in parts if part.due_on]
    assert len(days) == len(parts) >= 3
    assert days[-1] == ends_on
    assert all(later - earlier >= timedelta(days=14) for earlier, later in itertools.pairwise([TODAY, *days]))


def address(agreed: Agreed) -> str:
    return f"/v1/contracts/{agreed.contract_id}/milestones/proposal"


def test_what_is_proposed_can_be_saved_as_it_is(world: World) -> None:
    agreed = Agreed(world)
    cues = [agreed.cue("radar_ping"), agreed.cue("airlock")]
    proposed = body_of(world.producer.get(address(agreed), params={"total_minor": 60_000}))["milestones"]
    assert {UUID(cue_id) for one in proposed for cue_id in one["cue_ids"]} == set(cues)
    planned = [
        {key: one[key] for key in ("name", "amount_minor", "due_on", "is_deposit")}
        | {"cues": [{"cue_id": cue_id} for cue_id in one["cue_ids"]]}
        for one in proposed
    ]
    saved = agreed.plan(*planned)
    assert saved.status_code == 200, saved.text
    assert sum(one["amount_minor"] for one in saved.json()["milestones"]) == 60_000
    assert saved.json()["advice"] == []


def test_cues_of_an_agreed_contract_are_left_out(world: World) -> None:
    first = Agreed(world)
    covered = first.cue("radar_ping")
    first.agree(milestone("Alpha", covered, amount_minor=18_000))
    assert body_of(world.producer.get(address(first)))["milestones"] == []


def test_only_producers_are_notified(world: World) -> None:
    agreed = Agreed(world)
    assert world.stranger.get(address(agreed)).status_code == 404
    assert world.designer.get(address(agreed)).status_code in (403, 404)
    assert refused(world.producer.get(address(agreed), params={"total_minor": -1}))[0] == 422
