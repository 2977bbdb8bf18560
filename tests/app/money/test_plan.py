"""A plan while it is written: errors and warnings are shown, and nothing is saved."""

from typing import Any

import pytest

from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def looked_at(agreed: Agreed, *planned: dict[str, Any]) -> dict[str, Any]:
    body = {"milestones": list(planned)}
    return body_of(agreed.world.producer.post(f"/v1/contracts/{agreed.contract_id}/plan-check", json=body))


def test_warnings_are_shown_before_it_is_saved(agreed: Agreed) -> None:
    first, second = agreed.cue("radar_ping"), agreed.cue("dock_clamp")
    plan = [deposit(10_000), milestone("Alpha", first, amount_minor=30_000), milestone("Beta", second)]
    plan[2] |= {"amount_minor": 10_000, "due_on": None}
    checked = looked_at(agreed, *plan)
    assert checked["faults"] == []
    assert [one["code"] for one in checked["advice"]] == ["no-date", "not-rising", "completion-not-largest"]
    assert body_of(agreed.world.producer.get(f"/v1/contracts/{agreed.contract_id}/milestones"))["milestones"] == []


def test_what_is_wrong_names_its_milestone(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    checked = looked_at(agreed, milestone("Alpha", cue, amount_minor=30_000), {"name": "Beta", "cues": []})
    assert checked["faults"] == []
    checked = looked_at(agreed, milestone("Alpha", cue), milestone("Beta", cue, amount_minor=10_000))
    assert [fault["where"] for fault in checked["faults"]] == ["milestones.0", "milestones"]
    assert "no amount" in checked["faults"][0]["message"]


@pytest.mark.slow
def test_a_cue_of_another_agreed_contract_is_named(agreed: Agreed, contracts: Contracts) -> None:
    cue = agreed.cue("radar_ping")
    again = milestone("Alpha", cue, amount_minor=30_000)
    agreed.agree(deposit(20_000), again)
    address = f"/v1/contracts/{contracts.begin(title='More effects')['id']}"
    checked = body_of(agreed.world.producer.post(f"{address}/plan-check", json={"milestones": [again]}))
    (said,) = [one for one in checked["advice"] if one["code"] == "covered-elsewhere"]
    assert said["message"] == "radar_ping is part of Effects, which is signed."
    saved = body_of(agreed.world.producer.put(f"{address}/milestones", json={"milestones": [again]}))
    assert "covered-elsewhere" in {one["code"] for one in saved["advice"]}


def test_only_a_producer_plans(agreed: Agreed) -> None:
    address, body = f"/v1/contracts/{agreed.contract_id}/plan-check", {"milestones": []}
    assert refused(agreed.world.approver.post(address, json=body)) == (403, "producer-needed")
    assert refused(agreed.world.stranger.post(address, json=body)) == (404, "contract-not-found")
