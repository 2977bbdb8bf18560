"""Audits of builds: kept sound by sound, what is new, drift accepted with a reason, and sent back."""

import copy
from pathlib import Path
from typing import Any

import pytest

from app.builds.audits.rules import AuditStatus, Drift, is_in_build
from audio_checks.audit.statuses import STATUSES
from tests.app.builds.audited import approved_pack, audited, post, posted, sounds_of
from tests.app.builds.test_builds import token
from tests.support.server import World

LASERS = ["laser_fire_01.wav", "laser_fire_02.wav"]


@pytest.fixture
def game(world: World, tmp_path: Path) -> dict[str, Any]:
    """Two audits: the game as approved, and with the lasers turned up by 6 dB."""
    sounds = approved_pack(world)
    assert sorted(sounds) == [*LASERS, "ui_confirm.wav"]
    return {
        "sounds": sounds,
        "first": posted(world, audited(world, tmp_path / "a", sounds), "481"),
        "second": posted(world, audited(world, tmp_path / "b", sounds, laser_fire=6.0), "482"),
    }


def test_the_words_of_audits_are_those_of_the_command() -> None:
    assert [status.value for status in AuditStatus] == list(STATUSES)


@pytest.mark.slow
def test_a_sound_turned_up_in_the_project_is_named_with_its_property(world: World, game: dict[str, Any]) -> None:
    first, second = game["first"], game["second"]
    assert (first["sounds"], first["drifted"], first["new_drifts"], first["engine"]) == (3, 0, 0, "wwise")
    assert (second["drifted"], second["new_drifts"]) == (2, 2)
    sounds = sounds_of(world, second)
    laser = sounds[LASERS[0]]
    assert (laser["status"], laser["played_status"], laser["is_new"]) == ("gain", "gain", True)
    assert (laser["gain_db"], laser["file_db"], laser["property_db"]) == pytest.approx((6.0, 0.0, 6.0), abs=0.02)
    (move,) = laser["moves"]
    assert (move["property"], move["approved_db"], move["gain_db"]) == ("Volume", 0.0, 6.0)
    assert "laser_fire" in move["object"]
    assert laser["cue"]["name"] == "Laser fire"
    assert laser["events"] == ["Play_laser_fire"]
    assert laser["sound"]["preview_url"].startswith("/v1/sounds/")
    played = world.producer.get(f"/v1/takes/{laser['sound']['take_id']}").json()
    assert (played["cue"]["name"], played["state"]) == ("Laser fire", "approved")
    assert sounds["ui_confirm.wav"]["has_drifted"] is False
    assert set(sounds_of(world, second, drifted=True)) == set(LASERS)
    read = world.reviewer.get(f"/v1/audits/{second['id']}").json()
    assert (read["before"], read["accepted"], read["depends"]) == ("481", 0, 0)
    listed = world.reviewer.get(f"/v1/projects/{world.project_id}/audits").json()["items"]
    assert [one["label"] for one in listed] == ["482", "481"]
    history = world.reviewer.get(
        f"/v1/projects/{world.project_id}/sound-history", params={"path": laser["path"]}
    ).json()
    assert [(one["label"], one["status"]) for one in history] == [("482", "gain"), ("481", "same")]


@pytest.mark.slow
def test_accepted_drift_stays_accepted_until_the_level_is_another(
    world: World, game: dict[str, Any], tmp_path: Path
) -> None:
    second = game["second"]
    paths = {name: sounds_of(world, second)[name]["path"] for name in LASERS}
    for path in paths.values():
        body = {"path": path, "reason": "quiet under the battle music"}
        answer = world.approver.post(f"/v1/audits/{second['id']}/accepted-drifts", json=body)
        assert answer.status_code == 201, answer.text
        again = world.producer.post(f"/v1/audits/{second['id']}/accepted-drifts", json=body)
        assert again.json()["id"] == answer.json()["id"]
    accepted = sounds_of(world, second)[LASERS[0]]["accepted"]
    assert (accepted["reason"], accepted["accepted_by"]["name"]) == ("quiet under the battle music", "Audio director")
    assert accepted["accepted_at"]
    same = posted(world, audited(world, tmp_path / "c", game["sounds"], laser_fire=6.0), "483")
    assert (same["drifted"], same["new_drifts"]) == (2, 0)
    assert sounds_of(world, same)[LASERS[0]]["accepted"]["id"] == accepted["id"]
    louder = posted(world, audited(world, tmp_path / "d", game["sounds"], laser_fire=9.0), "484")
    assert (louder["drifted"], louder["new_drifts"]) == (2, 2)
    assert sounds_of(world, louder)[LASERS[0]]["accepted"] is None
    # The game's CI lets through the same, and nothing else.
    baseline = world.producer.get(f"/v1/projects/{world.project_id}/baseline.json").json()
    (kept,) = [one for one in baseline["accepted"] if one["path"] == paths[LASERS[0]]]
    assert (kept["status"], kept["played_status"], kept["gain_db"]) == ("gain", "gain", pytest.approx(6.0, abs=0.02))
    assert world.approver.delete(f"/v1/accepted-drifts/{accepted['id']}").status_code == 204
    assert sounds_of(world, same)[LASERS[0]]["accepted"] is None


@pytest.mark.slow
def test_a_reason_is_needed_and_a_person_who_acts_for_the_team(world: World, game: dict[str, Any]) -> None:
    second = game["second"]
    url, path = f"/v1/audits/{second['id']}/accepted-drifts", sounds_of(world, second)[LASERS[0]]["path"]
    assert world.producer.post(url, json={"path": path, "reason": "   "}).status_code == 422
    refused = world.reviewer.post(url, json={"path": path, "reason": "fine"})
    assert (refused.status_code, refused.json()["code"]) == (403, "team-needed")
    fine = sounds_of(world, second)["ui_confirm.wav"]["path"]
    answer = world.producer.post(url, json={"path": fine, "reason": "fine"})
    assert (answer.status_code, answer.json()["code"]) == (409, "nothing-drifted")
    gone = world.producer.post(url, json={"path": "nowhere.wav", "reason": "fine"})
    assert (gone.status_code, gone.json()["code"]) == (404, "audited-sound-not-found")


@pytest.mark.slow
def test_what_is_sent_back_is_one_task_for_the_implementers(world: World, game: dict[str, Any]) -> None:
    second = game["second"]
    path = sounds_of(world, second)[LASERS[0]]["path"]
    sent = world.approver.post(f"/v1/audits/{second['id']}/tasks", json={"path": path})
    assert sent.status_code == 201, sent.text
    task = sent.json()
    assert (task["kind"], task["role"], task["gain_db"]) == ("drift", "implementer", pytest.approx(-6.0, abs=0.02))
    assert task["where"].endswith("laser_fire, Volume")
    again = world.approver.post(f"/v1/audits/{second['id']}/tasks", json={"path": path})
    assert again.json()["id"] == task["id"]
    assert sounds_of(world, second)[LASERS[0]]["task_id"] == task["id"]
    refused = world.reviewer.put(f"/v1/game-tasks/{task['id']}", json={"is_done": True})
    assert (refused.status_code, refused.json()["code"]) == (403, "implementer-needed")
    assert world.designer.put(f"/v1/game-tasks/{task['id']}", json={"is_done": True}).status_code == 404
    done = world.producer.put(f"/v1/game-tasks/{task['id']}", json={"is_done": True}).json()
    assert done["done_at"]
    tasks = f"/v1/projects/{world.project_id}/game-tasks"
    assert world.producer.get(tasks).json()["items"] == []
    assert [one["id"] for one in world.producer.get(tasks, params={"done": True}).json()["items"]] == [task["id"]]


@pytest.mark.slow
def test_a_level_that_depends_on_the_game_is_no_drift_and_not_the_same(
    world: World, game: dict[str, Any], tmp_path: Path
) -> None:
    report = audited(world, tmp_path / "e", game["sounds"])
    sound = next(one for one in report["files"] if one["path"].endswith("ui_confirm.wav"))
    sound["status"] = sound["played_status"] = "depends"
    sound["plays"][0]["depends"] = [{"object": "x", "property": "Volume", "on": "state", "what": "Menu open"}]
    audit = posted(world, report, "485")
    assert audit["drifted"] == 0
    assert world.producer.get(f"/v1/audits/{audit['id']}").json()["depends"] == 1
    shown = sounds_of(world, audit)["ui_confirm.wav"]
    assert (shown["status"], shown["depends"], shown["has_drifted"]) == ("depends", ["Menu open"], False)


@pytest.mark.slow
def test_a_build_posts_by_its_token_and_a_designer_sees_none_of_it(world: World, game: dict[str, Any]) -> None:
    report = {"schema_version": 1, "tool": {"name": "audio-checks", "version": "1"}, "files": []}
    assert post(world, report, by=token(world, "checks:write")).status_code == 201
    assert post(world, report, by=token(world, "list:read")).status_code == 403
    url = f"/v1/audits/{game['second']['id']}"
    for client, status in ((world.designer, 403), (world.stranger, 404), (world.other_designer, 404)):
        assert client.get(url).status_code == status
        assert client.get(f"{url}/sounds").status_code == status
        assert client.post(f"{url}/tasks", json={"path": "x"}).status_code == status


def hostile(change: dict[str, Any]) -> dict[str, Any]:
    sound = {
        "path": "a.wav", "status": "gain", "gain_db": 1.0, "offset_s": 0.0, "approved": "a.wav", "message": "",
        "matches": [{"cue": "SW-1", "take": "no id", "path": "a.wav", "score": 1.0}],
    }  # fmt: skip
    files = [{**copy.deepcopy(sound), **change}]
    return {"schema_version": 1, "tool": {"name": "audio-checks", "version": "1"}, "files": files}


@pytest.mark.parametrize(
    "change",
    [
        {"path": ""},
        {"path": "x" * 1_001},
        {"status": "fine"},
        {"gain_db": 1e9},
        {"message": "x" * 20_001},
        {"matches": [{"cue": None, "take": None, "path": "a"}] * 1_001},
        {"plays": [{"gain_db": 1}]},
        {"plays": "loud"},
    ],
)
def test_a_report_that_is_none_is_refused(world: World, change: dict[str, Any]) -> None:
    assert post(world, hostile(change)).status_code == 422


def test_what_a_report_names_is_looked_up_in_its_project(world: World) -> None:
    """A take of another project, or a text that is not an id, belongs to no cue here."""
    audit = posted(world, hostile({}))
    (sound,) = sounds_of(world, audit).values()
    assert (sound["cue"], sound["sound"]) == (None, None)


def test_another_change_is_another_drift() -> None:
    up = Drift("a", AuditStatus.GAIN, AuditStatus.GAIN, 6.0)
    assert up.is_same(Drift("a", AuditStatus.GAIN, AuditStatus.GAIN, 6.05))
    assert not up.is_same(Drift("a", AuditStatus.GAIN, AuditStatus.GAIN, 6.2))
    assert not up.is_same(Drift("b", AuditStatus.GAIN, AuditStatus.GAIN, 6.0))
    assert not up.is_same(Drift("a", AuditStatus.TRIMMED, AuditStatus.GAIN, 6.0))
    assert not up.is_same(Drift("a", AuditStatus.GAIN, AuditStatus.GAIN, None))


def test_a_cue_is_in_the_build_when_every_file_of_it_is_played() -> None:
    same, gain, unused = AuditStatus.SAME, AuditStatus.GAIN, AuditStatus.UNUSED
    assert is_in_build([(same, same), (gain, gain)])
    assert not is_in_build([])
    assert not is_in_build([(same, same), (AuditStatus.MISSING, same)])
    assert not is_in_build([(unused, unused)])
