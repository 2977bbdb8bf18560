"""Before the upload: what files would be judged by, and the sounds to which the check in the browser is held."""

from pathlib import Path
from typing import Any

import pytest

import audio_checks
from tests.support.browser_vectors import vectors
from tests.support.deliver import add_cues, checked, deliver
from tests.support.server import World
from tests.support.waves import sine, wav_bytes

ROOT = Path(__file__).resolve().parents[3]
VECTORS = ROOT / "frontend/src/precheck/vectors.json"


def preview(world: World, *files: dict[str, Any], **further: Any) -> dict[str, Any]:
    body = {"files": files, **further}
    answer = world.designer.post(f"/v1/projects/{world.project_id}/check-preview", json=body)
    assert answer.status_code == 200, answer.text
    found: dict[str, Any] = answer.json()
    return found


def save_spec(world: World, toml: str) -> None:
    path = f"/v1/projects/{world.project_id}/spec"
    version = world.producer.get(path).json()["version"]
    saved = world.producer.put(path, json={"toml": toml, "note": "", "based_on_version": version})
    assert saved.status_code == 200, saved.text


@pytest.mark.slow
def test_the_sounds_that_the_page_is_tried_on_are_what_the_server_says() -> None:
    assert VECTORS.read_text() == vectors(), "run: make openapi"


@pytest.mark.slow
def test_each_file_has_its_cue_and_the_view_of_its_category(world: World) -> None:
    save_spec(
        world,
        "format = 1\n[accept]\nbit_depths = [24]\n[categories.ui.accept]\nbit_depths = [16]\n"
        '[checks]\nbit-depth = "warning"\n',
    )
    add_cues(
        world,
        {"name": "Laser fire", "category": "weapons", "duration_s": 0.8},
        {"name": "Click", "category": "ui", "length_locked": True, "duration_s": 0.1, "frame_rate_fps": 30},
    )
    found = preview(
        world,
        {"file_name": "takes/laser_fire__alt2.wav"},
        {"file_name": "click.wav"},
        {"file_name": "who knows.wav"},
        {"file_name": "click__dry.wav"},
    )
    laser, click, unknown, dry = found["files"]
    views = [found["specs"][one["spec"]] for one in (laser, click, unknown)]
    assert [(view["category"], view["accept"]["bit_depths"]) for view in views] == [
        ("weapons", [24]),
        ("ui", [16]),
        (None, [24]),
    ]
    assert views[0]["levels"] == {"bit-depth": "warning"}
    assert (laser["cue"]["name"], click["cue"]["name"], unknown["cue"]) == ("Laser fire", "Click", None)
    locked = {"duration_s": 0.1, "length_locked": True, "frame_rate_fps": 30.0}
    assert click["length"] == locked | dict.fromkeys(("duration_min_s", "duration_max_s", "channels"))
    assert unknown["length"] is None
    assert [one["is_dry_stem"] for one in (laser, click, unknown, dry)] == [False, False, False, True]
    assert found["checks"][0] == {"name": "container", "label": "Container"}
    assert found["checks"][-1] == {"name": "naming", "label": "Name"}


def test_a_file_dropped_on_a_cue_is_that_cues(world: World) -> None:
    [cue] = add_cues(world, {"name": "Laser fire", "category": "weapons"})
    [file] = preview(world, {"file_name": "bounce 7.wav", "cue_id": cue["id"]})["files"]
    assert (file["cue"]["id"], file["findings"]) == (cue["id"], [])  # it will be named for its cue


@pytest.mark.slow
def test_a_name_is_found_wrong_in_the_words_of_the_check(world: World) -> None:
    save_spec(world, 'format = 1\n[naming]\npattern = "[a-z_]+"\nextension = ".wav"\n')
    add_cues(world, {"name": "Laser fire"})
    deliver(world, "unrelated.wav", wav_bytes(sine(hz=300, seconds=0.1)))
    [file] = preview(world, {"file_name": "laser_fire.WAV"})["files"]
    take = deliver(world, "laser_fire.WAV", wav_bytes(sine(hz=440, seconds=0.1)))
    report = checked(world, take["id"], by=world.approver)
    named = [one for one in report["findings"] if one["check"] == "naming"]
    assert [one["code"] for one in file["findings"]] == ["naming:extension"]
    assert [(one["message"], one["fix"]) for one in named] == [(one["message"], one["fix"]) for one in file["findings"]]


def test_a_name_that_a_fix_makes_valid_says_so(world: World) -> None:
    save_spec(world, 'format = 1\n[naming]\npattern = "[a-z_]+"\nextension = ".wav"\n')
    add_cues(world, {"name": "Laser fire"})
    [fixable, other] = preview(world, {"file_name": "laser_fire.WAV"}, {"file_name": "laser_fire.mp3"})["files"]
    assert [one["auto_fix"] for one in fixable["findings"]] == ["names it laser_fire.wav"]
    assert [(one["auto_fix"], "name" in one["no_auto_fix"]) for one in other["findings"]] == [(None, True)]


def test_a_name_that_is_not_the_lists_has_the_lists_name_proposed(world: World) -> None:
    save_spec(world, 'format = 1\n[naming]\npattern = "[a-z0-9_]+"\nextension = ".wav"\n')
    add_cues(world, {"name": "Laser fire"}, {"name": "Steps", "variations": 4}, {"name": "UI-Click"})
    proposed = {
        "laser_fire.wav": None,
        "Laser Fire FINAL.wav": None,  # sure: it is named for its cue anyway
        "big_laser_fire.wav": "laser_fire.wav",
        "old/big_laser_fire_altB.WAV": "laser_fire__alt2.wav",
        "big_laser_fire.flac": "laser_fire.flac",  # another kind of file is not made by its name
        "big_steps_3.wav": "steps_03.wav",
        "laser_fire.WAV": "laser_fire.wav",
        "big_laser_fire__dry.wav": None,
        "nothing like it.wav": None,
    }
    found = preview(world, *({"file_name": name} for name in proposed))
    assert {name: file["list_name"] for name, file in zip(proposed, found["files"], strict=True)} == proposed
    names = [{"file_name": name} for name in proposed.values() if name and name.endswith(".wav")]
    assert all(file["cue"] and file["findings"] == [] for file in preview(world, *names)["files"])


@pytest.mark.slow
def test_names_of_a_set_without_a_number_get_its_free_variations(world: World) -> None:
    cue, _ = add_cues(world, {"name": "Steps", "variations": 5}, {"name": "Doors", "variations": 2})
    for place, name in enumerate(["steps_02.wav", "doors_01.wav", "doors_02.wav"]):
        deliver(world, name, wav_bytes(sine(hz=300 + place, seconds=0.1)))
    proposed = {
        "steps.wav": "steps_01.wav",
        "big_steps_4.wav": "steps_04.wav",
        "steps final.wav": "steps_03.wav",
        "steps__dry.wav": None,
        "big steps.wav": "steps_05.wav",
        "my steps.wav": None,  # nothing is free any more
        "doors.wav": None,
    }
    found = preview(world, *({"file_name": name} for name in proposed))
    assert {name: file["list_name"] for name, file in zip(proposed, found["files"], strict=True)} == proposed
    assert [file["cue"] for file in found["files"]] == [None] * len(proposed)
    [held] = preview(world, {"file_name": "steps.wav"}, proposed=["steps_01.wav", "steps_03.flac", "other.wav"])[
        "files"
    ]
    assert held["list_name"] == "steps_04.wav"
    [dropped, named] = preview(world, {"file_name": "x.wav", "cue_id": cue["id"]}, {"file_name": "steps.wav"})["files"]
    assert (dropped["variation"], named["list_name"]) == (1, "steps_03.wav")


@pytest.mark.slow
def test_a_prefix_that_files_share_is_not_of_their_names(world: World) -> None:
    cues = ["Laser fire", "Shield hit", "Door open", "Airlock", "Victory sting"]
    add_cues(world, *({"name": name} for name in cues))
    files = [{"file_name": f"nordlicht_{name.lower().replace(' ', '_')}.wav"} for name in cues]
    found = [file["list_name"] for file in preview(world, *files)["files"]]
    assert found == ["laser_fire.wav", "shield_hit.wav", "door_open.wav", "airlock.wav", "victory_sting.wav"]


def test_whom_the_project_does_not_know_it_does_not_answer(world: World) -> None:
    asked = {"files": [{"file_name": "laser_fire.wav"}]}
    path = f"/v1/projects/{world.project_id}/check-preview"
    assert world.stranger.post(path, json=asked).status_code == 404
    assert world.reviewer.post(path, json=asked).status_code == 403
    other = world.designer.post(
        path, json={"files": [{"file_name": "a.wav", "cue_id": "00000000-0000-4000-8000-000000000000"}]}
    )
    assert (other.status_code, other.json()["code"]) == (404, "cue-not-found")


def test_more_files_than_one_request_holds_are_refused(world: World) -> None:
    many = [{"file_name": f"{place}.wav"} for place in range(201)]
    answer = world.designer.post(f"/v1/projects/{world.project_id}/check-preview", json={"files": many})
    assert answer.status_code == 422


def test_a_name_is_judged_without_a_file() -> None:
    spec = audio_checks.parse_spec('format = 1\n[naming]\npattern = "[a-z_]+"\n[checks]\nnaming = "warning"\n')
    [found] = audio_checks.check_name("Laser.wav", spec)
    assert (found.code, found.severity) == ("naming:pattern", "warning")
    off = audio_checks.parse_spec('format = 1\n[naming]\npattern = "[a-z_]+"\n[checks]\nnaming = "off"\n')
    assert audio_checks.check_name("Laser.wav", off) == ()
    assert audio_checks.check_name("Laser.wav", audio_checks.parse_spec("format = 1")) == ()
