"""A verdict taken back within its minute, and what then stands again."""

from datetime import timedelta

import pytest

from app.core import clock
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def later(seconds: float, monkeypatch: pytest.MonkeyPatch) -> None:
    """Let time pass."""
    now = clock.now()
    monkeypatch.setattr(clock, "now", lambda: now + timedelta(seconds=seconds))


@pytest.mark.slow
def test_undo_brings_everything_back(stage: Stage) -> None:
    cue = stage.cue()
    former = stage.take(cue)
    stage.approve(former)
    picked, other = stage.take(cue), stage.take(cue)
    stage.draft(picked, "brighter", start_s=0.2)
    stage.draft(other, "shorter")
    before = {take["id"]: (take["state"], take["state_since"]) for take in stage.review(cue)["takes"]}
    stage.approve(picked)
    undone = body_of(stage.undo(picked))
    assert undone["draft_dropped"] is False
    after = stage.review(cue)["takes"]
    assert {take["id"]: (take["state"], take["state_since"]) for take in after} == before
    drafts = {take["id"]: take["draft_change"] for take in after if take["draft_change"]}
    assert drafts[str(picked)]["text"] == "brighter"
    assert drafts[str(picked)]["start_s"] == 0.2
    assert drafts[str(other)]["text"] == "shorter"
    assert [one["kind"] for one in stage.review(cue)["verdicts"] if one["withdrawn"]] == ["set_aside"] * 2 + ["approve"]


@pytest.mark.slow
def test_undo_is_for_a_minute(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    early, late = stage.take(stage.cue("early")), stage.take(stage.cue("late"))
    drafted = stage.take(stage.cue("drafted"))
    stage.approve(early)
    stage.approve(late)
    stage.draft(drafted)
    later(55, monkeypatch)
    assert stage.undo(early).status_code == 200
    later(10, monkeypatch)
    assert refused(stage.undo(late)) == (409, "too-late-to-undo")
    assert refused(stage.undo(drafted)) == (409, "too-late-to-undo")
    assert stage.states(early, late) == ["conforming", "approved"]


def test_undo_drops_a_fresh_draft(stage: Stage) -> None:
    take = stage.take(stage.cue())
    stage.approve(take)
    stage.draft(take, "on second thoughts, duller", seen_state="approved")
    assert body_of(stage.undo(take)) == {
        "takes": [{"id": str(take), "variation": 1, "state": "approved"}],
        "draft_dropped": True,
    }
    assert body_of(stage.undo(take))["takes"][0]["state"] == "conforming"
    assert refused(stage.undo(take)) == (409, "nothing-to-undo")


@pytest.mark.slow
def test_undo_stops_where_something_later_stands(stage: Stage) -> None:
    cue = stage.cue()
    a, b = stage.take(cue), stage.take(cue)
    stage.approve(a)
    stage.approve(b, seen_state="set_aside")
    assert body_of(stage.undo(a))["takes"]  # what set `a` aside was the pick of `b`: one click, taken back whole
    assert stage.states(a, b) == ["approved", "set_aside"]
    stage.draft(a, "softer", seen_state="approved")
    assert refused(stage.undo(b)) == (409, "verdict-since")
    stage.send()
    assert refused(stage.undo(a)) == (409, "nothing-to-undo")
    assert refused(stage.undo(b)) == (409, "verdict-since")
    assert stage.states(a, b) == ["change_requested", "set_aside"]


@pytest.mark.slow
def test_an_approval_taken_back_has_not_happened_lately(stage: Stage) -> None:
    stays, goes = stage.take(stage.cue("laser_fire")), stage.take(stage.cue("shield_hit"))
    for take in (stays, goes):
        stage.approve(take)
    assert stage.undo(goes).status_code == 200
    overview = body_of(stage.world.producer.get(f"/v1/projects/{stage.world.project_id}/overview"))
    approved = [each["text"] for each in overview["lately"] if each["kind"] == "approved"]
    assert approved == ["approved laser_fire, version 1"]
