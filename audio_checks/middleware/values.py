"""A project's facts on the sounds that the game plays, in plain values."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any, Literal

Engine = Literal["wwise", "fmod", "unity", "unreal", "godot"]
DependsOn = Literal["state", "random", "distance", "effect", "loudness", "script"]

SILENT_DB = -120.0  # of a factor of 0, or of what is muted: JSON has no infinity
LARGEST_DB = 1_000.0


@dataclass(frozen=True, slots=True)
class Part:
    """One constant gain on the way from a file to the output.

    Attributes
    ----------
    object_path : str
        Where in the project's tree it is set.
    property : str
        Its name in the project.
    gain_db : float
        What it adds.
    file : str
        The project's file that holds it, from the project's root.
    anchor : str
        Text that begins the object in that file; empty where there is none.
    """

    object_path: str
    property: str
    gain_db: float
    file: str
    anchor: str = ""

    def to_dict(self) -> dict[str, Any]:
        """Return the part as JSON has it."""
        return {
            "object": self.object_path,
            "property": self.property,
            "gain_db": round(self.gain_db, 2) + 0.0,
            "file": self.file,
        }


@dataclass(frozen=True, slots=True)
class Dependency:
    """Another cause of level changes while the game runs.

    Attributes
    ----------
    on : str
        "state" of the game (parameters, states, snapshots, ducking, animation), "random" within a range, "distance" to
        the listener, an "effect", measured "loudness", or a "script".
    what : str
        Its name in the project, such as 'game parameter "RPM"'.
    """

    object_path: str
    property: str
    on: DependsOn
    what: str

    def to_dict(self) -> dict[str, Any]:
        """Return the dependency as JSON has it."""
        return {"object": self.object_path, "property": self.property, "on": self.on, "what": self.what}


@dataclass(frozen=True, slots=True)
class Conversion:
    """A setting by which the import changes the sound itself: its level, its rate, or the noise of its last bit."""

    setting: str
    harm: str
    file: str

    def to_dict(self) -> dict[str, Any]:
        """Return the conversion as JSON has it."""
        return {"setting": self.setting, "harm": self.harm, "file": self.file}


@dataclass(frozen=True, slots=True)
class PlayedSound:
    """One way in which a game plays one sound file.

    Attributes
    ----------
    file : str
        The sound file, from the project's root, with slashes.
    object_path : str
        What plays it, in the project's tree.
    parts : tuple of Part
        The constant gains other than 0 dB, from the file to the output.
    depends : tuple of Dependency
        What else changes the level.
    events : tuple of str
        What begins it: events, scenes or prefabs.
    is_used : bool or None
        None where only a script could say.
    is_known : bool
        False where the gain is set in a script alone; `gain_db` is then None.
    random_set : str
        Where the container is that plays one of its sounds at random; empty where there is none.
    """

    file: str
    object_path: str
    parts: tuple[Part, ...] = ()
    depends: tuple[Dependency, ...] = ()
    conversions: tuple[Conversion, ...] = ()
    events: tuple[str, ...] = ()
    is_used: bool | None = True
    is_known: bool = True
    is_looped: bool | None = None
    is_streamed: bool | None = None
    random_set: str = ""

    @property
    def gain_db(self) -> float | None:
        """The constant gain that the game adds to the file; None where it is not known."""
        if not self.is_known:
            return None
        return math.fsum(part.gain_db for part in self.parts)

    def to_dict(self) -> dict[str, Any]:
        """Return the sound as JSON has it."""
        gain_db = self.gain_db
        return {
            "file": self.file,
            "object": self.object_path,
            "gain_db": None if gain_db is None else round(gain_db, 2) + 0.0,
            "parts": [part.to_dict() for part in self.parts],
            "depends": [depend.to_dict() for depend in self.depends],
            "conversions": [conversion.to_dict() for conversion in self.conversions],
            "events": list(self.events),
            "used": self.is_used,
            "looped": self.is_looped,
            "streamed": self.is_streamed,
        }


@dataclass(frozen=True, slots=True)
class Unread:
    """A file of a project that could not be read, and why; `line` is 0 where none is known."""

    file: str
    message: str
    line: int = 0

    def to_dict(self) -> dict[str, Any]:
        """Return it as JSON has it."""
        return {"file": self.file, "line": self.line, "message": self.message}


@dataclass(frozen=True, slots=True)
class Project:
    """The facts of a project.

    Attributes
    ----------
    root : str
        The folder that all paths of files begin at.
    version : str
        Of the engine, as the project says; empty where it does not.
    played : tuple of PlayedSound
        In the order of their files and objects.
    unread : tuple of Unread
        What was left out.
    """

    engine: Engine
    root: str
    version: str
    played: tuple[PlayedSound, ...]
    unread: tuple[Unread, ...] = ()

    def to_dict(self) -> dict[str, Any]:
        """Return the project as JSON has it, without the path of this machine."""
        return {
            "engine": self.engine,
            "version": self.version,
            "sounds": [sound.to_dict() for sound in self.played],
            "unread": [gap.to_dict() for gap in self.unread],
        }


def decibels(factor: float) -> float:
    """Return a linear gain in dB; SILENT_DB for 0 and less."""
    return max(SILENT_DB, 20 * math.log10(factor)) if factor > 0 else SILENT_DB


def number(text: str | None) -> float | None:
    """Return the number that a text is, None where it is none or no gain could be as large."""
    try:
        value = float(text or "")
    except ValueError:
        return None
    return value if abs(value) < 1e9 else None


def gain(object_path: str, name: str, gain_db: float | None, file: str, anchor: str = "") -> tuple[Part, ...]:
    """Return a part for a gain other than 0 dB, within what a gain can be."""
    if gain_db is None or math.isclose(gain_db, 0.0, abs_tol=1e-9):
        return ()
    return (Part(object_path, name, min(LARGEST_DB, max(-LARGEST_DB, gain_db)), file, anchor),)


def in_order(played: Iterable[PlayedSound]) -> tuple[PlayedSound, ...]:
    """Return sounds by their files and objects."""
    return tuple(sorted(played, key=lambda sound: (sound.file, sound.object_path)))
