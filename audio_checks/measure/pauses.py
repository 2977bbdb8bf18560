"""Pauses: silence between two parts of a sound, for a threshold that depends on a peak known only at the end."""

from __future__ import annotations

from itertools import pairwise
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
        first, last = self._seen // self._grain, (self._seen + ROW_FRAMES * (len(rows) - 1)) // self._grain
        places = np.arange(first, last + 1)
        starts = np.maximum(-((self._seen - places * self._grain) // ROW_FRAMES), 0)  # the first row of each grain
        self._highest[places] = np.maximum(self._highest[places], np.maximum.reduceat(rows, starts))
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return `pauses`, start and end of each in seconds; none in silence."""
        seconds = self._grain / self._rate
        sounds = self._grains_of_sounds(SHORTEST_S)
        return {"pauses": tuple((end * seconds, start * seconds) for (_, end), (start, _) in pairwise(sounds))}

    @property
    def threshold(self) -> float:
        """The magnitude below which all that was added is silence; 0 for digital silence."""
        return min(ratio(BELOW_DBFS), float(self._highest.max(initial=0.0)) * BELOW_PEAK)

    def sounds(self, shortest_s: float) -> list[tuple[int, int]]:
        """Return first and end frame of each sound between pauses of a length, to 10 ms; none in silence."""
        return [(first * self._grain, end * self._grain) for first, end in self._grains_of_sounds(shortest_s)]

    def _grains_of_sounds(self, shortest_s: float) -> list[tuple[int, int]]:
        threshold = self.threshold
        if not threshold:
            return []
        loud = np.flatnonzero(self._highest >= threshold)
        breaks = np.flatnonzero((np.diff(loud) - 1) * (self._grain / self._rate) >= shortest_s)
        firsts, lasts = loud[np.append(0, breaks + 1)], loud[np.append(breaks, -1)]
        return [(first, last + 1) for first, last in zip(firsts.tolist(), lasts.tolist(), strict=True)]
