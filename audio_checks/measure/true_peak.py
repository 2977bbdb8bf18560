"""The level of the curve between the samples."""

from __future__ import annotations

import math
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import decibels

OVERSAMPLING = 8
TAPS = 24  # a phase
BAND = 0.89  # of the Nyquist frequency: where these phases are to be right
OUTER_WEIGHT = 1e-4  # of errors above it
FINE_OVERSAMPLING = 16
FINE_TAPS = 256  # right to 0.99 of the Nyquist frequency
FINE_BETA = 4.5  # of their Kaiser window
MISSED = 1.3  # most that the 24 taps miss, as a multiple of the treble's largest excursion
ROW = 32  # intervals that are interpolated together
FINE_ROW = 8  # the same for the fine phases; a row has several of them
ROWS_AT_ONCE, FINE_ROWS_AT_ONCE = 20, 2  # products so small that no BLAS spreads them over threads
REACH = FINE_TAPS - 1  # samples that a row needs beside its own


@cache
def phases() -> NDArray[np.float64]:
    """Return the taps of the phases between two samples, shape (OVERSAMPLING - 1, TAPS).

    Notes
    -----
    Least squares: each phase comes as near to a pure delay as 24 taps can, below 0.445 of the
    sample rate first and above it second. Tap k stands on the sample k - TAPS / 2 + 1 frames after
    the one that the interval starts with.
    """
    places = np.arange(TAPS) - TAPS / 2 + 1
    gaps = places[:, np.newaxis] - places

    def band(distance: NDArray[np.float64]) -> NDArray[np.float64]:
        inner: NDArray[np.float64] = BAND * np.sinc(BAND * distance)
        return inner + OUTER_WEIGHT * (np.sinc(distance) - inner)

    delays = np.arange(1, OVERSAMPLING) / OVERSAMPLING
    return np.linalg.solve(band(gaps), band(places[:, np.newaxis] - delays)).T.astype(np.float64)


def fine_phases() -> NDArray[np.float64]:
    """Return the taps of the fine phases, a sinc under a Kaiser window, shape (FINE_OVERSAMPLING - 1, FINE_TAPS)."""
    places = np.arange(FINE_TAPS) - FINE_TAPS / 2 + 1
    distances = places - np.arange(1, FINE_OVERSAMPLING)[:, np.newaxis] / FINE_OVERSAMPLING
    window = np.i0(FINE_BETA * np.sqrt(1 - (2 * distances / (FINE_TAPS + 1)) ** 2)) / np.i0(FINE_BETA)
    return np.asarray(np.sinc(distances) * window, dtype=np.float64)


@cache
def _row_filter(fine: bool) -> NDArray[np.float64]:
    """Return all phases of the intervals of a row as one matrix."""
    taps, row = (fine_phases(), FINE_ROW) if fine else (phases(), ROW)
    count, length = taps.shape
    matrix = np.zeros((row + length - 1, row, count))
    for interval in range(row):
        matrix[interval : interval + length, interval] = taps.T
    return matrix.reshape(row + length - 1, -1)


def highest(samples: NDArray[np.float64], best: float) -> tuple[float, float]:
    """Return the highest magnitude of the curve where it exceeds `best`, and its place.

    Parameters
    ----------
    samples : ndarray, shape (REACH + n,)
        n a multiple of ROW: the n intervals after sample FINE_TAPS / 2 - 1 are searched.
    best : float
        What is known already.

    Returns
    -------
    (float, float)
        `best` and NaN when nothing exceeds it. The place is in frames from the first sample.

    Notes
    -----
    Three sieves, each dearer than the one before: rows that cannot exceed `best` by the filter's
    largest gain; rows whose curve by 24 taps, with what these may miss in the treble, stays below
    it; the rest is interpolated finely, the most promising rows first.
    """
    near = samples[(FINE_TAPS - TAPS) // 2 :][: len(samples) - FINE_TAPS + TAPS]
    magnitudes = _row_maxima(np.abs(near))
    gain = float(np.abs(phases()).sum(axis=1).max())
    rows = np.flatnonzero(magnitudes * gain > best)
    if not len(rows):
        return best, math.nan
    treble = MISSED * _row_maxima(np.abs(np.diff(near, n=4, prepend=near[:1], append=[near[-1]] * 3)) / 16)
    windows = np.lib.stride_tricks.sliding_window_view(near, ROW + TAPS - 1)[::ROW]
    reachable = np.empty(len(rows))
    for start in range(0, len(rows), ROWS_AT_ONCE):
        part = slice(start, start + ROWS_AT_ONCE)
        curve = windows[rows[part]] @ _row_filter(False)
        reachable[part] = np.maximum(curve.max(axis=1), -curve.min(axis=1)) + treble[rows[part]]
    order = np.argsort(-reachable, kind="stable")
    rows, reachable = rows[order], reachable[order]
    windows = np.lib.stride_tricks.sliding_window_view(samples, FINE_ROW + REACH)[::FINE_ROW]
    pieces = np.arange(ROW // FINE_ROW)
    place = math.nan
    start = 0
    while start < len(rows) and reachable[start] > best:
        now = (rows[start : start + FINE_ROWS_AT_ONCE, np.newaxis] * (ROW // FINE_ROW) + pieces).ravel()
        curve = np.abs(windows[now] @ _row_filter(True))
        if curve.max() > best:
            best = float(curve.max())
            row, point = divmod(int(curve.argmax()), curve.shape[1])
            interval, phase = divmod(point, FINE_OVERSAMPLING - 1)
            place = float(now[row] * FINE_ROW + FINE_TAPS // 2 - 1 + interval + (phase + 1) / FINE_OVERSAMPLING)
        start += FINE_ROWS_AT_ONCE
    return best, place


def _row_maxima(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest value that each row and the taps around it touch."""
    count = (len(values) - TAPS + 1) // ROW
    blocks = values[: count * ROW].reshape(count, ROW).max(axis=1)
    after: NDArray[np.float64] = np.append(blocks[1:], values[count * ROW :].max())
    np.maximum(blocks, after, out=after)
    return after


class TruePeak:
    """Measures the highest point of the curve of blocks; before and after the signal there is silence.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    """

    FIGURES = ("true_peak_dbtp", "true_peak_s")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:
        self._rate = sample_rate_hz
        self._frames = frames
        self._best = 0.0
        self._place = 0.0
        self._kept = np.zeros((channels, REACH))
        self._start = -REACH  # frame of the first one kept

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        peaks = np.maximum(block.max(axis=0), -block.min(axis=0))
        if peaks.max() > self._best:
            loudest = int(peaks.argmax())
            self._best = float(peaks[loudest])
            self._place = self._start + self._kept.shape[1] + int(np.abs(block[:, loudest]).argmax())
        kept = np.concatenate((self._kept, block.T), axis=1)
        rows = (kept.shape[1] - REACH) // ROW
        self._search(kept[:, : rows * ROW + REACH])
        self._kept = kept[:, rows * ROW :]
        self._start += rows * ROW

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        silence = REACH + -self._kept.shape[1] % ROW
        self._search(np.pad(self._kept, ((0, 0), (0, silence))))
        last = max(self._frames - 1, 0)
        return {
            "true_peak_dbtp": decibels(self._best),
            "true_peak_s": min(max(self._place, 0.0), last) / self._rate,
        }

    def _search(self, kept: NDArray[np.float64]) -> None:
        if kept.shape[1] < REACH + ROW:
            return
        for channel in kept:
            best, place = highest(channel, self._best)
            if best > self._best:
                self._best, self._place = best, self._start + place


def true_peak_dbtp(samples: NDArray[np.float64], sample_rate_hz: int) -> float:
    """Return the level of the curve that runs between the samples, in dBTP.

    Parameters
    ----------
    samples : ndarray, shape (frames, channels)
        Full scale is ±1.0. The loudest channel counts.
    sample_rate_hz : int
        Frames per second.

    Returns
    -------
    float
        -inf for digital silence and for no frames at all.

    Notes
    -----
    ITU-R BS.1770, Annex 2, which asks for 4x oversampling or more. Where the curve may be highest
    it is drawn 16x, at most 0.04 dB low, 20·log10(cos(π·0.5 / 16)), for content up to 0.49 of
    the sample rate.
    """
    meter = TruePeak(sample_rate_hz, samples.shape[1], len(samples))
    meter.add(samples)
    return float(meter.result()["true_peak_dbtp"])
