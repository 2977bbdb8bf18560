"""Which sounds make a scene, when each plays and how loud: without a database."""

import re
from collections.abc import Mapping, Sequence
from enum import StrEnum
from typing import Any, NamedTuple
from uuid import UUID

from app.sound_lists.rules import folded

MOST_NEIGHBOURS = 8
SHORTEST_S, LONGEST_S = 8.0, 30.0  # of a scene without a clip, and of any
FIRST_SPOT_S = 0.5  # where the list has no times
AFTER_S = 1.0  # that follow the end of the sound
MOST_SPOTS = 32
LOWEST_DB, HIGHEST_DB = -60.0, 12.0
UNMEASURED_LUFS = -70.0
SCENE_COLUMNS = frozenset({"scene", "scenes", "level", "location"})
SPOT_COLUMNS = frozenset({"spots", "spot", "spot times"})
_SPOT = re.compile(r"(?:(\d{1,3}):)?(\d{1,4}(?:\.\d{1,3})?)")


class BedRole(StrEnum):
    """The kinds of a bed."""

    MUSIC = "music"
    AMBIENCE = "ambience"
    VOICE = "voice"


LOOPING_ROLES = frozenset({BedRole.MUSIC, BedRole.AMBIENCE})


class LevelFrom(StrEnum):
    """Where the level of a lane comes from."""

    AUDIT = "audit"  # the newest audit of a build
    APPROVED = "approved"  # no audit names the sound: it plays as it was approved
    BED = "bed"  # a person set it


class Candidate(NamedTuple):
    """An approved sound that may sound at the same time as another."""

    cue_id: UUID
    scene: str
    category: str
    loops: bool
    variations: int
    level_lufs: float | None  # as the game plays it
    position: int


def column_value(extra: Mapping[str, Any], columns: frozenset[str]) -> str:
    """Return what a cue says in a column of the project's own, or an imported one; empty where there is none."""
    for name, value in extra.items():
        if folded(name) in columns and value is not None:
            return str(value).strip()
    return ""


def likeliest_neighbours(of: Candidate, candidates: Sequence[Candidate]) -> list[Candidate]:
    """Return the eight sounds that are likeliest heard with another.

    Those of its scene come first where the list has a column for it, then those of its category, then all others; among
    these loops before single sounds, the louder loop first, then the single sound with more variations, then the
    louder, then what stands nearer in the list.
    """

    def order(one: Candidate) -> tuple[float, ...]:
        nearness = 0 if of.scene and one.scene == of.scene else 1 if one.category == of.category else 2
        level = UNMEASURED_LUFS if one.level_lufs is None else one.level_lufs
        frequency = 0 if one.loops else -one.variations
        return nearness, not one.loops, frequency, -level, abs(one.position - of.position), one.position

    return sorted((one for one in candidates if one.cue_id != of.cue_id), key=order)[:MOST_NEIGHBOURS]


def spots_in(text: str) -> list[float]:
    """Return the times that a text names, in seconds, rising: "1.5, 3.05" or "0:01.5; 1:02"; others are left out."""
    found: set[float] = set()
    for word in re.split(r"[,;\s]+", text):
        named = _SPOT.fullmatch(word)
        if named:
            found.add(round(60 * int(named[1] or 0) + float(named[2]), 3))
    return sorted(found)[:MOST_SPOTS]


def scene_length_s(*, duration_s: float, spots: Sequence[float], clip_s: float | None) -> float:
    """Return how long a scene plays before it begins again."""
    if clip_s is not None:
        return round(min(LONGEST_S, max(1.0, clip_s)), 3)
    last = spots[-1] if spots else 0.0
    return round(min(LONGEST_S, max(SHORTEST_S, last + duration_s + AFTER_S)), 3)


def part_name(start_s: float | None, end_s: float | None) -> str:
    """Return the name of a part of a reference: another part is another sound."""
    return f"{start_s or 0:g}-{'' if end_s is None else f'{end_s:g}'}"
