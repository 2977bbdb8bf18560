"""Wwise: the tables read by the rules that Audiokinetic documents; they were never imported into Wwise itself."""

import re
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from hypothesis import given, settings

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.engines.wwise import import_files
from audio_checks.middleware.wwise import read_wwise
from tests.app.builds.handed import CONFIRM, CUES, LASER, cue, hostile_cues

COLUMNS = {"Audio File", "Object Path", "Object Type", "Notes", "Event"}
PROPERTY = re.compile(r"(Property|Reference)\[\w+\]")
TYPES = ("Virtual Folder", "Random Container", "Sound SFX", "Sound Voice")
TAGS = dict(zip(TYPES, ("Folder", "RandomSequenceContainer", "Sound", "Sound"), strict=True))
NAME = r'[^\\/:*?"<>|@\t\r\n]+'
PART = re.compile(rf"<({'|'.join(TYPES)})>({NAME})")
EVENT = re.compile(r"\\Events\\Default Work Unit\\([A-Za-z0-9_]+)@Play")


def read(table: bytes) -> list[dict[str, str]]:
    """Read a table, and refuse what the documents do not have."""
    text = table.decode("utf-8")
    assert text.endswith("\r\n")
    lines = text.removesuffix("\r\n").split("\r\n")
    assert not [line for line in lines if re.search(r"[\r\n\v\f\u2028\u2029\x00]", line)]
    head, *rows = (line.split("\t") for line in lines)
    assert len(set(head)) == len(head)
    assert [column for column in head if column not in COLUMNS and not PROPERTY.fullmatch(column)] == []
    assert {len(row) for row in rows} == {len(head)}
    return [dict(zip(head, row, strict=True)) for row in rows]


class Project:
    """What an import with "use existing" makes: objects by their paths, with a type, and events."""

    def __init__(self) -> None:
        self.objects: dict[str, dict[str, str]] = {}
        self.events: dict[str, str] = {}

    def import_table(self, table: bytes) -> None:
        for row in read(table):
            path = ""
            for part in row["Object Path"].split("\\"):
                found = PART.fullmatch(part)
                assert found, part
                path = f"{path}\\{found[2]}".lower()
                known = self.objects.setdefault(path, {"type": found[1]})
                assert known["type"] == found[1], path
            assert self.objects[path]["type"] == row["Object Type"]
            if row["Audio File"]:
                assert row["Object Type"].startswith("Sound ")
                assert re.fullmatch(r"\.\.\\[^\t]+\.\w+", row["Audio File"])
            else:
                assert "Event" in row or row["Object Type"] == "Random Container"
            self.objects[path] |= {name: text for name, text in row.items() if text and name != "Event"}
            if event := row.get("Event"):
                found = EVENT.fullmatch(event)
                assert found, event
                assert found[1] not in self.events
                self.events[found[1]] = path

    def save(self, folder: Path) -> Path:
        """Write the project as Wwise does, with the files in its Originals; return its path."""
        units = {"AudioObjects": ET.Element("ChildrenList"), "Events": ET.Element("ChildrenList")}
        elements: dict[str, ET.Element] = {}
        for path, facts in self.objects.items():
            above, _, name = path.rpartition("\\")
            parent = units["AudioObjects"] if not above else elements[above].find("ChildrenList")
            assert parent is not None
            element = ET.SubElement(parent, TAGS[facts["type"]], Name=name, ID=f"{{{path}}}")
            properties = ET.SubElement(element, "PropertyList")
            elements[path], children = element, ET.SubElement(element, "ChildrenList")
            for column, text in facts.items():
                if column.startswith("Property"):
                    value = {"Name": column[9:-1], "Type": "bool", "Value": text.capitalize()}
                    ET.SubElement(properties, "Property", value)
            if audio_file := facts.get("Audio File"):
                file_name = audio_file.rpartition("\\")[2]
                source = ET.SubElement(children, "AudioFileSource", Name=name, ID=f"{{source {path}}}")
                ET.SubElement(source, "Language").text = "SFX"
                ET.SubElement(source, "AudioFile").text = file_name
                (folder / "Originals" / "SFX").mkdir(parents=True, exist_ok=True)
                (folder / "Originals" / "SFX" / file_name).write_bytes(b"RIFF")
        for name, target in self.events.items():
            event = ET.SubElement(units["Events"], "Event", Name=name, ID=f"{{event {name}}}")
            action = ET.SubElement(ET.SubElement(event, "ChildrenList"), "Action", Name="", ID=f"{{action {name}}}")
            reference = ET.SubElement(ET.SubElement(action, "ReferenceList"), "Reference", Name="Target")
            ET.SubElement(reference, "ObjectRef", Name="", ID=f"{{{target}}}")
        for category, children in units.items():
            document = ET.Element("WwiseDocument", Type="WorkUnit", ID=f"{{{category}}}", SchemaVersion="110")
            unit = {"Name": "Default Work Unit", "ID": f"{{{category}}}", "PersistMode": "Standalone"}
            ET.SubElement(ET.SubElement(document, category), "WorkUnit", unit).append(children)
            (folder / f"{category}.wwu").write_bytes(ET.tostring(document))
        (folder / "Game.wproj").write_text('<WwiseDocument Type="Project" WwiseVersion="v2023.1.4"/>')
        return folder / "Game.wproj"


def imported(cues: list[ExportedCue]) -> Project:
    project = Project()
    for name, table in import_files(cues, set()).items():
        assert name.startswith("wwise/")
        project.import_table(table)
    return project


def test_a_set_is_a_random_container_with_its_sounds() -> None:
    project = imported(CUES)
    assert project.objects["\\weapon\\laser_fire"]["type"] == "Random Container"
    assert project.objects["\\weapon\\laser_fire"]["Notes"] == "SW-001 Laser fire. Bright, thin."
    first = project.objects["\\weapon\\laser_fire\\laser_fire_01"]
    assert (first["type"], first["Audio File"]) == ("Sound SFX", "..\\Assets\\weapon\\laser_fire_01.wav")
    assert first["Property[IsLoopingEnabled]"] == "false"
    assert "Property[IsStreamingEnabled]" not in first
    hum = project.objects["\\ambience\\hum"]
    assert (hum["Property[IsLoopingEnabled]"], hum["Property[IsStreamingEnabled]"]) == ("true", "true")
    assert project.events == {
        "Play_laser_fire": "\\weapon\\laser_fire",
        "Hum": "\\ambience\\hum",
        "Play_Confirm": "\\ui_confirm",
    }


def test_the_audit_finds_events_loops_and_levels_of_what_was_imported(tmp_path: Path) -> None:
    project = read_wwise(imported(CUES).save(tmp_path))
    assert project.unread == ()
    found = {
        one.file.rpartition("/")[2]: (one.events, one.is_looped, one.is_streamed, one.gain_db) for one in project.played
    }
    laser = (("Play_laser_fire",), False, False, 0.0)
    assert found == {
        "hum.wav": (("Hum",), True, True, 0.0),
        "laser_fire_01.wav": laser,
        "laser_fire_02.wav": laser,
        "ui_confirm.wav": (("Play_Confirm",), False, False, 0.0),
    }


def test_importing_the_sounds_again_changes_nothing() -> None:
    project = imported(CUES)
    before = {path: dict(facts) for path, facts in project.objects.items()}
    project.import_table(import_files(CUES, set())["wwise/sounds.tsv"])
    assert project.objects == before


def test_an_event_is_handed_over_once() -> None:
    known = {file.path for file in LASER.files}
    (_, *events) = import_files(CUES, known)["wwise/events.tsv"].decode().splitlines()
    assert [line.rpartition("\t")[2] for line in events] == [
        "\\Events\\Default Work Unit\\Hum@Play",
        "\\Events\\Default Work Unit\\Play_Confirm@Play",
    ]
    assert list(import_files([LASER], known)) == ["wwise/sounds.tsv"]


def test_lines_of_speech_have_a_table_for_each_language() -> None:
    line = cue(4, "vo/hello.wav", language="French (France)")
    files = import_files([*CUES, line], set())
    assert sorted(files) == ["wwise/events.tsv", "wwise/sounds.tsv", "wwise/voices-French_France.tsv"]
    (row,) = read(files["wwise/voices-French_France.tsv"])
    assert (row["Object Path"], row["Object Type"]) == ("<Sound Voice>hello", "Sound Voice")


@pytest.mark.parametrize(
    ("stated", "named"),
    [
        ("event:/Weapons/Laser", "Laser"),
        ("\\Events\\Default Work Unit\\Play_Laser@Play", "Play_Laser"),
        ("", "Play_ui_confirm"),
        ("Play Läser!", "Play_Laser"),
    ],
)
def test_an_event_keeps_the_name_that_the_list_states(stated: str, named: str) -> None:
    table = import_files([cue(3, "ui_confirm.wav", event=stated)], set())["wwise/events.tsv"]
    found = EVENT.fullmatch(read(table)[0]["Event"])
    assert found
    assert found[1] == named


def test_names_that_are_alike_in_wwise_are_parted() -> None:
    alike = [
        cue(1, "a@b.wav"),
        cue(2, "a_b.wav"),
        cue(3, "ui.wav"),
        cue(4, "ui/c@_1.wav", "ui/c__1.wav", name="c", category="ui"),
    ]
    assert list(imported(alike).objects) == [
        "\\a_b",
        "\\a_b_sw_002",
        "\\ui_sw_003",
        "\\ui",
        "\\ui\\c",
        "\\ui\\c\\c__1",
        "\\ui\\c\\c__1_02",
    ]


def test_two_cues_with_one_event_have_two() -> None:
    both = [CONFIRM, cue(9, "ui_cancel.wav", event="play_confirm")]
    assert list(imported(both).events) == ["Play_Confirm", "play_confirm_SW_009"]


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(cues=hostile_cues())
def test_hostile_names_stay_in_their_cells(cues: list[ExportedCue]) -> None:
    files = import_files(cues, set())
    assert files == import_files(cues, set())
    objects = imported(cues).objects
    assert len([one for one in objects.values() if "Audio File" in one]) == sum(len(one.files) for one in cues)
    rows = [row for name, table in files.items() if name != "wwise/events.tsv" for row in read(table)]
    assert len([row for row in rows if row["Audio File"]]) == sum(len(one.files) for one in cues)
    for row in rows:
        assert all(PART.fullmatch(part) for part in row["Object Path"].split("\\")), row["Object Path"]
    assert all(EVENT.fullmatch(row["Event"]) for row in read(files["wwise/events.tsv"]))
