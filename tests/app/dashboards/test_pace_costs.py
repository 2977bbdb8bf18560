"""What a project costs, against sums done by hand: budget, committed, spent, a kept sound, churn, estimates."""

import copy
from datetime import UTC, datetime, timedelta
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.core.db import new_id
from app.dashboards.velocity.cost_rules import (
    OrderedCue,
    churn,
    churned_since,
    estimate_error,
    kept_sounds,
    per_kept_minor,
    wants_another_sound,
)
from tests.app.money.agreed import Agreed, day, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

NOW = datetime(2026, 11, 25, 12, tzinfo=UTC)


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def ordered(amount_minor: int = 10_000, *, kept: bool = False, churned: bool = False, of: UUID | None = None):
    return OrderedCue(of or new_id(), "USD", amount_minor, is_kept=kept, is_churned=churned)


def test_a_kept_sound_costs_what_was_spent_by_what_is_kept() -> None:
    assert per_kept_minor(27_500, 2) == 13_750
    assert per_kept_minor(100, 3) == 33
    assert per_kept_minor(5, 2) == 3  # halves up
    assert per_kept_minor(27_500, 0) is None


def test_churn_is_a_share_of_cues_and_the_money_that_was_agreed_for_them() -> None:
    found = churn([ordered(churned=True), ordered(2_500, churned=True), ordered(), ordered()])
    assert (found.ordered, found.churned, found.share, found.churned_minor) == (4, 2, 0.5, 12_500)
    assert churn([ordered(churned=True), ordered()]).share is None  # two are too few for a share


def test_a_cue_under_two_contracts_is_one_sound() -> None:
    cue_id = new_id()
    twice = [ordered(6_000, kept=True, churned=True, of=cue_id), ordered(4_000, kept=True, churned=True, of=cue_id)]
    assert kept_sounds(twice) == 1
    assert (churn(twice).ordered, churn(twice).churned, churn(twice).churned_minor) == (1, 1, 10_000)


@pytest.mark.parametrize(
    ("before", "after", "rewritten"),
    [
        ({}, {"description": "A bell"}, False),  # the cue was added
        ({"description": "A bell"}, {"description": "A gong"}, True),
        ({"description": "A bell."}, {"description": "A bell.\n\nHow heavy? Two tons"}, False),  # an answer was added
        ({"description": "A bell."}, {"description": "A bell, struck twice"}, False),
        ({"description": ""}, {"description": "A bell"}, False),
        ({"description": "A bell"}, {"description": ""}, True),
        ({"duration_s": 1.0}, {"duration_s": 2.0}, True),
        ({"loop": False}, {"loop": True}, True),
        ({"variations": 1}, {"variations": 4}, True),
        ({"due_on": "2026-11-01"}, {"due_on": "2026-12-01"}, False),
        ({"name": "bell"}, {"name": "bell_big"}, False),
    ],
)
def test_which_changes_ask_for_another_sound(before: dict[str, Any], after: dict[str, Any], rewritten: bool) -> None:
    assert wants_another_sound(before, after) is rewritten


def test_only_what_changes_after_work_began_is_churn() -> None:
    assert not churned_since(None, [NOW])
    assert not churned_since(NOW, [NOW - timedelta(days=1)])
    assert churned_since(NOW, [NOW - timedelta(days=1), NOW + timedelta(days=1)])


def test_estimates_are_summed_up_before_they_are_compared() -> None:
    error = estimate_error([(60, 90), (60, 60), (120, 150)])
    assert error is not None
    assert (error.cues, error.estimated_min, error.logged_min, error.percent) == (3, 240, 300, 25)
    assert estimate_error([(60, 90), (60, 60)]) is None


def pace(agreed: Agreed, by: Any = None) -> dict[str, Any]:
    return body_of((by or agreed.world.producer).get(f"/v1/projects/{agreed.world.project_id}/pace"))


def set_budget(agreed: Agreed, by: Any, **body: Any) -> Any:
    return by.put(f"/v1/projects/{agreed.world.project_id}/budget", json=body)


def change(agreed: Agreed, cue_id: UUID, **facts: Any) -> None:
    answer = agreed.world.producer.patch(f"/v1/cues/{cue_id}", json={"edition": 1, **facts})
    assert answer.status_code == 200, answer.text


def in_euro(agreed: Agreed) -> Agreed:
    """Return the same stage with a second contract, in euro."""

    def renumber(session: Session) -> None:
        session.get_one(Contract, agreed.contract_id).number = 2

    agreed.world.server.in_database(renumber)
    second = copy.copy(agreed)
    second.currency = "EUR"
    second.contract_id = agreed.world.server.in_database(second._draft)
    return second


@pytest.mark.slow
@pytest.mark.both_databases
def test_the_figures_of_two_contracts_by_hand(agreed: Agreed) -> None:
    world = agreed.world
    bell, gong, horn, drum = cues = [agreed.cue(name, description=name) for name in ("bell", "gong", "horn", "drum")]
    agreed.agree(milestone("Alpha", *cues, amount_minor=40_000))
    change(agreed, drum, description="a snare")  # before work began: no churn
    for cue in (bell, gong):
        agreed.approve(agreed.take(cue))
    change(agreed, gong, description="a cymbal")
    agreed.take(horn)
    cut = world.producer.post(f"/v1/cues/{horn}/cut", json={"reason": "the level is gone"})
    assert cut.status_code == 200, cut.text
    agreed.pay(agreed.invoice(), 10_000)
    euro = in_euro(agreed)
    euro.agree(milestone("Beta", agreed.cue("whistle"), amount_minor=5_000))
    assert set_budget(agreed, world.producer, currency="USD", amount_minor=50_000).json() == [
        {"currency": "USD", "amount_minor": 50_000}
    ]
    assert pace(agreed)["costs"] == [
        {
            "currency": "EUR",
            "budget_minor": None,
            "committed_minor": 5_000,
            "spent_minor": 0,
            "paid_minor": 0,
            "due_minor": 0,
            "kept": 0,
            "per_kept_minor": None,
            "to_finish_minor": 5_000,
            "ordered": 1,
            "churned": 0,
            "churn": None,
            "churned_minor": 0,
        },
        {
            "currency": "USD",
            "budget_minor": 50_000,
            "committed_minor": 37_500,  # a quarter of the horn's 100.00 is saved: its files were delivered
            "spent_minor": 27_500,  # bell and gong, and 75 % of the horn
            "paid_minor": 10_000,
            "due_minor": 17_500,
            "kept": 2,
            "per_kept_minor": 13_750,
            "to_finish_minor": 10_000,  # the drum
            "ordered": 4,
            "churned": 2,  # the horn was cut, the gong rewritten
            "churn": 0.5,
            "churned_minor": 20_000,
        },
    ]


@pytest.mark.slow
def test_budgets_are_set_by_producers_and_seen_by_no_designer(agreed: Agreed) -> None:
    world = agreed.world
    agreed.agree(milestone("Alpha", agreed.cue("bell"), amount_minor=10_000))
    for currency, amount_minor in (("USD", 50_000), ("EUR", 9_000), ("USD", 60_000)):
        assert set_budget(agreed, world.producer, currency=currency, amount_minor=amount_minor).status_code == 200
    seen = {one["currency"]: one["budget_minor"] for one in pace(agreed, world.approver)["costs"]}
    assert seen == {"EUR": 9_000, "USD": 60_000}
    assert [(one["currency"], one["budget_minor"]) for one in pace(agreed, world.designer)["costs"]] == [("USD", None)]
    assert body_of(set_budget(agreed, world.producer, currency="EUR", amount_minor=None)) == [
        {"currency": "USD", "amount_minor": 60_000}
    ]
    for by in (world.designer, world.approver, world.reviewer):
        assert refused(set_budget(agreed, by, currency="USD", amount_minor=1)) == (403, "producer-needed")
    assert refused(set_budget(agreed, world.stranger, currency="USD", amount_minor=1)) == (404, "project-not-found")
    for wrong in ({"currency": "usd", "amount_minor": 1}, {"currency": "USD", "amount_minor": 0}):
        assert set_budget(agreed, world.producer, **wrong).status_code == 422


@pytest.mark.slow
def test_estimates_against_logged_time_are_for_producers_and_their_designer(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}") for number in range(4)]
    planned = milestone("Alpha", amount_minor=40_000, due_on=day(10))
    planned["cues"] = [{"cue_id": str(cue), "estimate_min": 100} for cue in cues]
    agreed.agree(planned)
    for cue, minutes in zip(cues, (120, 140, 130, 900), strict=True):
        body = {"cue_id": str(cue), "minutes": minutes, "worked_on": day(0)}
        agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=body)
    for cue in cues[:2]:
        agreed.approve(agreed.take(cue))
    assert pace(agreed)["estimates"] is None  # two are too few
    agreed.approve(agreed.take(cues[2]))
    expected = {"cues": 3, "estimated_min": 300, "logged_min": 390, "error_percent": pytest.approx(30)}
    assert pace(agreed)["estimates"] == expected  # the fourth is not accepted yet
    assert pace(agreed, agreed.world.designer)["estimates"] == expected
    assert pace(agreed)["over_estimate"] == {"cues": 1, "over_min": 800}, "it is open, and longer already"
    assert pace(agreed, agreed.world.approver)["estimates"] is None
    assert pace(agreed, agreed.world.approver)["over_estimate"] is None
