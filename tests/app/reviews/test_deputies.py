"""Deputies: who decides for an approver, from one day to another."""

import json
from datetime import datetime, timedelta
from typing import Any
from uuid import uuid4

import pytest
from sqlalchemy import select

from app.agreements.queries import events_of
from app.projects.models import Deputy
from app.projects.rules import ApprovalRights
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import Stage, body_of, refused
from tests.app.reviews.test_approval import (
    FIRST,
    LAST,
    SECOND,
    ZONE,
    approves,
    days_of,
    local,
    moment,
    name_deputy,
    name_for,
    path,
    today_and_on,
)
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    """A project whose composer may be an approver too."""
    assert world.producer.put(path(world, f"/liaisons/{world.reviewer_id}")).status_code == 200
    return Stage(world)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("at", "may"),
    [
        (local(FIRST) - SECOND, False),
        (local(FIRST), True),
        (local(LAST, days=1) - SECOND, True),
        (local(LAST, days=1), False),
    ],
    ids=["the day before", "first day", "last day", "the day after"],
)
def test_a_deputy_approves_from_the_first_day_to_the_last_in_the_studios_time_zone(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, at: datetime, may: bool
) -> None:
    world = stage.world
    calendar = {"time_zone": ZONE.key, "holidays": []}
    assert world.producer.put(f"/v1/studios/{world.studio_id}/calendar", json=calendar).status_code == 200
    name_deputy(world, world.approver_id, world.producer_id)
    take, cue = stage.take(cue_id := stage.cue()), cue_id
    deputy, approver = world.producer, world.approver
    moment(monkeypatch, at)
    review = body_of(deputy.get(f"/v1/cues/{cue}/review"))
    assert review["may_approve"] is may
    assert [one["name"] for one in review["deputies"]] == (["Producer"] if may else [])
    assert review["approver"]["name"] == "Audio director"
    assert (review["on_behalf_of"] or {}).get("name") == ("Audio director" if may else None)
    assert approves(deputy, take) is may
    assert approves(approver, stage.take(cue)), "the approver may approve all the time"


@pytest.mark.slow
def test_the_verdict_of_a_deputy_says_for_whom_it_was_given(stage: Stage) -> None:
    world = stage.world
    name_deputy(world, world.approver_id, world.producer_id, *today_and_on(world))
    cue = stage.cue()
    first, second = stage.take(cue), stage.take(cue)
    assert approves(world.producer, first)
    body = {"kind": "approve", "seen_state": "set_aside"}
    assert world.approver.post(f"/v1/takes/{second}/verdict", json=body).status_code == 200
    said = [
        (one["kind"], one["given_by"]["name"], one["on_behalf_of"] and one["on_behalf_of"]["name"])
        for one in stage.review(cue)["verdicts"]
        if one["kind"] == "approve"
    ]
    assert said == [("approve", "Producer", "Audio director"), ("approve", "Audio director", None)]
    (approved,) = [one for one in world.designer.get(f"/v1/takes/{first}/history").json() if one["kind"] == "approve"]
    assert (approved["by"]["name"], approved["on_behalf_of"]["name"]) == ("Producer", "Audio director")


@pytest.mark.slow
def test_the_record_of_a_contract_says_for_whom_a_deputy_decided(world: World) -> None:
    agreed = Agreed(world)
    cue = agreed.cue()
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    assert world.producer.put(path(world, f"/liaisons/{world.reviewer_id}")).status_code == 200
    name_deputy(world, world.approver_id, world.reviewer_id, *today_and_on(world))
    assert approves(world.reviewer, agreed.take(cue))
    events = world.server.in_database(lambda session: [*events_of(session, agreed.contract_id)])
    (judged,) = [json.loads(event.payload) for event in events if event.kind == "judged"]
    assert (judged["by"], judged["on_behalf_of"]) == ("Composer", "Audio director")
    assert judged["role"].startswith("deputy of the approver")


def test_a_deputy_of_a_categorys_approver_decides_there_alone(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    name_deputy(world, world.reviewer_id, world.producer_id, *today_and_on(world))
    click, shot = (stage.take(stage.cue(name, category=name)) for name in ("ui", "weapon"))
    assert not approves(world.producer, shot)
    assert approves(world.producer, click)


def test_a_deputy_has_no_deputy() -> None:
    one, two, three = uuid4(), uuid4(), uuid4()
    rights = ApprovalRights(one, {}, {one: [two], two: [three]})
    assert rights.people_for("ui") == [one, two]
    assert not rights.scope_of(three).is_any


@pytest.mark.slow
def test_rights_end_with_a_withdrawal_and_with_the_membership(stage: Stage) -> None:
    world = stage.world
    name_for(world, "ui", world.reviewer_id)
    withdrawn = name_deputy(world, world.approver_id, world.producer_id, *today_and_on(world))
    assert world.producer.delete(path(world, f"/deputies/{withdrawn}")).status_code == 204
    assert refused(world.producer.delete(path(world, f"/deputies/{withdrawn}"))) == (404, "deputy-not-found")
    click, shot = (stage.take(stage.cue(name, category=name)) for name in ("ui", "weapon"))
    assert not approves(world.producer, shot)

    name_deputy(world, world.reviewer_id, world.producer_id, *today_and_on(world))
    assert world.producer.delete(f"/v1/studios/{world.studio_id}/people/{world.reviewer_id}").status_code == 204
    assert world.reviewer.get(f"/v1/takes/{click}/history").status_code == 404
    project = body_of(world.producer.get(path(world, "")))
    assert project["category_approvers"] == []
    assert body_of(world.producer.get(path(world, "/deputies")))["deputies"] == []
    assert not approves(world.producer, click), "the deputy of a person who left decides nothing"
    assert approves(world.approver, click), "the category is the project's approver's again"


@pytest.mark.parametrize(
    ("change", "where"),
    [
        ({"until_on": str(FIRST - timedelta(days=1))}, "until_on"),
        ({"from_on": "2020-01-01", "until_on": "2020-01-02"}, "until_on"),
        ({"deputy_id": None}, "deputy_id"),
    ],
    ids=["ends before it begins", "over", "oneself"],
)
def test_a_deputy_needs_days_to_come_and_another_person(stage: Stage, change: dict[str, Any], where: str) -> None:
    world = stage.world
    body = days_of(world.approver_id, world.producer_id) | change
    body["deputy_id"] = body["deputy_id"] or str(world.approver_id)
    answer = world.producer.post(path(world, "/deputies"), json=body)
    assert (refused(answer), answer.json()["errors"][0]["where"]) == ((422, "bad-deputy"), where)


def test_days_are_kept_by_the_database(stage: Stage) -> None:
    world = stage.world
    name_deputy(world, world.approver_id, world.producer_id, FIRST, FIRST)
    kept = world.server.in_database(
        lambda session: [(one.from_on, one.until_on) for one in session.scalars(select(Deputy))]
    )
    assert (FIRST, FIRST) in kept
