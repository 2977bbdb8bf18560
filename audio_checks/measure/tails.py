"""Features that distinguish a reverberant sound from a dry one: its falls, its tail against its head, its gaps."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.course import WIDE, Course, Floats
from audio_checks.measure.decay import OCTAVES_HZ, DecayFigures
from audio_checks.measure.head_and_tail import materials, modulation, sides, spectra, stereo

SLOPE_ROWS = (6, 12, 24)  # 30, 60 and 120 ms
DROP_ROWS = (2, 4, 8, 16, 32, 64)  # 10 to 320 ms
QUANTILES = (0.02, 0.1, 0.3, 0.6, 0.97)
MOST_POINTS = 60  # of a curve that is drawn


def features_of(decay: DecayFigures) -> Floats | None:
    """Return the features of a sound in a fixed order.

    Parameters
    ----------
    decay : DecayFigures
        Of the whole sound.

    Returns
    -------
    ndarray, shape (features,), or None
        nan where the sound has nothing to say, as of left and right in mono; None for silence, and for what
        is shorter than 40 ms.
    """
    course = Course.of(decay)
    if course is None:
        return None
    return np.array(
        [
            *_slopes(course),
            *_drops(course),
            *_last_falls(course),
            *materials(decay, course),
            *spectra(decay, course),
            *modulation(course),
            *sides(decay, course),
        ]
    )


def decay_curves(decay: DecayFigures) -> dict[str, Any] | None:
    """Return the energy decay curve of every octave from where it was last loud, for drawing.

    Parameters
    ----------
    decay : DecayFigures
        Of the whole sound.

    Returns
    -------
    dict or None
        `start_s`, from the first frame that is no silence; `step_s` between two points; and `bands`, those
        that are heard to die away, each with `hz`, `curve_db` (0 at the start), and by the line through -5 to
        -25 dB `rt60_s` and `rate_db_s`, None where the curve is too short. None where there is no course.

    Notes
    -----
    Schroeder's backward integration, as in ISO 3382-1, 5.3.3.
    """
    course = Course.of(decay)
    if course is None:
        return None
    step = max(1, math.ceil((len(course.levels) - course.last + 6) / MOST_POINTS))
    bands = []
    for band, hz in enumerate(OCTAVES_HZ):
        start, stop = course.last_fall(band)
        if not course.active[:, band].any() or stop - start < 5:
            continue
        curve = energy_decay_db(course.levels[start:stop, band])
        slope = _slope_between(curve, -5, -25)
        rate = None if math.isnan(slope) or slope >= 0 else slope / decay.hop_s
        bands.append(
            {
                "hz": hz,
                "rt60_s": None if rate is None else round(-60 / rate, 2),
                "rate_db_s": None if rate is None else round(rate, 1),
                "curve_db": [round(level, 1) for level in np.maximum(curve[::step], -80.0).tolist()],
            }
        )
    return {"start_s": round(course.last * decay.hop_s, 3), "step_s": round(step * decay.hop_s, 4), "bands": bands}


def likeness_of_sides(decay: DecayFigures) -> list[dict[str, float | None]] | None:
    """Return the likeness of left and right in head and tail, by octave.

    Parameters
    ----------
    decay : DecayFigures
        Of the whole sound; the first two channels count.

    Returns
    -------
    list of dict or None
        Each octave's `hz`, and its coherence over 40 ms in `head` and `tail`, 0..1, None where there is no
        such part; independent noise gives about 0.3 in the high octaves. None for mono and for no course.
    """
    course = Course.of(decay)
    if course is None or decay.sides is None:
        return None
    head, tail = (stereo(decay.sides, rows)[0] for rows in (course.head, course.tail))
    return [
        {"hz": hz, "head": _share(head[band]), "tail": _share(tail[band])}
        for band, hz in enumerate(OCTAVES_HZ)
        if not np.isnan(decay.energies[0, band])
    ]


def energy_decay_db(levels: Floats) -> Floats:
    """Return the energy that is still to come, in dB under all of it, shape as `levels`, which are in dB."""
    to_come = np.cumsum(10 ** (levels[::-1] / 10))[::-1]
    curve: Floats = 10 * np.log10(to_come / to_come[0])
    return curve


def _slopes(course: Course) -> list[float]:
    """Return the bands' speeds of fall and rise, over windows of three lengths: quantiles, and incidence of falls."""
    features: list[float] = []
    held = np.maximum(course.levels, course.floors - 3).T.copy()
    active = course.active.T
    for rows in SLOPE_ROWS:
        table = np.full((WIDE + 1, len(QUANTILES) + 1), np.nan)
        if (last := held.shape[1] - rows + 1) > 0:
            turns = np.arange(rows) - (rows - 1) / 2
            weights = turns / np.square(turns).sum()
            slopes = np.stack([np.correlate(levels, weights) for levels in held])
            slopes[~(active[:, :last] & active[:, rows - 1 :])] = np.inf
            slopes.sort(axis=1)
            counts = np.isfinite(slopes).sum(axis=1)
            counted_bands = np.flatnonzero(counts >= 3)
            places = np.rint(np.outer(counts[counted_bands] - 1, QUANTILES)).astype(int)
            picked = np.take_along_axis(slopes[counted_bands], places, axis=1)
            table[counted_bands, :-1] = np.sign(picked) * np.log1p(10 * np.abs(picked))
            table[counted_bands, -1] = (slopes[counted_bands] < 0).sum(axis=1) / counts[counted_bands]
        features += [*table.ravel(), *_over_octaves(table)]
    return features


def _over_octaves(table: Floats) -> list[float]:
    """Return the middle and the spread over the octaves of each column; nan where no octave says anything."""
    ordered = np.sort(table[:WIDE], axis=0)  # what says nothing comes last
    is_known = ~np.isnan(ordered)
    counts = is_known.sum(axis=0)
    middles = np.take_along_axis(ordered, np.maximum(0, [(counts - 1) // 2, counts // 2]), axis=0).sum(axis=0) / 2
    with np.errstate(invalid="ignore"):  # of no octave
        means = np.where(is_known, ordered, 0.0).sum(axis=0) / counts
        spreads = np.sqrt(np.where(is_known, np.square(ordered - means), 0.0).sum(axis=0) / counts)
    return [*middles, *spreads]


def _drops(course: Course) -> list[float]:
    """Return the largest drops within some spans of time, in dB and as a share of what counts."""
    held = np.maximum(course.smooth, course.floors)
    held = np.concatenate((held, np.repeat(held[-1:], DROP_ROWS[-1], axis=0)))
    drops = np.stack([(held[:-rows] - held[rows:]).max(axis=0) for rows in DROP_ROWS], axis=1)
    drops[~course.active.any(axis=0)] = np.nan
    depth = np.maximum(course.smooth.max(axis=0) - course.floors, 1.0)
    share = drops / depth[:, np.newaxis]
    return [*drops[WIDE], *_over_octaves(drops), *_over_octaves(share), *drops[:WIDE, 2], *drops[:WIDE, 4]]


def _last_falls(course: Course) -> list[float]:
    """Return the decay of each band after it was last loud: its decay times, its bend, its straightness."""
    table = np.full((WIDE + 1, 7), np.nan)
    for band in range(WIDE + 1):
        start, stop = course.last_fall(band)
        if stop - start < 5 or not course.active[:, band].any():
            continue
        levels = course.levels[start:stop, band]
        curve = energy_decay_db(levels)
        spans = ((-1, -8), (-6, -20), (-18, -38))
        early, middle, late = (_decay_log(_slope_between(curve, *span)) for span in spans)
        slope, unsteadiness = _line(levels)
        depth = course.smooth[start, band] - max(course.floors[band], course.smooth[stop - 1, band])
        table[band] = early, middle, late, _decay_log(slope), late - early, unsteadiness, depth
    falls = np.flatnonzero(~np.isnan(table[:WIDE, 2]))
    tilt = _tilt(falls, table[falls, 2]) if len(falls) >= 3 else math.nan
    wide, top = course.smooth[:, WIDE], course.smooth[:, WIDE].max()
    rises = np.flatnonzero((wide[4:] - wide[:-4] > 9) & (wide[4:] > top - 25))
    onsets = int((np.diff(rises, prepend=-100) > 10).sum())
    length = math.log1p((course.end - course.last) / 20)
    return [*table.ravel(), *_over_octaves(table), length, tilt, float(len(falls)), float(onsets)]


def _tilt(places: NDArray[np.int64], values: Floats) -> float:
    """Return the slope of the straight line through some values."""
    off = places - places.mean()
    return float(off @ values / (off @ off))


def _slope(values: Floats) -> float:
    """Return the slope of the straight line through values that follow each other."""
    count = len(values)
    return float((np.arange(count) - (count - 1) / 2) @ values) * 12 / (count * (count * count - 1))


def _line(values: Floats) -> tuple[float, float]:
    """Return that slope, and how far the values lie off the line, RMS."""
    slope = _slope(values)
    rest = values - values.mean() - slope * (np.arange(len(values)) - (len(values) - 1) / 2)
    return slope, math.sqrt(float(rest @ rest) / len(rest))


def _slope_between(curve: Floats, upper_db: float, lower_db: float) -> float:
    """Return the slope of a part of a decay curve, which never rises, in dB a row; nan where the curve lacks it."""
    if curve[-1] > lower_db:
        return math.nan
    first, end = np.searchsorted(-curve, -upper_db), np.searchsorted(-curve, -lower_db, side="right")
    return math.nan if end - first < 3 else _slope(curve[first:end])


def _decay_log(slope: float) -> float:
    """Return the log2 of the seconds in which a slope in dB a row falls by 60 dB."""
    return math.nan if math.isnan(slope) else math.log2(min(100.0, max(0.01, 0.3 / max(-slope, 1e-3))))


def _share(value: float) -> float | None:
    return None if math.isnan(value) else round(min(1.0, max(0.0, float(value))), 2)
