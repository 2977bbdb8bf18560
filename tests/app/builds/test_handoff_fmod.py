"""FMOD Studio: the script run by Node over the documented calls; it was never run in FMOD Studio itself."""

import json
import shutil
import subprocess
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings

from app.builds.engine_export import engines
from app.builds.engine_export.cues import ExportedCue, Handoff
from app.builds.engine_export.engines.fmod import import_files
from tests.app.builds.handed import CUES, HUM, LASER, cue, hostile_cues

STUDIO = Path(__file__).resolve().parents[2] / "support" / "editors" / "fmod_studio.js"
NODE = shutil.which("node") or "node"


def unpack(folder: Path, cues: list[ExportedCue]) -> Path:
    for path, content in import_files(cues).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)
    for path in (file.path for one in cues for file in one.files):
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(b"RIFF")
    return folder


def run(folder: Path, *more: str) -> dict[str, Any]:
    script = str(folder / "Scripts" / "soundlist_import.js")
    done = subprocess.run([NODE, str(STUDIO), script, str(folder), *more], capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    found: dict[str, Any] = json.loads(done.stdout)
    return found


def test_events_are_made_by_category_and_a_second_run_changes_nothing(tmp_path: Path) -> None:
    found = run(unpack(tmp_path, CUES), "2")
    assert found["menu"] == ["Soundlist\\Import pack"]
    events = {event["path"]: event for event in found["events"]}
    assert list(events) == ["event:/weapon/laser_fire", "event:/Ambience/Ship/Hum", "event:/Play_Confirm"]
    assert events["event:/weapon/laser_fire"]["assets"] == ["weapon/laser_fire_01.wav", "weapon/laser_fire_02.wav"]
    assert events["event:/weapon/laser_fire"]["note"] == "SW-001 Laser fire. Bright, thin."
    assert events["event:/weapon/laser_fire"]["loops"] == []
    assert events["event:/Ambience/Ship/Hum"]["loops"] == [[pytest.approx(0.1), pytest.approx(11.9)]]
    assert found["streamed"] == ["ambience/hum.wav"]
    first, second = found["runs"]
    assert first["changes"] > 0
    assert first["shown"] == "3 events and 3 folders made, 4 files imported, 0 variations added."
    assert second == {
        "changes": 0,
        "shown": "0 events and 0 folders made, 0 files imported, 0 variations added.",
    }


def test_a_new_variation_is_added_to_its_set(tmp_path: Path) -> None:
    taken_out = "events[0].groupTracks[0].modules[0].sounds.pop()"
    found = run(unpack(tmp_path, [LASER]), "3", taken_out)
    assert [one["shown"].split(", ")[2] for one in found["runs"]] == [
        "0 variations added.",
        "1 variations added.",
        "0 variations added.",
    ]
    assert found["events"][0]["assets"] == ["weapon/laser_fire_01.wav", "weapon/laser_fire_02.wav"]
    assert found["runs"][2]["changes"] == 0


def test_an_event_that_plays_something_else_is_left_and_named(tmp_path: Path) -> None:
    other = "events[0].groupTracks[0].modules.pop()"
    found = run(unpack(tmp_path, [HUM]), "2", other)
    assert found["runs"][1]["changes"] == 0
    assert "Left as they are, because they play other files: event:/Ambience/Ship/Hum" in found["runs"][1]["shown"]


@pytest.mark.slow
def test_a_lost_file_stops_its_event_only(tmp_path: Path) -> None:
    folder = unpack(tmp_path, CUES)
    (folder / LASER.files[0].path).unlink()
    shown = run(folder)["runs"][0]["shown"]
    assert "2 events" in shown
    assert "Not imported: SW-001: Assets/weapon/laser_fire_01.wav could not be imported." in shown


def test_files_outside_assets_are_imported_once_and_named_afterwards(tmp_path: Path) -> None:
    found = run(unpack(tmp_path, [cue(1, "boom.wav")]), "2")
    assert found["events"][0]["assets"] == ["boom.wav"]
    assert found["runs"][1]["changes"] == 0
    assert "1 files are in the project already." in found["runs"][1]["shown"]


def test_without_the_document_it_says_where_the_pack_belongs(tmp_path: Path) -> None:
    folder = unpack(tmp_path, CUES)
    (folder / "soundlist-handoff.json").unlink()
    assert "Unpack the pack there." in run(folder)["runs"][0]["shown"]


def test_an_event_that_is_called_as_a_folder_has_a_name_of_its_own(tmp_path: Path) -> None:
    both = [cue(1, "a.wav", event="UI"), cue(2, "b.wav", event="ui/Back"), cue(3, "c.wav", event="UI")]
    found = run(unpack(tmp_path, both), "2")
    assert [event["path"] for event in found["events"]] == ["event:/UI_SW_001", "event:/ui/Back", "event:/UI_SW_003"]
    assert found["runs"][1]["changes"] == 0


@pytest.mark.slow
@settings(max_examples=5, deadline=None)
@given(cues=hostile_cues())
def test_hostile_names_are_only_names(tmp_path_factory, cues: list[ExportedCue]) -> None:
    found = run(unpack(tmp_path_factory.mktemp("project"), cues), "2")
    assert len(found["events"]) == len(cues)
    assert found["runs"][1]["changes"] == 0
    assert sum(len(event["assets"]) for event in found["events"]) == sum(len(one.files) for one in cues)


def test_each_module_is_an_engine_that_can_be_chosen():
    modules = {path.stem for path in Path(engines.__file__).parent.glob("*.py")} - {"__init__"}
    assert set(Handoff) == modules | {"none"}
    assert len(modules) >= 5
    for name in modules:
        assert callable(import_module(f"{engines.__name__}.{name}").import_files)


def test_an_unknown_engine_is_refused_with_those_that_there_are():
    with pytest.raises(ValueError, match="one of none, fmod, godot, unity, unreal, wwise"):
        Handoff("renderware")
