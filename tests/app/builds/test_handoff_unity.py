"""Unity: the document against the fields that the scripts read, and the scripts' text; no C# compiler ran over them."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings

from app.builds.engine_export.cues import ExportedCue, file_safe
from app.builds.engine_export.document import script
from app.builds.engine_export.engines.unity import import_files
from tests.app.builds.handed import CUES, HUM, LASER, cue, file, hostile_cues

SCRIPTS = ("SoundlistImporter.cs", "SoundlistSet.cs")
TOKEN = re.compile(
    r"""(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<string>"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)')|(?P<name>[A-Za-z_]\w*)"""
    r"|(?P<number>\d+)|(?P<space>\s+)|(?P<mark>=>|==|!=|<=|>=|&&|\|\||\+\+|\+=|[-+*/%=<>!?:;,.(){}\[\]])",
    re.DOTALL,
)
NAMES = Path(__file__).resolve().parents[2] / "support" / "editors" / "unity_names.txt"
DOCUMENTED = {line for line in NAMES.read_text().splitlines() if not line.startswith("#")}
DECLARED = re.compile(
    r"(?:class|void|const string|const int|string\[\]|string|bool|int|DateTime|Document|Sound|Sound\[\]|SoundFile\[\]|"
    r"SoundlistSet|AudioClip|AudioClip\[\]|AudioSource|AudioImporter|AudioImporterSampleSettings|GameObject|"
    r"AudioClipLoadType|AudioCompressionFormat) ([A-Za-z_]\w*)"
)


def tokens(text: str) -> list[tuple[str, str]]:
    """Return the tokens of C#; what is none fails."""
    found, at = [], 0
    while at < len(text):
        token = TOKEN.match(text, at)
        assert token, text[at : at + 40]
        if token.lastgroup not in ("comment", "space"):
            found.append((token.lastgroup or "", token[0]))
        at = token.end()
    return found


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_scripts_are_balanced_and_name_documented_calls_only(name: str) -> None:
    text = script(name).decode("ascii")
    found = tokens(text)
    open_: list[str] = []
    for kind, token in found:
        if kind == "mark" and token in "([{":
            open_.append(token)
        elif kind == "mark" and token in ")]}":
            assert open_.pop() + token in ("()", "[]", "{}")
    assert open_ == []
    declared = set(DECLARED.findall(text)) | {"made", "changed", "same", "one", "file", "clip"}
    named = {token for kind, token in found if kind == "name"}
    assert named - DOCUMENTED - declared - {"SoundlistSet"} == set()


def sounds(cues: list[ExportedCue]) -> list[dict[str, Any]]:
    (content,) = (content for path, content in import_files(cues).items() if path.endswith(".json"))
    document = json.loads(content)
    assert document["format"] == 1
    found: list[dict[str, Any]] = document["sounds"]
    return found


def test_the_document_has_every_field_that_the_importer_reads() -> None:
    text = script("SoundlistImporter.cs").decode()
    body = text[text.index("private class Sound\n") : text.index("private class SoundFile")]
    fields = re.findall(r"public (?:string|bool|string\[\]|SoundFile\[\]) (\w+) =", body)
    assert len(fields) == 6
    assert all(set(fields) <= set(sound) for sound in sounds(CUES))


def test_scripts_stand_below_assets_where_the_sounds_are() -> None:
    inside = ["SoundlistSet.cs", "Editor/SoundlistImporter.cs", "Editor/soundlist-handoff.json"]
    assert list(import_files(CUES)) == [f"Assets/Soundlist/{name}" for name in inside]
    assert list(import_files([cue(1, "Audio/a.wav")])) == [f"Soundlist/{name}" for name in inside]


@pytest.mark.parametrize(
    ("seconds", "ratio", "load", "compression"),
    [
        (0.5, 1.0, "decompressed", "pcm"),
        (1.99, 3.5, "decompressed", "adpcm"),
        (2.0, 10.0, "compressed", "vorbis"),
        (9.99, 10.0, "compressed", "vorbis"),
        (10.0, 10.0, "streaming", "vorbis"),
    ],
)
def test_loading_is_by_length_and_the_codec_by_the_target(
    seconds: float, ratio: float, load: str, compression: str
) -> None:
    one = cue(1, "a.wav", files=(file("a.wav", seconds=seconds),), codec_ratio=ratio)
    (sound,) = sounds([one])
    assert (sound["load"], sound["compression"]) == (load, compression)


def test_a_target_that_streams_streams_short_sounds_too() -> None:
    (sound,) = sounds([cue(1, "a.wav", target_streamed=True)])
    assert sound["load"] == "streaming"


def test_a_prefab_stands_in_the_folder_of_its_event() -> None:
    assert [sound["event_path"] for sound in sounds([LASER, HUM])] == [
        ["weapon", "laser_fire"],
        ["Ambience", "Ship", "Hum"],
    ]


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(cues=hostile_cues())
def test_hostile_names_make_no_paths(cues: list[ExportedCue]) -> None:
    files = import_files(cues)
    assert files == import_files(cues)
    assert files["Assets/Soundlist/Editor/SoundlistImporter.cs"] == script("SoundlistImporter.cs")
    found = sounds(cues)
    paths = [sound["event_path"] for sound in found]
    assert all(part == file_safe(part) and part not in ("", ".", "..") for path in paths for part in path)
    assert len({"/".join(path).casefold() for path in paths}) == len(cues)
    assert [sound["notes"] for sound in found] == [one.notes for one in cues]
