"""Pauses: silence between two parts of a sound, for a threshold that depends on a peak known only at the end."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import ratio
from audio_checks.measure.maxima import ROW_FRAMES
from audio_checks.measure.survey import Survey

BELOW_DBFS, BELOW_PEAK = -60.0, 1e-3  # silent is what lies below both
SHORTEST_S = 0.6  # a shorter pause is part of a sound: of the ticks of a clock, of a bird that calls
GRAIN_S = 0.01


class Pauses:
    """Remembers the highest magnitude of each 10 ms, and finds the silent stretches with sound on both sides.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = ("pauses",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, survey: Survey | None = None) -> None:
        self._rate = sample_rate_hz
        self._survey = survey or Survey()
        self._grain = max(1, round(GRAIN_S * sample_rate_hz / ROW_FRAMES)) * ROW_FRAMES
        self._highest = np.zeros(frames // self._grain + 1, np.float32)
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        rows = self._survey.maxima(block).max(axis=0)
        grains = (self._seen + ROW_FRAMES * np.arange(len(rows))) // self._grain
        starts = np.flatnonzero(np.diff(grains, prepend=-1))
        places = grains[starts]
        self._highest[places] = np.maximum(self._highest[places], np.maximum.reduceat(rows, starts))
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return `pauses`, start and end of each in seconds; none in silence."""
        highest = self._highest
        threshold = min(ratio(BELOW_DBFS), float(highest.max(initial=0.0)) * BELOW_PEAK)
        loud = np.flatnonzero(highest >= threshold) if threshold else np.empty(0, np.int64)
        seconds = self._grain / self._rate
        long = np.flatnonzero((np.diff(loud) - 1) * seconds >= SHORTEST_S)
        return {
            "pauses": tuple(
                (float((loud[index] + 1) * seconds), float(loud[index + 1] * seconds)) for index in long.tolist()
            )
        }
