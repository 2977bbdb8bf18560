"""Godot: streams in streams, scenes in scenes, animations, scripts and import settings."""

import pytest

from audio_checks.middleware.godot import read_godot

PLAYER = '[node name="Steps" type="AudioStreamPlayer" parent="."]\n'
WAVE = '[ext_resource type="AudioStream" path="res://a.wav" id="1_a"]\n'


@pytest.fixture
def godot(put):
    def read(**files):
        put("project.godot", 'config_version=5\n[application]\nconfig/features=PackedStringArray("4.3")\n')
        put("a.wav.import", '[remap]\nimporter="wav"\n[params]\n' + files.pop("params", ""))
        root = None
        for name, text in files.items():
            root = put(name.replace("_", ".", 1), text)
        return read_godot(root)

    return read


def test_a_randomizer_and_what_it_holds(godot):
    scene = (
        "[gd_scene format=3]\n" + WAVE + '[sub_resource type="AudioStreamRandomizer" id="R_1"]\nstreams_count = 1\n'
        'random_volume_offset_db = 3.0\nstream_0/stream = ExtResource("1_a")\nstream_0/weight = 2.0\n'
        '[node name="Main" type="Node"]\n' + PLAYER + 'stream = SubResource("R_1")\nvolume_db = -4.0\n'
    )
    (one,) = godot(main_tscn=scene).played
    assert (one.file, one.gain_db) == ("a.wav", -4.0)
    assert [(found.on, found.what) for found in one.depends] == [("random", "random by 3.0 dB")]


def test_an_animated_volume_is_reported(godot):
    scene = (
        "[gd_scene format=3]\n" + WAVE + '[sub_resource type="Animation" '
        'id="A"]\ntracks/0/path = NodePath("Steps:volume_db")\n'
        'tracks/0/keys = {\n"times": PackedFloat32Array(0, 1),\n"values": [0.0, -80.0]\n}\n'
        '[node name="Main" type="Node"]\n' + PLAYER + 'stream = ExtResource("1_a")\n'
    )
    (one,) = godot(main_tscn=scene).played
    assert [(found.on, found.what) for found in one.depends] == [("state", "an animation")]


def test_godot_3_writes_numbers_and_spaces(godot):
    scene = (
        '[gd_scene load_steps=2 format=2]\n[ext_resource path="res://a.wav" type="AudioStream" id=1]\n'
        '[node name="Main" type="Node2D"]\n[node name="Steps" type="AudioStreamPlayer2D" '
        'parent="."]\nstream = ExtResource( 1 )\nvolume_db = -7.5\n'
    )
    (one,) = godot(main_tscn=scene).played
    assert one.gain_db == -7.5


def test_what_scripts_play_is_not_claimed_to_be_0_db(godot):
    script = 'extends Node\nfunc _ready():\n\tvar s = load("res://a.wav")\n'
    (one,) = godot(main_gd=script).played
    assert (one.gain_db, one.is_used, one.depends[0].on) == (None, True, "script")


@pytest.mark.parametrize(
    ("params", "harms"),
    [
        ("", []),
        ("edit/normalize=true\n", ["its peak is raised to full scale"]),
        ("force/8_bit=true\nforce/mono=true\n", ["8 bits a sample undo the dither", "mixed to mono"]),
        ("force/max_rate=true\nforce/max_rate_hz=22050\n", ["resampled to 22,050 Hz at most"]),
        ("compress/mode=1\n", ["IMA ADPCM: 4 bits a sample undo the dither"]),
        ("compress/mode=2\n", []),
    ],
)
def test_import_settings_that_change_the_sound(godot, params, harms):
    scene = (
        "[gd_scene format=3]\n" + WAVE + '[node name="Main" type="Node"]\n' + PLAYER + 'stream = ExtResource("1_a")\n'
    )
    (one,) = godot(main_tscn=scene, params=params).played
    assert [found.harm for found in one.conversions] == harms


def test_scenes_that_hold_one_another_end(godot):
    scene = (
        '[gd_scene format=3]\n[ext_resource type="PackedScene" path="res://main.tscn" id="1"]\n'
        '[node name="Main" type="Node"]\n[node name="Again" parent="." instance=ExtResource("1")]\n'
        '[node name="Steps" parent="Again"]\nvolume_db = 3.0\n'
    )
    assert godot(main_tscn=scene).played == ()


def test_what_is_no_scene_is_named(godot):
    project = godot(main_tscn="nothing of the kind\n")
    assert "no sections" in project.unread[0].message
