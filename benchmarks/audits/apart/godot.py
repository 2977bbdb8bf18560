"""Godot 4.3: streams in resources of their own, an inherited scene, buses four deep, an animation."""

from __future__ import annotations

from pathlib import Path

from benchmarks.audits.apart.project import Apart, Gains, put


def write_godot(root: Path, gains: Gains) -> Path:
    """Write a Godot project."""

    def of(place: str) -> float:
        return gains.get(place, 0.0)

    put(
        root,
        "project.godot",
        'config_version=5\n\n[application]\n\nconfig/name="Apart"\nrun/main_scene="res://main.tscn"\n'
        'config/features=PackedStringArray("4.3")\n\n[audio]\n\nbuses/default_bus_layout="res://audio/buses.tres"\n',
    )
    buses = [("World", "Master"), ("Steps", "World"), ("Soft", "Steps"), ("Hall", "Master")]
    layout = (
        '[gd_resource type="AudioBusLayout" load_steps=3 format=3 uid="uid://b1"]\n\n'
        f'[sub_resource type="AudioEffectAmplify" id="amp"]\nresource_name = "Amplify"\nvolume_db = {of("amplify")}\n\n'
        '[sub_resource type="AudioEffectCompressor" id="comp"]\nresource_name = "Compressor"\ngain = 6.0\n\n'
        f"[resource]\nbus/0/volume_db = {of('bus Master')}\n"
    )
    for number, (name, send) in enumerate(buses, start=1):
        layout += (
            f'bus/{number}/name = &"{name}"\nbus/{number}/solo = false\nbus/{number}/mute = false\n'
            f"bus/{number}/bypass_fx = false\nbus/{number}/volume_db = {of(f'bus {name}')}\n"
            f'bus/{number}/send = &"{send}"\n'
        )
    layout += 'bus/2/effect/0/effect = SubResource("amp")\nbus/2/effect/0/enabled = true\n'
    layout += 'bus/4/effect/0/effect = SubResource("comp")\nbus/4/effect/0/enabled = true\n'
    put(root, "audio/buses.tres", layout)
    put(
        root,
        "audio/steps.tres",
        '[gd_resource type="AudioStreamRandomizer" load_steps=3 format=3 uid="uid://b2"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://c1" path="res://audio/left.wav" id="1_l"]\n'
        '[ext_resource type="AudioStream" uid="uid://c2" path="res://audio/right.wav" id="2_r"]\n\n[resource]\n'
        "random_pitch = 1.05\nrandom_volume_offset_db = 2.0\nstreams_count = 2\n"
        'stream_0/stream = ExtResource("1_l")\nstream_0/weight = 1.0\nstream_1/stream = ExtResource("2_r")\n'
        "stream_1/weight = 1.0\n",
    )
    put(
        root,
        "audio/layers.tres",
        '[gd_resource type="AudioStreamSynchronized" load_steps=3 format=3 uid="uid://b3"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://c3" path="res://audio/pad.wav" id="1_p"]\n'
        '[ext_resource type="AudioStream" uid="uid://c4" path="res://audio/beat.wav" id="2_b"]\n\n[resource]\n'
        f'stream_count = 2\nstream_0/stream = ExtResource("1_p")\nstream_0/volume = {of("layer pad")}\n'
        f'stream_1/stream = ExtResource("2_b")\nstream_1/volume = {of("layer beat")}\n',
    )
    put(
        root,
        "player.tscn",
        '[gd_scene load_steps=4 format=3 uid="uid://d1"]\n\n'
        '[ext_resource type="AudioStream" uid="uid://b2" path="res://audio/steps.tres" id="1_s"]\n'
        '[ext_resource type="AudioStream" uid="uid://c5" path="res://audio/jump.wav" id="2_j"]\n\n'
        '[node name="Player" type="CharacterBody3D"]\n\n[node name="Audio" type="Node" parent="."]\n\n'
        '[node name="Steps" type="AudioStreamPlayer" parent="Audio"]\nstream = ExtResource("1_s")\n'
        f'volume_db = {of("player steps")}\nbus = &"Soft"\n\n'
        '[node name="Jump" type="AudioStreamPlayer" parent="Audio"]\nstream = ExtResource("2_j")\n'
        f'volume_db = {of("player jump")}\nbus = &"Steps"\n',
    )
    changed = (
        f'[node name="Jump" parent="Audio" index="1"]\nvolume_db = {of("inherited")}\n' if "inherited" in gains else ""
    )
    put(
        root,
        "hero.tscn",
        '[gd_scene load_steps=2 format=3 uid="uid://d2"]\n\n'
        '[ext_resource type="PackedScene" uid="uid://d1" path="res://player.tscn" id="1_p"]\n\n'
        f'[node name="Hero" instance=ExtResource("1_p")]\n\n{changed}',
    )
    put(
        root,
        "main.tscn",
        '[gd_scene load_steps=6 format=3 uid="uid://d3"]\n\n'
        '[ext_resource type="PackedScene" uid="uid://d2" path="res://hero.tscn" id="1_h"]\n'
        '[ext_resource type="AudioStream" uid="uid://b3" path="res://audio/layers.tres" id="2_m"]\n'
        '[ext_resource type="AudioStream" uid="uid://c6" path="res://audio/drip.wav" id="3_d"]\n'
        '[ext_resource type="AudioStream" uid="uid://c7" path="res://audio/alarm.wav" id="4_a"]\n\n'
        '[sub_resource type="Animation" id="anim"]\nresource_name = "fade"\nlength = 2.0\ntracks/0/type = "value"\n'
        'tracks/0/path = NodePath("Alarm:volume_db")\ntracks/0/keys = {\n"times": PackedFloat32Array(0, 2),\n'
        '"values": [0.0, -40.0]\n}\n\n[sub_resource type="AnimationLibrary" id="lib"]\n_data = {\n'
        '"fade": SubResource("anim")\n}\n\n'
        '[node name="Main" type="Node3D"]\n\n[node name="Hero" parent="." instance=ExtResource("1_h")]\n\n'
        '[node name="Music" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("2_m")\n'
        f"volume_db = {of('music')}\nautoplay = true\n\n"
        '[node name="Drip" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("3_d")\n'
        f'volume_db = {of("drip")}\nbus = &"Hall"\n\n[node name="Alarm" type="AudioStreamPlayer" parent="."]\n'
        f'stream = ExtResource("4_a")\nvolume_db = {of("alarm")}\n\n'
        '[node name="AnimationPlayer" type="AnimationPlayer" parent="."]\nlibraries = {\n"": SubResource("lib")\n}\n',
    )
    return root / "project.godot"


def _wavs(*names: str) -> tuple[str, ...]:
    return tuple(f"audio/{name}.wav" for name in names)


GODOT = Apart(
    write_godot,
    {
        "player steps": _wavs("left", "right"), "player jump": _wavs("jump"), "inherited": _wavs("jump"),
        "layer pad": _wavs("pad"), "layer beat": _wavs("beat"), "music": _wavs("pad", "beat"), "drip": _wavs("drip"),
        "alarm": _wavs("alarm"), "bus Soft": _wavs("left", "right"), "bus Steps": _wavs("left", "right", "jump"),
        "amplify": _wavs("left", "right", "jump"), "bus World": _wavs("left", "right", "jump"),
        "bus Hall": _wavs("drip"), "bus Master": _wavs("left", "right", "jump", "pad", "beat", "drip", "alarm"),
    },
    {
        **dict.fromkeys(_wavs("jump", "pad"), ("",)), **dict.fromkeys(_wavs("left", "right"), ("random",)),
        **dict.fromkeys(_wavs("drip"), ("effect",)), **dict.fromkeys(_wavs("alarm"), ("state",)),
    },
)  # fmt: skip
