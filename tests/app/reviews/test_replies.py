"""Replies are below the note that they answer, and notify its author."""

from typing import Any
from uuid import uuid4

import pytest
from httpx2 import Client

from tests.app.reviews.making import Stage
from tests.support.server import World


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def say(by: Client, take_id: Any, text: str, **more: Any) -> Any:
    return by.post(f"/v1/takes/{take_id}/comments", json={"text": text, **more})


def sent_change(stage: Stage, take_id: Any) -> str:
    stage.draft(take_id, "a duller clank")
    stage.send()
    (request,) = stage.world.approver.get(f"/v1/projects/{stage.world.project_id}/change-requests").json()["items"]
    return str(request["id"])


@pytest.mark.slow
def test_a_designer_replies_to_a_change_and_the_desk_shows_the_conversation(stage: Stage) -> None:
    take_id = stage.take(stage.cue())
    change_id = sent_change(stage, take_id)
    answer = say(stage.world.designer, take_id, "Duller as in darker?", change_request_id=change_id)
    assert answer.status_code == 201
    assert answer.json()["change_request_id"] == change_id
    again = say(stage.world.approver, take_id, "Darker, yes.", reply_to_id=answer.json()["id"])
    assert (again.json()["reply_to_id"], again.json()["change_request_id"]) == (None, change_id)
    (back,) = stage.world.designer.get(f"/v1/projects/{stage.world.project_id}/desk").json()["came_back"]
    assert back["changes"][0]["id"] == change_id
    assert [comment["text"] for comment in back["comments"]] == ["Duller as in darker?", "Darker, yes."]


@pytest.mark.slow
def test_a_reply_is_mailed_to_who_wrote_the_note(stage: Stage) -> None:
    world = stage.world
    take_id = stage.take(stage.cue())
    note = say(world.reviewer, take_id, "Is it too long?").json()
    say(world.designer, take_id, "As long as the brief says.", reply_to_id=note["id"])
    say(world.designer, take_id, "0.8 s.", reply_to_id=note["id"])
    world.server.wait_for_jobs()
    mails = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    (mail,) = [mail for mail in mails if mail["subject"].endswith("a reply to your note")]
    assert "0.8 s." in mail["text"]


@pytest.mark.slow
def test_a_designer_whose_work_has_ended_is_mailed_no_answer_to_their_note(stage: Stage) -> None:
    world = stage.world
    cue_id = stage.cue()
    take_id = stage.take(cue_id)
    note = say(world.designer, take_id, "Is it too long?").json()
    question = world.designer.post(f"/v1/cues/{cue_id}/questions", json={"text": "Which gun?"}).json()
    engagements = world.producer.get(f"/v1/projects/{world.project_id}").json()["engagements"]
    (own_id,) = [
        engagement["id"] for engagement in engagements if engagement["designer"]["id"] == str(world.designer_id)
    ]
    ended = world.producer.patch(f"/v1/projects/{world.project_id}/engagements/{own_id}", json={"ended": True})
    assert ended.status_code == 200, ended.text
    assert say(world.reviewer, take_id, "A little.", reply_to_id=note["id"]).status_code == 201
    answered = world.producer.post(f"/v1/questions/{question['id']}/answer", json={"text": "The small one."})
    assert answered.status_code == 200, answered.text
    world.server.wait_for_jobs()
    mails = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    assert [mail["subject"] for mail in mails if "note" in mail["subject"] or "answered" in mail["subject"]] == []


def test_only_notes_on_the_same_version_are_answered(stage: Stage) -> None:
    cue = stage.cue()
    first, other = stage.take(cue), stage.take(cue)
    note = say(stage.world.reviewer, first, "Too long?").json()
    assert say(stage.world.designer, other, "Which?", reply_to_id=note["id"]).status_code == 404
    assert say(stage.world.designer, first, "Which?", change_request_id=str(uuid4())).status_code == 404
    draft = stage.draft(first, "a duller clank")["id"]
    assert say(stage.world.designer, first, "Which?", change_request_id=draft).status_code == 404  # not sent yet
