"""Reasons found again: how often each was given, and of which versions."""

from typing import Any

import pytest

from app.reviews.reasons import reason_counts as found_reasons
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def counts(stage: Stage, by: Any = None, **wanted: Any) -> dict[str, dict[str, int]]:
    found = body_of((by or stage.world.reviewer).get(f"/v1/projects/{stage.world.project_id}/reasons", params=wanted))
    return {kind: {one["reason"]: one["versions"] for one in found[kind]} for kind in ("change", "pick")}


def versions(stage: Stage, kind: str, reason: str, by: Any = None, **wanted: Any) -> dict[str, Any]:
    path = f"/v1/projects/{stage.world.project_id}/reasons/versions"
    return body_of((by or stage.world.reviewer).get(path, params={"kind": kind, "reason": reason, **wanted}))


@pytest.mark.slow
def test_reasons_of_picks_and_of_sent_changes_are_counted_apart(stage: Stage) -> None:
    for reason in ("Fits the scene", "Cleanest", "Fits the scene"):
        stage.approve(stage.take(stage.cue()), reasons=[reason])
    take_id = stage.take(stage.cue())
    stage.draft(take_id, "Too loud. Off style.", reasons=["Too loud", "Off style"])
    picks = {"Fits the scene": 2, "Cleanest": 1}
    assert counts(stage) == {"change": {}, "pick": picks}, "a draft is not said yet"
    stage.send()
    assert counts(stage) == {"change": {"Off style": 1, "Too loud": 1}, "pick": picks}
    path = f"/v1/projects/{stage.world.project_id}/reasons"
    found = body_of(stage.world.reviewer.get(path))
    assert [one["reason"] for one in found["pick"]] == ["Fits the scene", "Cleanest"], "the most frequent first"


@pytest.mark.slow
def test_an_approval_that_is_taken_back_counts_no_longer(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    stage.approve(take_id, reasons=["Cleanest"])
    assert counts(stage)["pick"] == {"Cleanest": 1}
    body_of(stage.undo(take_id))
    assert counts(stage)["pick"] == {}
    assert versions(stage, "pick", "Cleanest")["items"] == []
    stage.approve(take_id, reasons=["Cleanest"])
    assert counts(stage)["pick"] == {"Cleanest": 1}


def test_each_version_is_named_with_who_said_what_and_where(stage: Stage) -> None:
    cue_id = stage.cue("laser", category="weapon")
    take_id = stage.take(cue_id)
    stage.draft(take_id, "Too loud. 3 dB less.", reasons=["Too loud"], start_s=0.25, end_s=0.5)
    stage.send()
    (found,) = versions(stage, "change", "Too loud")["items"]
    assert (found["take_id"], found["cue_name"], found["number"]) == (str(take_id), "laser", 1)
    assert (found["text"], found["reasons"], found["start_s"]) == ("Too loud. 3 dB less.", ["Too loud"], 0.25)
    assert found["designer"]["id"] == str(stage.world.designer_id)
    assert found["given_by"]["id"] == str(stage.world.approver_id)
    assert versions(stage, "pick", "Too loud")["items"] == []


@pytest.mark.slow
def test_they_are_filtered_by_designer_and_category(stage: Stage) -> None:
    world = stage.world
    stage.approve(stage.take(stage.cue(category="ui")), reasons=["Cleanest"])
    stage.approve(stage.take(stage.cue(category="ui"), designer_id=world.producer_id), reasons=["Best timing"])
    stage.approve(stage.take(stage.cue()), reasons=["Best weight"])
    own = {"designer_id": str(world.designer_id)}
    assert counts(stage, category="ui")["pick"] == {"Best timing": 1, "Cleanest": 1}
    assert counts(stage, category="")["pick"] == {"Best weight": 1}
    assert counts(stage, **own)["pick"] == {"Best weight": 1, "Cleanest": 1}
    assert counts(stage, category="ui", **own)["pick"] == {"Cleanest": 1}
    assert versions(stage, "pick", "Best timing", **own)["items"] == []
    assert len(versions(stage, "pick", "Best timing", category="ui")["items"]) == 1
    found = body_of(world.reviewer.get(f"/v1/projects/{world.project_id}/reasons"))
    assert found["categories"] == ["", "ui"]
    assert {one["id"] for one in found["designers"]} == {str(world.designer_id), str(world.producer_id)}


@pytest.mark.slow
def test_a_designer_finds_their_own_alone(stage: Stage) -> None:
    world = stage.world
    stage.approve(stage.take(stage.cue(category="ui")), reasons=["Cleanest"])
    stage.approve(stage.take(stage.cue("other"), designer_id=world.producer_id), reasons=["Cleanest"])
    others = {"designer_id": str(world.producer_id)}
    for wanted in ({}, others):
        assert counts(stage, by=world.designer, **wanted)["pick"] == {"Cleanest": 1}
        (found,) = versions(stage, "pick", "Cleanest", by=world.designer, **wanted)["items"]
        assert found["cue_name"] == "shield_hit"
    seen = body_of(world.designer.get(f"/v1/projects/{world.project_id}/reasons"))
    assert (seen["designers"], seen["categories"]) == ([], ["ui"])


@pytest.mark.slow
def test_versions_come_newest_first_page_by_page(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(found_reasons, "PAGE_PLACES", 2)
    takes = [stage.take(stage.cue()) for _ in range(3)]
    for take_id in takes:
        stage.approve(take_id, reasons=["Cleanest"])
    first = versions(stage, "pick", "Cleanest")
    second = versions(stage, "pick", "Cleanest", cursor=first["next"])
    assert [one["take_id"] for page in (first, second) for one in page["items"]] == [
        str(take_id) for take_id in reversed(takes)
    ]
    assert second["next"] is None
    path = f"/v1/projects/{stage.world.project_id}/reasons/versions"
    bad = stage.world.reviewer.get(path, params={"kind": "pick", "reason": "Cleanest", "cursor": "no"})
    assert refused(bad) == (422, "bad-cursor")
