"""Repeated buffers: a stretch of samples that comes again, bit by bit, at once or some buffers later."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel

SHORTEST_S, LONGEST_S = 0.0013, 0.047  # buffers of 64 frames at 48 kHz to 2048 at 44.1 kHz
MOST_TIMES = 4.5  # repeated more often it is a period, or a stutter that is meant
RING = 4  # buffers at most, the oldest of which plays again where the next one is late
HISTORY_S = (MOST_TIMES + 1.5) * LONGEST_S  # of samples that came before: what the longest repeat needs
SPREAD = 16.0  # steps of the bit depth between the samples of a word: quieter ones come again by chance
LEAST_SPREAD = 1e-4
MAX_AT_ONCE, MAX_KEPT = 256, 1_000


class Repeat(NamedTuple):
    """One repeat: from when to when a stretch plays again, and how long after the first time."""

    start_s: float
    end_s: float
    lag_s: float


class Repeats:
    """Finds repeated buffers.

    Parameters
    ----------
    sample_rate_hz : int
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("repeats", "repeat_places")

    def __init__(self, sample_rate_hz: int, step: float) -> None:
        self._rate = sample_rate_hz
        self._spread = max(SPREAD * step, LEAST_SPREAD)
        self._lags = (round(SHORTEST_S * sample_rate_hz), round(LONGEST_S * sample_rate_hz))
        self._out = np.empty((MAX_AT_ONCE, 3), np.int64)
        self._found: list[Repeat] = []

    def add(self, samples: NDArray[np.float64], channel: int, first: int, frame: int) -> None:
        """Take the samples from `first` on, shape (channels, n); those before came already.

        A stretch is looked for in one `channel`, best the loudest: a buffer holds all, so it comes again in each.
        `frame` is the position in the whole signal of the first of all samples.
        """
        count = kernel.recurrences(samples[channel], first, self._spread, *self._lags, MOST_TIMES, RING, self._out)
        for start, end, lag in self._out[:count].tolist():
            if self._begins(samples, start - lag, frame):  # a tone that has just begun is not a buffer
                continue
            again = np.array_equal(samples[:, start:end], samples[:, start - lag : end - lag])
            if again and len(self._found) < MAX_KEPT:
                self._found.append(Repeat((frame + start) / self._rate, (frame + end) / self._rate, lag / self._rate))

    def _begins(self, samples: NDArray[np.float64], at: int, frame: int) -> bool:
        """Return whether the sound begins at a place, with the file or out of silence."""
        before = samples[:, max(at - self._lags[0], 0) : at]
        return frame + at < self._lags[0] or float(np.abs(before).max(initial=0.0)) < self._spread

    def result(self) -> dict[str, Any]:
        """Return `repeats`, how many there are, and `repeat_places`."""
        return {"repeats": len(self._found), "repeat_places": tuple(sorted(self._found))}
