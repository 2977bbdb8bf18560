"""Godot: the files as the reader of our audit reads them, and the cached paths of real projects."""

import re
from pathlib import Path

import pytest
from hypothesis import given, settings

from app.builds.engine_export.cues import ExportedCue
from app.builds.engine_export.engines.godot import import_files, quoted, uid_of
from audio_checks.middleware.godot import read_godot
from tests.app.builds.handed import CUES, HUM, LASER, cue, hostile_cues

SCENE = """[gd_scene load_steps=3 format=3]

[ext_resource type="AudioStream" path="res://Assets/weapon/laser_fire.tres" id="1"]
[ext_resource type="AudioStream" path="res://Assets/ambience/hum.wav" id="2"]

[node name="Ship" type="Node2D"]

[node name="Laser" type="AudioStreamPlayer" parent="."]
stream = ExtResource("1")
volume_db = -6.0

[node name="Hum" type="AudioStreamPlayer" parent="."]
stream = ExtResource("2")
"""


def unpack(folder: Path, cues: list[ExportedCue]) -> None:
    files = {file.path: b"RIFF" for one in cues for file in one.files} | import_files(cues)
    for path, content in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_bytes(content)


def test_the_audit_finds_sets_loops_and_levels(tmp_path: Path) -> None:
    unpack(tmp_path, CUES)
    (tmp_path / "project.godot").write_text('config/features=PackedStringArray("4.5")\n')
    (tmp_path / "ship.tscn").write_text(SCENE)
    project = read_godot(tmp_path)
    assert project.unread == ()
    played = {one.file: one for one in project.played}
    assert sorted(played) == [
        "Assets/ambience/hum.wav",
        "Assets/weapon/laser_fire_01.wav",
        "Assets/weapon/laser_fire_02.wav",
    ]
    for number in (1, 2):
        laser = played[f"Assets/weapon/laser_fire_0{number}.wav"]
        assert (laser.is_looped, sum(part.gain_db for part in laser.parts)) == (False, -6.0)
        assert laser.conversions == ()  # nothing that undoes dither or level
    assert (played["Assets/ambience/hum.wav"].is_looped, played["Assets/ambience/hum.wav"].parts) == (True, ())


def test_a_loop_is_that_of_the_file() -> None:
    settings_of = import_files([HUM])["Assets/ambience/hum.wav.import"].decode()
    assert "edit/loop_mode=2\nedit/loop_begin=4800\nedit/loop_end=576000\n" in settings_of
    assert "edit/normalize=false\n" in settings_of
    assert settings_of.endswith("compress/mode=0\n")


def test_the_cached_path_is_the_one_that_godot_chooses() -> None:
    # As in gui/translation of godot-demo-projects, whose import file Godot wrote.
    made = import_files([cue(1, "audio/hello_es.wav")])["audio/hello_es.wav.import"].decode()
    assert 'path="res://.godot/imported/hello_es.wav-0b3ee7fc19ef7ac4822f3f3dc177c570.sample"' in made


def test_a_uid_is_of_the_digits_that_godot_reads() -> None:
    uid = uid_of("res://a.wav")
    digits = uid.removeprefix("uid://")
    assert re.fullmatch(r"[a-y0-8]{1,13}", digits)
    number = 0
    for digit in digits:
        number = number * 34 + "abcdefghijklmnopqrstuvwxy012345678".index(digit)
    assert 0 <= number < 2**63
    assert uid == uid_of("res://a.wav") != uid_of("res://b.wav")


def test_other_formats_have_the_importers_of_theirs() -> None:
    made = import_files([cue(1, "music.ogg", loop=True), cue(2, "jingle.mp3"), cue(3, "odd.flac")])
    assert sorted(made) == ["jingle.mp3.import", "music.ogg.import"]
    assert 'importer="oggvorbisstr"\ntype="AudioStreamOggVorbis"\n' in made["music.ogg.import"].decode()
    assert "\nloop=true\n" in made["music.ogg.import"].decode()
    assert "\nloop=false\n" in made["jingle.mp3.import"].decode()


def test_a_randomizer_keeps_what_the_list_says() -> None:
    made = import_files([LASER])["Assets/weapon/laser_fire.tres"].decode()
    assert 'metadata/cue = "SW-001"\nmetadata/title = "Laser fire"\nmetadata/notes = "SW-001 Laser fire.' in made
    assert "random_pitch" not in made
    assert "random_volume_offset_db" not in made


@pytest.mark.slow
@settings(max_examples=40, deadline=None)
@given(cues=hostile_cues())
def test_hostile_names_stay_in_their_strings(cues: list[ExportedCue]) -> None:
    made = import_files(cues)
    assert made == import_files(cues)
    assert len(made) == sum(len(one.files) + one.is_set for one in cues)
    for path, content in made.items():
        text = content.decode()
        bare = re.sub(r'"(?:[^"\\]|\\.)*"', '""', text)
        allowed = r"[A-Za-z0-9_/]+ ?= ?(\"\"|\[\"\"\]|true|false|-?[\d.]+|ExtResource\(\"\"\))"
        header = r"\[[a-z_]+( [a-z_]+=(\"\"|\d+))*\]"
        odd = [line for line in bare.split("\n") if line and not re.fullmatch(f"{allowed}|{header}", line)]
        assert odd == [], path


def test_a_string_is_read_back() -> None:
    assert quoted('a"b\\c\nd') == '"a\\"b\\\\c\\nd"'
