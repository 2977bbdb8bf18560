"""Notices in the app: the same news as in mails, for one person, read or not."""

from datetime import timedelta
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client

from app.core import clock
from app.core.db import new_id
from app.notifications import service
from app.notifications.notices import jobs as notice_jobs
from app.notifications.notices import service as notices
from app.notifications.rules import Fold, folded_text
from tests.support.deliver import add_cues
from tests.support.server import World


@pytest.fixture(autouse=True)
def _without_digests(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(world.server.runtime.settings, "digest_delay_s", 0.0)


def answer_a_question(world: World, text: str) -> str:
    """Have the designer's question answered; return the id of its cue."""
    (cue,) = add_cues(world, {"name": f"coolant_{text}"})
    asked = world.designer.post(f"/v1/cues/{cue['id']}/questions", json={"text": "A drop, or a tool?"})
    world.approver.post(f"/v1/questions/{asked.json()['id']}/answer", json={"text": text}).raise_for_status()
    world.server.wait_for_jobs()
    return str(cue["id"])


def read(by: Client, **query: str) -> Any:
    answer = by.get("/v1/me/notices", params=query)
    assert answer.status_code == 200, answer.text
    return answer.json()


def talk(by: Client) -> list[dict[str, Any]]:
    return [one for one in read(by)["items"] if one["news"] == "talk"]


def unread(by: Client) -> int:
    return int(by.get("/v1/me/notices/unread").json()["unread"])


def add(world: World, person_id: UUID, **facts: Any) -> None:
    given = {
        "event_id": str(new_id()),
        "studio_id": world.studio_id,
        "project_id": world.project_id,
        "topic": f"answers:{world.project_id}",
        "recipient": f"{person_id}@example.test",
        "subject": "your question is answered",
        "text": "A bell.",
        "path": "/desk",
    }
    world.server.in_database(lambda session: notices.add(session, **given | facts))


@pytest.mark.slow
def test_an_answer_is_a_notice_that_leads_to_its_cue(world: World):
    cue_id = answer_a_question(world, "a_tool")
    (notice,) = talk(world.designer)
    assert notice["subject"] == "Shield Wing: your question is answered"
    assert "a_tool" in notice["text"]
    assert notice["path"] == f"/projects/{world.project_id}/sound-list/cues/{cue_id}"
    assert notice["read_at"] is None


@pytest.mark.slow
def test_who_turned_the_mail_off_has_the_notice_all_the_same(world: World):
    body = {"cadences": {"talk": "never"}, "time_zone": "UTC", "daily_at": "08:00"}
    world.designer.put("/v1/me/mail-preferences", json=body).raise_for_status()
    answer_a_question(world, "a_tool")
    mails = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    assert not [mail for mail in mails if "your question is answered" in mail["subject"]]
    assert len(talk(world.designer)) == 1


@pytest.mark.slow
def test_nobody_reads_or_marks_the_notices_of_another(world: World):
    answer_a_question(world, "a_tool")
    (notice,) = talk(world.designer)
    assert talk(world.other_designer) == []
    assert all("your question" not in one["subject"] for one in read(world.producer)["items"])
    assert world.nobody.get("/v1/me/notices").status_code == 401
    for body in ({"ids": [notice["id"]]}, {"up_to": notice["id"]}):
        assert world.producer.post("/v1/me/notices/read", json=body).status_code == 204
    assert talk(world.designer)[0]["read_at"] is None


def test_what_is_read_counts_no_more_and_what_came_since_still_does(world: World):
    for _ in range(3):
        add(world, world.designer_id)
    newest, middle, oldest = read(world.designer)["items"]
    assert unread(world.designer) == 3
    world.designer.post("/v1/me/notices/read", json={"ids": [newest["id"]]}).raise_for_status()
    assert unread(world.designer) == 2
    world.designer.post("/v1/me/notices/read", json={"up_to": middle["id"]}).raise_for_status()
    assert unread(world.designer) == 0
    add(world, world.designer_id)
    world.designer.post("/v1/me/notices/read", json={"up_to": newest["id"]}).raise_for_status()
    assert unread(world.designer) == 1
    assert oldest["id"] < middle["id"] < newest["id"]


def test_an_event_is_noticed_once_however_often_its_job_runs(world: World):
    for _ in range(2):
        add(world, world.designer_id, event_id="one")
    add(world, world.designer_id, event_id="one", topic=f"replies:{world.project_id}")
    assert len(read(world.designer)["items"]) == 2


@pytest.mark.slow
def test_pages_follow_one_another_and_the_count_ends_at_a_hundred(world: World):
    for number in range(103):
        add(world, world.designer_id, subject=f"piece {number}")
    first = read(world.designer)
    second = read(world.designer, cursor=first["next"])
    third = read(world.designer, cursor=second["next"])
    subjects = [one["subject"] for page in (first, second, third) for one in page["items"]]
    assert subjects == [f"piece {number}" for number in reversed(range(103))]
    assert third["next"] is None
    assert unread(world.designer) == 100
    assert world.designer.get("/v1/me/notices", params={"cursor": "x"}).status_code == 422


def test_notices_leave_ninety_days_after_they_were_read(world: World, monkeypatch: pytest.MonkeyPatch):
    for _ in range(2):
        add(world, world.designer_id)
    kept, gone = read(world.designer)["items"]
    world.designer.post("/v1/me/notices/read", json={"ids": [gone["id"]]}).raise_for_status()
    now = clock.now()
    for days, wanted in ((89, {kept["id"], gone["id"]}), (91, {kept["id"]})):
        later = now + timedelta(days=days)
        monkeypatch.setattr(clock, "now", lambda later=later: later)
        notice_jobs.delete_old_notices(world.server.runtime, {})
        with world.server.runtime.database.reading() as session:
            left = {str(notice.id) for notice in notices.queries.notices_of(
                session, world.designer_id, before=None, limit=10)}  # fmt: skip
        assert left == wanted


def test_a_long_text_is_cut_and_an_address_without_an_account_has_no_notice(world: World):
    add(world, world.designer_id, text="a" * 5_000)
    add(world, new_id())
    (notice,) = read(world.designer)["items"]
    assert len(notice["text"]) == notices.MAX_TEXT_CHARS


FOLD = Fold("Shield Wing", "version approved", "versions approved")


def approve(world: World, *lines: str, event_id: str | None = None) -> None:
    """Write the news of approvals by one event for the designer."""
    news = {
        "event_id": event_id or str(new_id()),
        "studio_id": world.studio_id,
        "project_id": world.project_id,
        "topic": f"approved:{world.project_id}",
        "recipient": f"{world.designer_id}@example.test",
        "subject": FOLD,
        "lines": lines,
        "base_url": "https://sounds.example",
        "path": "/desk",
        "delay_s": 60.0,
    }
    world.server.in_database(lambda session: service.write_news(session, **news))


def approvals(world: World) -> list[dict[str, Any]]:
    return [notice for notice in read(world.designer)["items"] if "approved" in notice["subject"]]


def test_the_text_of_a_fold_shows_five_lines_and_counts_the_rest():
    text, count = "", 0
    for lines in (["a"], ["b", "c"], ["d", "e", "f"], ["g"]):
        text, count = folded_text(text, count, lines), count + len(lines)
    assert text == "a\nb\nc\nd\ne\nand 2 more"
    assert folded_text("", 0, ["a"]) == "a"
    assert folded_text("", 0, list("abcdef")) == "a\nb\nc\nd\ne\nand 1 more"
    assert (FOLD.subject(1), FOLD.subject(2)) == ("Shield Wing: 1 version approved", "Shield Wing: 2 versions approved")


@pytest.mark.both_databases
def test_the_approvals_of_a_review_are_one_notice_and_one_mail(world: World):
    for number in range(7):
        approve(world, f"SW-00{number} hit: approved.", event_id=f"event {number}")
        approve(world, f"SW-00{number} hit: approved.", event_id=f"event {number}")  # a job that runs twice
    (notice,) = approvals(world)
    assert (notice["subject"], notice["path"]) == ("Shield Wing: 7 versions approved", "/desk")
    assert notice["text"].splitlines()[-2:] == ["SW-004 hit: approved.", "and 2 more"]
    (mail,) = [mail for mail in outbox(world) if "approved" in mail["subject"]]
    assert mail["subject"] == "Shield Wing: 7 versions approved"
    assert mail["text"].count("approved.") == 7


def test_what_was_read_and_what_a_pause_has_ended_take_no_more(world: World, monkeypatch: pytest.MonkeyPatch):
    approve(world, "SW-001 hit: approved.", event_id="first")
    (notice,) = approvals(world)
    world.designer.post("/v1/me/notices/read", json={"ids": [notice["id"]]}).raise_for_status()
    approve(world, "SW-001 hit: approved.", event_id="first")
    approve(world, "SW-002 hit: approved.")
    later = clock.now() + timedelta(hours=2)
    monkeypatch.setattr(clock, "now", lambda: later)
    approve(world, "SW-003 hit: approved.")
    approve(world, "SW-004 hit: approved.")
    shown = [(approval["subject"], approval["read_at"] is None) for approval in approvals(world)]
    assert shown == [
        ("Shield Wing: 2 versions approved", True),
        ("Shield Wing: 1 version approved", True),
        ("Shield Wing: 1 version approved", False),
    ]


def test_a_digest_has_one_part_for_the_approvals_among_other_news(world: World):
    body = {"cadences": {"sounds": "daily"}, "time_zone": "UTC", "daily_at": "08:00"}
    world.designer.put("/v1/me/mail-preferences", json=body).raise_for_status()
    approve(world, "SW-001 hit: approved.")
    facts = {"studio_id": world.studio_id, "project_id": world.project_id, "base_url": "https://sounds.example"}
    facts |= {"recipient": f"{world.designer_id}@example.test", "path": "/desk", "delay_s": 60.0}
    facts |= {"event_id": str(new_id()), "topic": "changes:x", "subject": "Shield Wing: 1 change requested"}
    world.server.in_database(lambda session: service.write_news(session, **facts, lines=["SW-009: duller."]))
    approve(world, "SW-002 hit: approved.")
    (mail,) = [mail for mail in outbox(world) if "news of the day" in mail["subject"]]
    parts = "Shield Wing: 2 versions approved", "SW-001 hit: approved.", "SW-002 hit: approved."
    expected = [*parts, "https://sounds.example/desk", "Shield Wing: 1 change requested", "SW-009: duller."]
    assert mail["text"].split("\n\n")[: len(expected)] == expected


def outbox(world: World) -> list[dict[str, Any]]:
    mails = world.producer.get(f"/v1/studios/{world.studio_id}/outbox").json()["mails"]
    return [mail for mail in mails if mail["recipient"] == f"{world.designer_id}@example.test"]
