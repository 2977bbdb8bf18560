"""The clarity check asks for what a designer needs and cannot find, and for little else."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from app.sound_lists.clarity.rules import MAX_QUESTIONS, Fact, Kind, lexicon, questions
from tests.support.server import World

REQUESTS = Path(__file__).parent / "clarity"


def requests(file_name: str) -> Iterator[tuple[str, str, bool, bool, set[str]]]:
    for line in (REQUESTS / file_name).read_text(encoding="utf-8").splitlines():
        name, said, loop, length, facts = (field.strip() for field in line.split("|"))
        wanted = set() if facts == "clear" else {fact.strip() for fact in facts.split(",")}
        yield name, said, loop == "loop", length != "-", wanted


def rates(file_name: str) -> tuple[float, float]:
    """Return which share of the missing facts is asked for, and how many needless questions a cue gets."""
    wanted = asked = needless = cues = 0
    for name, said, loop, has_length, facts in requests(file_name):
        got = {question.fact.value for question in questions(name, "", said, loop, has_length)}
        cues, wanted, asked = cues + 1, wanted + len(facts), asked + len(facts & got)
        needless += len(got - facts)
    return asked / wanted, needless / cues


@pytest.mark.parametrize(
    ("file_name", "least_asked", "most_needless"),
    [
        ("worked_on.txt", 0.92, 0.12),
        ("by_others.txt", 0.95, 0.05),
    ],
)
def test_most_of_what_is_missing_is_asked_and_little_else(
    file_name: str, least_asked: float, most_needless: float
) -> None:
    asked, needless = rates(file_name)
    assert asked >= least_asked
    assert needless <= most_needless


def facts_of(name: str, description: str = "", *, category: str = "", loop: bool = False, has_length: bool = False):
    return [question.fact for question in questions(name, category, description, loop, has_length)]


def test_a_splash_is_asked_for_what_the_field_asks() -> None:
    assert facts_of("splash", "A splash") == [Fact.SOURCE, Fact.SIZE, Fact.PLACE]
    assert facts_of("splash", "A man of 400 pounds falls into the sea") == []


def test_a_few_words_that_say_nothing_known_leave_open_what_makes_the_sound() -> None:
    assert facts_of("blorp_01", "Blorps twice") == [Fact.SOURCE]
    assert facts_of("blorp_01", "The blorp of a thick brown glimmering flurf over its edge") == []


def test_the_category_speaks_where_the_words_do_not() -> None:
    assert facts_of("level_3", "as before", category="ambience") == [Fact.PLACE, Fact.MOOD, Fact.LOOP]
    assert facts_of("level_3", "as before", category="ambience", loop=True) == [Fact.PLACE, Fact.MOOD]


def test_a_voice_line_is_asked_for_what_is_spoken_and_never_for_a_mood_or_a_place() -> None:
    line = [Fact.CHARACTER, Fact.WORDS, Fact.DIRECTION]
    assert facts_of("vo_captain_010", category="vo") == line
    assert facts_of("captain_010", "the first of three", category="dialogue") == line
    assert facts_of("captain_010", 'A guard, angry: "Halt at once!"', category="vo") == []
    assert facts_of("captain_010", "A woman", category="voice") == [Fact.WORDS, Fact.DIRECTION]
    scripted = "Voice line captain_010 of Captain, de: its text is with the voice lines."
    assert facts_of("de_captain_010", scripted, category="vo") == []
    said = "The second line"
    for question in questions("captain_010", "vo", said, False, False):
        said += f". {question.fact.value.capitalize()}: {question.answers[0]}"
    assert facts_of("captain_010", said, category="vo") == []


@pytest.mark.parametrize(
    ("name", "said", "facts"),
    [
        ("fox", "Fox", [Fact.MOOD]),  # an animal that only WordNet's list has
        ("sousaphone", "Bassoon", [Fact.MOOD, Fact.LENGTH]),
        ("barge", "Barge passes", [Fact.DISTANCE, Fact.INTENSITY]),
    ],
)
def test_a_thing_is_known_by_what_it_is(name: str, said: str, facts: list[Fact]) -> None:
    assert facts_of(name, said) == facts


def test_a_word_with_one_slip_is_still_read() -> None:
    assert facts_of("sfx_3", "Explosin") == facts_of("sfx_3", "Explosion") != facts_of("sfx_3", "Explosingly")


def test_the_same_word_needs_other_facts_beside_another() -> None:
    assert facts_of("hurt", "Hero hurt") == [Fact.SOURCE, Fact.INTENSITY]
    assert facts_of("hurt", "Monster hurt") == [Fact.SOURCE, Fact.SIZE]


def test_a_description_of_seven_words_leaves_nothing_open_but_something() -> None:
    assert facts_of("steps", "The guard of the north tower walks") == []
    assert facts_of("steps", "Something of the north tower slowly walks") == [Fact.SOURCE, Fact.SURFACE]


def test_answers_make_no_request_long() -> None:
    said = "A splash. Source: a tool. Size: under 1 kg, as it was drawn in the film."
    assert facts_of("splash", said) == [Fact.PLACE]


def test_a_cry_without_words_is_asked_as_a_sound() -> None:
    assert Fact.WORDS not in facts_of("guard_scream", category="vo")


def test_what_was_answered_is_not_asked_again() -> None:
    said = "A splash"
    for question in questions("splash", "", said, False, False):
        said += f". {question.fact.value.capitalize()}: blorp"
    assert facts_of("splash", said) == []


@pytest.mark.parametrize("kind", lexicon().kinds, ids=lambda kind: min(kind.words))
def test_each_answer_that_is_offered_answers_its_question(kind: Kind) -> None:
    assert len({one.fact for one in kind.needs}) == len(kind.needs)
    for need in kind.needs:
        assert 2 <= len(need.answers) <= MAX_QUESTIONS
        for answer in need.answers:
            said = f"{need.fact.value.capitalize()}: {answer}."
            assert need.fact not in facts_of(sorted(kind.words)[0], said)


def test_no_request_is_asked_more_than_a_reader_takes_in() -> None:
    assert max(len(facts_of(word)) for kind in lexicon().kinds for word in kind.words) == MAX_QUESTIONS


@pytest.mark.slow
def test_the_list_names_what_is_open_and_an_answer_joins_the_description(world: World) -> None:
    project = f"/v1/projects/{world.project_id}"
    splash = {"name": "Splash", "description": "A splash.", "category": "pond"}
    cue = world.producer.post(f"{project}/cues", json={"cues": [splash]}).json()[0]

    def open_facts(person: Any) -> list[str]:
        unclear = person.get(f"{project}/clarity").json()["unclear"]
        return next(([one["fact"] for one in each["questions"]] for each in unclear if each["cue_id"] == cue["id"]), [])

    assert open_facts(world.designer) == ["source", "size", "place"]
    path = f"/v1/cues/{cue['id']}/clarity"
    assert world.producer.post(f"{path}/source/answer", json={"text": " a  tool "}).status_code == 204
    assert world.producer.put(f"{path}/size/dismissed", json={"dismissed": True}).status_code == 204
    assert open_facts(world.producer) == ["place"]
    changed = world.producer.get(f"/v1/cues/{cue['id']}").json()
    assert (changed["description"], changed["edition"]) == ("A splash. Source: a tool.", 2)

    world.producer.put(f"{path}/size/dismissed", json={"dismissed": False})
    assert open_facts(world.producer) == ["size", "place"]


def test_bounds_of_a_length_count_as_a_length(world: World) -> None:
    project = f"/v1/projects/{world.project_id}"
    bounds: list[dict[str, float]] = [{}, {"duration_min_s": 1}, {"duration_max_s": 2}]
    cues = [{"name": f"Stone splash {number}", "category": "pond", **each} for number, each in enumerate(bounds)]
    added = world.producer.post(f"{project}/cues", json={"cues": cues}).json()
    unclear = [cue["cue_id"] for cue in world.producer.get(f"{project}/clarity").json()["unclear"]]
    assert [cue["id"] in unclear for cue in added] == [True, False, False]


def test_only_the_team_answers_and_strangers_see_nothing(world: World) -> None:
    cues = world.producer.post(f"/v1/projects/{world.project_id}/cues", json={"cues": [{"name": "Splash"}]}).json()
    path = f"/v1/cues/{cues[0]['id']}/clarity"
    assert world.designer.post(f"{path}/size/answer", json={"text": "small"}).status_code == 403
    assert world.designer.put(f"{path}/size/dismissed", json={"dismissed": True}).status_code == 403
    assert world.stranger.get(f"/v1/projects/{world.project_id}/clarity").status_code == 404
    assert world.stranger.post(f"{path}/size/answer", json={"text": "small"}).status_code == 404
    assert world.producer.post(f"{path}/colour/answer", json={"text": "red"}).status_code == 422


@pytest.mark.slow
def test_a_cut_cue_is_not_asked_about(world: World) -> None:
    project = f"/v1/projects/{world.project_id}"
    cue = world.producer.post(f"{project}/cues", json={"cues": [{"name": "Impact"}]}).json()[0]
    world.approver.post(f"/v1/cues/{cue['id']}/cut", json={"reason": "the scene is gone"})
    unclear = world.producer.get(f"{project}/clarity").json()["unclear"]
    assert cue["id"] not in [one["cue_id"] for one in unclear]
    refused = world.producer.post(f"/v1/cues/{cue['id']}/clarity/source/answer", json={"text": "a tool"})
    assert refused.status_code == 409
