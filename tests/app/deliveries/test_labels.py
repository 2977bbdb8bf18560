"""Labels of takes: what each is among alternates."""

from typing import Any
from uuid import UUID

import pytest

from tests.app.reviews.making import Stage, body_of
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def label(stage: Stage, take_id: UUID, words: str | None, by: Any = None) -> Any:
    return (by or stage.world.reviewer).put(f"/v1/takes/{take_id}/label", json={"label": words})


def test_the_team_labels_and_each_page_shows_it(stage: Stage) -> None:
    cue_id = stage.cue()
    take_id = stage.take(cue_id, file_name="shield_hit_wild.wav")
    path = f"/v1/takes/{take_id}"
    assert body_of(stage.world.designer.get(path))["label"] is None, "a name of a file says nothing"
    said = body_of(label(stage, take_id, "  wild "))
    assert (said["label"], said["labelled_by"]["id"]) == ("wild", str(stage.world.reviewer_id))
    assert body_of(stage.world.designer.get(path))["label"] == "wild"
    (take,) = stage.review(cue_id)["takes"]
    assert take["label"] == "wild"
    assert stage.queue()[0]["takes"][0]["label"] == "wild"


def test_its_designer_labels_it_and_the_last_who_did_is_in_its_history(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    body_of(label(stage, take_id, "longer"))
    body_of(label(stage, take_id, "layered", by=stage.world.designer))
    entries = stage.world.designer.get(f"/v1/takes/{take_id}/history").json()
    labelled = [(entry["text"], entry["by"]["id"]) for entry in entries if entry["kind"] == "labelled"]
    assert labelled == [("layered", str(stage.world.designer_id))]


def test_a_label_that_is_there_already_stays_whose_it_was(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    body_of(label(stage, take_id, "dry", by=stage.world.designer))
    again = body_of(label(stage, take_id, "dry"))
    assert again["labelled_by"]["id"] == str(stage.world.designer_id)
    assert body_of(label(stage, take_id, None))["label"] is None


def test_another_designers_take_is_not_there(stage: Stage) -> None:
    take_id = stage.take(stage.cue(), designer_id=stage.world.producer_id)
    assert label(stage, take_id, "wild", by=stage.world.designer).status_code == 404


@pytest.mark.parametrize("words", ["", "   ", "x" * 41, "two\nlines", "nul\x00"])
def test_what_a_label_may_be(stage: Stage, words: str) -> None:
    assert label(stage, stage.take(stage.cue()), words).status_code == 422
