"""Notes move on to the next version, until a person marks them as done."""

from typing import Any
from uuid import UUID, uuid4

import pytest

from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World

pytestmark = pytest.mark.both_databases


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def comment(by: Any, take_id: UUID, text: str, **more: Any) -> dict[str, Any]:
    answer = by.post(f"/v1/takes/{take_id}/comments", json={"text": text, **more})
    assert answer.status_code == 201, answer.text
    said: dict[str, Any] = answer.json()
    return said


def answer(by: Any, take_id: UUID, note: dict[str, Any] | UUID, *, is_done: bool) -> Any:
    note_id = note["id"] if isinstance(note, dict) else note
    return by.post(f"/v1/takes/{take_id}/carried-notes/{note_id}", json={"is_done": is_done})


def returned(stage: Stage, cue_id: UUID) -> UUID:
    """Deliver a version, comment on it, ask a change at a place, and send it."""
    take_id = stage.take(cue_id)
    comment(stage.world.reviewer, take_id, "The tail is long.", start_s=0.5)
    stage.draft(take_id, "a duller clank", start_s=0.2, end_s=0.4)
    stage.send()
    return take_id


def notes_of(stage: Stage, cue_id: UUID) -> list[dict[str, Any]]:
    notes: list[dict[str, Any]] = stage.review(cue_id)["carried_notes"]
    return notes


def open_notes(stage: Stage) -> int:
    (item,) = stage.queue()
    count: int = item["open_notes"]
    return count


@pytest.mark.slow
def test_what_was_said_of_a_version_stands_at_the_next_one_with_its_place(stage: Stage) -> None:
    cue_id = stage.cue()
    first = returned(stage, cue_id)
    assert stage.queue() == []
    stage.take(cue_id)
    tail, clank = notes_of(stage, cue_id)
    assert (tail["kind"], tail["text"], tail["start_s"], tail["answer"]) == ("comment", "The tail is long.", 0.5, None)
    assert (clank["kind"], clank["text"]) == ("change", "a duller clank")
    assert (clank["start_s"], clank["end_s"], clank["decides"]) == (0.2, 0.4, True)
    assert {(note["take_id"], note["variation"], note["number"]) for note in (tail, clank)} == {(str(first), 1, 1)}
    assert open_notes(stage) == 2


@pytest.mark.slow
def test_who_said_done_and_of_which_version_is_kept_and_what_is_open_counts(stage: Stage) -> None:
    cue_id = stage.cue()
    first = returned(stage, cue_id)
    second = stage.take(cue_id)
    tail, clank = notes_of(stage, cue_id)
    done = body_of(answer(stage.world.reviewer, second, tail, is_done=True))
    assert (done["answer"]["is_done"], done["answer"]["number"]) == (True, 2)
    assert done["answer"]["given_by"]["id"] == str(stage.world.reviewer_id)
    assert open_notes(stage) == 1
    body_of(answer(stage.world.approver, second, clank, is_done=True))
    assert open_notes(stage) == 0
    again = body_of(answer(stage.world.approver, second, clank, is_done=False))
    assert again["answer"]["is_done"] is False
    assert open_notes(stage) == 1
    comments = body_of_list(stage.world.reviewer.get(f"/v1/takes/{first}/comments"))
    assert [one["resolved_at"] is not None for one in comments] == [True]


def body_of_list(given: Any) -> list[dict[str, Any]]:
    assert given.status_code == 200, given.text
    items: list[dict[str, Any]] = given.json()
    return items


@pytest.mark.slow
def test_what_is_still_open_moves_on_again_and_what_is_done_does_not(stage: Stage) -> None:
    cue_id = stage.cue()
    returned(stage, cue_id)
    second = stage.take(cue_id)
    tail, clank = notes_of(stage, cue_id)
    body_of(answer(stage.world.approver, second, tail, is_done=True))
    body_of(answer(stage.world.approver, second, clank, is_done=False))
    stage.draft(second, "the clank again")
    stage.send()
    third = stage.take(cue_id)
    assert open_notes(stage) == 2
    answers = {note["text"]: note["answer"] for note in notes_of(stage, cue_id)}
    assert answers["The tail is long."]["number"] == 2
    assert answers["a duller clank"]["is_done"] is False
    assert answers["the clank again"] is None
    body_of(answer(stage.world.approver, third, clank, is_done=True))
    assert open_notes(stage) == 1


@pytest.mark.slow
def test_an_approval_answers_what_is_left_and_its_undo_takes_that_back(stage: Stage) -> None:
    cue_id = stage.cue()
    returned(stage, cue_id)
    second = stage.take(cue_id)
    before = notes_of(stage, cue_id)
    tail, clank = before
    stage.approve(second)
    for note in notes_of(stage, cue_id):
        assert (note["answer"]["is_done"], note["answer"]["number"]) == (True, 2)
        assert note["answer"]["given_by"]["id"] == str(stage.world.approver_id)
    assert stage.undo(second).status_code == 200
    assert notes_of(stage, cue_id) == before
    body_of(answer(stage.world.reviewer, second, clank, is_done=False))
    stage.approve(second)
    done = {note["id"]: note["answer"]["is_done"] for note in notes_of(stage, cue_id)}
    assert done == {tail["id"]: True, clank["id"]: False}, "what was said to be open of this version stays so"


@pytest.mark.slow
def test_an_approval_says_nothing_of_notes_on_other_variations(stage: Stage) -> None:
    cue_id = stage.cue(variations=2)
    returned(stage, cue_id)
    other = stage.take(cue_id, 2)
    stage.take(cue_id)
    stage.approve(other)
    assert [note["answer"] for note in notes_of(stage, cue_id)] == [None, None]


@pytest.mark.slow
def test_an_earlier_version_that_is_approved_in_the_end_answers_no_note_on_a_later_one(stage: Stage) -> None:
    cue_id = stage.cue()
    first = stage.take(cue_id)
    second = stage.take(cue_id)
    stage.draft(second, "a duller clank")
    stage.send()
    stage.approve(first)
    assert [(note["number"], note["answer"]) for note in notes_of(stage, cue_id)] == [(2, None)]


@pytest.mark.slow
def test_saying_the_same_twice_says_it_once(stage: Stage) -> None:
    cue_id = stage.cue()
    returned(stage, cue_id)
    second = stage.take(cue_id)
    tail, _ = notes_of(stage, cue_id)
    once = body_of(answer(stage.world.approver, second, tail, is_done=True))
    assert body_of(answer(stage.world.reviewer, second, tail, is_done=True)) == once


@pytest.mark.slow
def test_replies_and_what_its_designer_said_and_notes_of_what_still_waits_are_not_carried(stage: Stage) -> None:
    cue_id = stage.cue()
    first = stage.take(cue_id)
    asked = comment(stage.world.reviewer, first, "Too long?")
    comment(stage.world.designer, first, "By 0.2 s.", reply_to_id=asked["id"])
    comment(stage.world.designer, first, "Made of three bowls.")
    assert notes_of(stage, cue_id) == []
    stage.draft(first)
    stage.send()
    stage.take(cue_id)
    assert [note["text"] for note in notes_of(stage, cue_id)] == ["Too long?", "a duller clank"]


@pytest.mark.slow
def test_only_a_note_on_an_earlier_version_of_the_same_variation_is_answered(stage: Stage) -> None:
    cue_id = stage.cue(variations=2)
    first = returned(stage, cue_id)
    second, other = stage.take(cue_id), stage.take(cue_id, 2)
    tail, _ = notes_of(stage, cue_id)
    for take_id, note in ((first, tail), (other, tail), (second, uuid4())):
        assert refused(answer(stage.world.approver, take_id, note, is_done=True)) == (404, "note-not-found")


def test_a_designer_reads_the_change_and_does_not_say_that_it_is_done(stage: Stage) -> None:
    cue_id = stage.cue()
    returned(stage, cue_id)
    second = stage.take(cue_id)
    tail, _ = notes_of(stage, cue_id)
    assert answer(stage.world.designer, second, tail, is_done=True).status_code == 403
