"""The sounds of a scene, with the times and the level of each: without a database."""

import re
from collections.abc import Mapping, Sequence
from enum import StrEnum
from typing import Any, NamedTuple
from uuid import UUID

from app.core.plural import counted
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
    """The source of the level of a lane."""

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
    """Return a cue's value in a column of the project's own, or an imported one; empty where there is none."""
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

    def order(candidate: Candidate) -> tuple[float, ...]:
        nearness = 0 if of.scene and candidate.scene == of.scene else 1 if candidate.category == of.category else 2
        level = UNMEASURED_LUFS if candidate.level_lufs is None else candidate.level_lufs
        frequency = 0 if candidate.loops else -candidate.variations
        return (
            nearness,
            not candidate.loops,
            frequency,
            -level,
            abs(candidate.position - of.position),
            candidate.position,
        )

    return sorted((candidate for candidate in candidates if candidate.cue_id != of.cue_id), key=order)[:MOST_NEIGHBOURS]


def spots_in(text: str) -> list[float]:
    """Return the times that a text names, in seconds, rising: "1.5, 3.05" or "0:01.5; 1:02"; others are left out."""
    spots: set[float] = set()
    for word in re.split(r"[,;\s]+", text):
        named = _SPOT.fullmatch(word)
        if named:
            spots.add(round(60 * int(named[1] or 0) + float(named[2]), 3))
    return sorted(spots)[:MOST_SPOTS]


def scene_length_s(*, duration_s: float, spots: Sequence[float], clip_s: float | None) -> float:
    """Return the playing time of a scene before it begins again."""
    if clip_s is not None:
        return round(min(LONGEST_S, max(1.0, clip_s)), 3)
    last = spots[-1] if spots else 0.0
    return round(min(LONGEST_S, max(SHORTEST_S, last + duration_s + AFTER_S)), 3)


def part_name(start_s: float | None, end_s: float | None) -> str:
    """Return the name of a part of a reference: another part is another sound."""
    return f"{start_s or 0:.3f}-{'' if end_s is None else f'{end_s:.3f}'}"


def part_bounds(part: str) -> tuple[float, float]:
    """Return the start and the end of a named part of a reference, in seconds."""
    start, _, end = part.partition("-")
    return float(start), float(end or "inf")


class CoveredBand(NamedTuple):
    """One band of hearing, as words are made of it."""

    hz: float
    is_part: bool
    is_heard: bool
    margin_db: float  # infinite where nothing covers
    covered_by: str  # the name of a sound, empty for none


def masking_words(bands: Sequence[CoveredBand]) -> str:
    """Return the bands of a sound heard among others, and those covered, with their causes, in words."""
    part = [band for band in bands if band.is_part]
    if not part:
        return "The sound is silent."
    heard = [band for band in part if band.is_heard]
    words = [f"Heard in {len(heard)} of {counted(len(part), 'band')}."]
    clearest = max(heard, key=lambda band: band.margin_db, default=None)
    if clearest is None:
        words = ["Covered in all bands."]
    elif clearest.margin_db == float("inf"):
        words.append("Nothing covers it." if all(band.margin_db == float("inf") for band in part) else "")
    else:
        words.append(f"Clearest at {_in_hz(clearest.hz)}, {clearest.margin_db:+.0f} dB.")
    words += [f"Covered by {name}: {', '.join(ranges)}." for name, ranges in _covered(bands).items()]
    return " ".join(word for word in words if word)


def missing_words(*, neighbours: bool, bed: bool, any_on: bool) -> str:
    """Return a scene's gaps for the question whether a sound is heard in it; empty where it has all."""
    if not any_on and not neighbours and not bed:
        return (
            "Not known yet: the scene has no bed and no neighbours. Add a bed, or approve sounds that play beside it."
        )
    if not any_on:
        return "Not known: the other sounds of the scene are off. Switch one on."
    if not bed:
        return "The scene has no bed: music and ambience are not counted."
    return "" if neighbours else "The scene has no neighbours: other sounds of the game are not counted."


def _covered(bands: Sequence[CoveredBand]) -> dict[str, list[str]]:
    """Return the ranges of frequency in which each sound covers, by its name."""
    ranges: dict[str, list[str]] = {}
    run: list[CoveredBand] = []
    for band in (*bands, None):
        covers = band is not None and band.is_part and not band.is_heard
        if run and not (covers and band is not None and band.covered_by == run[0].covered_by):
            ends = dict.fromkeys((_in_hz(run[0].hz), _in_hz(run[-1].hz)))
            ranges.setdefault(run[0].covered_by, []).append("–".join(ends))
            run = []
        if covers and band is not None:
            run.append(band)
    return ranges


def _in_hz(hz: float) -> str:
    return f"{hz / 1_000:.1f} kHz" if hz >= 1_000 else f"{round(hz, -1):.0f} Hz"
