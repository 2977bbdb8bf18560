"""Webhooks: set by producers, signed, sent again with growing pauses, disabled, replayed."""

import base64
import hashlib
import hmac
import json
import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor, wait
from datetime import UTC, datetime, timedelta
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import Select, select, update

from app.accounts.models import RateLimit
from app.accounts.rate_limits import WEBHOOK_MESSAGES_OF_STUDIO
from app.core import clock
from app.webhooks import jobs, queries, sending
from app.webhooks.bodies import Message, body_of
from app.webhooks.models import Webhook, WebhookAttempt, WebhookCall
from app.webhooks.rules import PAUSES, WebhookEvent, WebhookForm, is_delivered, pause_after, signature
from tests.app.reviews.making import Stage
from tests.support.deliver import add_cues
from tests.support.receiver import Receiver, receiver
from tests.support.server import World

ALL = [event.value for event in WebhookEvent]
AT = datetime(2026, 11, 26, 12, tzinfo=UTC)


@pytest.fixture
def target(world: World, monkeypatch: pytest.MonkeyPatch) -> Iterator[Receiver]:
    monkeypatch.setattr(world.server.runtime.settings, "webhook_localhost", True)
    monkeypatch.setattr(world.server.runtime.settings, "digest_delay_s", 0.0)
    with receiver() as server:
        yield server


def add(world: World, url: str, **more: Any) -> dict[str, Any]:
    body = {"url": url, "events": ALL, **more}
    answer = world.producer.post(f"/v1/studios/{world.studio_id}/webhooks", json=body)
    assert answer.status_code == 201, answer.text
    return dict(answer.json())


def calls(world: World, webhook: dict[str, Any]) -> list[dict[str, Any]]:
    return list(world.producer.get(f"/v1/webhooks/{webhook['id']}/calls").json()["items"])


def is_signed_by(secret: str, request: Any) -> list[bool]:
    """Whether each signature of a request is by the secret, as Standard Webhooks verifies it."""
    key = base64.b64decode(secret.removeprefix("whsec_"))
    content = f"{request.headers['webhook-id']}.{request.headers['webhook-timestamp']}.".encode() + request.body
    wanted = base64.b64encode(hmac.new(key, content, hashlib.sha256).digest()).decode()
    return [hmac.compare_digest(one, f"v1,{wanted}") for one in request.headers["webhook-signature"].split()]


def attempt_again(world: World, call_id: str) -> None:
    """Make the attempt that is due next, without its pause."""
    with world.server.runtime.database.reading() as session:
        call = session.get_one(WebhookCall, UUID(call_id))
    assert call.next_attempt is not None
    sending.send(world.server.runtime, call.id, call.next_attempt)


@pytest.mark.parametrize(("status", "wanted"), [(199, False), (200, True), (299, True), (300, False), (500, False)])
def test_an_answer_says_whether_the_message_was_taken(status: int, wanted: bool):
    assert is_delivered(status) is wanted


def test_signature_of_the_standards_own_example():
    # From the reference libraries of Standard Webhooks.
    secret = base64.b64decode("MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw")
    at = datetime.fromtimestamp(1614265330, UTC)
    assert (
        signature([secret], "msg_p5jXN8AQM9LWM0D4loKWxJek", at, b'{"test": 2432232314}')
        == "v1,g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE="
    )


def test_pauses_grow_and_end_within_four_days():
    assert list(PAUSES) == sorted(PAUSES)
    assert timedelta(days=3) < sum(PAUSES, timedelta()) < timedelta(days=4)
    assert pause_after(1) == timedelta(seconds=5)
    assert pause_after(len(PAUSES)) == timedelta(days=1)
    assert pause_after(len(PAUSES) + 1) is None


def test_bodies_of_chats_call_nobody():
    message = Message(WebhookEvent.CUE_CUT, "Wing: SW-001 was cut: <!channel> & @everyone", "https://s.example/p")
    slack = json.loads(body_of(WebhookForm.SLACK, message, AT))
    assert slack == {"text": "Wing: SW-001 was cut: &lt;!channel&gt; &amp; @everyone\nhttps://s.example/p"}
    discord = json.loads(body_of(WebhookForm.DISCORD, message, AT))
    assert discord["allowed_mentions"] == {"parse": []}
    assert discord["content"].endswith("\nhttps://s.example/p")
    card = json.loads(body_of(WebhookForm.TEAMS, message, AT))["attachments"][0]["content"]
    assert (card["body"][0]["text"], card["actions"][0]["url"]) == (message.text, message.url)
    own = json.loads(body_of(WebhookForm.JSON, message, AT))
    assert (own["type"], own["timestamp"]) == ("cue.cut", "2026-11-26T12:00:00+00:00")
    long = Message(WebhookEvent.CUE_CUT, "a" * 5_000, "https://s.example/p")
    assert len(json.loads(body_of(WebhookForm.DISCORD, long, AT))["content"]) < 2_000


@pytest.mark.slow
def test_an_approval_arrives_signed_with_cue_words_and_link(world: World, target: Receiver):
    webhook = add(world, f"{target.url}/in", events=["take.approved"])
    stage = Stage(world)
    cue_id = stage.cue("radar_ping")
    stage.approve(stage.take(cue_id))
    world.server.wait_for_jobs()
    (request,) = target.received
    assert is_signed_by(webhook["secret"], request) == [True]
    body = json.loads(request.body)
    assert body["type"] == "take.approved"
    assert "radar_ping, version 1" in body["data"]["text"]
    assert body["data"]["url"].endswith(f"/projects/{world.project_id}/review/{cue_id}")
    assert body["data"]["cue"]["id"] == str(cue_id)
    (call,) = calls(world, webhook)
    assert (call["state"], call["status"], call["answer"], call["tries"]) == ("delivered", 200, "taken", 1)
    assert request.headers["webhook-id"] == call["id"]


@pytest.mark.slow
def test_what_was_not_chosen_and_other_projects_call_nobody(world: World, target: Receiver):
    body = {"name": "Other", "cue_prefix": "OT"}
    other = world.producer.post("/v1/projects", json={**body, "studio_id": str(world.studio_id)}).json()
    add(world, target.url, events=["pack.made"])
    elsewhere = add(world, target.url, project_id=other["id"])
    add_cues(world, {"name": "coolant"})
    world.server.wait_for_jobs()
    assert target.received == []
    assert elsewhere["project"]["name"] == "Other"


@pytest.mark.slow
def test_a_designers_question_calls_the_studios_webhook(world: World, target: Receiver):
    add(world, target.url, events=["question.asked"], form="slack")
    (cue,) = add_cues(world, {"name": "coolant"})
    world.designer.post(f"/v1/cues/{cue['id']}/questions", json={"text": "A drop?"}).raise_for_status()
    world.server.wait_for_jobs()
    (request,) = target.received
    assert "Sound designer asks about SW-001 coolant: A drop?" in json.loads(request.body)["text"]


@pytest.mark.slow
def test_an_event_is_one_call_however_often_its_job_runs(world: World, target: Receiver):
    webhook = add(world, target.url, events=["list.revised"])
    payload = {"event": "list.revised", "event_id": "one", "studio_id": str(world.studio_id)}
    payload |= {"project_id": str(world.project_id), "revision": 3, "added": 2, "changed": 0, "cut": 0}
    for _ in range(2):
        jobs.write_calls(world.server.runtime, payload)
    world.server.wait_for_jobs()
    assert len(target.received) == len(calls(world, webhook)) == 1


@pytest.mark.slow
def test_what_fails_is_tried_again_with_pauses_then_given_up(world: World, target: Receiver):
    webhook = add(world, target.url)
    target.status, target.answer = 500, b"out of order " * 200
    test = world.producer.post(f"/v1/webhooks/{webhook['id']}/test")
    assert test.status_code == 202
    runtime = world.server.runtime
    with runtime.database.reading() as session:
        first = session.get_one(WebhookCall, UUID(test.json()["id"]))
    sending.send(runtime, first.id, first.next_attempt) if first.next_attempt and first.tries == 0 else None
    for tries in range(1, len(PAUSES) + 1):
        (call,) = calls(world, webhook)
        assert (call["state"], call["problem"]) == ("waiting", "answered 500")
        assert call["tries"] >= tries
        assert len(call["answer"]) == 1_000
        attempt_again(world, call["id"])
    (call,) = calls(world, webhook)
    assert call["state"] == "failed"
    assert call["next_at"] is None
    target.status = 200
    world.producer.post(f"/v1/webhook-calls/{call['id']}/replay").raise_for_status()
    world.server.wait_for_jobs()
    (call,) = calls(world, webhook)
    assert (call["state"], call["tries"]) == ("delivered", 1)
    assert len({(request.headers["webhook-id"], request.body) for request in target.received}) == 1


def attempts_at(call_id: str) -> Select[WebhookAttempt]:
    return select(WebhookAttempt).where(WebhookAttempt.call_id == UUID(call_id))


@pytest.mark.slow
def test_each_attempt_at_a_message_is_in_its_log(world: World, target: Receiver, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(sending, "pause_after", lambda _tries: timedelta(hours=1))  # no attempt but those made here
    webhook = add(world, target.url)
    target.status, target.answer = 500, b"out of order " * 200
    world.producer.post(f"/v1/webhooks/{webhook['id']}/test").raise_for_status()
    until_tried(world, webhook)
    target.status = 503
    attempt_again(world, calls(world, webhook)[0]["id"])
    target.status, target.answer = 200, b"taken"
    attempt_again(world, calls(world, webhook)[0]["id"])
    (call,) = calls(world, webhook)
    assert (call["state"], call["tries"]) == ("delivered", 3)
    log = call["attempts"]
    assert [(one["status"], one["problem"]) for one in log] == [
        (500, "answered 500"),
        (503, "answered 503"),
        (200, ""),
    ]
    assert [len(one["answer"]) for one in log] == [1_000, 1_000, len("taken")]
    assert all(one["took_ms"] >= 0 for one in log)
    assert sorted(one["tried_at"] for one in log) == [one["tried_at"] for one in log]
    assert world.producer.delete(f"/v1/webhooks/{webhook['id']}").status_code == 204
    with world.server.runtime.database.reading() as session:
        assert session.scalars(attempts_at(call["id"])).all() == []


def test_an_attempt_that_is_not_due_any_more_sends_nothing(world: World, target: Receiver):
    webhook = add(world, target.url)
    call_id = world.producer.post(f"/v1/webhooks/{webhook['id']}/test").json()["id"]
    world.server.wait_for_jobs()
    sending.send(world.server.runtime, UUID(call_id), UUID(int=7))
    assert len(target.received) == 1


@pytest.mark.slow
def test_after_five_days_of_failures_it_is_disabled_with_a_notice(
    world: World, target: Receiver, monkeypatch: pytest.MonkeyPatch
):
    webhook = add(world, target.url)
    target.status = 410
    call_id = world.producer.post(f"/v1/webhooks/{webhook['id']}/test").json()["id"]
    world.server.in_database(lambda session: session.get_one(WebhookCall, UUID(call_id)))
    until_tried(world, webhook)
    later = clock.now() + timedelta(days=5, seconds=1)
    with monkeypatch.context() as patched:
        patched.setattr(clock, "now", lambda: later)
        attempt_again(world, call_id)
    world.server.wait_for_jobs()
    (read,) = world.producer.get(f"/v1/studios/{world.studio_id}/webhooks").json()["items"]
    assert read["disabled_at"] is not None
    (notice,) = [
        one for one in world.producer.get("/v1/me/notices").json()["items"] if one["subject"] == "a webhook is disabled"
    ]
    assert "answered 410" in notice["text"]
    assert notice["path"] == f"/webhooks?studio={world.studio_id}"
    assert world.producer.post(f"/v1/webhooks/{webhook['id']}/test").status_code == 409
    assert world.producer.post(f"/v1/webhook-calls/{call_id}/replay").status_code == 409
    count = len(target.received)
    add_cues(world, {"name": "coolant"})
    world.server.wait_for_jobs()
    assert len(target.received) == count
    enabled = world.producer.patch(f"/v1/webhooks/{webhook['id']}", json={"enabled": True}).json()
    assert (enabled["disabled_at"], enabled["failing_since"]) == (None, None)


def until_tried(world: World, webhook: dict[str, Any]) -> None:
    """Make the first attempt, unless the worker was quicker."""
    (call,) = calls(world, webhook)
    if call["tries"] == 0:
        attempt_again(world, call["id"])


@pytest.mark.slow
def test_a_rotated_secret_signs_beside_the_old_one_for_a_day(
    world: World, target: Receiver, monkeypatch: pytest.MonkeyPatch
):
    webhook = add(world, target.url)
    rotated = world.producer.post(f"/v1/webhooks/{webhook['id']}/secret").json()
    assert rotated["secret"] != webhook["secret"]
    assert rotated["old_secret_until"] is not None
    call_id = world.producer.post(f"/v1/webhooks/{webhook['id']}/test").json()["id"]
    world.server.wait_for_jobs()
    assert is_signed_by(rotated["secret"], target.received[-1]) == [True, False]
    assert is_signed_by(webhook["secret"], target.received[-1]) == [False, True]
    later = clock.now() + timedelta(days=1, seconds=1)
    world.producer.post(f"/v1/webhook-calls/{call_id}/replay").raise_for_status()
    world.server.wait_for_jobs()
    world.server.in_database(lambda session: _due(session, call_id))
    with monkeypatch.context() as patched:
        patched.setattr(clock, "now", lambda: later)
        attempt_again(world, call_id)
    assert is_signed_by(rotated["secret"], target.received[-1]) == [True]
    shown = world.producer.get(f"/v1/studios/{world.studio_id}/webhooks").text
    assert "whsec_" not in shown


def _due(session: Any, call_id: str) -> None:
    session.get_one(WebhookCall, UUID(call_id)).next_attempt = UUID(int=9)


@pytest.mark.slow
def test_addresses_inside_are_refused_when_saved_and_when_sent(world: World):
    path = f"/v1/studios/{world.studio_id}/webhooks"
    for url in (
        "http://hooks.example.com/",
        "https://10.0.0.5/",
        "https://localhost/",
        "https://[::1]/",
        "javascript:",
    ):
        refused = world.producer.post(path, json={"url": url, "events": ALL})
        assert (refused.status_code, refused.json()["code"]) == (422, "webhook-address-refused")
    webhook = add(world, "https://hooks.example.com/in")
    changed = world.producer.patch(f"/v1/webhooks/{webhook['id']}", json={"url": "https://192.168.1.1/"})
    assert changed.status_code == 422
    world.server.runtime.settings.webhook_localhost = False
    call_id = UUID(world.producer.post(f"/v1/webhooks/{webhook['id']}/test").json()["id"])
    world.server.wait_for_jobs(20)
    world.server.in_database(lambda session: _due(session, str(call_id)))
    sending.send(world.server.runtime, call_id, UUID(int=9), resolver=lambda *_: ["169.254.169.254"])
    (call,) = calls(world, webhook)
    assert call["problem"] == "hooks.example.com has no public address"
    assert call["status"] is None


@pytest.mark.slow
def test_only_producers_of_the_studio_see_and_set_webhooks(world: World, target: Receiver):
    webhook = add(world, target.url)
    call_id = world.producer.post(f"/v1/webhooks/{webhook['id']}/test").json()["id"]
    path = f"/v1/studios/{world.studio_id}/webhooks"
    for by, status in ((world.reviewer, 403), (world.approver, 403), (world.designer, 404), (world.stranger, 404)):
        assert by.get(path).status_code == status
        assert by.post(path, json={"url": "https://a.example/", "events": ALL}).status_code == status
        for method, one in (
            ("GET", f"/v1/webhooks/{webhook['id']}/calls"),
            ("POST", f"/v1/webhooks/{webhook['id']}/secret"),
            ("POST", f"/v1/webhooks/{webhook['id']}/test"),
            ("DELETE", f"/v1/webhooks/{webhook['id']}"),
            ("POST", f"/v1/webhook-calls/{call_id}/replay"),
        ):
            assert by.request(method, one).status_code == 404
    world.server.wait_for_jobs()
    assert world.producer.delete(f"/v1/webhooks/{webhook['id']}").status_code == 204
    assert world.producer.get(path).json()["items"] == []


@pytest.mark.slow
def test_a_studio_has_twenty_at_most_and_no_other_studios_project(world: World, target: Receiver):
    path = f"/v1/studios/{world.studio_id}/webhooks"
    elsewhere = world.stranger.get("/v1/me").json()["studios"][0]["id"]
    foreign = {"url": target.url, "events": ALL, "project_id": str(world.project_id)}
    assert world.stranger.post(f"/v1/studios/{elsewhere}/webhooks", json=foreign).status_code == 404
    for _ in range(20):
        add(world, target.url)
    assert world.producer.post(path, json={"url": target.url, "events": ALL}).status_code == 409


def test_calls_leave_the_log_after_thirty_days(world: World, target: Receiver, monkeypatch: pytest.MonkeyPatch):
    webhook = add(world, target.url)
    world.producer.post(f"/v1/webhooks/{webhook['id']}/test").raise_for_status()
    world.server.wait_for_jobs()
    (call,) = calls(world, webhook)
    now = clock.now()
    for days, left in ((29, 1), (31, 0)):
        with monkeypatch.context() as patched:
            patched.setattr(clock, "now", lambda days=days: now + timedelta(days=days))
            jobs.delete_old_calls(world.server.runtime, {})
        with world.server.runtime.database.reading() as session:
            found = queries.calls_of(session, UUID(webhook["id"]), before=None, limit=5)
            attempts = session.scalars(attempts_at(call["id"])).all()
        assert (len(found), len(attempts)) == (left, left)


def test_tests_and_repeated_messages_have_a_limit_for_each_studio(world: World, target: Receiver) -> None:
    webhook = add(world, f"{target.url}/hook")
    path = f"/v1/webhooks/{webhook['id']}/test"
    key = hashlib.sha256(f"{WEBHOOK_MESSAGES_OF_STUDIO.name}\0{world.studio_id}".encode()).hexdigest()
    used_up = time.time() + WEBHOOK_MESSAGES_OF_STUDIO.burst * WEBHOOK_MESSAGES_OF_STUDIO.interval_s
    world.server.in_database(lambda session: session.add(RateLimit(key=key, free_at_s=used_up)))
    assert world.producer.post(path).status_code == 429
    assert calls(world, webhook) == []
    world.server.forget_tries()
    assert world.producer.post(path).status_code == 202
    world.server.wait_for_jobs()
    [call] = calls(world, webhook)
    world.server.in_database(lambda session: session.execute(update(RateLimit).values(free_at_s=used_up)))
    answer = world.producer.post(f"/v1/webhook-calls/{call['id']}/replay")
    assert (answer.status_code, "Retry-After" in answer.headers) == (429, True)
    world.server.forget_tries()


@pytest.mark.both_databases
def test_a_webhook_is_deleted_once_the_attempt_at_its_message_is_in_the_log(world: World, target: Receiver) -> None:
    webhook = add(world, target.url)
    world.producer.post(f"/v1/webhooks/{webhook['id']}/test").raise_for_status()
    world.server.wait_for_jobs()
    (call,) = calls(world, webhook)
    with ThreadPoolExecutor(1) as thread:
        with world.server.runtime.database.writing() as session:
            session.get_one(Webhook, UUID(webhook["id"]), with_for_update=True)  # as sending does
            session.add(
                WebhookAttempt(
                    studio_id=world.studio_id, call_id=UUID(call["id"]), tried_at=AT, took_ms=1, status=200,
                    answer="", problem="",
                )
            )  # fmt: skip
            session.flush()
            deletion = thread.submit(world.producer.delete, f"/v1/webhooks/{webhook['id']}")
            wait([deletion], timeout=0.5)  # it waits for this transaction
        assert deletion.result().status_code == 204, deletion.result().text
