"""Milestones proposed from dates and categories of the sound list."""

from datetime import date
from typing import Any
from uuid import UUID, uuid4

from app.agreements.plan_proposal import WantedCue, propose_milestones
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

FIRST, SECOND = date(2026, 12, 4), date(2027, 1, 15)


def wanted(category: str = "", due_on: date | None = None) -> WantedCue:
    return WantedCue(uuid4(), category, due_on)


def named(cues: list[WantedCue], **more: Any) -> list[tuple[str, date | None, int]]:
    return [(one.name, one.due_on, len(one.cue_ids)) for one in propose_milestones(cues, **more)]


def test_days_come_in_order_then_categories_in_list_order() -> None:
    cues = [
        wanted("weapon"),
        wanted("ui", SECOND),
        wanted("ui", FIRST),
        wanted("ui", FIRST),
        wanted("weapon"),
        wanted(),
    ]
    assert named(cues) == [
        ("UI, 4 December", FIRST, 2),
        ("UI, 15 January", SECOND, 1),
        ("Weapon", None, 2),
        ("Other sounds", None, 1),
    ]


def test_a_day_of_several_categories_is_not_named_by_one() -> None:
    assert named([wanted("ui", FIRST), wanted("weapon", FIRST)]) == [("Sounds, 4 December", FIRST, 2)]


def test_a_price_is_a_deposit_and_shares_by_cues_that_add_up() -> None:
    cues = [wanted("ui"), wanted("ui"), wanted("weapon")]
    deposit, ui, weapon = propose_milestones(cues, total_minor=100_000, deposit_bp=2_500)
    assert (deposit.is_deposit, deposit.amount_minor, deposit.cue_ids) == (True, 25_000, [])
    assert (ui.amount_minor, weapon.amount_minor) == (50_000, 25_000)
    odd = propose_milestones(cues, total_minor=100_001)
    assert sum(one.amount_minor or 0 for one in odd) == 100_001


def test_without_a_price_nothing_has_an_amount() -> None:
    assert [one.amount_minor for one in propose_milestones([wanted("ui")])] == [None]


def test_no_cues_are_no_milestones() -> None:
    assert propose_milestones([], total_minor=100) == []


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
