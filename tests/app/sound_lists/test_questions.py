"""A designer asks on a cue, and the answer becomes part of it."""

import pytest

from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.support.server import World


def a_cue(world: World) -> str:
    rows = {"cues": [{"name": "Coolant splash", "description": "Something falls in."}]}
    cue_id: str = world.producer.post(f"/v1/projects/{world.project_id}/cues", json=rows).json()[0]["id"]
    return cue_id


@pytest.mark.slow
def test_the_answer_joins_the_cue(world: World) -> None:
    cue_id = a_cue(world)
    asked = world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "A drop, a tool, a person?"})
    assert asked.status_code == 201, asked.text
    listed = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()
    assert listed["cues"][0]["open_questions"] == 1
    answer = world.approver.post(f"/v1/questions/{asked.json()['id']}/answer", json={"text": "A tool."})
    assert answer.status_code == 200, answer.text
    assert answer.json()["answered_by"]["name"] == "Audio director"
    cue = world.designer.get(f"/v1/cues/{cue_id}").json()
    assert cue["description"] == "Something falls in.\n\nA drop, a tool, a person? A tool."
    assert (cue["open_questions"], cue["edition"]) == (0, 2)
    assert cue["questions"][0]["answer"] == "A tool."
    again = world.approver.post(f"/v1/questions/{asked.json()['id']}/answer", json={"text": "A drop."})
    assert again.status_code == 409
    assert again.json()["code"] == "question-answered"


@pytest.mark.slow
def test_an_answer_need_not_join(world: World) -> None:
    cue_id = a_cue(world)
    asked = world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "When?"}).json()
    world.producer.post(f"/v1/questions/{asked['id']}/answer", json={"text": "Friday.", "joins": False})
    assert world.designer.get(f"/v1/cues/{cue_id}").json()["description"] == "Something falls in."


def test_an_owner_is_of_the_team_and_only_the_team_names_one(world: World) -> None:
    cue_id = a_cue(world)
    question = world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "When?"}).json()
    assert (question["owner"], question["due_on"], question["blocks"]) == (None, None, False)
    address = f"/v1/questions/{question['id']}"
    for client, status in ((world.designer, 403), (world.other_designer, 404), (world.stranger, 404)):
        assert client.patch(address, json={"blocks": True}).status_code == status
    refused = world.producer.patch(address, json={"owner_id": str(world.designer_id)})
    assert (refused.status_code, refused.json()["code"]) == (422, "question-owner-unknown")
    changes = {"owner_id": str(world.approver_id), "due_on": "2027-01-15", "blocks": True}
    changed = world.producer.patch(address, json=changes).json()
    assert (changed["owner"]["name"], changed["due_on"], changed["blocks"]) == ("Audio director", "2027-01-15", True)
    assert world.producer.patch(address, json={"owner_id": None}).json()["owner"] is None
    assert world.designer.get(f"/v1/cues/{cue_id}").json()["questions"][0]["due_on"] == "2027-01-15"


@pytest.mark.slow
def test_designers_do_not_learn_of_one_another(world: World) -> None:
    cue_id = a_cue(world)
    world.server.in_database(
        lambda session: session.add(
            Engagement(
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.other_designer_id,
                kind=EngagementKind.ADVISORY,
            )
        )
    )
    world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "How loud?"})
    url = f"/v1/projects/{world.project_id}/questions"
    assert world.other_designer.get(url).json()["items"][0]["asked_by"] is None
    assert world.designer.get(url).json()["items"][0]["asked_by"]["name"] == "Sound designer"
    assert world.producer.get(url).json()["items"][0]["asked_by"]["name"] == "Sound designer"


@pytest.mark.slow
def test_open_questions_alone(world: World) -> None:
    cue_id = a_cue(world)
    first = world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "One?"}).json()
    world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "Two?"})
    world.producer.post(f"/v1/questions/{first['id']}/answer", json={"text": "Yes."})
    url = f"/v1/projects/{world.project_id}/questions"
    assert [one["text"] for one in world.producer.get(url, params={"only_open": True}).json()["items"]] == ["Two?"]
    assert [one["text"] for one in world.producer.get(url).json()["items"]] == ["One?", "Two?"]


def test_who_may_answer(world: World) -> None:
    asked = world.designer.post(f"/v1/cues/{a_cue(world)}/questions", json={"text": "One?"}).json()
    url = f"/v1/questions/{asked['id']}/answer"
    assert world.designer.post(url, json={"text": "No."}).status_code == 403
    assert world.reviewer.post(url, json={"text": "No."}).status_code == 403
    assert world.stranger.post(url, json={"text": "No."}).status_code == 404
    assert world.nobody.post(url, json={"text": "No."}).status_code == 401
    assert world.designer.post(f"/v1/cues/{a_cue_again(world)}/questions", json={"text": "  "}).status_code == 422


def a_cue_again(world: World) -> str:
    cue_id: str = world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"][0]["id"]
    return cue_id
