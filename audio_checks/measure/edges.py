"""Silence at head and tail, for a threshold that depends on a peak known only at the end."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure import buffer_pool
from audio_checks.measure.decibels import ratio
from audio_checks.measure.survey import Survey

BELOW_PEAK = 1e-3  # 60 dB
BELOW_DBFS = -60.0
CEILING = 0.016  # thresholds reach no higher: 60 dB under a peak of +24 dBFS
GRAIN = 1e-4  # levels closer than this count as one (0.001 dB): bounds memory, exact for PCM to 24 bits


class Edges:
    """Remembers, for every threshold, where a signal first and last reaches it.

    The first frame to reach a threshold is among those that are louder than all before them; the
    last among those louder than all after. Only these are kept.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = ("head_silence_ms", "tail_silence_ms", "edges")

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        survey: Survey | None = None,
    ) -> None:
        self._survey = survey or Survey()
        self._rate = sample_rate_hz
        self._seen = 0
        self._peak = 0.0
        self._head_levels = np.empty(0)  # rising
        self._head_frames = np.empty(0, np.int64)
        self._tail_levels = np.empty(0)  # falling
        self._tail_frames = np.empty(0, np.int64)
        self._cached: dict[float, tuple[float, float]] = {}  # by threshold: two checks ask for the same

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        rows = kernel.by_channel(block)
        loudest = float(self._head_levels[-1]) if len(self._head_levels) else 0.0
        self._peak = max(self._peak, self._survey.highest(block))
        room = buffer_pool.acquire("records", 2 * len(block) * 8)  # bytes of a float64, and of an int64
        if loudest < CEILING:
            levels, places = self._records(rows, loudest, room, backward=False)
            self._head_levels = np.concatenate((self._head_levels, levels))
            self._head_frames = np.concatenate((self._head_frames, places))
        levels, places = self._records(rows, 0.0, room, backward=True)
        if len(levels):
            kept = self._tail_levels > levels[-1]
            self._tail_levels = np.concatenate((self._tail_levels[kept], levels[::-1]))
            self._tail_frames = np.concatenate((self._tail_frames[kept], places[::-1]))
        buffer_pool.release("records", room)
        self._seen += len(block)
        self._cached = {}

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        head, tail = self.edges(BELOW_DBFS)
        return {"head_silence_ms": head, "tail_silence_ms": tail, "edges": self.edges}

    def edges(self, below_dbfs: float) -> tuple[float, float]:
        """Return the silence at head and tail, in ms.

        Silent is what stays below `below_dbfs` or 60 dB under the peak, whichever is lower, in
        every channel. In digital silence both are the whole length.
        """
        if self._peak == 0:
            whole = 1000 * self._seen / self._rate
            return whole, whole
        if below_dbfs not in self._cached:
            threshold = min(ratio(below_dbfs), self._peak * BELOW_PEAK, CEILING)
            first = int(self._head_frames[self._head_levels.searchsorted(threshold)])
            last = int(self._tail_frames[(-self._tail_levels).searchsorted(-threshold, side="right") - 1])
            self._cached[below_dbfs] = 1000 * first / self._rate, 1000 * (self._seen - 1 - last) / self._rate
        return self._cached[below_dbfs]

    def _records(
        self, rows: NDArray[np.float64], loudest: float, room: NDArray[np.uint8], *, backward: bool
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Return the values louder than `loudest` and than all on their way, rising, with their frames."""
        half = len(room) // 2
        levels, places = room[:half].view(np.float64), room[half:].view(np.int64)
        count = kernel.records(rows, loudest, CEILING, 1 + GRAIN, backward, levels, places)
        return levels[:count].copy(), places[:count] + self._seen
