"""Checklists by category, and what is open blocks approval where the project wants it."""

from typing import Any
from uuid import UUID, uuid4

import pytest

from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def write(stage: Stage, *items: str, category: str = "") -> dict[str, str]:
    """Write a checklist, and return the ids of its items by text."""
    path = f"/v1/projects/{stage.world.project_id}/checklist"
    settings = body_of(stage.world.producer.put(path, json={"category": category, "items": list(items)}))
    return {item["text"]: item["id"] for setting in settings["checklists"] for item in setting["items"]}


def block(stage: Stage, blockers: str) -> None:
    path = f"/v1/projects/{stage.world.project_id}/approval-blockers"
    assert body_of(stage.world.producer.put(path, json={"blockers": blockers}))["blockers"] == blockers


def check(stage: Stage, take_id: UUID, item_id: str, *, is_checked: bool = True, by: Any = None) -> None:
    path = f"/v1/takes/{take_id}/checklist/{item_id}"
    answer = (by or stage.world.reviewer).put(path, json={"is_checked": is_checked})
    assert answer.status_code == 204, answer.text


def comment(stage: Stage, take_id: UUID, **more: Any) -> dict[str, Any]:
    answer = stage.world.reviewer.post(f"/v1/takes/{take_id}/comments", json={"text": "A click.", **more})
    assert answer.status_code == 201, answer.text
    said: dict[str, Any] = answer.json()
    return said


@pytest.mark.slow
def test_items_of_every_cue_stand_before_those_of_the_category(stage: Stage) -> None:
    cue_id = stage.cue(category="ui")
    stage.take(cue_id)
    write(stage, "Fits the mood", "No clicks")
    write(stage, "Short enough", category="UI")
    write(stage, "Loops", category="ambience")
    texts = [item["text"] for item in stage.review(cue_id)["checklist"]["items"]]
    assert texts == ["Fits the mood", "No clicks", "Short enough"]


@pytest.mark.slow
def test_who_checked_an_item_of_which_version_is_kept(stage: Stage) -> None:
    cue_id = stage.cue()
    first, second = stage.take(cue_id), stage.take(cue_id)
    clicks = write(stage, "No clicks")["No clicks"]
    check(stage, first, clicks)
    check(stage, first, clicks, by=stage.world.approver)  # the first who checked it is kept
    (kept,) = stage.review(cue_id)["checklist"]["checks"]
    assert (kept["take_id"], kept["item_id"], kept["by"]["id"]) == (str(first), clicks, str(stage.world.reviewer_id))
    check(stage, first, clicks, is_checked=False)
    check(stage, second, clicks, is_checked=False)
    assert stage.review(cue_id)["checklist"]["checks"] == []


@pytest.mark.slow
def test_an_item_written_as_before_keeps_its_checks_and_another_has_none(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    before = write(stage, "No clicks", "Fits")
    check(stage, take_id, before["No clicks"])
    assert write(stage, "Fits", "No clicks")["No clicks"] == before["No clicks"]
    write(stage, "Fits the game")
    assert stage.review(cue_id)["checklist"]["items"][0]["text"] == "Fits the game"
    assert write(stage, "No clicks")["No clicks"] == before["No clicks"]
    assert len(stage.review(cue_id)["checklist"]["checks"]) == 1


def test_nothing_blocks_until_a_producer_sets_it(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    write(stage, "No clicks")
    comment(stage, take_id)
    assert stage.approve(take_id)["state"] == "approved"


@pytest.mark.slow
def test_unchecked_items_block_approval_in_words_until_they_are_checked(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    clicks = write(stage, "No clicks")["No clicks"]
    block(stage, "items")
    why = "“No clicks” is not checked"
    assert stage.review(cue_id)["checklist"]["blocked"] == [{"take_id": str(take_id), "why": why}]
    comment(stage, take_id)  # notes block nothing here
    answer = stage.verdict(take_id, "approve")
    assert refused(answer) == (409, "approval-blocked")
    assert answer.json()["detail"] == f"nothing was approved of shield_hit. version 1: {why}"
    assert "check the items" in answer.json()["fix"]
    assert stage.states(take_id) == ["conforming"]
    check(stage, take_id, clicks)
    assert stage.review(cue_id)["checklist"]["blocked"] == []
    stage.approve(take_id)


@pytest.mark.slow
def test_the_queue_says_beforehand_which_versions_cannot_be_approved_yet(stage: Stage) -> None:
    shield, laser = stage.cue(category="weapon"), stage.cue(name="laser", category="ui")
    first, later, other = stage.take(shield), stage.take(shield), stage.take(laser)
    clicks = write(stage, "No clicks")["No clicks"]
    fits = write(stage, "Fits the palette", category="weapon")["Fits the palette"]
    comment(stage, later)

    def blocked() -> dict[str, str]:
        items = body_of(stage.world.approver.get(f"/v1/review-queue?project_id={stage.world.project_id}"))["items"]
        for item in items:
            assert item["blocked"] == stage.review(UUID(item["cue"]["id"]))["checklist"]["blocked"]
        return {one["take_id"]: one["why"] for item in items for one in item["blocked"]}

    assert blocked() == {}
    block(stage, "both")
    both = "“No clicks”, “Fits the palette” are not checked"
    assert blocked() == {
        str(first): both,
        str(later): f"1 comment is not resolved; {both}",
        str(other): "“No clicks” is not checked",
    }
    check(stage, other, clicks)
    check(stage, later, fits)
    assert blocked() == {str(first): both, str(later): "1 comment is not resolved; “No clicks” is not checked"}
    block(stage, "notes")
    assert blocked() == {str(later): "1 comment is not resolved"}


@pytest.mark.slow
def test_comments_that_are_not_resolved_block_and_replies_do_not(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    write(stage, "No clicks")
    block(stage, "notes")
    said = comment(stage, take_id)
    comment(stage, take_id, reply_to_id=said["id"])
    answer = stage.verdict(take_id, "approve")
    assert refused(answer) == (409, "approval-blocked")
    assert "version 1: 1 comment is not resolved" in answer.json()["detail"]
    body_of(stage.world.reviewer.post(f"/v1/comments/{said['id']}/resolve"))
    stage.approve(take_id)


@pytest.mark.slow
def test_a_note_on_an_earlier_version_blocks_until_it_is_done(stage: Stage) -> None:
    cue_id = stage.cue()
    stage.draft(stage.take(cue_id), "a duller clank")
    stage.send()
    second = stage.take(cue_id)
    block(stage, "both")
    assert "1 note on an earlier version is not done" in stage.verdict(second, "approve").json()["detail"]
    (note,) = stage.review(cue_id)["carried_notes"]
    body_of(stage.world.reviewer.post(f"/v1/takes/{second}/carried-notes/{note['id']}", json={"is_done": True}))
    stage.approve(second)


def test_setting_aside_and_requesting_a_change_are_never_blocked(stage: Stage) -> None:
    cue_id = stage.cue()
    first, second = stage.take(cue_id), stage.take(cue_id)
    write(stage, "No clicks")
    block(stage, "both")
    stage.draft(first)
    body_of(stage.verdict(second, "set_aside"))


@pytest.mark.slow
def test_a_set_is_refused_as_a_whole_and_names_each_version_that_is_open(stage: Stage) -> None:
    cue_id = stage.cue(variations=3)
    takes = [stage.take(cue_id, variation) for variation in (1, 2, 3)]
    clicks = write(stage, "No clicks")["No clicks"]
    block(stage, "items")
    check(stage, takes[1], clicks)
    answer = stage.world.approver.post(f"/v1/cues/{cue_id}/accept-set", json={})
    assert refused(answer) == (409, "approval-blocked")
    assert [one["where"] for one in answer.json()["errors"]] == [str(takes[0]), str(takes[2])]
    assert "variation 3" in answer.json()["detail"]
    assert stage.states(*takes) == ["conforming"] * 3
    for take_id in (takes[0], takes[2]):
        check(stage, take_id, clicks)
    assert body_of(stage.world.approver.post(f"/v1/cues/{cue_id}/accept-set", json={}))["cue_accepted"]


@pytest.mark.slow
def test_only_a_producer_writes_checklists_and_blockers(stage: Stage) -> None:
    project = f"/v1/projects/{stage.world.project_id}"
    for path, body in (("checklist", {"category": "", "items": []}), ("approval-blockers", {"blockers": "both"})):
        assert stage.world.reviewer.put(f"{project}/{path}", json=body).status_code == 403
        assert stage.world.designer.put(f"{project}/{path}", json=body).status_code == 403
    assert stage.world.designer.get(f"{project}/approval-settings").status_code == 403


def test_a_designer_checks_nothing_and_an_item_of_another_category_is_not_found(stage: Stage) -> None:
    take_id = stage.take(stage.cue(category="ui"))
    loops = write(stage, "Loops", category="ambience")["Loops"]
    clicks = write(stage, "No clicks")["No clicks"]
    checked = {"is_checked": True}
    assert stage.world.designer.put(f"/v1/takes/{take_id}/checklist/{clicks}", json=checked).status_code == 403
    for item_id in (loops, str(uuid4())):
        answer = stage.world.reviewer.put(f"/v1/takes/{take_id}/checklist/{item_id}", json=checked)
        assert refused(answer) == (404, "checklist-item-not-found")


@pytest.mark.parametrize("items", [["No clicks", " No clicks "], [""], ["x" * 201], ["x"] * 31])
def test_a_checklist_that_is_wrong_is_refused(stage: Stage, items: list[str]) -> None:
    path = f"/v1/projects/{stage.world.project_id}/checklist"
    assert stage.world.producer.put(path, json={"category": "", "items": items}).status_code == 422
