"""The level of the curve between the samples."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.decibels import decibels
from audio_checks.measure.maxima import ROW_FRAMES
from audio_checks.measure.survey import Survey

OVERSAMPLING = 8
TAPS = 24  # a phase
BAND = 0.89  # of the Nyquist frequency: where these phases are to be right
OUTER_WEIGHT = 1e-4  # of errors above it
FINE_OVERSAMPLING = 16
# The fine points lie between samples and the middles of intervals. With 250 taps a square of 8 bits read 0.06 dB high;
# 504 are right to 0.995 of the Nyquist frequency. Samples and middles hold twice the band: 12 taps are right to 3e-5.
MIDDLE_TAPS, MIDDLE_BETA = 504, 4.5  # a sinc under a Kaiser window of this shape
HALF_TAPS, HALF_OVERSAMPLING = 12, 8
HALF_BAND, HALF_OUTER_WEIGHT = 0.5, 1e-8
HISTORY = MIDDLE_TAPS + 7  # samples before a block that its fine points take
# Most by which the curve exceeds the samples next to it, in second and fourth differences nearby; and by which it
# exceeds 24 taps, in fourth differences. Held over noise of all colours, tones, clipping and random signs.
BEND, KINK, MISSED = 1 / 8, 1 / 10, 1 / 16


@cache
def phases() -> NDArray[np.float64]:
    """Return the taps of the phases between two samples, shape (OVERSAMPLING - 1, TAPS)."""
    return _delays(TAPS, OVERSAMPLING, BAND, OUTER_WEIGHT)


@cache
def half_phases() -> NDArray[np.float64]:
    """Return the taps between a sample and the middle beside it, shape (HALF_OVERSAMPLING - 1, HALF_TAPS)."""
    return _delays(HALF_TAPS, HALF_OVERSAMPLING, HALF_BAND, HALF_OUTER_WEIGHT)


@cache
def middle_taps() -> NDArray[np.float64]:
    """Return the taps that find the point half-way between two samples, shape (MIDDLE_TAPS,)."""
    distances = np.arange(MIDDLE_TAPS) - (MIDDLE_TAPS - 1) / 2
    window = np.i0(MIDDLE_BETA * np.sqrt(1 - (2 * distances / (MIDDLE_TAPS + 1)) ** 2)) / np.i0(MIDDLE_BETA)
    return np.asarray(np.sinc(distances) * window, dtype=np.float64)


def _delays(taps: int, oversampling: int, band: float, outer_weight: float) -> NDArray[np.float64]:
    """Return filters that delay by parts of a sample, shape (oversampling - 1, taps).

    Notes
    -----
    Least squares: each phase comes as near to a pure delay as its taps can, below `band` of the
    Nyquist frequency first and above it second. Tap k stands on the sample k - taps / 2 + 1 frames
    after the one that the interval starts with.
    """
    places = np.arange(taps) - taps / 2 + 1
    gaps = places[:, np.newaxis] - places

    def within(distance: NDArray[np.float64]) -> NDArray[np.float64]:
        inner: NDArray[np.float64] = band * np.sinc(band * distance)
        return inner + outer_weight * (np.sinc(distance) - inner)

    delays = np.arange(1, oversampling) / oversampling
    return np.linalg.solve(within(gaps), within(places[:, np.newaxis] - delays)).T.astype(np.float64)


@cache
def _plan() -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Return the kernel's plan: its taps, phases in even and odd parts, and the bounds of its sieves."""
    gain = float(np.abs(phases()).sum(axis=1).max())
    outwards = np.ascontiguousarray(middle_taps()[MIDDLE_TAPS // 2 :])
    return _parts(phases()), outwards, _parts(half_phases()), np.array([gain, BEND, KINK, MISSED])


def _parts(taps: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return phases by pairs of taps, from the middle outwards: the even part of each, then the odd."""
    count, length = taps.shape
    half = count // 2 + 1
    left, right = taps[:half, length // 2 - 1 :: -1], taps[:half, length // 2 :]
    parts = np.zeros((length // 2, 2 * half))
    parts[:, :half] = (left + right).T / 2
    parts[:, half : 2 * half - 1] = (left - right)[:-1].T / 2
    return parts


class TruePeak:
    """Measures the highest point of the curve of blocks; before and after the signal there is silence.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = ("true_peak_dbtp", "true_peak_s")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, survey: Survey | None = None) -> None:
        self._rate = sample_rate_hz
        self._frames = frames
        self._survey = survey or Survey()
        self._best = 0.0
        self._place = 0  # in parts of a frame, FINE_OVERSAMPLING of them
        self._seen = 0
        self._history = np.zeros((channels, HISTORY))

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        self._take(kernel.by_channel(block), self._survey.maxima(block))

    def _take(self, rows: NDArray[np.float64], maxima: NDArray[np.float64]) -> None:
        self._best, self._place = kernel.true_peak(
            rows,
            maxima,
            self._history,
            *_plan(),
            self._best,
            self._place,
            self._seen,
        )
        self._seen += rows.shape[1]

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        channels, frames = self._history.shape
        self._take(np.zeros((channels, frames)), np.zeros((channels, -(-frames // ROW_FRAMES))))
        last = max(self._frames - 1, 0)
        return {
            "true_peak_dbtp": decibels(self._best),
            "true_peak_s": min(max(self._place / FINE_OVERSAMPLING, 0.0), last) / self._rate,
        }


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
