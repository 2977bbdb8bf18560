"""The lists of a designer's desk come in pages, which together hold each thing once, in order."""

from collections.abc import Iterator
from typing import Any

import pytest

from app.dashboards import queries
from app.deliveries.rules import TakeState
from tests.app.reviews.making import Stage
from tests.support.server import World

CUES = 53


def pages(world: World, path: str) -> Iterator[list[Any]]:
    query: dict[str, str] = {}
    while True:
        answer = world.designer.get(f"/v1/projects/{world.project_id}/desk/{path}", params=query)
        assert answer.status_code == 200, answer.text
        yield answer.json()["items"]
        if (cursor := answer.json()["next"]) is None:
            return
        query = {"cursor": cursor}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("state", "path", "key", "first"),
    [
        (None, "to-make", "to_make", 50),
        (TakeState.CONFORMING, "with-approver", "with_approver", 50),
        (TakeState.RETURNED, "came-back", "came_back", 20),
    ],
)
def test_pages_hold_each_thing_once(world: World, state: TakeState | None, path: str, key: str, first: int):
    stage = Stage(world)
    for place in range(CUES):
        cue_id = stage.cue(f"sound_{place:02}")
        if state is not None:
            stage.take(cue_id, state=state)
    desk = world.designer.get(f"/v1/projects/{world.project_id}/desk").json()
    found = list(pages(world, path))
    assert (desk[key], desk[f"{key}_cues"], len(desk[key])) == (found[0], CUES, first)
    assert desk[f"{key}_next"] is not None
    named = [(one.get("cue") or one)["name"] for page in found for one in page]
    assert named == [f"sound_{place:02}" for place in range(CUES)]


def test_what_came_back_of_an_accepted_or_a_cut_cue_is_not_there(world: World):
    stage = Stage(world)
    accepted, wanted = stage.cue("accepted"), stage.cue("wanted")
    for cue_id, state in ((accepted, TakeState.APPROVED), (accepted, TakeState.RETURNED), (wanted, TakeState.RETURNED)):
        stage.take(cue_id, state=state)
    gone = stage.cue("gone")
    stage.take(gone, state=TakeState.CHANGE_REQUESTED)
    cut = world.approver.post(f"/v1/cues/{gone}/cut", json={"reason": "no such level"})
    assert cut.status_code < 300, cut.text
    desk = world.designer.get(f"/v1/projects/{world.project_id}/desk").json()
    assert [one["cue"]["name"] for one in desk["came_back"]] == ["wanted"]
    assert (desk["came_back_cues"], desk["came_back_next"], desk["accepted"], desk["cues"]) == (1, None, 1, 2)


@pytest.mark.parametrize("path", ["to-make", "with-approver", "came-back"])
def test_a_bad_cursor_is_refused_and_strangers_see_nothing(world: World, path: str):
    answer = world.designer.get(f"/v1/projects/{world.project_id}/desk/{path}", params={"cursor": "yesterday"})
    assert (answer.status_code, answer.json()["code"]) == (422, "bad-cursor")
    for who, status in ((world.producer, 403), (world.stranger, 404), (world.nobody, 401)):
        assert who.get(f"/v1/projects/{world.project_id}/desk/{path}").status_code == status


def test_it_brings_every_open_question_and_the_answers_given_last(
    world: World, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(queries, "ANSWERED", 1)
    url = f"/v1/cues/{Stage(world).cue('laser_fire')}/questions"
    asked = [world.designer.post(url, json={"text": text}).json() for text in ("One?", "Two?", "Three?")]
    for question in (asked[1], asked[0]):
        world.producer.post(f"/v1/questions/{question['id']}/answer", json={"text": "Yes."})
    desk = world.designer.get(f"/v1/projects/{world.project_id}/desk").json()
    answers = [(question["text"], question["answer"]) for question in desk["questions"]]
    assert answers == [("One?", "Yes."), ("Three?", None)]
