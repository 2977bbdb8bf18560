"""A game project's facts on the files of a folder: categories, random sets, loops and events."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from audio_checks.middleware.by_path import sounds_by_path
from audio_checks.middleware.values import Engine, PlayedSound, Project

PLACED = frozenset({"wwise", "fmod", "unreal"})  # whose tree is ordered by kinds of sounds, and not by scenes
PLAIN = frozenset({"default work unit", "game"})  # containers whose names say nothing
EVENTS_SHOWN = 20


class PlayedFile(NamedTuple):
    """A project's facts on one file.

    Attributes
    ----------
    containers : tuple of str
        The names of what holds it in the project's tree, from the outermost; empty where the tree says no category.
    random_set : str
        Where the container is that plays it as one of several; empty where there is none.
    events : tuple of str
        What begins it, the first 20.
    is_looped : bool
        Whether all that plays it plays it in a loop.
    is_used : bool or None
        None where only a script could say.
    """

    containers: tuple[str, ...]
    random_set: str
    events: tuple[str, ...]
    is_looped: bool
    is_used: bool | None


def played_files(project: Project, paths: Iterable[str]) -> dict[str, PlayedFile]:
    """Return a project's facts on each file that it plays, by the file's path."""
    return {path: _played(project.engine, sounds) for path, sounds in sounds_by_path(project, paths).items()}


def set_name(random_set: str) -> str:
    """Return the name of a random set: the last of its path."""
    return _names(random_set)[-1] if _names(random_set) else ""


def _played(engine: Engine, sounds: Sequence[PlayedSound]) -> PlayedFile:
    used = [sound for sound in sounds if sound.is_used is not False]
    shown = used or sounds
    first = next((sound for sound in shown if sound.random_set), shown[0])
    events = dict.fromkeys(event for sound in used for event in sound.events)
    is_used = None if used and all(sound.is_used is None for sound in used) else bool(used)
    return PlayedFile(
        _containers(engine, first),
        first.random_set,
        tuple(events)[:EVENTS_SHOWN],
        bool(used) and all(sound.is_looped for sound in used),
        is_used,
    )


def _containers(engine: Engine, sound: PlayedSound) -> tuple[str, ...]:
    if engine not in PLACED:
        return ()
    object_path = sound.random_set or sound.object_path
    if engine == "fmod" and sound.events:
        object_path = sound.events[0]
    names = _names(object_path)[:-1]
    roots = 0 if engine == "unreal" else 1  # a hierarchy of Wwise, "event:" of FMOD Studio
    return tuple(name for name in names[roots:] if name.lower() not in PLAIN)


def _names(path: str) -> list[str]:
    return [name.strip() for name in re.split(r"[\\/]|: ", path) if name.strip()]
