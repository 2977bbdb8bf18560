"""A pack with the import files of an engine: asked for by name, part of its sums, and remembered for the next."""

import io
import json
import zipfile
from typing import Any

import pytest

from tests.app.builds.approved import accepted_list, approve
from tests.app.builds.test_packs import KEY, SOUNDS, download
from tests.app.builds.test_sealed_packs import fetch, seal
from tests.support.deliver import add_cues
from tests.support.server import World

pytestmark = pytest.mark.slow

FILES = {
    "none": [],
    "wwise": ["wwise/sounds.tsv", "wwise/events.tsv"],
    "fmod": ["Scripts/soundlist_import.js", "soundlist-handoff.json"],
    "unity": [f"Soundlist/{name}" for name in ("SoundlistSet.cs", "Editor/SoundlistImporter.cs")]
    + ["Soundlist/Editor/soundlist-handoff.json"],
    "unreal": ["soundlist_import.py", "soundlist-handoff.json"],
    "godot": ["laser_fire_01.wav.import", "laser_fire_02.wav.import", "laser_fire.tres", "ui_confirm.wav.import"],
}


def opened(content: bytes) -> zipfile.ZipFile:
    return zipfile.ZipFile(io.BytesIO(content))


def test_each_engine_gets_its_files_and_nothing_else(world: World) -> None:
    accepted_list(world)
    for handoff, files in FILES.items():
        whole = download(world, handoff=handoff)
        with opened(whole) as archive:
            assert archive.namelist() == SOUNDS + files + KEY
            assert [line.split("  ")[1] for line in archive.read("SHA256SUMS").decode().splitlines()] == (
                SOUNDS + files + KEY[:-1]
            )
    assert download(world, handoff="godot") == whole  # the last of them, byte by byte
    answer = world.producer.get(f"/v1/projects/{world.project_id}/pack.zip", params={"handoff": "cryengine"})
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid-request")


def test_the_document_says_what_the_list_says(world: World) -> None:
    cues = add_cues(
        world,
        {
            "name": "Laser fire",
            "variations": 2,
            "category": "weapon",
            "description": "Bright,\nthin.",
            "trigger": "the trigger is pulled",
            "extra": {"FMOD event": "event:/Weapons/Laser/Fire", "Event": "Play_Laser", "Language": "fr"},
        },
    )
    approve(world, cues)
    with opened(download(world, handoff="fmod")) as archive:
        (sound,) = json.loads(archive.read("soundlist-handoff.json"))["sounds"]
    assert sound["event_path"] == ["Weapons", "Laser", "Fire"]
    assert (sound["cue"], sound["category"], sound["language"]) == ("SW-001", "weapon", "fr")
    assert sound["notes"] == "SW-001 Laser fire. Bright, thin. Trigger: the trigger is pulled"
    assert [file["path"] for file in sound["files"]] == SOUNDS[:2]
    assert [file["duration_s"] for file in sound["files"]] == [0.25, 0.25]
    with opened(download(world, handoff="wwise")) as archive:
        assert archive.read("wwise/events.tsv").endswith(b"Play_Laser@Play\r\n")
        assert "wwise/voices-fr.tsv" in archive.namelist()


def test_placeholders_are_handed_over_and_called_so(world: World) -> None:
    accepted_list(world)
    body = {"target": "game"}
    assert world.producer.post(f"/v1/projects/{world.project_id}/placeholders", json=body).status_code == 202
    world.server.wait_for_jobs()
    with opened(download(world, handoff="fmod", placeholders=True)) as archive:
        sounds = json.loads(archive.read("soundlist-handoff.json"))["sounds"]
    notes = {sound["name"]: sound["notes"] for sound in sounds}
    assert list(notes) == ["laser_fire", "ui_confirm", "warp_in"]
    assert notes["warp_in"].startswith("PLACEHOLDER: not the final sound; it must not ship. SW-003 Warp in.")
    assert "PLACEHOLDER" not in notes["laser_fire"]


@pytest.mark.both_databases
def test_a_sealed_pack_keeps_its_hand_off_and_new_events_come_once(world: World) -> None:
    accepted_list(world)
    url = f"/v1/projects/{world.project_id}/pack"
    params: dict[str, Any] = {"target": "game"}
    assert world.producer.get(url, params=params).json()["handoff"] == "none"
    first = seal(world, handoff="wwise")
    assert first["handoff"] == "wwise"
    with fetch(world, first) as archive:
        assert archive.namelist() == SOUNDS + FILES["wwise"] + KEY
    assert world.producer.get(url, params=params).json()["handoff"] == "wwise"
    assert world.producer.get(url, params={"target": "handheld"}).json()["handoff"] == "none"
    with opened(download(world, handoff="wwise")) as archive:
        assert "wwise/events.tsv" not in archive.namelist()
    with opened(download(world, handoff="wwise", target="handheld")) as archive:
        assert "wwise/events.tsv" in archive.namelist()
    approve(world, add_cues(world, {"name": "Siren"}))
    second = seal(world, handoff="wwise")
    with fetch(world, second) as archive:
        (_, *rows) = archive.read("wwise/events.tsv").decode().splitlines()
        assert [row.rpartition("\\")[2] for row in rows] == ["Play_siren@Play"]
    with fetch(world, first) as archive:
        assert archive.read("wwise/events.tsv").count(b"@Play") == 2
