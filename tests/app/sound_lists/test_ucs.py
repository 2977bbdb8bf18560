"""Categories of the Universal Category System that a request may mean, and the press that sets one."""

import pytest

from app.sound_lists.categories.ucs_rules import (
    MOST_OFFERED,
    _meant,
    cat_id_of,
    is_ucs,
    ucs_candidates,
    ucs_categories,
)
from audio_checks import SpecError, parse_spec
from tests.support.server import World


def ids(name: str, description: str = "") -> set[str]:
    return {candidate.cat_id for candidate in ucs_candidates(name, description)}


def test_the_list_has_every_id_once_and_each_has_the_form_that_names_take() -> None:
    assert len(ucs_categories()) == 669
    assert len({entry.category for entry in ucs_categories().values()}) == 81
    written = ", ".join(f'"{cat_id}"' for cat_id in ucs_categories())
    try:
        parse_spec(f"format = 1\nnaming = {{ grammar = 'ucs', ucs_ids = [{written}] }}")
    except SpecError as error:
        pytest.fail(str(error))
    assert frozenset[str]().union(*_meant().values()) <= ucs_categories().keys()


@pytest.mark.parametrize(
    ("name", "description", "wanted"),
    [
        ("splash", "A splash", {"WATRImpt", "WATRDrip", "WATRMvmt", "WATRSplsh"}),
        ("Fence_break", "Fence breaks", {"GLASBrk", "WOODBrk", "METLBrk", "CERMBrk", "ROCKBrk"}),
        ("horse", "Horse gallops", {"ANMLHors", "FEETHors"}),
        ("door creak", "", {"DOORCreak"}),  # two words that speak of one category decide
        ("rain", "Rain on a metal roof", {"RAINMetl"}),
        ("splash", "A man of 400 pounds falls into the sea", set()),
        ("blorp", "", set()),
    ],
)
def test_the_categories_that_most_words_speak_of_are_candidates(name: str, description: str, wanted: set[str]) -> None:
    assert ids(name, description) == wanted


def test_a_word_that_only_names_a_whole_category_is_too_general() -> None:
    assert len(ids("door")) > MOST_OFFERED


def test_ids_and_whole_categories_are_of_the_system() -> None:
    assert all(is_ucs(category) for category in ("WATRSplsh", "watrsplsh", "Water", "Footsteps"))
    assert all(is_ucs(category) for category in ("User Interface", "user-interface", "dirt-&-sand"))
    assert not any(is_ucs(category) for category in ("hero", "user", ""))
    assert (cat_id_of("Water: splash"), cat_id_of("hero")) == ("WATRSplsh", "hero")


def test_the_check_counts_the_categories_and_an_answer_sets_one(world: World) -> None:
    project = f"/v1/projects/{world.project_id}"
    cue = world.producer.post(f"{project}/cues", json={"cues": [{"name": "splash"}]}).json()[0]

    def category_questions() -> list[dict[str, object]]:
        unclear = world.producer.get(f"{project}/clarity").json()["unclear"]
        return [question for cue in unclear for question in cue["questions"] if question["fact"] == "category"]

    (asked,) = category_questions()
    assert asked["question"] == "Which of 4 categories?"
    assert asked["answers"] == ["Water: drip", "Water: impact", "Water: movement", "Water: splash"]
    answer = f"/v1/cues/{cue['id']}/clarity/category/answer"
    assert world.designer.post(answer, json={"text": "Water: splash"}).status_code == 403
    assert world.producer.post(answer, json={"text": "Water: splash"}).status_code == 204
    changed = world.producer.get(f"/v1/cues/{cue['id']}").json()
    assert (changed["category"], changed["description"]) == ("watrsplsh", "")  # the list has categories in lower case
    assert category_questions() == []

    more = [{"name": "explosion"}, {"name": "hero jump", "category": "hero"}]
    world.producer.post(f"{project}/cues", json={"cues": more[:1]})
    assert len(category_questions()) == 1
    world.producer.post(f"{project}/cues", json={"cues": more[1:]})
    assert category_questions() == []  # the list files by categories of its own
