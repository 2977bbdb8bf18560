"""A small project of Godot with a gain at each place of its tree."""

from __future__ import annotations

from pathlib import Path

from benchmarks.audits.places import IN_BUS, IN_CONTAINER, Gains, put_file


def write_godot(root: Path, sounds: int, gains: Gains) -> Path:
    """Write a Godot project: a scene for each container, a main scene that changes players, buses in a bus."""

    def of(*place):
        return gains.get(place)

    put_file(root, "project.godot", 'config_version=5\n\n[application]\n\nconfig/features=PackedStringArray("4.3")\n')
    layout = '[gd_resource type="AudioBusLayout" load_steps=2 format=3]\n\n'
    buses = range(-(-sounds // IN_BUS))
    for bus in buses:
        layout += (
            f'[sub_resource type="AudioEffectAmplify" id="amplify_{bus}"]\nvolume_db = {of("amplify", bus) or 0.0}\n\n'
        )
    layout += f'[resource]\nbus/0/volume_db = {of("master", 0) or 0.0}\nbus/1/name = &"All"\n'
    layout += f'bus/1/volume_db = {of("parent bus", 0) or 0.0}\nbus/1/send = &"Master"\n'
    for bus in buses:
        layout += (
            f'bus/{bus + 2}/name = &"bus_{bus}"\nbus/{bus + 2}/volume_db '
            f'= {of("bus", bus) or 0.0}\nbus/{bus + 2}/send = &"All"\n'
            f'bus/{bus + 2}/effect/0/effect = SubResource("amplify_{bus}")\nbus/{bus + 2}/effect/0/enabled = true\n'
        )
    put_file(root, "default_bus_layout.tres", layout)
    main = "[gd_scene load_steps=2 format=3]\n\n"
    nodes = '[node name="Main" type="Node"]\n\n'
    for container in range(-(-sounds // IN_CONTAINER)):
        held = range(container * IN_CONTAINER, min(sounds, (container + 1) * IN_CONTAINER))
        scene = "[gd_scene format=3]\n\n"
        players = f'[node name="Box{container}" type="Node"]\n\n'
        main += f'[ext_resource type="PackedScene" path="res://scenes/box_{container}.tscn" id="{container}_b"]\n'
        changed = ""
        for sound in held:
            scene += f'[ext_resource type="AudioStream" path="res://steps/snd_{sound:04}.wav" id="{sound}_s"]\n'
            players += (
                f'[node name="snd_{sound:04}" type="AudioStreamPlayer" parent="."]\nstream = ExtResource("{sound}_s")\n'
                f'volume_db = {of("player", sound) or 0.0}\nbus = &"bus_{sound // IN_BUS}"\n\n'
            )
            if of("instance", sound) is not None:
                changed += (
                    f'[node name="snd_{sound:04}" parent="Box{container}"]\nvolume_db = {of("instance", sound)}\n\n'
                )
        put_file(root, f"scenes/box_{container}.tscn", scene + "\n" + players)
        nodes += f'[node name="Box{container}" parent="." instance=ExtResource("{container}_b")]\n\n' + changed
    put_file(root, "main.tscn", main + "\n" + nodes)
    return root / "project.godot"
