"""Rules for comparing a sound with others, stated without a database.

A figure is within range if it is between the others' or at most a slack beyond. What has many numbers (spectrum,
timbre) is compared by its distance from the middle of the others; each of them has its own, from the middle of the
rest.
"""

import math
from bisect import bisect_left
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from statistics import median
from typing import NamedTuple

Numbers = Sequence[float]
FEWEST = 3  # cues to be compared with: fewer have no middle


class Measure(StrEnum):
    """The measures by which sounds are compared."""

    LOUDNESS = "loudness"
    SPECTRUM = "spectrum"
    DRYNESS = "dryness"
    TIMBRE = "timbre"


class FitBasis(StrEnum):
    """The approved sounds that a take is compared with."""

    CATEGORY = "category"
    PALETTE = "palette"


class Stands(StrEnum):
    """The position of a figure among others."""

    WITHIN = "within"
    ABOVE = "above"
    BELOW = "below"


SLACK = {Measure.LOUDNESS: 2.0, Measure.SPECTRUM: 2.0, Measure.DRYNESS: 0.15, Measure.TIMBRE: 1.0}
UNITS = {Measure.LOUDNESS: "LUFS", Measure.SPECTRUM: "dB", Measure.DRYNESS: "of 1", Measure.TIMBRE: "dB"}
WORDS = {
    Measure.LOUDNESS: {Stands.ABOVE: "louder", Stands.BELOW: "quieter"},
    Measure.SPECTRUM: {Stands.ABOVE: "different spectrum"},
    Measure.DRYNESS: {Stands.ABOVE: "more reverberant", Stands.BELOW: "drier"},
    Measure.TIMBRE: {Stands.ABOVE: "different timbre"},
}


@dataclass(frozen=True)
class Likeness:
    """The compared features of a sound; None if not measured, or for silence."""

    loudness_lufs: float | None = None
    reverb_score: float | None = None  # 0 is surely dry, 1 surely reverberant
    bands_db: Numbers | None = None
    timbre: Numbers | None = None


class Fit(NamedTuple):
    """The position of a sound among others by one measure."""

    value: float
    others: list[float | None]  # in the order that they were given
    middle: float
    lowest: float
    highest: float
    stands: Stands


def distance_db(numbers: Numbers, other: Numbers) -> float:
    """Return the RMS difference of two spectra in dB, over the bands that both have."""
    pairs = list(zip(numbers, other, strict=False))
    return math.sqrt(sum((a - b) ** 2 for a, b in pairs) / len(pairs))


def timbre_distance_db(numbers: Numbers, other: Numbers) -> float:
    """Return the distance of two timbres in dB; each number bears its weight already."""
    return math.dist(numbers, other)


def nearest(sound: Likeness, others: Sequence[Likeness]) -> list[tuple[int, float]]:
    """Return the places of the others and their distances in timbre in dB, the nearest first; silence has none."""
    if not sound.timbre:
        return []
    distances = [
        (place, timbre_distance_db(sound.timbre, other.timbre)) for place, other in enumerate(others) if other.timbre
    ]
    return sorted(distances, key=lambda distance: distance[1])


def middle_of(sounds: Sequence[Likeness]) -> Likeness:
    """Return the medians of some sounds, number by number: so the variations of one cue count as one sound."""
    loudness = [sound.loudness_lufs for sound in sounds if sound.loudness_lufs is not None]
    reverb = [sound.reverb_score for sound in sounds if sound.reverb_score is not None]
    bands = [sound.bands_db for sound in sounds if sound.bands_db]
    timbre = [sound.timbre for sound in sounds if sound.timbre]
    return Likeness(
        loudness_lufs=median(loudness) if loudness else None,
        reverb_score=median(reverb) if reverb else None,
        bands_db=_middle(bands) if bands else None,
        timbre=_middle(timbre) if timbre else None,
    )


def fit_of(sound: Likeness, others: Sequence[Likeness]) -> dict[Measure, Fit]:
    """Return the position of a sound among others, by every measure that it and three of them have."""
    plain: dict[Measure, Callable[[Likeness], float | None]] = {
        Measure.LOUDNESS: lambda sound_likeness: sound_likeness.loudness_lufs,
        Measure.DRYNESS: lambda sound_likeness: sound_likeness.reverb_score,
    }
    places = {measure: _placed(measure, of(sound), [of(other) for other in others]) for measure, of in plain.items()}
    bands = _apart(sound.bands_db, [other.bands_db for other in others], distance_db)
    timbre = _apart(sound.timbre, [other.timbre for other in others], timbre_distance_db)
    places |= {Measure.SPECTRUM: _placed(Measure.SPECTRUM, *bands), Measure.TIMBRE: _placed(Measure.TIMBRE, *timbre)}
    return {measure: fit for measure in Measure if (fit := places[measure]) is not None}


def _placed(measure: Measure, value: float | None, others: list[float | None]) -> Fit | None:
    measured = [other for other in others if other is not None]
    if value is None or len(measured) < FEWEST:
        return None
    lowest, highest, slack = min(measured), max(measured), SLACK[measure]
    stands = Stands.ABOVE if value > highest + slack else Stands.BELOW if value < lowest - slack else Stands.WITHIN
    if stands is Stands.BELOW and measure in (Measure.SPECTRUM, Measure.TIMBRE):
        stands = Stands.WITHIN  # nearer to the middle than any other
    return Fit(value, others, median(measured), lowest, highest, stands)


def _apart(
    figures: Numbers | None, others: Sequence[Numbers | None], distance: Callable[[Numbers, Numbers], float]
) -> tuple[float | None, list[float | None]]:
    """Return the distance from the middle of the others, and of each of them from the middle of the rest."""
    measured = [other for other in others if other]
    if not figures or len(measured) < FEWEST:
        return None, []
    middles = iter(_middles_without_each(measured))
    return distance(figures, _middle(measured)), [distance(other, next(middles)) if other else None for other in others]


def _middles_without_each(lists: Sequence[Numbers]) -> list[list[float]]:
    """Return for each of some lists the middle of the others; each column is sorted once."""
    columns = [sorted(values) for values in zip(*lists, strict=False)]
    return [
        [_median_without(column, value) for column, value in zip(columns, numbers, strict=False)] for numbers in lists
    ]


def _median_without(ordered: Sequence[float], value: float) -> float:
    gone = bisect_left(ordered, value)
    below, above = (len(ordered) - 2) // 2, (len(ordered) - 1) // 2
    return (ordered[below + (below >= gone)] + ordered[above + (above >= gone)]) / 2


def _middle(lists: Sequence[Numbers]) -> list[float]:
    """Return the median of each number, of as many as all have."""
    return [median(values) for values in zip(*lists, strict=False)]


def in_words(fits: dict[Measure, Fit]) -> str:
    """Return a sentence on how a sound differs, or that it fits."""
    apart = [
        f"{WORDS[measure][fit.stands]}{_by_how_much(measure, fit)}"
        for measure, fit in fits.items()
        if fit.stands is not Stands.WITHIN
    ]
    return f"Stands apart: {', '.join(apart)}." if apart else "Within their range in everything measured."


def _by_how_much(measure: Measure, fit: Fit) -> str:
    if measure is Measure.LOUDNESS:
        edge = fit.highest if fit.stands is Stands.ABOVE else fit.lowest
        return f" than all of them, by {abs(fit.value - edge):.1f} LU"
    return " than all of them" if measure is Measure.DRYNESS else ""


def shift(placed: Sequence[tuple[float, float, Stands]]) -> tuple[int, float]:
    """Return the number of sounds out of range among some, and the median of their distances from the others.

    Each is its value, the median of the others, and its position.
    """
    apart = sum(stands is not Stands.WITHIN for _, _, stands in placed)
    return apart, median(value - middle for value, middle, _ in placed)
