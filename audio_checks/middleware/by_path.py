"""Identification of another folder's files as sounds of a project."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from itertools import takewhile
from pathlib import PurePosixPath

from audio_checks.middleware.values import PlayedSound, Project

NOT_PLAYED = {
    "wwise": "no event plays it",
    "fmod": "no event of a bank plays it",
    "unity": "no scene, prefab or script plays it",
    "unreal": "nothing in the project refers to it",
    "godot": "no scene or script plays it",
}


def sounds_by_path(project: Project, paths: Iterable[str]) -> dict[str, list[PlayedSound]]:
    """Return a project's played sounds by the paths of a build's files.

    Parameters
    ----------
    project : Project
        Its files are named from its own root.
    paths : iterable of str
        From the build's folder. A path and a file belong together where their ends agree most, whatever the endings and
        the case; where two agree as much and neither is whole, they do not.
    """
    by_name: dict[str, list[tuple[tuple[str, ...], str]]] = defaultdict(list)
    for path in paths:
        steps = _steps(path)
        by_name[steps[0]].append((steps, path))
    by_path: dict[str, list[PlayedSound]] = defaultdict(list)
    places: dict[str, str | None] = {}
    for sound in project.played:
        if sound.file not in places:
            places[sound.file] = _best(_steps(sound.file), by_name)
        if (asset_path := places[sound.file]) is not None:
            by_path[asset_path].append(sound)
    return by_path


def _steps(path: str) -> tuple[str, ...]:
    """Return a path's names from the last, without the ending of the file."""
    names = PurePosixPath(path.replace("\\", "/").lower()).with_suffix("").parts
    return tuple(reversed(names)) or ("",)


def _best(steps: tuple[str, ...], by_name: dict[str, list[tuple[tuple[str, ...], str]]]) -> str | None:
    candidates = by_name.get(steps[0], [])
    if not candidates:
        return None
    scored = [(_agreeing(steps, other), len(other), path) for other, path in candidates]
    most = max(score for score, _, _ in scored)
    best = [candidate for candidate in scored if candidate[0] == most]
    if len(best) == 1:
        return best[0][2]
    whole = [path for score, length, path in best if length == score]  # all of the path agrees
    return whole[0] if len(whole) == 1 else None


def _agreeing(steps: tuple[str, ...], other: tuple[str, ...]) -> int:
    return sum(1 for _ in takewhile(lambda pair: pair[0] == pair[1], zip(steps, other, strict=False)))
