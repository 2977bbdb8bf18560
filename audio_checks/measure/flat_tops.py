"""Runs of samples at full scale: the flat tops that clipping leaves."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

SHORTEST_RUN = 3  # one or two samples at full scale are a normalised crest
MAX_SPANS = 1_000  # kept with their times; the count goes on
CLOSE = 2.0**-15  # how far under 1.0 still is full scale: the largest 16-bit sample


class FlatTops:
    """Finds runs at full scale in blocks, per channel and per sign.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("clipped_runs", "clipped_spans")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, step: float = 0.0) -> None:  # noqa: ARG002 - all accumulators are made alike
        self._rate = sample_rate_hz
        self._rail = 1 - max(step, CLOSE)
        self._seen = 0
        self._sign = [0] * channels
        self._start = [0] * channels
        self._count = 0
        self._spans: list[tuple[float, float, int]] = []

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        highest, lowest = block.max(axis=0), block.min(axis=0)
        for channel in range(block.shape[1]):
            if highest[channel] >= self._rail or lowest[channel] <= -self._rail:
                self._follow(block[:, channel], channel)
            else:
                self._end(channel, self._seen)
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return the figures, by name; spans are (start_s, end_s, channel), channel 1 being the first."""
        for channel in range(len(self._sign)):
            self._end(channel, self._seen)
        return {"clipped_runs": self._count, "clipped_spans": tuple(sorted(self._spans))}

    def _follow(self, samples: NDArray[np.float64], channel: int) -> None:
        signs = (samples >= self._rail).astype(np.int8) - (samples <= -self._rail)
        changes = np.flatnonzero(np.diff(signs, prepend=np.int8(self._sign[channel])))
        starts = np.concatenate(([self._start[channel]], changes + self._seen))
        states = np.concatenate(([self._sign[channel]], signs[changes]))
        runs = (states[:-1] != 0) & (np.diff(starts) >= SHORTEST_RUN)
        self._count += int(runs.sum())
        for run in np.flatnonzero(runs)[: MAX_SPANS - len(self._spans)]:
            self._keep(int(starts[run]), int(starts[run + 1]), channel)
        self._sign[channel], self._start[channel] = int(states[-1]), int(starts[-1])

    def _end(self, channel: int, frame: int) -> None:
        if self._sign[channel] and frame - self._start[channel] >= SHORTEST_RUN:
            self._count += 1
            if len(self._spans) < MAX_SPANS:
                self._keep(self._start[channel], frame, channel)
        self._sign[channel], self._start[channel] = 0, frame

    def _keep(self, start: int, end: int, channel: int) -> None:
        self._spans.append((start / self._rate, end / self._rate, channel + 1))
