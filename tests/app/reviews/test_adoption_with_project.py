"""A folder adopted with the project of its game: sets, loops, events, and the levels that count as approved."""

import base64
import gzip
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import sqlalchemy as sa

import audio_checks
from app.deliveries.adoptions.game_projects import read_sent
from app.deliveries.models import Adoption
from app.reviews.models import GameLevel
from tests.support.adoptions import adopt, folder, send, undo
from tests.support.server import World
from tests.support.waves import noise, wav_bytes

RATE = 44_100


def sound(seed: int) -> bytes:
    return wav_bytes(noise(dbfs=-24, seconds=0.3, rate=RATE, seed=seed), rate=RATE, bits=16)


FILES = {"a/step soft.wav": sound(1), "a/step hard.wav": sound(2), "a/wind.wav": sound(3), "a/old.wav": sound(4)}
SCENE = """[gd_scene format=3]
[ext_resource type="AudioStream" path="res://a/step soft.wav" id="1"]
[ext_resource type="AudioStream" path="res://a/step hard.wav" id="2"]
[ext_resource type="AudioStream" path="res://a/wind.wav" id="3"]
[sub_resource type="AudioStreamRandomizer" id="R"]
stream_0/stream = ExtResource("1")
stream_1/stream = ExtResource("2")
[node name="Main" type="Node"]
[node name="Steps" type="AudioStreamPlayer" parent="."]
stream = SubResource("R")
volume_db = -6.0
[node name="Wind" type="AudioStreamPlayer" parent="."]
stream = ExtResource("3")
"""
GODOT = {
    "project.godot": "config_version=5\n",
    "main.tscn": SCENE,
    "a/wind.wav.import": '[remap]\nimporter="wav"\n[params]\nedit/loop_mode=2\n',
}


def packed(texts: Any, path: str = "project.godot") -> dict[str, str]:
    whole = texts if isinstance(texts, bytes) else gzip.compress(json.dumps(texts).encode())
    return {"path": path, "content_base64": base64.b64encode(whole).decode()}


def body(files: Mapping[str, bytes] = FILES, **project: Any) -> dict[str, Any]:
    return {**folder(files), "project": packed(GODOT, **project)}


def opened(world: World) -> str:
    answer = world.producer.post(f"/v1/projects/{world.project_id}/adoptions", json=body())
    assert answer.status_code == 201, answer.text
    for path in answer.json()["missing"]:
        send(world, answer.json()["id"], path, FILES[path])
    return str(answer.json()["id"])


def adopted(world: World) -> str:
    adoption_id = opened(world)
    answer = adopt(world, adoption_id)
    assert answer.status_code == 200, answer.text
    world.server.wait_for_jobs()
    return adoption_id


def test_the_plan_says_what_the_project_says(world: World) -> None:
    answer = world.producer.post(f"/v1/projects/{world.project_id}/adoption-plan", json=body())
    assert answer.status_code == 200, answer.text
    plan = answer.json()
    assert plan["project"] == {
        "name": "project.godot", "engine": "godot", "version": "", "played": 3, "unread_count": 0, "unread": [],
    }  # fmt: skip
    assert {one["file_name"]: (one["paths"], one["loop"], one["events"]) for one in plan["cues"]} == {
        "Steps": (["a/step hard.wav", "a/step soft.wav"], False, ["main.tscn"]),
        "wind": (["a/wind.wav"], True, ["main.tscn"]),
        "old": (["a/old.wav"], False, []),
    }
    assert [(one["path"], one["message"]) for one in plan["oddities"] if one["code"] == "unused"] == [
        ("a/old.wav", "no scene or script plays it in the project")
    ]


@pytest.mark.slow
def test_cues_have_loop_and_events_and_takes_say_their_level(world: World) -> None:
    adopted(world)
    cues = {
        one["file_name"]: one
        for one in world.producer.get(f"/v1/projects/{world.project_id}/sound-list").json()["cues"]
    }
    assert {name: (one["loop"], one["trigger"], one["variations"]) for name, one in cues.items()} == {
        "Steps": (False, "main.tscn", 2), "wind": (True, "main.tscn", 1), "old": (False, "", 1),
    }  # fmt: skip
    shown = world.producer.get(f"/v1/cues/{cues['Steps']['id']}/review").json()
    assert shown["takes"][0]["note"] == "In the game as a/step hard.wav, played at -6.0 dB"


@pytest.mark.slow
def test_the_level_in_the_game_is_the_approved_one(world: World, tmp_path: Path) -> None:
    adopted(world)
    url = f"/v1/projects/{world.project_id}/manifest.json"
    world.producer.get(url, params={"target": "game"})  # asks for what the sounds are known by
    world.server.wait_for_jobs()
    answer = world.producer.get(url, params={"target": "game"})
    assert answer.status_code == 200, answer.text
    plays = {one["path"].rpartition("/")[2]: one.get("plays") for one in answer.json()["files"]}
    part = {"object": "main.tscn: Steps", "property": "volume_db", "gain_db": -6.0}
    assert plays["Steps_01.wav"] == [{"object": "main.tscn: Steps", "gain_db": -6.0, "parts": [part]}]
    assert plays["wind.wav"] == [{"object": "main.tscn: Wind", "gain_db": 0.0, "parts": []}]
    assert plays["old.wav"] is None
    (tmp_path / "approved.json").write_text(answer.text)
    (old,) = [one for one in audio_checks.read_manifest(tmp_path / "approved.json") if one.path.endswith("old.wav")]
    assert old.plays is None


@pytest.mark.slow
def test_undo_takes_the_levels_along(world: World) -> None:
    adoption_id = adopted(world)
    assert undo(world, adoption_id).status_code == 200
    rows = sa.select(GameLevel).where(GameLevel.project_id == world.project_id)
    assert world.server.in_database(lambda session: session.scalars(rows).all()) == []
    again = world.producer.get(f"/v1/adoptions/{adoption_id}/plan").json()
    assert again["plan"]["project"]["played"] == 3


@pytest.mark.parametrize(
    ("project", "says"),
    [
        (packed(b"not packed"), "not a gzip-compressed"),
        (packed(["a list"]), "wanted a JSON object"),
        (packed({"a": 1}), "wanted a JSON object"),
        (packed({"readme.txt": ""}), "was not sent"),
        (packed({"game.json": "[" * 50_000}, "game.json"), "is not JSON"),
        ({"path": "", "content_base64": "???"}, "base64"),
        (packed(gzip.compress(b" " * (65 << 20))), "64 MiB"),
    ],
)
def test_what_is_no_project_is_refused_and_nothing_is_written(world: World, project: dict[str, str], says: str) -> None:
    url = f"/v1/projects/{world.project_id}/adoptions"
    refused = world.producer.post(url, json={**folder(FILES), "project": project})
    assert (refused.status_code, refused.json()["code"]) == (422, "game-project-unreadable"), refused.text
    assert says in refused.json()["detail"]
    rows = sa.select(Adoption).where(Adoption.project_id == world.project_id)
    assert world.server.in_database(lambda session: session.scalars(rows).all()) == []


def test_no_one_else_has_a_project_read(world: World) -> None:
    for client, status in ((world.designer, 403), (world.reviewer, 403), (world.stranger, 404)):
        assert client.post(f"/v1/projects/{world.project_id}/adoption-plan", json=body()).status_code == status


def test_texts_that_no_database_holds_are_stored_without_the_fault() -> None:
    scene = SCENE.replace("Steps", "St\\u0000eps\ud800")
    texts = json.dumps({**GODOT, "main.tscn": scene})
    read = json.loads(read_sent("project.godot", gzip.compress(texts.encode())))
    assert "\0" not in json.dumps(read)
    json.dumps(read, ensure_ascii=False).encode()
