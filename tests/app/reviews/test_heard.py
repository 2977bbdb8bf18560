"""Which versions a person has heard: their own record, a filter of the queue, private to them."""

from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import func, select

from app.core.db import new_id
from app.deliveries.rules import TakeState
from app.reviews.models import HeardTake
from app.reviews.schemas import MAX_HEARD
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def hear(client: Any, project_id: UUID, *take_ids: UUID) -> Any:
    return client.post(
        f"/v1/projects/{project_id}/heard-takes", json={"take_ids": [str(take_id_) for take_id_ in take_ids]}
    )


def unheard(client: Any, project_id: UUID) -> list[str]:
    """Return the cues that the filter leaves; the count says the same."""
    params = {"project_id": str(project_id), "unheard": "true"}
    items = body_of(client.get("/v1/review-queue", params=params))["items"]
    assert body_of(client.get("/v1/review-queue/count", params=params))["cues"] == len(items)
    return [item["cue"]["name"] for item in items]


@pytest.mark.slow
def test_what_a_person_heard_leaves_their_filter_and_no_other(stage: Stage) -> None:
    world = stage.world
    laser, shield = stage.take(stage.cue("laser")), stage.take(stage.cue("shield"))
    assert unheard(world.reviewer, world.project_id) == ["laser", "shield"]
    for _ in range(2):  # a batch that is sent again changes nothing
        assert hear(world.reviewer, world.project_id, laser, laser).status_code == 204
    assert unheard(world.reviewer, world.project_id) == ["shield"]
    assert unheard(world.approver, world.project_id) == ["laser", "shield"]
    by_take = {take["id"]: take["is_heard"] for item in stage.queue() for take in item["takes"]}
    assert by_take == {str(laser): False, str(shield): False}, "the approver heard neither"


@pytest.mark.slow
def test_a_new_version_and_another_variation_have_to_be_heard_too(stage: Stage) -> None:
    world, reviewer = stage.world, stage.world.reviewer
    pair = stage.cue("pair", variations=2)
    first, second = stage.take(pair, 1), stage.take(pair, 2)
    hear(reviewer, world.project_id, first)
    assert unheard(reviewer, world.project_id) == ["pair"]
    hear(reviewer, world.project_id, second)
    assert unheard(reviewer, world.project_id) == []
    later = stage.take(pair, 2)
    assert unheard(reviewer, world.project_id) == ["pair"]
    takes = stage.review(pair)["takes"]
    assert {take["id"]: take["is_heard"] for take in takes} == {str(first): True, str(second): True, str(later): False}


def test_takes_of_other_projects_are_passed_over(stage: Stage) -> None:
    world = stage.world
    laser = stage.take(stage.cue("laser"))
    made = world.producer.post(
        "/v1/projects", json={"studio_id": str(world.studio_id), "name": "Elsewhere", "cue_prefix": "EL"}
    )
    elsewhere = made.json()["id"]
    assert hear(world.producer, elsewhere, laser, new_id()).status_code == 204
    assert unheard(world.producer, world.project_id) == ["laser"]
    heard = select(func.count()).select_from(HeardTake).where(HeardTake.person_id == world.producer_id)
    assert world.server.in_database(lambda session: session.scalar(heard)) == 0


def test_a_stranger_sees_no_project_and_a_designer_has_no_queue(stage: Stage) -> None:
    world = stage.world
    laser = stage.take(stage.cue("laser"))
    assert refused(hear(world.stranger, world.project_id, laser)) == (404, "project-not-found")
    assert refused(hear(world.designer, world.project_id, laser)) == (403, "team-needed")


@pytest.mark.parametrize("number", [0, MAX_HEARD + 1])
def test_a_batch_has_some_and_not_too_many(stage: Stage, number: int) -> None:
    world = stage.world
    assert hear(world.reviewer, world.project_id, *(new_id() for _ in range(number))).status_code == 422


def without_listening(stage: Stage, cue: UUID) -> dict[str, bool]:
    """Return of each approved take whether it was approved unheard; review and history say the same."""
    review = stage.review(cue)
    of_takes = {one["take_id"]: one["without_listening"] for one in review["verdicts"] if one["kind"] == "approve"}
    for take_id, unheard_ in of_takes.items():
        history = stage.world.designer.get(f"/v1/takes/{take_id}/history").json()
        assert [one["without_listening"] for one in history if one["kind"] == "approve"] == [unheard_]
    return of_takes


def test_an_approval_says_whether_it_was_given_without_listening(stage: Stage) -> None:
    world = stage.world
    before, now, never, of_another = (stage.cue(name) for name in ("before", "now", "never", "of_another"))
    takes = {cue: stage.take(cue) for cue in (before, now, never, of_another)}
    hear(world.approver, world.project_id, takes[before])
    hear(world.reviewer, world.project_id, takes[of_another])
    for cue, take in takes.items():
        stage.approve(take, **({"heard": True} if cue == now else {}))
    found = {cue: without_listening(stage, cue)[str(take)] for cue, take in takes.items()}
    assert found == {before: False, now: False, never: True, of_another: True}
    assert unheard_of_list(stage, world.approver)["now"] == [], "what was heard with the verdict counts as heard"


def test_of_a_set_each_file_says_it(stage: Stage) -> None:
    world, pair = stage.world, stage.cue("pair", variations=3)
    first, second, third = (stage.take(pair, variation) for variation in (1, 2, 3))
    hear(world.approver, world.project_id, first)
    foreign = stage.take(stage.cue("other"))
    body = {"heard_take_ids": [str(second), str(foreign)]}
    body_of(world.approver.post(f"/v1/cues/{pair}/accept-set", json=body))
    assert without_listening(stage, pair) == {str(first): False, str(second): False, str(third): True}
    assert unheard(world.approver, world.project_id) == ["other"]


def unheard_of_list(stage: Stage, client: Any) -> dict[str, list[str]]:
    """Return the takes that the sound list marks as not heard, by the name of their cue."""
    project = f"/v1/projects/{stage.world.project_id}"
    names = {cue["id"]: cue["name"] for cue in body_of(client.get(f"{project}/sound-list"))["cues"]}
    cues = body_of(client.get(f"{project}/sound-list/progress"))["cues"]
    return {names[cue["cue_id"]]: cue["unheard_take_ids"] for cue in cues}


@pytest.mark.slow
def test_the_list_marks_what_waits_or_is_approved_and_was_not_heard(stage: Stage) -> None:
    world, reviewer = stage.world, stage.world.reviewer
    pair, door, cut = stage.cue("pair", variations=2), stage.cue("door"), stage.cue("cut")
    stage.cue("empty")
    first, second, waits = stage.take(pair, 1), stage.take(pair, 2), stage.take(door)
    stage.take(cut)
    stage.approve(first)
    stage.take(door, state=TakeState.SET_ASIDE)
    stage.take(door, state=TakeState.RETURNED)
    stage.take(door, state=TakeState.CHANGE_REQUESTED)
    assert world.producer.post(f"/v1/cues/{cut}/cut", json={"reason": "no room"}).status_code == 200
    expected = {"pair": [str(first), str(second)], "door": [str(waits)], "cut": [], "empty": []}
    assert unheard_of_list(stage, reviewer) == expected
    hear(reviewer, world.project_id, first, waits)
    assert unheard_of_list(stage, reviewer) == {**expected, "pair": [str(second)], "door": []}
    assert unheard_of_list(stage, world.approver) == expected
    assert unheard_of_list(stage, world.designer) == {name: [] for name in expected}


@pytest.mark.slow
def test_a_longer_list_costs_no_more_statements(stage: Stage) -> None:
    server, project = stage.world.server, f"/v1/projects/{stage.world.project_id}"

    def statements() -> int:
        with server.counted_selects() as selects:
            body_of(stage.world.reviewer.get(f"{project}/sound-list/progress"))
        assert any("reviews_heard_takes" in text for text in selects)
        return len(selects)

    stage.take(stage.cue())
    for_one = statements()
    for number in range(20):
        stage.take(stage.cue(f"cue_{number}"))
    assert statements() == for_one
