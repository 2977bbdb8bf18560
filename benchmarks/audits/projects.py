"""Small projects of every engine with a gain at each place of their trees, to plant changes in and to read them again.

A project is written from a number of sounds and the gains of places such as ("container", 3). What a place reaches is
known by how it is written: `reached`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from benchmarks.audits.fmod_project import write_fmod
from benchmarks.audits.godot_project import write_godot
from benchmarks.audits.places import IN_BUS, IN_CONTAINER, IN_MIXER, Gains, Place
from benchmarks.audits.unity_project import write_unity
from benchmarks.audits.unreal_project import write_unreal
from benchmarks.audits.wwise_project import write_wwise


@dataclass(frozen=True)
class Kind:
    """One engine: how its project is written, its levels from the sound outwards, and how many sounds a place holds."""

    write: Callable[[Path, int, Gains], Path]
    levels: dict[str, int]  # a level's places hold as many sounds each; 0 is all of them
    file: str  # of a sound, with its number

    def places(self, level: str, sounds: int) -> range:
        """Return the numbers of a level's places."""
        each = self.levels[level]
        return range(1 if each == 0 else -(-sounds // each))

    def reached(self, place: Place, sounds: int) -> range:
        """Return the numbers of the sounds whose level a place changes."""
        level, number = place
        each = self.levels[level]
        return range(sounds) if each == 0 else range(number * each, min(sounds, (number + 1) * each))


KINDS = {
    "wwise": Kind(
        write_wwise,
        {
            "source": 1, "sound": 1, "make-up": 1, "container": IN_CONTAINER, "mixer": IN_MIXER, "top": 0,
            "bus": IN_BUS, "bus output": IN_BUS, "master": 0,
        },
        "Originals/SFX/steps/snd_{:04}.wav",
    ),
    "fmod": Kind(
        write_fmod,
        {
            "instrument": 1, "playlist": IN_CONTAINER, "track": IN_CONTAINER, "event master": IN_MIXER, "bus": IN_BUS,
            "gain effect": IN_BUS, "master": 0,
        },
        "Assets/steps/snd_{:04}.wav",
    ),
    "unity": Kind(
        write_unity,
        {"source": 1, "instance": 1, "group": IN_CONTAINER, "bus": IN_BUS, "master": 0, "manager": 0},
        "Assets/Audio/steps/snd_{:04}.wav",
    ),
    "unreal": Kind(
        write_unreal,
        {"wave": 1, "node": 1, "cue": IN_CONTAINER, "class": IN_BUS, "parent class": 0, "submix": 0},
        "Audio/steps/snd_{:04}.wav",
    ),
    "godot": Kind(
        write_godot,
        {"player": 1, "instance": 1, "bus": IN_BUS, "amplify": IN_BUS, "parent bus": 0, "master": 0},
        "steps/snd_{:04}.wav",
    ),
}  # fmt: skip
