"""`variation-set`: the variations of a cue belong together, and are not the same.

Why: the game picks one of them at random each time. One that is louder or longer than the others
sticks out at every tenth step; two that are alike are heard as a repeat, which a set is there to avoid.
How to fix: bring the one that stands out to the level and length of the others; replace one of two
that are alike by another take.
Source: integrated loudness, for sounds under 0.4 s the loudest 0.4 s: within 2 LU over the set, or what
`[limits] variation_level_lu` says. Without that it is 4 LU for footsteps, foley, weapons and impacts, which vary on
purpose; and a set of five or more whose levels spread may do so, up to 6 LU: then 3.5 times the middle distance from
the middle counts. Length within 25 % of the middle of the others. Alike are sounds whose octave bands follow each
other within 0.4 dB once their levels are matched. It needs the sound list, and is asked once every variation is
there. The server shows it to both sides, and returns no take for it.
"""

import re
import statistics
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from audio_checks.measure.likeness import unlikeness_db
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.report.judged import JudgedFile

SEVERITY = "warning"
LABEL = "Inconsistent variation"
OVER_FILES = True
LIMITS = {"variation_level_lu": (0.0, 60.0, "Level within a set")}
NOT_FIXED = "A set is balanced by ear, all of it together: in the session."
FIGURES = ("integrated_lufs", "short_loudness_lufs", "likeness_print")
MOST_SPREAD_LU, MOST_SPREAD_VARIED_LU = 2.0, 4.0
# Categories that vary on purpose: beginnings of words, and no one-shots.
VARIED = re.compile(r"(?<![a-z])(?:foot|step|foley|impact|hit|weapon|gun|(?<!one[ _-])shot)", re.IGNORECASE)
VARIED_KIND = "natural-decay"
FEWEST_SPREAD, SPREADS, MOST_SPREAD_OF_SET_LU = 5, 3.5, 6.0  # a set that spreads as a whole has its own limit
MOST_LENGTH_OFF = 0.25
LEAST_UNLIKE_DB = 0.4
EPSILON = 1e-9
ONE_BLOCK_S = 0.4  # of BS.1770: below, there is no integrated loudness

Set = dict[int, int]  # the place of the file that represents each variation


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Only for a cue with variations."""
    return cue is not None and cue.variations > 1


def check_set(files: "Sequence[JudgedFile]") -> Iterator[tuple[int, Finding]]:
    """Yield the outliers of a set once all variations are there.

    `variation-set:level` for loudness, `variation-set:length` for length, `variation-set:alike` for the later one
    of two that are nearly the same. An alternate is held against the set, and moves nothing in it.
    """
    by_cue: dict[str, list[int]] = defaultdict(list)
    for index, file in enumerate(files):
        if file.cue is not None and file.cue.variations > 1:
            by_cue[file.cue.number].append(index)
    for places in by_cue.values():
        chosen = _chosen(files, places)
        cue = files[places[0]].cue
        if cue is not None and len(chosen) == cue.variations:
            yield from _of_one_set(files, places, chosen)


def offset_from_set_lu(files: "Sequence[JudgedFile]") -> list[float | None]:
    """Return the excess loudness of each file of one cue over the other variations that are there, in LU.

    None for a file without others to compare with, and for silence.
    """
    places = range(len(files))
    off = _off(_levels(files, places), files, places, _chosen(files, places))
    return [off.get(index) for index in places]


def _chosen(files: "Sequence[JudgedFile]", places: Sequence[int]) -> Set:
    """Return the file that represents each variation: an alternate only if there is nothing else."""
    chosen: Set = {}
    for index in sorted(places, key=lambda position: files[position].is_alternate):
        chosen.setdefault(files[index].variation, index)
    return chosen


def _of_one_set(files: "Sequence[JudgedFile]", places: Sequence[int], chosen: Set) -> Iterator[tuple[int, Finding]]:
    levels, lengths = _levels(files, places), {index: _duration_s(files[index]) for index in places}
    levels_off = _off(levels, files, places, chosen)
    limit = _limit_lu(files[places[0]].spec, [levels[index] for index in chosen.values() if index in levels])
    most_off = _most_off(levels, levels_off, chosen, limit + files[places[0]].spec.limits.tolerance_db)
    lengths_off = _off(lengths, files, places, chosen)
    for file_index in places:
        off = levels_off.get(file_index)
        if off is not None and most_off is not None and abs(off) > most_off:
            yield file_index, _level(off, levels[file_index], files[file_index], limit)
        off = lengths_off.get(file_index)
        if off is not None and abs(off) > MOST_LENGTH_OFF * (lengths[file_index] - off):
            yield file_index, _length(off, lengths[file_index], files[file_index])
    yield from _alike(files, list(chosen.values()))


def _levels(files: "Sequence[JudgedFile]", places: Sequence[int]) -> dict[int, float]:
    """Return the loudness of each file that has one, all measured the same way."""
    short = any(_duration_s(files[index]) < ONE_BLOCK_S for index in places)
    figure = "short_loudness_lufs" if short else "integrated_lufs"
    known_levels = {index: files[index].report.measurements.get(figure) for index in places}
    return {index: level for index, level in known_levels.items() if level is not None and level > float("-inf")}


def _duration_s(file: "JudgedFile") -> float:
    return float((file.report.facts or {})["duration_s"])


def _off(
    figures: Mapping[int, float], files: "Sequence[JudgedFile]", places: Sequence[int], chosen: Set
) -> dict[int, float]:
    """Return the distance of each file's figure from the middle of the other variations'."""
    far: dict[int, float] = {}
    for index in places:
        others = [other for variation, other in chosen.items() if variation != files[index].variation]
        known_levels = [figures[other] for other in others if other in figures]
        if index in figures and known_levels:
            far[index] = figures[index] - statistics.median(known_levels)
    return far


def _limit_lu(spec: DeliverySpec, levels: Sequence[float]) -> float:
    """Return the limit on one variation's distance in level from the others, in LU."""
    stated = spec.limits.variation_level_lu
    if stated is not None:
        return stated
    varies = spec.kind == VARIED_KIND or VARIED.search(spec.category or "") is not None
    limit = MOST_SPREAD_VARIED_LU if varies else MOST_SPREAD_LU
    if len(levels) < FEWEST_SPREAD:
        return limit
    middle = statistics.median(levels)
    spread = SPREADS * statistics.median(abs(level - middle) for level in levels)
    return max(limit, min(spread, MOST_SPREAD_OF_SET_LU))


def _most_off(levels: Mapping[int, float], off: Mapping[int, float], chosen: Set, limit: float) -> float | None:
    """Return the distance beyond which a file is named; None where none is.

    One that is farther from the middle than the whole set may spread is named. Where none is, but the
    set spreads too far all the same, those that lie farthest are.
    """
    known_levels = [levels[index] for index in chosen.values() if index in levels]
    if len(known_levels) < 2:
        return None
    farthest = max(abs(off[index]) for index in chosen.values() if index in off)
    return limit if farthest > limit or max(known_levels) - min(known_levels) <= limit else farthest - EPSILON


def _level(off: float, level: float, file: "JudgedFile", limit: float) -> Finding:
    turn, how = ("lower", "louder") if off > 0 else ("raise", "quieter")
    return Finding(
        code="variation-set:level",
        message=f"_{file.variation:02} is {abs(off):.1f} LU {how} than the rest of its set, limit {limit:.3g} LU",
        fix=f"{turn} its level by {abs(off):.1f} dB, to {level - off:.1f} LUFS",
        measured=off,
        limit=limit,
        unit="LU",
    )


def _length(off: float, length_s: float, file: "JudgedFile") -> Finding:
    wanted_s = length_s - off
    turn = "shorten" if off > 0 else "lengthen"
    return Finding(
        code="variation-set:length",
        message=f"_{file.variation:02} is {length_s:.2f} s long, its set {wanted_s:.2f} s, limit {MOST_LENGTH_OFF:.0%}",
        fix=f"{turn} the sound by {abs(off):.2f} s, or say on the cue why it differs",
        measured=length_s,
        limit=wanted_s,
        unit="s",
        start_s=min(wanted_s, length_s) if off > 0 else 0.0,
        end_s=length_s,
    )


def _alike(files: "Sequence[JudgedFile]", places: Sequence[int]) -> Iterator[tuple[int, Finding]]:
    ordered = sorted(places, key=lambda position: files[position].variation)
    for index, file_index in enumerate(ordered):
        near = [
            (apart, before)
            for before in ordered[:index]
            if (apart := _apart(files[before], files[file_index])) is not None
        ]
        nearest, before = min(near, default=(LEAST_UNLIKE_DB, file_index))
        if nearest < LEAST_UNLIKE_DB:
            yield file_index, _two_alike(nearest, files[before], files[file_index])


def _two_alike(apart_db: float, before: "JudgedFile", same: "JudgedFile") -> Finding:
    both = f"_{same.variation:02} is nearly identical to _{before.variation:02}"
    return Finding(
        code="variation-set:alike",
        message=f"{both}, {apart_db:.1f} dB apart, limit {LEAST_UNLIKE_DB:g} dB",
        fix="replace one of them with a different take",
        measured=apart_db,
        limit=LEAST_UNLIKE_DB,
        unit="dB",
        start_s=0.0,
        end_s=_duration_s(same),
    )


def _apart(file: "JudgedFile", other: "JudgedFile") -> float | None:
    """Return the unlikeness of two sounds; None if it cannot be decided, or the duplicate check reports it."""
    first, second = file.report.likeness_print, other.report.likeness_print
    if first is None or second is None or file.report.pcm_sha256 == other.report.pcm_sha256:
        return None
    return unlikeness_db(first, second)
