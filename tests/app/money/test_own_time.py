"""Time without a contract: logged on a cue, a bid or a project, seen and counted for the person alone."""

from typing import Any

import pytest

from tests.app.hiring.test_postings import join, opened
from tests.app.money.agreed import Agreed, day, milestone
from tests.support.deliver import add_cues
from tests.support.server import World


def log(world: World, by: Any = None, **given: Any) -> Any:
    body = {"minutes": 90, "worked_on": day(0), **given}
    return (by or world.designer).post(f"/v1/projects/{world.project_id}/own-time", json=body)


def times(world: World, by: Any = None) -> list[dict[str, Any]]:
    answer = (by or world.designer).get(f"/v1/projects/{world.project_id}/own-time")
    assert answer.status_code == 200, answer.text
    return list(answer.json()["times"])


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def test_time_is_logged_without_a_contract_and_seen_by_its_person_alone(world: World) -> None:
    [cue] = add_cues(world, {"name": "Door"})
    made = log(world, cue_id=cue["id"])
    assert made.status_code == 201, made.text
    assert log(world, note="test work", minutes=30).status_code == 201
    assert [(time["cue"] and time["cue"]["name"], time["minutes"], time["note"]) for time in times(world)] == [
        (None, 30, "test work"),
        ("Door", 90, ""),
    ]
    for client in (world.producer, world.approver, world.reviewer):
        assert times(world, client) == []
        assert client.delete(f"/v1/own-time/{made.json()['id']}").status_code == 404
    for client in (world.other_designer, world.stranger):
        assert log(world, client, note="x").status_code == 404
    assert world.designer.delete(f"/v1/own-time/{made.json()['id']}").status_code == 204
    assert [time["minutes"] for time in times(world)] == [30]


def test_it_says_what_it_went_into_and_when(world: World) -> None:
    nothing = log(world)
    assert (nothing.status_code, nothing.json()["code"]) == (422, "work-not-named")
    ahead = log(world, note="x", worked_on=day(3))
    assert (ahead.status_code, ahead.json()["code"]) == (422, "day-in-future")
    unknown = log(world, cue_id=str(world.project_id))
    assert (unknown.status_code, unknown.json()["code"]) == (404, "cue-not-found")


def test_a_bidder_logs_time_on_the_bid(world: World) -> None:
    add_cues(world, {"name": "Door"})
    posting = opened(world)
    join(world, posting, world.other_designer)
    assert log(world, world.other_designer, note="reading the brief").status_code == 404  # the project is not seen yet
    made = log(world, world.other_designer, note="reading the brief", posting_id=posting["id"])
    assert made.status_code == 201, made.text
    address = f"/v1/projects/{world.project_id}/own-time"
    seen = world.other_designer.get(address, params={"posting_id": posting["id"]}).json()
    assert [time["note"] for time in seen["times"]] == ["reading the brief"]
    assert world.producer.get(address, params={"posting_id": posting["id"]}).json()["times"] == []
    assert log(world, world.stranger, note="x", posting_id=posting["id"]).status_code == 404


@pytest.mark.slow
def test_an_hour_earns_less_by_the_time_before_the_contract_and_only_its_designer_is_told(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    assert log(agreed.world, cue_id=str(cue), minutes=60).status_code == 201
    agreed.agree(milestone("Alpha", cue, amount_minor=30_000))
    address = f"/v1/contracts/{agreed.contract_id}/estimates"
    pay = agreed.world.designer.get(address).json()["pay"]
    assert (pay["logged_min"], pay["own_min"], pay["by_log_minor"]) == (60, 60, 30_000)
    body = {"cue_id": str(cue), "minutes": 120, "worked_on": day(0)}
    assert agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=body).status_code == 204
    pay = agreed.world.designer.get(address).json()["pay"]
    assert (pay["logged_min"], pay["own_min"], pay["by_log_minor"]) == (180, 60, 10_000)
    assert agreed.world.producer.get(address).json()["pay"] is None


@pytest.mark.slow
def test_approved_cues_say_how_long_one_of_their_category_takes(agreed: Agreed) -> None:
    cues = [agreed.cue(f"cue_{number}", category="ui") for number in range(4)]
    agreed.agree(milestone("Alpha", *cues, amount_minor=30_000))
    for cue, minutes in zip(cues, (60, 120, 180, 600), strict=True):
        assert log(agreed.world, cue_id=str(cue), minutes=minutes).status_code == 201
    body = {"cue_id": str(cues[2]), "minutes": 60, "worked_on": day(0)}  # under the contract: counts too
    assert agreed.world.designer.post(f"/v1/contracts/{agreed.contract_id}/work-logs", json=body).status_code == 204
    address = f"/v1/projects/{agreed.world.project_id}/own-time"
    for cue in cues[:2]:
        agreed.approve(agreed.take(cue))
    assert agreed.world.designer.get(address).json()["categories"] == []  # two are too few
    agreed.approve(agreed.take(cues[2]))
    assert agreed.world.designer.get(address).json()["categories"] == [
        {"category": "ui", "cues": 3, "low_min": 90, "high_min": 180}  # of 60, 120 and 240
    ]
    assert agreed.world.producer.get(address).json()["categories"] == []
