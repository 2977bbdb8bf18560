"""A contract by the day: days are logged, agreed to and due up to the cap."""

from typing import Any

import pytest

from tests.app.money.agreed import Agreed, day, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def agreed(world: World) -> Agreed:
    """Return a contract of two days at most, at 400.01 each."""
    agreed = Agreed(world, terms={"price_mode": "day_rate", "day_rate_minor": 40_001, "days_cap": 2})
    agreed.agree(milestone("Month", agreed.cue("radar_ping"), amount_minor=0))
    return agreed


def log(agreed: Agreed, worked_on: str, quarters: int = 4, by: Any = None) -> Any:
    body = {"worked_on": worked_on, "quarters": quarters, "note": "Servo recordings"}
    return (by or agreed.world.designer).post(f"/v1/contracts/{agreed.contract_id}/worked-days", json=body)


def used(agreed: Agreed) -> tuple[int, int]:
    """Return what of the cap was agreed to, and the cap."""
    (contract,) = body_of(agreed.world.producer.get(f"/v1/projects/{agreed.world.project_id}/money"))["contracts"]
    return contract["by_day"]["agreed_minor"], contract["by_day"]["cap_minor"]


@pytest.mark.slow
def test_up_to_the_cap(agreed: Agreed) -> None:
    world = agreed.world
    assert agreed.figures()["agreed_minor"] == 80_002
    days = [log(agreed, day(-number), quarters).json()["id"] for number, quarters in ((1, 4), (2, 3), (3, 2))]
    for worked_day_id in days:
        body_of(world.producer.post(f"/v1/worked-days/{worked_day_id}/agree"))
    # Three quarters are 30,000.75; of the last half day the cap leaves 10,000.
    assert [line["amount_minor"] for line in agreed.ledger()["lines"]] == [40_001, 30_001, 10_000]
    assert used(agreed) == (80_002, 80_002)
    assert refused(world.producer.post(f"/v1/worked-days/{days[0]}/agree")) == (409, "day-agreed")
    one_more = log(agreed, day(-4)).json()["id"]
    assert refused(world.producer.post(f"/v1/worked-days/{one_more}/agree")) == (409, "cap-exceeded")


@pytest.mark.slow
def test_a_day_is_taken_back_until_it_is_agreed_to(agreed: Agreed) -> None:
    world = agreed.world
    mistaken, meant = log(agreed, day(-1)).json()["id"], log(agreed, day(-2)).json()["id"]
    assert refused(world.producer.delete(f"/v1/worked-days/{mistaken}")) == (403, "other-party-needed")
    for outsider in (world.stranger, world.other_designer, world.reviewer):
        assert refused(outsider.delete(f"/v1/worked-days/{mistaken}")) == (404, "worked-day-not-found")
    assert world.designer.delete(f"/v1/worked-days/{mistaken}").status_code == 204
    body_of(world.producer.post(f"/v1/worked-days/{meant}/agree"))
    assert refused(world.designer.delete(f"/v1/worked-days/{meant}")) == (409, "day-agreed")
    logged = world.producer.get(f"/v1/contracts/{agreed.contract_id}/worked-days").json()
    assert [one["id"] for one in logged] == [meant]


def test_a_day_that_lies_ahead_is_not_worked_yet(agreed: Agreed) -> None:
    assert refused(log(agreed, day(2))) == (422, "day-in-future")
    assert log(agreed, day(1)).status_code == 201  # somewhere it is tomorrow already
    assert refused(log(agreed, day(0), by=agreed.world.producer)) == (403, "other-party-needed")


def test_a_contract_that_pays_otherwise_has_no_days(world: World) -> None:
    agreed = Agreed(world)
    agreed.agree(milestone("Alpha", agreed.cue("radar_ping"), amount_minor=100))
    assert refused(log(agreed, day(0))) == (409, "not-day-rate")
    (contract,) = body_of(world.producer.get(f"/v1/projects/{world.project_id}/money"))["contracts"]
    assert contract["by_day"] is None
