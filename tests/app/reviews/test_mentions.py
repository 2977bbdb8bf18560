"""Mentions, acknowledgements, and comments that are resolved and opened again."""

from typing import Any
from uuid import uuid4

import pytest
from httpx2 import Client

from app.reviews.errors import NotMentionable
from app.reviews.rules import names_mentioned
from tests.app.reviews.making import Stage
from tests.support.server import World

ADA, BEN = uuid4(), uuid4()
PEOPLE = {ADA: "Ada Mills", BEN: "Ben"}


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def say(by: Client, take_id: Any, text: str, **more: Any) -> Any:
    return by.post(f"/v1/takes/{take_id}/comments", json={"text": text, **more})


def names(by: Client, take_id: Any) -> list[str]:
    answer = by.get(f"/v1/takes/{take_id}/people")
    assert answer.status_code == 200, answer.text
    return [person["name"] for person in answer.json()]


def mentions_of(world: World, by: Client) -> list[dict[str, Any]]:
    world.server.wait_for_jobs()
    return [one for one in by.get("/v1/me/notices").json()["items"] if one["news"] == "mentions"]


def test_a_name_stands_in_the_text_or_is_refused():
    assert names_mentioned("@Ada Mills, and @Ben?", [BEN, ADA, BEN], PEOPLE) == {str(BEN): "Ben", str(ADA): "Ada Mills"}
    assert names_mentioned("nobody", [], PEOPLE) == {}
    for text, wanted in (("@Ada", ADA), ("Ben", BEN), ("@Ben", uuid4())):
        with pytest.raises(NotMentionable):
            names_mentioned(text, [wanted], PEOPLE)


def test_offered_are_the_team_and_the_sounds_own_designer_without_the_caller(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    assert names(world.reviewer, take_id) == ["Audio director", "Producer", "Sound designer"]
    assert names(world.designer, take_id) == ["Audio director", "Composer", "Producer"]
    assert world.other_designer.get(f"/v1/takes/{take_id}/people").status_code == 404
    assert world.stranger.get(f"/v1/takes/{take_id}/people").status_code == 404


def test_who_is_mentioned_has_a_notice_and_a_mail_that_lead_there(stage: Stage):
    world, cue_id = stage.world, stage.cue()
    take_id = stage.take(cue_id)
    said = say(world.designer, take_id, "@Composer, does it clash?", start_s=0.2, mentions=[str(world.reviewer_id)])
    assert said.status_code == 201, said.text
    assert said.json()["mentions"] == [{"person_id": str(world.reviewer_id), "name": "Composer"}]
    (notice,) = mentions_of(world, world.reviewer)
    assert notice["subject"].endswith("Sound designer mentions you")
    assert "at 0.200 s: Sound designer wrote: @Composer, does it clash?" in notice["text"]
    assert notice["path"] == f"/projects/{world.project_id}/review/{cue_id}?take={take_id}&at=0.2"
    mails = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    assert [mail["recipient"] for mail in mails if mail["subject"].endswith("mentions you")] == [
        f"{world.reviewer_id}@example.test"
    ]
    assert mentions_of(world, world.approver) == []


def test_the_designer_is_led_to_the_version(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    say(world.approver, take_id, "@Sound designer, shorter?", mentions=[str(world.designer_id)])
    (notice,) = mentions_of(world, world.designer)
    assert notice["path"] == f"/takes/{take_id}"


def test_nobody_is_mentioned_who_may_not_see_the_version(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    for person_id in (world.other_designer_id, world.stranger_id, uuid4()):
        refused = say(world.approver, take_id, "@Another sound designer", mentions=[str(person_id)])
        assert (refused.status_code, refused.json()["code"]) == (422, "not-mentionable")
    assert mentions_of(world, world.other_designer) == []


def test_who_is_answered_and_mentioned_hears_of_it_once(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    note = say(world.reviewer, take_id, "Too long?").json()
    say(world.designer, take_id, "@Composer, 0.8 s", reply_to_id=note["id"], mentions=[str(world.reviewer_id)])
    assert len(mentions_of(world, world.reviewer)) == 1
    assert [one["news"] for one in world.reviewer.get("/v1/me/notices").json()["items"]] == ["mentions"]


@pytest.mark.slow
def test_a_mention_in_a_change_request_is_sent_with_it_and_outlives_an_undone_approval(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    both = [str(world.reviewer_id), str(world.designer_id)]
    stage.verdict(take_id, "request_change", note="@Composer and @Sound designer: duller", mentions=both)
    stage.approve(take_id)
    assert world.approver.delete(f"/v1/takes/{take_id}/verdict").status_code == 200
    assert mentions_of(world, world.reviewer) == []
    stage.send()
    assert len(mentions_of(world, world.reviewer)) == 1
    assert mentions_of(world, world.designer) == [], "the designer has the change itself"
    (request,) = world.designer.get(f"/v1/projects/{world.project_id}/change-requests").json()["items"]
    assert {one["name"] for one in request["mentions"]} == {"Composer", "Sound designer"}


@pytest.mark.slow
def test_a_comment_is_acknowledged_by_who_is_mentioned_and_by_the_designer_once_each(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    said = say(world.approver, take_id, "@Composer, listen", mentions=[str(world.reviewer_id)]).json()
    path = f"/v1/comments/{said['id']}/acknowledgement"
    assert said["acknowledgements"] == []
    for by in (world.reviewer, world.designer, world.reviewer):
        assert by.post(path).status_code == 200
    seen = world.approver.get(f"/v1/takes/{take_id}/comments").json()[0]["acknowledgements"]
    assert [one["person"]["name"] for one in seen] == ["Composer", "Sound designer"]
    for by, status in (
        (world.producer, 409),
        (world.approver, 409),
        (world.other_designer, 404),
        (world.stranger, 404),
    ):
        assert by.post(path).status_code == status
    own = say(world.designer, take_id, "It is shorter now.").json()
    assert world.designer.post(f"/v1/comments/{own['id']}/acknowledgement").status_code == 409


def test_a_comment_is_resolved_and_opened_again(stage: Stage):
    world, take_id = stage.world, stage.take(stage.cue())
    said = say(world.reviewer, take_id, "Too long?").json()
    assert world.designer.post(f"/v1/comments/{said['id']}/resolve").json()["resolved_at"] is not None
    assert world.stranger.post(f"/v1/comments/{said['id']}/reopen").status_code == 404
    assert world.approver.post(f"/v1/comments/{said['id']}/reopen").json()["resolved_at"] is None
