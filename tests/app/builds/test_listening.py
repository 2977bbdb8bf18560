"""The listening pass: what is said once counts once, becomes a task for the right person, and is counted."""

from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa

from app.builds.audits.rules import HeardAs, TaskKind, TaskRole, is_heard, role_of, task_of
from app.core.db import new_id
from app.notifications.models import Mail
from tests.app.builds.audited import approved_pack, audited, posted
from tests.support.server import World


@pytest.fixture
def listening(world: World, tmp_path: Path) -> dict[str, Any]:
    """A listening pass over a build in which the lasers are 6 dB louder."""
    report = audited(world, tmp_path, approved_pack(world), laser_fire=6.0)
    posted(world, report, "482")
    return started(world)


def started(world: World, by: Any = None) -> dict[str, Any]:
    answer = (by or world.producer).post(f"/v1/projects/{world.project_id}/listening-passes")
    assert answer.status_code == 201, answer.text
    now: dict[str, Any] = answer.json()["listening_pass"]
    return now


def seen(world: World, by: Any = None) -> dict[str, Any]:
    answer = (by or world.producer).get(f"/v1/projects/{world.project_id}/listening-pass")
    assert answer.status_code == 200, answer.text
    now: dict[str, Any] = answer.json()["listening_pass"]
    return now


def cue_named(listening: dict[str, Any], name: str) -> str:
    (found,) = [one["cue"]["id"] for one in listening["cues"] if one["cue"]["name"] == name]
    return str(found)


def say(world: World, listening: dict[str, Any], cue: str, said: str, *, by: Any = None, **more: Any) -> Any:
    body = {"note_id": str(new_id()), "cue_id": cue_named(listening, cue), "said": said} | more
    return (by or world.producer).post(f"/v1/listening-passes/{listening['id']}/notes", json=body)


def tasks(world: World, by: Any = None) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = (
        (by or world.producer).get(f"/v1/projects/{world.project_id}/game-tasks").json()["items"]
    )
    return found


def states(world: World) -> dict[str, Any]:
    found: dict[str, Any] = world.producer.get(f"/v1/projects/{world.project_id}/game-states").json()
    return found


def test_nothing_is_there_to_hear_before_a_build_was_audited(world: World) -> None:
    answer = world.producer.post(f"/v1/projects/{world.project_id}/listening-passes")
    assert (answer.status_code, answer.json()["code"]) == (409, "nothing-to-hear")
    now = world.producer.get(f"/v1/projects/{world.project_id}/listening-pass").json()
    assert now == {"listening_pass": None, "newest_audit": None}


@pytest.mark.slow
def test_a_pass_lists_the_cues_of_the_build_with_what_it_plays(world: World, listening: dict[str, Any]) -> None:
    assert [one["cue"]["name"] for one in listening["cues"]] == ["Laser fire", "UI confirm"]
    laser = listening["cues"][0]
    assert (laser["files"], laser["events"], laser["heard"]) == (2, ["Play_laser_fire"], False)
    assert (laser["gain_db"], laser["suggested_db"]) == pytest.approx((6.0, -6.0), abs=0.02)
    assert laser["move"]["property"] == "Volume"
    assert listening["cues"][1]["suggested_db"] is None
    assert started(world)["id"] == listening["id"], "a pass is continued"


@pytest.mark.slow
def test_what_is_too_loud_becomes_a_task_of_the_implementer_with_a_gain(
    world: World, listening: dict[str, Any]
) -> None:
    said = say(world, listening, "Laser fire", "too-loud", amount_db=-6.0, text="crunches over the dialogue")
    assert said.status_code == 201, said.text
    (task,) = tasks(world)
    assert (task["kind"], task["role"], task["gain_db"]) == ("too-loud", "implementer", -6.0)
    assert (task["text"], task["may_do"]) == ("crunches over the dialogue", True)
    assert task["where"].endswith("laser_fire, Volume")
    world.server.wait_for_jobs()
    find = sa.select(Mail.lines).where(Mail.studio_id == world.studio_id, Mail.topic.startswith("tasks:"))
    (lines,) = world.server.in_database(lambda session: session.scalars(find).all())
    assert any("too loud, suggested −6.0 dB" in line for line in lines)


@pytest.mark.slow
def test_what_is_too_long_becomes_a_task_of_its_designer(world: World, listening: dict[str, Any]) -> None:
    assert say(world, listening, "UI confirm", "too-long").status_code == 201
    assert say(world, listening, "Laser fire", "missing").status_code == 201
    (own,) = tasks(world, world.designer)
    assert (own["kind"], own["role"], own["may_do"]) == ("too-long", "designer", True)
    assert len(tasks(world)) == 2
    done = world.designer.put(f"/v1/game-tasks/{own['id']}", json={"is_done": True})
    assert done.status_code == 200, done.text
    assert tasks(world, world.designer) == []
    note = next(one for one in seen(world)["notes"] if one["cue"]["name"] == "UI confirm")
    assert note["is_done"] is True
    other = next(task for task in tasks(world))
    assert world.designer.put(f"/v1/game-tasks/{other['id']}", json={"is_done": True}).status_code == 404


@pytest.mark.slow
def test_a_note_sent_again_counts_once_and_one_taken_back_not_at_all(world: World, listening: dict[str, Any]) -> None:
    body = {
        "note_id": str(new_id()),
        "cue_id": cue_named(listening, "Laser fire"),
        "said": "too-soft",
        "amount_db": 3.0,
    }
    url = f"/v1/listening-passes/{listening['id']}/notes"
    first, again = (world.producer.post(url, json=body) for _ in range(2))
    assert (first.status_code, again.status_code) == (201, 201)
    assert first.json() == again.json()
    assert len(tasks(world)) == 1
    taken = world.approver.post(url, json=body)
    assert (taken.status_code, taken.json()["code"]) == (409, "listening-note-taken")
    for _ in range(2):
        assert world.producer.delete(f"/v1/listening-notes/{body['note_id']}").status_code == 204
    assert world.approver.delete(f"/v1/listening-notes/{body['note_id']}").status_code == 404
    assert (tasks(world), seen(world)["notes"], seen(world)["heard"]) == ([], [], 0)
    assert world.producer.post(url, json=body).status_code == 201, "it comes late, and stays taken back"
    assert seen(world)["notes"] == []


@pytest.mark.slow
def test_a_later_note_of_the_same_person_replaces_theirs_alone(world: World, listening: dict[str, Any]) -> None:
    say(world, listening, "Laser fire", "too-loud", amount_db=-6.0)
    say(world, listening, "Laser fire", "wrong", by=world.reviewer)
    say(world, listening, "Laser fire", "good")
    assert {(one["said"], one["written_by"]["name"]) for one in seen(world)["notes"]} == {
        ("good", "Producer"), ("wrong", "Composer"),
    }  # fmt: skip
    assert [task["kind"] for task in tasks(world)] == ["wrong"]
    assert seen(world)["people"] == 2


@pytest.mark.slow
def test_not_reached_and_missing_are_not_heard_and_what_was_never_heard_is_counted(
    world: World, listening: dict[str, Any]
) -> None:
    before = states(world)
    assert (before["cues"], before["in_build"], before["heard"], before["never_heard"]) == (3, 2, 0, 3)
    say(world, listening, "Laser fire", "not-reached")
    say(world, listening, "UI confirm", "missing")
    assert (seen(world)["heard"], states(world)["never_heard"]) == (0, 3)
    assert [task["kind"] for task in tasks(world)] == ["missing"]
    say(world, listening, "Laser fire", "good")
    now = states(world)
    assert (seen(world)["heard"], now["heard"], now["never_heard"]) == (1, 1, 2)
    assert [(one["cue"]["name"], one["in_build"]) for one in now["unheard"]] == [
        ("UI confirm", "audit"),
        ("Warp in", None),
    ]
    assert now["build"] == "482"


@pytest.mark.slow
def test_an_implementer_sets_a_state_by_hand_and_a_reviewer_does_not(world: World, listening: dict[str, Any]) -> None:
    cue_id = next(state["cue"]["id"] for state in states(world)["unheard"] if state["cue"]["name"] == "Warp in")
    url = f"/v1/cues/{cue_id}"
    body = {"mark": "in-build", "is_set": True}
    refused = world.reviewer.put(f"{url}/game-state", json=body)
    assert (refused.status_code, refused.json()["code"]) == (403, "implementer-needed")
    assert world.designer.put(f"{url}/game-state", json=body).status_code == 403
    assert world.stranger.put(f"{url}/game-state", json=body).status_code == 404
    for _ in range(2):
        now = world.producer.put(f"{url}/game-state", json=body)
        assert now.status_code == 200, now.text
    assert now.json()["in_build"] == 3
    assert world.producer.put(f"{url}/game-state", json=body | {"is_set": False}).json()["in_build"] == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    "more",
    [
        {"said": "too-loud", "amount_db": 3.0},
        {"said": "too-soft", "amount_db": -3.0},
        {"said": "too-soft", "amount_db": 0},
        {"said": "good", "amount_db": 3.0},
        {"said": "quiet"},
        {"said": "good", "text": "x" * 1_001},
    ],
)
def test_a_note_that_contradicts_itself_is_refused(
    world: World, listening: dict[str, Any], more: dict[str, Any]
) -> None:
    body = {"note_id": str(new_id()), "cue_id": cue_named(listening, "UI confirm")} | more
    assert world.producer.post(f"/v1/listening-passes/{listening['id']}/notes", json=body).status_code == 422


@pytest.mark.slow
def test_a_note_that_comes_late_keeps_its_time_within_the_pass(world: World, listening: dict[str, Any]) -> None:
    tomorrow = (datetime.now(UTC) + timedelta(days=1)).isoformat()
    said = say(world, listening, "UI confirm", "good", written_at=tomorrow).json()
    assert datetime.fromisoformat(said["written_at"]) <= datetime.now(UTC)
    said = say(world, listening, "UI confirm", "good", written_at="1999-01-01T00:00:00Z").json()
    assert said["written_at"] == listening["started_at"]


@pytest.mark.slow
def test_designers_hear_their_own_cues_and_others_see_no_pass(world: World, listening: dict[str, Any]) -> None:
    assert len(seen(world, world.designer)["cues"]) == 2
    assert say(world, listening, "UI confirm", "too-short", by=world.designer).status_code == 201
    url = f"/v1/listening-passes/{listening['id']}"
    for client in (world.stranger, world.other_designer):
        assert client.get(f"/v1/projects/{world.project_id}/listening-pass").status_code == 404
        assert client.post(f"{url}/notes", json={}).status_code in (404, 422)
        assert client.post(f"{url}/close").status_code == 404


@pytest.mark.slow
def test_a_closed_pass_takes_no_notes_and_the_next_begins_with_the_newest_build(
    world: World, listening: dict[str, Any]
) -> None:
    url = f"/v1/listening-passes/{listening['id']}/close"
    refused = world.reviewer.post(url)
    assert (refused.status_code, refused.json()["code"]) == (403, "team-needed")
    assert [world.producer.post(url).status_code for _ in range(2)] == [204, 204]
    late = say(world, listening, "UI confirm", "good")
    assert (late.status_code, late.json()["code"]) == (409, "listening-pass-closed")
    assert started(world)["id"] != listening["id"]


def test_whose_task_a_note_is() -> None:
    said = {HeardA: task_of(HeardA) for HeardA in HeardAs}
    assert {one for one, task in said.items() if task is None} == {HeardAs.GOOD, HeardAs.NOT_REACHED}
    of_designer = {task for task in said.values() if task and role_of(task) is TaskRole.DESIGNER}
    assert of_designer == {TaskKind.TOO_LONG, TaskKind.TOO_SHORT, TaskKind.WRONG}
    assert {HeardA for HeardA in HeardAs if not is_heard(HeardA)} == {HeardAs.MISSING, HeardAs.NOT_REACHED}
