"""Filters of the review queue leave whole cues, in the order of the queue."""

from datetime import UTC, date, datetime, timedelta
from typing import Any

import pytest

from app.deliveries.rules import TakeState
from app.sound_lists.rules import Need
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World

START = datetime(2026, 11, 20, tzinfo=UTC)


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def names(stage: Stage, **wanted: Any) -> list[str]:
    """Return the cues that a filter leaves; the count says the same."""
    params = {"project_id": str(stage.world.project_id), **wanted}
    items = body_of(stage.world.reviewer.get("/v1/review-queue", params=params))["items"]
    assert body_of(stage.world.reviewer.get("/v1/review-queue/count", params=params))["cues"] == len(items)
    return [item["cue"]["name"] for item in items]


@pytest.mark.slow
def test_facts_of_the_cue_leave_cues_in_order_and_combine(stage: Stage) -> None:
    facts: dict[str, dict[str, Any]] = {
        "laser": {"category": "weapon", "need": Need.SHOULD, "due_on": date(2999, 1, 2)},
        "shield": {"category": "weapon", "description": "An enemy SHOT meets the shield."},
        "click": {"category": "ui", "due_on": date(2999, 1, 1), "use": "every menu"},
    }
    for place, (name, of_cue) in enumerate(facts.items()):
        stage.take(stage.cue(name, **of_cue), state_since=START + timedelta(hours=place))
    assert names(stage) == ["shield", "click", "laser"], "what must be there comes first"
    assert names(stage, category="weapon") == ["shield", "laser"]
    assert names(stage, need="should") == ["laser"]
    assert names(stage, due_by="2999-01-01") == ["click"]
    assert names(stage, due_by="2999-01-02") == ["click", "laser"]
    assert names(stage, q="shot enemy") == ["shield"]
    assert names(stage, q="MENU") == ["click"]
    assert names(stage, category="weapon", q="lase") == ["laser"]
    assert names(stage, category="weapon", need="wish") == []


@pytest.mark.slow
def test_a_set_alternates_and_single_versions_are_distinguished(stage: Stage) -> None:
    single, several, whole = stage.cue("single"), stage.cue("several"), stage.cue("whole", variations=2)
    for place, cue_id in enumerate((single, several, several, whole)):
        stage.take(cue_id, state_since=START + timedelta(hours=place))
    stage.take(single, state=TakeState.SET_ASIDE)
    assert names(stage, kind="single") == ["single"]
    assert names(stage, kind="alternates") == ["several"]
    assert names(stage, kind="set") == ["whole"]


@pytest.mark.slow
def test_a_version_that_answers_a_change_is_new(stage: Stage) -> None:
    changed, first = stage.cue("changed"), stage.cue("first")
    stage.draft(stage.take(changed))
    stage.send()
    stage.take(changed)
    stage.take(first)
    assert names(stage, version="new") == ["changed"]
    assert names(stage, version="first") == ["first"]


@pytest.mark.slow
def test_a_designer_whose_version_is_not_the_first_that_waits_is_found_with_the_whole_cue(stage: Stage) -> None:
    world = stage.world
    mixed = stage.cue("mixed", variations=2)
    stage.take(mixed, 1, state_since=START)
    stage.take(mixed, 2, designer_id=world.producer_id, state_since=START + timedelta(hours=1))
    stage.take(stage.cue("other"), state_since=START + timedelta(hours=2))
    assert names(stage, designer_id=str(world.producer_id)) == ["mixed"]
    assert names(stage, designer_id=str(world.designer_id)) == ["mixed", "other"]
    params = {"project_id": str(world.project_id), "designer_id": str(world.producer_id)}
    (item,) = body_of(world.reviewer.get("/v1/review-queue", params=params))["items"]
    assert len(item["takes"]) == 2


@pytest.mark.parametrize("wanted", [{"need": "soon"}, {"due_by": "tomorrow"}, {"kind": "x"}, {"version": "old"}])
def test_an_unknown_filter_is_refused(stage: Stage, wanted: dict[str, str]) -> None:
    assert stage.world.reviewer.get("/v1/review-queue", params=wanted).status_code == 422
