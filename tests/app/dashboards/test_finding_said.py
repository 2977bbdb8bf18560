"""The search finds versions by their reasons and labels, with who said it, within the caller's sight."""

from collections.abc import Callable
from typing import Any

import pytest
from httpx2 import Client

from app.dashboards.search.service import OF_A_KIND
from tests.app.reviews.making import Stage, body_of
from tests.support.server import RunningServer, World

KINDS = ("change_reason", "pick_reason", "label")
Search = Callable[..., list[dict[str, Any]]]


@pytest.fixture(autouse=True)
def _without_digests(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(server.runtime.settings, "digest_delay_s", 0.0)  # so that no job is left over


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


@pytest.fixture(params=["in the project", "in all projects"])
def search(request: pytest.FixtureRequest, stage: Stage) -> Search:
    """Search one project, or all that the person sees; return the reasons and labels."""
    path = f"/v1/projects/{stage.world.project_id}/find" if request.param == "in the project" else "/v1/find"

    def find(typed: str, by: Client | None = None) -> list[dict[str, Any]]:
        found = body_of((by or stage.world.reviewer).get(path, params={"q": typed}))
        return [hit for hit in found["hits"] if hit["kind"] in KINDS]

    return find


def change(stage: Stage, cue_name: str, *reasons: str, **facts: Any) -> str:
    take_id = stage.take(stage.cue(cue_name), **facts)
    stage.draft(take_id, ". ".join(reasons), reasons=list(reasons), start_s=0.25, end_s=0.5)
    stage.send()
    return str(take_id)


def label(stage: Stage, words: str, by: Client, **facts: Any) -> str:
    take_id = stage.take(stage.cue(), **facts)
    body_of(by.put(f"/v1/takes/{take_id}/label", json={"label": words}))
    return str(take_id)


@pytest.mark.slow
def test_a_reason_finds_its_version_with_who_said_it(stage: Stage, search: Search) -> None:
    take_id = change(stage, "laser", "Too long", "Off style")
    stage.approve(stage.take(stage.cue("door")), reasons=["Best timing"])
    (found,) = search("TOO long")
    assert (found["kind"], found["title"], found["text"]) == ("change_reason", "laser", "Too long, Off style")
    assert (found["take_id"], found["start_s"], found["cue"]["name"]) == (take_id, 0.25, "laser")
    said = found["said"]
    assert (said["variation"], said["number"], said["by"]["name"]) == (1, 1, "Audio director")
    assert said["on_behalf_of"] is None
    assert said["at"] is not None
    (found,) = search("timing")
    assert (found["kind"], found["title"], found["text"]) == ("pick_reason", "door", "Best timing")
    assert (found["start_s"], found["said"]["by"]["name"]) == (None, "Audio director")
    assert search("zzz") == []


def test_a_label_finds_its_version_with_who_set_it(stage: Stage, search: Search) -> None:
    take_id = label(stage, "very layered", stage.world.designer)
    (found,) = search("layered")
    assert (found["kind"], found["text"], found["take_id"]) == ("label", "very layered", take_id)
    assert (found["said"]["number"], found["said"]["by"]["name"]) == (1, "Sound designer")
    body_of(stage.world.producer.put(f"/v1/takes/{take_id}/label", json={"label": "wild"}))
    assert search("layered") == []
    assert search("wild")[0]["said"]["by"]["name"] == "Producer"


def test_a_verdict_is_one_hit_however_many_of_its_reasons_match(stage: Stage, search: Search) -> None:
    change(stage, "laser", "Too loud", "Too long")
    assert [hit["text"] for hit in search("too")] == ["Too loud, Too long"]


@pytest.mark.slow
def test_a_draft_and_a_verdict_that_was_taken_back_are_not_found(stage: Stage, search: Search) -> None:
    stage.draft(stage.take(stage.cue()), "Too long.", reasons=["Too long"])
    take_id = stage.take(stage.cue("door"))
    stage.approve(take_id, reasons=["Cleanest"])
    assert len(search("clean")) == 1
    body_of(stage.undo(take_id))
    assert search("clean") == search("too long") == []


@pytest.mark.parametrize("typed", ["doesn't", "doesn’t", "Doesn"])
def test_either_apostrophe_finds_the_reason(stage: Stage, search: Search, typed: str) -> None:
    change(stage, "laser", "Doesn’t read in game")
    assert len(search(typed)) == 1


@pytest.mark.slow
def test_a_designer_finds_what_was_said_of_their_own_versions(stage: Stage, search: Search) -> None:
    world = stage.world
    own, others = change(stage, "laser", "Too long"), change(stage, "door", "Too long", designer_id=world.producer_id)
    label(stage, "layered", world.producer, designer_id=world.producer_id)
    own_label = label(stage, "layered", world.producer)
    assert [hit["take_id"] for hit in search("too long")] == [others, own], "the team finds all, the newest first"
    assert [hit["take_id"] for hit in search("too long", by=world.designer)] == [own]
    assert len(search("layered")) == 2
    assert [hit["take_id"] for hit in search("layered", by=world.designer)] == [own_label]


@pytest.mark.slow
def test_a_stranger_finds_nothing(stage: Stage) -> None:
    world = stage.world
    change(stage, "laser", "Too long")
    label(stage, "layered", world.designer)
    for person in (world.stranger, world.other_designer):
        for typed in ("too long", "layered"):
            assert person.get(f"/v1/projects/{world.project_id}/find", params={"q": typed}).status_code == 404
            assert body_of(person.get("/v1/find", params={"q": typed}))["hits"] == []


@pytest.mark.slow
def test_a_designer_finds_nothing_before_the_nda_is_accepted(stage: Stage) -> None:
    world = stage.world
    change(stage, "laser", "Too long")
    label(stage, "layered", world.designer)
    body_of(world.producer.patch(f"/v1/projects/{world.project_id}", json={"nda_needed": True}))
    for typed in ("too long", "layered"):
        assert body_of(world.designer.get("/v1/find", params={"q": typed}))["hits"] == []


def test_a_discarded_version_is_not_found_by_its_label(stage: Stage, search: Search) -> None:
    take_id = label(stage, "layered", stage.world.designer)
    assert len(search("layered")) == 1
    path = f"/v1/projects/{stage.world.project_id}/takes/discard"
    assert stage.world.producer.post(path, json={"take_ids": [take_id]}).is_success
    assert search("layered") == []


def test_other_projects_are_searched_without_the_one_that_is_open(stage: Stage) -> None:
    change(stage, "laser", "Too long")
    wanted = {"q": "too long", "except_in": str(stage.world.project_id)}
    assert body_of(stage.world.reviewer.get("/v1/find", params=wanted))["hits"] == []


@pytest.mark.slow
def test_no_kind_fills_the_results_and_more_hits_cost_no_more_statements(stage: Stage, search: Search) -> None:
    change(stage, "laser", "Too long")
    label(stage, "too wild", stage.world.designer)
    search("too")
    with stage.world.server.counted_selects() as few:
        assert len(search("too")) == 2
    for _ in range(OF_A_KIND):
        change(stage, "laser", "Too long")
        label(stage, "too wild", stage.world.designer)
        stage.approve(stage.take(stage.cue()), reasons=["Too good"])
    with stage.world.server.counted_selects() as many:
        found = search("too")
    assert len(many) == len(few)
    assert [hit["kind"] for hit in found].count("label") == OF_A_KIND
    assert len(found) == 2 * OF_A_KIND, "reasons of changes and of picks count together"


@pytest.mark.slow
def test_hits_of_one_kind_do_not_push_out_those_of_another(stage: Stage) -> None:
    for _ in range(25):
        stage.take(stage.cue("long"), file_name="long.wav")
    change(stage, "laser", "Too long")
    hits = body_of(stage.world.reviewer.get(f"/v1/projects/{stage.world.project_id}/find", params={"q": "long"}))[
        "hits"
    ]
    assert [hit["kind"] for hit in hits] == [*["cue"] * 13, *["file"] * OF_A_KIND, "change_reason"]
