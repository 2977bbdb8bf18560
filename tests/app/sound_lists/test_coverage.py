"""The list is held against the brief: what the brief names and no cue is for."""

from typing import Any

import pytest

from app.sound_lists.coverage.rules import ListedCue, coverage, words_of
from app.sound_lists.rules import Need
from tests.support.deliver import add_cues
from tests.support.server import World


def cue(name: str, category: str = "", **texts: str) -> ListedCue:
    return ListedCue(category, name, *(texts.get(text, "") for text in ("file_name", "description", "use", "trigger")))


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("The boss’s roar", {"boss", "s", "roar"}),
        ("Low-health warnings", {"low", "health", "warning"}),
        ("Café at night", {"cafe", "night"}),
        ("glass", {"glass"}),
        ("the sound of", set()),
        ("海の音", {"海の音"}),
    ],
)
def test_words_that_carry_meaning(text: str, words: set[str]) -> None:
    assert words_of(text) == words


def scene(name: str, ambience: str = "", *, music: bool = False) -> dict[str, Any]:
    return {"scene": name, "ambience": ambience, "music": music}


def test_a_scene_needs_an_ambience_that_names_it() -> None:
    scenes = {"scenes": [scene("Harbour", "gulls"), scene("Engine room", "hum"), scene("Menu", music=True)]}
    cues = [cue("Gulls", "ambience", use="Harbours by day"), cue("Engine room door", "foley")]
    found = coverage(scenes, cues)
    assert (found.scenes_without_ambience, found.silent_scenes) == (["Engine room"], [])
    assert coverage({"scenes": [scene("Void")]}, []).silent_scenes == ["Void"]


def test_a_priority_sound_needs_a_cue_with_all_of_its_words() -> None:
    priority = {"priority": ["Shield hit", "Low health", "Coins"]}
    cues = [cue("shield_hit"), cue("Coin pick-up"), cue("Health pack", description="low thump")]
    assert coverage(priority, cues).priority_without_cue == []
    assert coverage(priority, [cue("shield_hit")]).priority_without_cue == ["Low health", "Coins"]


def test_a_priority_sound_that_is_only_a_wish_is_said() -> None:
    priority = {"priority": ["Shield hit", "Coins", "Siren"]}
    wish = cue("Coin pick-up")._replace(need=Need.WISH)
    found = coverage(priority, [cue("shield_hit"), cue("Shield hit again")._replace(need=Need.WISH), wish])
    assert (found.priority_as_wish, found.priority_without_cue) == (["Coins"], ["Siren"])
    assert coverage(priority, [wish, cue("Coins", "ui")._replace(need=Need.SHOULD)]).priority_as_wish == []


def test_categories_of_the_brief_have_cues() -> None:
    found = coverage({"categories": ["ui", "vehicle"]}, [cue("Confirm", "ui")])
    assert found.categories_without_cue == ["vehicle"]


def read(world: World, by: str = "producer") -> dict[str, Any]:
    answer = getattr(world, by).get(f"/v1/projects/{world.project_id}/sound-list/coverage")
    assert answer.status_code == 200, answer.text
    return dict(answer.json())


@pytest.mark.slow
def test_the_project_says_what_is_missing(world: World) -> None:
    scenes = ("scenes_without_ambience", "silent_scenes")
    fields = (*scenes, "categories_without_cue", "priority_without_cue", "priority_as_wish")
    nothing: dict[str, Any] = {field: [] for field in fields}
    assert read(world) == nothing
    answers = {
        "scenes": {"value": [scene("Harbour", "gulls")]},
        "categories": {"value": ["ui", "weapon"]},
        "priority": {"value": ["Shield hit"]},
    }
    body = {"revision": 0, "answers": answers}
    assert world.producer.patch(f"/v1/projects/{world.project_id}/brief", json=body).status_code == 200
    add_cues(world, {"name": "Confirm", "category": "ui"}, {"name": "Shield hit", "category": "weapon"})
    assert read(world, "designer") == nothing | {"scenes_without_ambience": ["Harbour"]}
    add_cues(world, {"name": "Harbour bed", "category": "ambience"})
    assert read(world) == nothing
    cues = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    shield = next(one["id"] for one in cues if one["name"] == "Shield hit")
    assert world.producer.post(f"/v1/cues/{shield}/cut", json={"reason": "No shields."}).status_code < 300
    assert read(world) == nothing | {"categories_without_cue": ["weapon"], "priority_without_cue": ["Shield hit"]}
    assert world.stranger.get(f"/v1/projects/{world.project_id}/sound-list/coverage").status_code == 404
