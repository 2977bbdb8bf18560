"""Features that distinguish a reverberant sound from a dry one: its falls, its tail against its head, its gaps."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decay import OCTAVES_HZ, TINY, DecayFigures

Floats = NDArray[np.float64]
Rows = NDArray[np.bool_]

RANGE_DB = 60.0  # under the loudest row nothing counts
BAND_RANGE_DB = 45.0  # a band that never comes nearer to the whole is not heard
ABOVE_FLOOR_DB = 8.0
LOUD_DB = 12.0  # under the loudest row a row is loud
FEWEST_ROWS = 8
SLOPE_ROWS = (6, 12, 24)  # 30, 60 and 120 ms
DROP_ROWS = (2, 4, 8, 16, 32, 64)  # 10 to 320 ms
QUANTILES = (0.02, 0.1, 0.3, 0.6, 0.97)
MODULATION_HZ = ((0.5, 2), (2, 5), (5, 10), (10, 20), (20, 50), (50, 100))
SPAN_ROWS = 8  # over which left and right are compared
MOST_POINTS = 60  # of a curve that is drawn
WIDE = len(OCTAVES_HZ)  # the place of the whole range after the octaves


@dataclass(frozen=True)
class Course:
    """How loud a sound is in each row and band, and which rows are head and which tail.

    Attributes
    ----------
    levels, smooth : ndarray, shape (rows, octaves + 1)
        In dB, as they are and as means over three rows; the last column is the whole range.
    floors : ndarray, shape (octaves + 1,)
        Lower levels count for nothing.
    active : ndarray, shape (rows, octaves + 1)
        The cells that count.
    head, tail : ndarray, shape (rows,)
        The head is near what was loudest of late, the tail well under it.
    last, end : int
        The last row that is loud, and the last that counts.
    """

    levels: Floats
    smooth: Floats
    floors: Floats
    active: Rows
    head: Rows
    tail: Rows
    last: int
    end: int

    @classmethod
    def of(cls, decay: DecayFigures) -> Course | None:
        """Return the course of a sound; None for silence, and for what is shorter than 40 ms."""
        energies = np.nan_to_num(decay.energies)
        if len(energies) < FEWEST_ROWS or energies.max() <= TINY:
            return None
        powers = np.column_stack((energies, energies.sum(axis=1)))
        around = np.concatenate((powers[:1], powers, powers[-1:]))
        smooth = 10 * np.log10((around[:-2] + powers + around[2:]) / 3 + TINY)
        tops = smooth.max(axis=0)
        floors = np.maximum(tops - RANGE_DB, _noise_under(smooth) + ABOVE_FLOOR_DB)
        active = (smooth > floors) & (tops > tops[WIDE] - BAND_RANGE_DB)
        if not active[:, WIDE].any():  # no louder than TINY
            return None
        wide, top = smooth[:, WIDE], tops[WIDE]
        forgotten = 0.1 * np.arange(len(wide))  # what was loudest counts for 20 dB less a second later
        under = np.maximum.accumulate(wide + forgotten) - forgotten - wide
        last = int(np.flatnonzero(wide >= top - LOUD_DB)[-1])
        return cls(
            levels=10 * np.log10(powers + TINY),
            smooth=smooth,
            floors=floors,
            active=active,
            head=(under < 4) & active[:, WIDE] & (wide > top - 25),
            tail=(under > 10) & active[:, WIDE],
            last=last,
            end=max(last, int(np.flatnonzero(active[:, WIDE])[-1])),
        )

    def last_fall(self, band: int) -> tuple[int, int]:
        """Return the rows from where a band was last loud to where it no longer counts."""
        first = max(0, self.last - 6)
        start = first + int(np.argmax(self.smooth[first : self.last + 7, band]))
        under = np.flatnonzero(self.smooth[start:, band] <= self.floors[band])
        return start, start + (int(under[0]) if len(under) else len(self.smooth) - start)


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
            *_materials(decay, course),
            *_spectra(decay, course),
            *_modulation(course),
            *_sides(decay, course),
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
                "curve_db": [round(float(level), 1) for level in np.maximum(curve[::step], -80.0)],
            }
        )
    return {"start_s": round(course.last * decay.hop_s, 3), "step_s": round(step * decay.hop_s, 4), "bands": bands}


def likeness_of_sides(decay: DecayFigures) -> list[dict[str, float | None]] | None:
    """Return how alike left and right are in head and tail, by octave.

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
    head, tail = (_stereo(decay.sides, rows)[0] for rows in (course.head, course.tail))
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


def _noise_under(smooth: Floats) -> Floats:
    """Return by band the level of a steady noise under the sound, by its quietest rows; -200 where there is none."""
    quiet = np.sort(smooth, axis=0)[: max(1, len(smooth) // 10)]
    steady = (quiet[-1] - quiet[0] < 6) & (quiet[-1] < smooth.max(axis=0) - 25)
    floors: Floats = np.where(steady, quiet.mean(axis=0), -200.0)
    return floors


def _slopes(course: Course) -> list[float]:
    """Return how fast the bands fall and rise, over windows of three lengths: quantiles, and how often they fall."""
    found: list[float] = []
    held = np.maximum(course.levels, course.floors - 3)
    for rows in SLOPE_ROWS:
        table = np.full((WIDE + 1, len(QUANTILES) + 1), np.nan)
        if len(held) >= rows:
            turns = np.arange(rows) - (rows - 1) / 2
            windows = np.lib.stride_tricks.sliding_window_view(held, rows, axis=0)
            slopes = windows @ (turns / np.square(turns).sum())
            counts = course.active[: len(slopes)] & course.active[rows - 1 :]
            for band in range(WIDE + 1):
                known = np.sort(slopes[counts[:, band], band])
                if len(known) >= 3:
                    picked = known[[round(share * (len(known) - 1)) for share in QUANTILES]]
                    table[band, :-1] = np.sign(picked) * np.log1p(10 * np.abs(picked))
                    table[band, -1] = np.searchsorted(known, 0.0) / len(known)
        found += [*table.ravel(), *_over_octaves(table)]
    return found


def _over_octaves(table: Floats) -> list[float]:
    """Return the middle and the spread over the octaves of each column; nan where no octave says anything."""
    found = np.full((2, table.shape[1]), np.nan)
    for column, values in enumerate(table[:WIDE].T):
        known = np.sort(values[~np.isnan(values)])
        if len(known):
            found[:, column] = (known[(len(known) - 1) // 2] + known[len(known) // 2]) / 2, known.std()
    return list(found.ravel())


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
    """Return how each band dies away after it was last loud: its decay times, its bend, how straight it falls."""
    table = np.full((WIDE + 1, 7), np.nan)
    for band in range(WIDE + 1):
        start, stop = course.last_fall(band)
        if stop - start < 5 or not course.active[:, band].any():
            continue
        levels = course.levels[start:stop, band]
        curve = energy_decay_db(levels)
        spans = ((-1, -8), (-6, -20), (-18, -38))
        early, middle, late = (_decay_log(_slope_between(curve, *span)) for span in spans)
        slope, unsteadiness = _line(np.arange(len(levels)), levels)
        depth = course.smooth[start, band] - max(course.floors[band], course.smooth[stop - 1, band])
        table[band] = early, middle, late, _decay_log(slope), late - early, unsteadiness, depth
    falls = np.flatnonzero(~np.isnan(table[:WIDE, 2]))
    tilt = _line(falls, table[falls, 2])[0] if len(falls) >= 3 else math.nan
    wide, top = course.smooth[:, WIDE], course.smooth[:, WIDE].max()
    rises = np.flatnonzero((wide[4:] - wide[:-4] > 9) & (wide[4:] > top - 25))
    onsets = int((np.diff(rises, prepend=-100) > 10).sum())
    length = math.log1p((course.end - course.last) / 20)
    return [*table.ravel(), *_over_octaves(table), length, tilt, float(len(falls)), float(onsets)]


def _line(places: NDArray[Any], values: Floats) -> tuple[float, float]:
    """Return the slope of the straight line through some values, and how far they lie off it, RMS."""
    off = places - places.mean()
    slope = float(off @ values / (off @ off))
    rest = values - values.mean() - slope * off
    return slope, math.sqrt(float(rest @ rest) / len(rest))


def _slope_between(curve: Floats, upper_db: float, lower_db: float) -> float:
    """Return the slope of a part of a decay curve in dB a row; nan where the curve lacks it."""
    rows = np.flatnonzero((curve <= upper_db) & (curve >= lower_db))
    return math.nan if len(rows) < 3 or curve[-1] > lower_db else _line(rows, curve[rows])[0]


def _decay_log(slope: float) -> float:
    """Return the log2 of the seconds in which a slope in dB a row falls by 60 dB."""
    return math.nan if math.isnan(slope) else math.log2(min(100.0, max(0.01, 0.3 / max(-slope, 1e-3))))


def _materials(decay: DecayFigures, course: Course) -> list[float]:
    """Return how noisy head and tail are, and how they differ."""
    found: list[float] = []
    weights = np.sqrt(np.nan_to_num(decay.energies))
    weights /= weights.sum(axis=1, keepdims=True) + TINY
    parts = (course.head, course.tail)
    for values in (decay.flatness_db, decay.flutter_db):
        for lowest in (0, 3):
            head, tail = (_weighted(values[:, lowest:], weights[:, lowest:], rows) for rows in parts)
            found += [head, tail, tail - head]
        enough = course.tail.sum() > 3
        found += list(np.median(values[course.tail], axis=0)) if enough else [math.nan] * WIDE
    head, tail = (_kurtosis(decay.edges[rows]) for rows in parts)
    counts = [math.log1p(int(rows.sum())) for rows in parts]
    return [*found, head, tail, tail - head, float(course.tail.mean()), *counts]


def _weighted(values: Floats, weights: Floats, rows: Rows) -> float:
    if rows.sum() < 3:
        return math.nan
    return float((values[rows] * weights[rows]).sum() / (weights[rows].sum() + TINY))


def _kurtosis(edges: Floats) -> float:
    """Return the middle of the log of kurtosis over four rows."""
    count = len(edges) // 4
    if count < 2:
        return math.nan
    second, fourth = edges[: count * 4].reshape(count, 4, 2).mean(axis=1).T
    return float(np.median(np.log(fourth / np.maximum(np.square(second), 1e-30) + 1e-3)))


def _spectra(decay: DecayFigures, course: Course) -> list[float]:
    """Return how alike the spectra of head and tail are, which is higher, and how rough each is."""
    head, tail = (_spectrum(decay.fine, rows) for rows in (course.head, course.tail))
    if head is None or tail is None:
        return [math.nan] * 6
    pitch = np.arange(len(head))
    shares = [np.exp2(one / 3) for one in (head, tail)]
    lower, higher = (float((pitch * share).sum() / share.sum()) for share in shares)
    rough = [float(np.abs(np.diff(one, 2)).mean()) for one in (head, tail)]
    moved = (head - head.mean()) - (tail - tail.mean())
    spread = float(head.std() * tail.std())
    alike = float((head - head.mean()) @ (tail - tail.mean())) / len(head) / spread if spread else math.nan
    return [alike, higher - lower, *rough, rough[1] - rough[0], float(np.abs(moved).mean())]


def _spectrum(fine: Floats, rows: Rows) -> Floats | None:
    """Return the mean level of each fine band with every row at equal power, in dB."""
    if rows.sum() < 3:
        return None
    shares = fine[rows] / (fine[rows].sum(axis=1, keepdims=True) + TINY)
    levels: Floats = 10 * np.log10(shares.mean(axis=0) + 1e-6)
    return levels


def _modulation(course: Course) -> list[float]:
    """Return how deep and how fast the level moves, and how much faster it rises than falls."""
    wide, top = course.smooth[:, WIDE], float(course.smooth[:, WIDE].max())
    level = np.maximum(wide[: course.end + 1], top - 50)
    size = max(512, 1 << (len(level) - 1).bit_length())
    spectrum = np.square(np.abs(np.fft.rfft((level - level.mean()) * np.hanning(len(level)), size)))
    hz = np.fft.rfftfreq(size, 0.005)
    parts = [math.log10(float(spectrum[(hz >= low) & (hz < high)].sum()) + 1e-3) for low, high in MODULATION_HZ]
    steps = np.diff(level)
    rise, fall = np.square(np.maximum(steps, 0)), np.square(np.maximum(-steps, 0))
    squares = rise + fall
    skew = float((steps * squares).mean() / (squares.mean() ** 1.5 + 1e-9))
    lean = math.log((float(rise.mean()) + 1e-4) / (float(fall.mean()) + 1e-4))
    shares = [float((level > top - below).mean()) for below in (10, 20, 30, 40)]
    between = [higher - lower for lower, higher in pairwise(parts)]
    return [*between, parts[1] - parts[4], float(level.std()), skew, lean, *shares]


def _sides(decay: DecayFigures, course: Course) -> list[float]:
    """Return how alike left and right are in head, tail and last fall, and how much of each is side."""
    if decay.sides is None:
        return [math.nan] * 24
    fading = course.active[:, WIDE].copy()
    fading[: course.last] = False
    parts = []
    for rows in (course.head, course.tail, fading):
        alike, side, balance = _stereo(decay.sides, rows)
        parts.append([_mean(alike[:3]), _mean(alike[3:]), _mean(alike), side, balance])
    moved = [tail - head for head, tail in zip(parts[0][:4], parts[1][:4], strict=True)]
    return [*parts[0], *parts[1], *parts[2], *moved, *_stereo(decay.sides, course.tail)[0][2:]]


def _stereo(sides: Floats, rows: Rows) -> tuple[Floats, float, float]:
    """Return by octave the coherence over spans of rows, and of all the log of the side's share and the balance."""
    if rows.sum() < SPAN_ROWS:
        return np.full(sides.shape[1], math.nan), math.nan, math.nan
    chosen = sides[rows]
    spans = chosen[: len(chosen) // SPAN_ROWS * SPAN_ROWS].reshape(-1, SPAN_ROWS, *chosen.shape[1:]).mean(axis=1)
    left, right, real, imaginary = np.moveaxis(spans, 2, 0)
    alike = np.sqrt(np.square(real) + np.square(imaginary)) / (np.sqrt(left * right) + TINY)
    heard = (left + right).sum(axis=0) > TINY
    totals = (chosen / (chosen[:, :, :2].sum(axis=(1, 2), keepdims=True) + TINY)).mean(axis=0).sum(axis=0)
    power, product = totals[0] + totals[1], 2 * totals[2]
    side = math.log10(max(0.0, power - product) / (max(0.0, power + product) + TINY) + 1e-4)
    balance = abs(math.log10((totals[0] + 1e-9) / (totals[1] + 1e-9)))
    return np.where(heard, alike.mean(axis=0), math.nan), side, balance


def _mean(values: Floats) -> float:
    known = values[~np.isnan(values)]
    return float(known.mean()) if len(known) else math.nan


def _share(value: float) -> float | None:
    return None if math.isnan(value) else round(min(1.0, max(0.0, float(value))), 2)
