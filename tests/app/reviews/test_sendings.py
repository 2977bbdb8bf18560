"""Change requests and the rounds they count, comments, histories and cuts."""

from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.core import clock
from app.core.db import new_id
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.reviews.jobs import send_change_request
from app.reviews.models import ChangeRequest
from tests.app.renders.making import add_cue, deliver_sound
from tests.app.reviews.making import Stage, body_of, refused
from tests.support.server import World
from tests.support.waves import sine


@pytest.fixture
def stage(world: World) -> Stage:
    return Stage(world)


def requests_seen_by(stage: Stage, who: str, state: str = "sent") -> list[str]:
    client = getattr(stage.world, who)
    answer = client.get(f"/v1/projects/{stage.world.project_id}/change-requests", params={"state": state})
    return [one["text"] for one in body_of(answer)["items"]]


@pytest.mark.slow
def test_one_sending_counts_once_for_a_set(stage: Stage) -> None:
    """Eight notes on a set are one round, and so is a single note on a single cue."""
    steps, clank = stage.cue("steps", variations=8), stage.cue("clank")
    takes = [stage.take(steps, variation) for variation in range(1, 9)] + [stage.take(clank)]
    for take in takes:
        stage.draft(take, "softer")
    sent = stage.send("all a bit softer")
    assert len(sent["change_requests"]) == 9
    assert sent["held_back"] == []
    assert {(one["cue_id"], one["number"]) for one in sent["rounds"]} == {(str(steps), 1), (str(clank), 1)}
    assert stage.states(*takes) == ["change_requested"] * 9
    assert stage.queue() == []
    second = stage.take(steps, 1)
    assert stage.queue()[0]["rounds_so_far"] == 1
    stage.draft(second, "softer still")
    assert [one["number"] for one in stage.send()["rounds"]] == [2]
    assert [one["number"] for one in stage.review(steps)["rounds"]] == [1, 2]


@pytest.mark.slow
def test_a_reversal_is_sent_and_counts_no_round(stage: Stage) -> None:
    cue = stage.cue()
    take = stage.take(cue)
    stage.approve(take)
    draft = stage.draft(take, "we changed our minds: glass, not metal", seen_state="approved")
    assert draft["reverses"] is True
    (only,) = stage.send()["rounds"]
    assert only["number"] is None
    assert only["why_not_counted"] == "the approver reversed an approval"
    assert stage.states(take) == ["change_requested"]
    stage.draft(stage.take(cue), "shorter")
    assert [one["number"] for one in stage.send()["rounds"]] == [1]


@pytest.mark.slow
def test_beside_a_reversal_a_change_still_counts(stage: Stage) -> None:
    cue = stage.cue(variations=2)
    approved, waiting = stage.take(cue, 1), stage.take(cue, 2)
    stage.approve(approved)
    stage.draft(approved, "glass after all", seen_state="approved")
    stage.draft(waiting, "louder")
    assert [one["number"] for one in stage.send()["rounds"]] == [1]


@pytest.mark.slow
def test_a_draft_whose_take_moved_on_is_kept_back(stage: Stage) -> None:
    gone, here = stage.take(stage.cue("gone")), stage.take(stage.cue("here"))
    stage.draft(gone, "shorter")
    stage.world.server.in_database(
        lambda session: session.execute(sa.update(Take).where(Take.id == gone).values(state=TakeState.RECEIVED))
    )
    answer = stage.world.approver.post(f"/v1/projects/{stage.world.project_id}/feedback", json={})
    assert refused(answer) == (409, "nothing-to-send")
    assert "is being checked" in answer.json()["detail"]
    stage.draft(here, "longer")
    sent = stage.send()
    assert [one["take_id"] for one in sent["change_requests"]] == [str(here)]
    assert [one["take_id"] for one in sent["held_back"]] == [str(gone)]
    assert requests_seen_by(stage, "approver", "draft") == ["shorter"]


@pytest.mark.slow
def test_a_draft_stays_with_its_cue_when_its_take_leaves_it(stage: Stage) -> None:
    bell, drum = stage.cue("bell"), stage.cue("drum")
    take = stage.take(bell)
    stage.draft(take, "shorter")

    def put(**place: Any) -> None:
        stage.world.server.in_database(
            lambda session: session.execute(sa.update(Take).where(Take.id == take).values(**place))
        )

    for place, why in (
        ({"cue_id": None, "number": None}, "is not matched to this cue any more"),
        ({"cue_id": drum, "variation": 1, "number": 1}, "is not matched to this cue any more"),
    ):
        put(**place)
        (draft,) = stage.review(bell)["change_requests"]
        assert (draft["cue_id"], draft["cue_name"]) == (str(bell), "bell")
        assert requests_seen_by(stage, "approver", "draft") == ["shorter"]
        answer = stage.world.approver.post(f"/v1/projects/{stage.world.project_id}/feedback", json={})
        assert refused(answer) == (409, "nothing-to-send")
        assert why in answer.json()["detail"]
    stage.draft(take, "duller")
    (sent,) = stage.send()["rounds"]
    assert sent["cue_id"] == str(drum)


def test_nothing_is_sent_twice(stage: Stage) -> None:
    stage.draft(stage.take(stage.cue()))
    stage.send()
    answer = stage.world.approver.post(f"/v1/projects/{stage.world.project_id}/feedback", json={})
    assert refused(answer) == (409, "nothing-to-send")


@pytest.mark.slow
def test_a_draft_can_be_dropped_until_it_is_sent(stage: Stage) -> None:
    cue = stage.cue()
    take = stage.take(cue)
    first = stage.draft(take, "softer")
    path = f"/v1/change-requests/{first['id']}"
    assert refused(stage.world.reviewer.delete(path)) == (403, "approver-needed")
    assert refused(stage.world.designer.delete(path)) == (404, "change-request-not-found")
    assert refused(stage.world.stranger.delete(path)) == (404, "change-request-not-found")
    assert stage.world.approver.delete(path).status_code == 204
    assert refused(stage.world.approver.delete(path)) == (404, "change-request-not-found")
    second = stage.draft(take, "softer")
    stage.send()
    assert refused(stage.world.approver.delete(f"/v1/change-requests/{second['id']}")) == (409, "already-sent")
    assert refused(stage.world.designer.delete(f"/v1/change-requests/{second['id']}")) == (403, "approver-needed")


@pytest.mark.slow
def test_drafts_are_the_teams_and_what_was_sent_is_the_designers_too(stage: Stage) -> None:
    world = stage.world
    stage.draft(stage.take(stage.cue("mine")), "mine")
    stage.draft(stage.take(stage.cue("theirs"), designer_id=world.other_designer_id), "theirs")
    assert sorted(requests_seen_by(stage, "reviewer", "draft")) == ["mine", "theirs"]
    path = f"/v1/projects/{world.project_id}/change-requests"
    assert refused(world.designer.get(path, params={"state": "draft"})) == (403, "team-needed")
    assert requests_seen_by(stage, "designer") == []
    stage.send()
    assert requests_seen_by(stage, "designer") == ["mine"]
    assert sorted(requests_seen_by(stage, "reviewer")) == ["mine", "theirs"]
    assert refused(world.stranger.get(path)) == (404, "project-not-found")
    assert world.nobody.get(path).status_code == 401


def test_only_the_approver_sends(stage: Stage) -> None:
    world = stage.world
    stage.draft(stage.take(stage.cue()))
    path = f"/v1/projects/{world.project_id}/feedback"
    for who in (world.producer, world.reviewer, world.designer):
        assert refused(who.post(path, json={})) == (403, "approver-needed")
    assert refused(world.stranger.post(path, json={})) == (404, "project-not-found")
    assert world.nobody.post(path, json={}).status_code == 401


@pytest.mark.slow
def test_lists_of_change_requests_have_pages(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.reviews.rounds.change_requests.PAGE_CHANGE_REQUESTS", 2)
    for number in range(5):
        stage.draft(stage.take(stage.cue(f"cue_{number}")), f"note {number}")
    path, seen, cursor = f"/v1/projects/{stage.world.project_id}/change-requests", [], None
    while True:
        params = {"state": "draft"} | ({"cursor": cursor} if cursor else {})
        page = body_of(stage.world.approver.get(path, params=params))
        seen += [one["text"] for one in page["items"]]
        if (cursor := page["next"]) is None:
            break
    assert seen == [f"note {number}" for number in (4, 3, 2, 1, 0)]


def comment(client: Any, take: UUID | str, text: str, **at: float) -> Any:
    return client.post(f"/v1/takes/{take}/comments", json={"text": text, **at})


@pytest.mark.slow
def test_all_who_see_a_take_may_comment_and_only_one_decides(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    for who, text in (
        (world.reviewer, "I would take A"),
        (world.approver, "the shimmer stays"),
        (world.designer, "ok"),
    ):
        assert comment(who, take, text, start_s=0.307, end_s=0.462).status_code == 201
    found = world.designer.get(f"/v1/takes/{take}/comments").json()
    assert [(one["text"], one["author"]["name"], one["decides"]) for one in found] == [
        ("I would take A", "Composer", False),
        ("the shimmer stays", "Audio director", True),
        ("ok", "Sound designer", False),
    ]
    assert stage.queue()[0]["takes"][0]["open_comments"] == 3
    resolved = body_of(world.designer.post(f"/v1/comments/{found[0]['id']}/resolve"))
    assert resolved["resolved_at"]
    again = body_of(world.approver.post(f"/v1/comments/{found[0]['id']}/resolve"))
    assert again["resolved_at"] == resolved["resolved_at"]
    assert stage.queue()[0]["takes"][0]["open_comments"] == 2


@pytest.mark.slow
def test_comments_are_checked_and_kept_from_strangers(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    mine = comment(world.reviewer, take, "x").json()["id"]
    assert refused(comment(world.reviewer, take, " ")) == (422, "invalid-request")
    assert refused(comment(world.reviewer, take, "x", start_s=2.0)) == (422, "range-invalid")
    assert comment(world.nobody, take, "x").status_code == 401
    for who in (world.stranger, world.other_designer):
        assert refused(comment(who, take, "x")) == (404, "take-not-found")
        assert refused(who.get(f"/v1/takes/{take}/comments")) == (404, "take-not-found")
        assert who.post(f"/v1/comments/{mine}/resolve").status_code == 404
        assert refused(who.get(f"/v1/takes/{take}/history")) == (404, "take-not-found")
    theirs = stage.take(stage.cue("theirs"), designer_id=world.other_designer_id)
    assert refused(world.designer.get(f"/v1/takes/{theirs}/comments")) == (404, "take-not-found")
    assert refused(world.approver.post(f"/v1/comments/{new_id()}/resolve")) == (404, "comment-not-found")


@pytest.mark.slow
def test_a_history_lists_all_but_drafts(stage: Stage) -> None:
    world = stage.world
    take = stage.take(stage.cue())
    comment(world.reviewer, take, "nice")
    stage.approve(take, note="yes")
    body_of(stage.undo(take))
    stage.draft(take, "a dull metallic clank", start_s=0.2, end_s=0.3)

    def kinds() -> list[str]:
        answer = world.designer.get(f"/v1/takes/{take}/history")
        assert answer.status_code == 200
        return [entry["kind"] for entry in answer.json()]

    so_far = ["received", "checked", "comment", "approve", "withdraw"]
    assert kinds() == so_far
    stage.send()
    assert kinds() == [*so_far, "request_change"]
    last = world.designer.get(f"/v1/takes/{take}/history").json()[-1]
    assert (last["text"], last["start_s"], last["end_s"]) == ("a dull metallic clank", 0.2, 0.3)
    assert last["by"]["name"] == "Audio director"


@pytest.mark.slow
def test_the_review_room_shows_a_cue_with_its_older_versions(stage: Stage) -> None:
    world = stage.world
    cue = stage.cue("suit_hit")
    first = stage.take(cue)
    stage.draft(first, "add a dull metallic clank")
    stage.send()
    second = stage.take(cue)
    comment(world.reviewer, second, "better")
    room = stage.review(cue)
    assert [(take["id"], take["state"]) for take in room["takes"]] == [
        (str(second), "conforming"),
        (str(first), "change_requested"),
    ]
    assert [one["text"] for one in room["change_requests"]] == ["add a dull metallic clank"]
    assert [one["text"] for one in room["comments"]] == ["better"]
    assert [(one["kind"], one["withdrawn"]) for one in room["verdicts"]] == [("request_change", False)]
    assert (room["accepted"], room["may_approve"], room["approver"]["name"]) == (False, False, "Audio director")
    assert body_of(world.approver.get(f"/v1/cues/{cue}/review"))["may_approve"] is True
    assert refused(world.designer.get(f"/v1/cues/{cue}/review")) == (403, "team-needed")
    assert refused(world.stranger.get(f"/v1/cues/{cue}/review")) == (404, "cue-not-found")
    assert refused(world.approver.get(f"/v1/cues/{new_id()}/review")) == (404, "cue-not-found")


@pytest.mark.slow
def test_a_cue_is_cut_with_its_reason(stage: Stage) -> None:
    world = stage.world
    cue = stage.cue("mine_arm")
    take = stage.take(cue)
    stage.draft(take, "shorter")
    path, body = f"/v1/cues/{cue}/cut", {"reason": "no mines in the game any more"}
    for who in (world.reviewer, world.designer):
        assert refused(who.post(path, json=body)) == (403, "producer-needed")
    assert refused(world.stranger.post(path, json=body)) == (404, "cue-not-found")
    assert refused(world.producer.post(path, json={"reason": "  "})) == (422, "invalid-request")
    cut = body_of(world.producer.post(path, json=body))
    assert (cut["state"], cut["cut_reason"]) == ("cut", body["reason"])
    assert stage.queue() == []
    assert requests_seen_by(stage, "approver", "draft") == []
    assert [one["state"] for one in stage.review(cue)["takes"]] == ["conforming"]
    assert refused(world.approver.post(path, json=body)) == (409, "cue-is-cut")
    assert refused(world.approver.post(f"/v1/cues/{cue}/accept-set", json={})) == (409, "cue-is-cut")


@pytest.mark.slow
def test_from_the_first_version_to_the_pack(world: World) -> None:
    """The main job over HTTP with real files: a change is asked for, the next version is approved."""
    cue = add_cue(world, "suit_hit")
    first = deliver_sound(world, "suit_hit.wav", sine(hz=500, dbfs=-6, rate=96_000, seconds=0.3))
    body = {"kind": "request_change", "note": "add a dull metallic clank", "start_s": 0.1}
    body_of(world.approver.post(f"/v1/takes/{first}/verdict", json=body))
    sent = world.approver.post(f"/v1/projects/{world.project_id}/feedback", json={"note": ""})
    assert sent.status_code == 201
    second = deliver_sound(world, "suit_hit.wav", sine(hz=300, dbfs=-6, rate=96_000, seconds=0.3))
    (item,) = body_of(world.approver.get("/v1/review-queue"))["items"]
    assert item["cue"]["id"] == cue["id"]
    assert (item["rounds_so_far"], [take["number"] for take in item["takes"]]) == (1, [2])
    given = body_of(world.approver.post(f"/v1/takes/{second}/verdict", json={"kind": "approve"}))
    assert given["cue_accepted"] is True
    world.server.wait_for_jobs()
    found = body_of(world.approver.get(f"/v1/cues/{cue['id']}/review"))
    assert [(take["number"], take["state"]) for take in found["takes"]] == [(2, "approved"), (1, "change_requested")]


class _Sending:
    """Change requests that send themselves, and the job that sends them."""

    def __init__(self, stage: Stage) -> None:
        self.stage = stage
        self.runtime = stage.world.server.runtime

    def request(self, take_id: UUID, note: str) -> dict[str, Any]:
        answer = self.stage.verdict(take_id, "request_change", note=note, send=True)
        draft: dict[str, Any] = body_of(answer)["draft"]
        return draft

    def pass_time(self) -> None:
        """Move every request that is on its way behind the ten seconds in which it can be undone."""
        ago = clock.now() - timedelta(seconds=1)
        self.stage.world.server.in_database(
            lambda session: session.execute(
                sa.update(ChangeRequest).where(ChangeRequest.sends_at.is_not(None)).values(sends_at=ago)
            )
        )

    def run(self, draft: dict[str, Any]) -> None:
        send_change_request(self.runtime, {"change_request_id": draft["id"]})

    def send(self, take_id: UUID, note: str) -> None:
        draft = self.request(take_id, note)
        self.pass_time()
        self.run(draft)


@pytest.fixture
def sending(stage: Stage) -> _Sending:
    return _Sending(stage)


def test_a_request_leaves_by_itself_once_it_cannot_be_undone(stage: Stage, sending: _Sending) -> None:
    take = stage.take(stage.cue())
    draft = sending.request(take, "shorter")
    assert draft["sends_at"] is not None
    sending.run(draft)  # too early
    assert stage.states(take) == ["conforming"]
    sending.pass_time()
    sending.run(draft)
    sending.run(draft)  # a job may run twice
    assert stage.states(take) == ["change_requested"]
    assert requests_seen_by(stage, "designer") == ["shorter"]


def test_an_undone_request_is_never_sent(stage: Stage, sending: _Sending) -> None:
    take = stage.take(stage.cue())
    draft = sending.request(take, "shorter")
    assert body_of(stage.undo(take))["draft_dropped"] is True
    sending.pass_time()
    sending.run(draft)
    assert stage.states(take) == ["conforming"]
    assert requests_seen_by(stage, "designer") == []


def test_drafts_stay_when_a_request_leaves(stage: Stage, sending: _Sending) -> None:
    cue = stage.cue(variations=2)
    kept, sent = stage.take(cue, 1), stage.take(cue, 2)
    stage.draft(kept, "later")
    draft = sending.request(sent, "now")
    sending.pass_time()
    sending.run(draft)
    assert stage.states(kept, sent) == ["conforming", "change_requested"]


def test_requests_on_a_set_are_one_round_until_something_is_delivered(stage: Stage, sending: _Sending) -> None:
    cue = stage.cue(variations=2)
    takes = [stage.take(cue, variation) for variation in (1, 2)]
    for take in takes:
        sending.send(take, "softer")
    sending.send(stage.take(cue, 1), "softer still")
    assert [one["number"] for one in stage.review(cue)["rounds"]] == [1, None, 2]
    assert stage.review(cue)["rounds"][1]["why_not_counted"] == "part of round 1: nothing was delivered since"
