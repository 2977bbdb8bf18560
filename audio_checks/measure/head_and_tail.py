"""Differences of a sound's tail from its head: in noise, spectrum, modulation and width."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np

from audio_checks.measure.course import WIDE, Course, Floats, Rows
from audio_checks.measure.decay import TINY, DecayFigures

MODULATION_HZ = ((0.5, 2), (2, 5), (5, 10), (10, 20), (20, 50), (50, 100))
SPAN_ROWS = 8  # over which left and right are compared


def materials(decay: DecayFigures, course: Course) -> list[float]:
    """Return the noisiness of head and tail, and their difference."""
    figures: list[float] = []
    weights = np.sqrt(np.nan_to_num(decay.energies))
    weights /= weights.sum(axis=1, keepdims=True) + TINY
    parts = (course.head, course.tail)
    for values in (decay.flatness_db, decay.flutter_db):
        for lowest in (0, 3):
            head, tail = (_weighted(values[:, lowest:], weights[:, lowest:], rows) for rows in parts)
            figures += [head, tail, tail - head]
        enough = course.tail.sum() > 3
        figures += list(np.median(values[course.tail], axis=0)) if enough else [math.nan] * WIDE
    head, tail = (_kurtosis(decay.edges[rows]) for rows in parts)
    counts = [math.log1p(int(rows.sum())) for rows in parts]
    return [*figures, head, tail, tail - head, float(course.tail.mean()), *counts]


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


def spectra(decay: DecayFigures, course: Course) -> list[float]:
    """Return the likeness of the spectra of head and tail, the higher one, and the roughness of each."""
    head, tail = (_spectrum(decay.fine, rows) for rows in (course.head, course.tail))
    if head is None or tail is None:
        return [math.nan] * 6
    pitch = np.arange(len(head))
    shares = [np.exp2(part / 3) for part in (head, tail)]
    lower, higher = (float((pitch * share).sum() / share.sum()) for share in shares)
    rough = [float(np.abs(np.diff(part, 2)).mean()) for part in (head, tail)]
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


def modulation(course: Course) -> list[float]:
    """Return the depth and speed of the level's moves, and the extra speed of rises over falls."""
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


def sides(decay: DecayFigures, course: Course) -> list[float]:
    """Return the likeness of left and right in head, tail and last fall, and the share of side in each."""
    if decay.sides is None:
        return [math.nan] * 24
    fading = course.active[:, WIDE].copy()
    fading[: course.last] = False
    parts = []
    for rows in (course.head, course.tail, fading):
        alike, side, balance = stereo(decay.sides, rows)
        parts.append([_mean(alike[:3]), _mean(alike[3:]), _mean(alike), side, balance])
    moved = [tail - head for head, tail in zip(parts[0][:4], parts[1][:4], strict=True)]
    return [*parts[0], *parts[1], *parts[2], *moved, *stereo(decay.sides, course.tail)[0][2:]]


def stereo(sides: Floats, rows: Rows) -> tuple[Floats, float, float]:
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
    measured = values[~np.isnan(values)]
    return float(measured.mean()) if len(measured) else math.nan
