"""Silence at head and tail, for a threshold that depends on a peak known only at the end."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import ratio

BELOW_PEAK = 1e-3  # 60 dB
BELOW_DBFS = -60.0
CEILING = 0.016  # thresholds reach no higher: 60 dB under a peak of +24 dBFS
GRAIN = 1e-4  # levels closer than this count as one (0.001 dB): bounds memory, exact for PCM to 24 bits
STRIDE = 4_096


class Edges:
    """Remembers, for every threshold, where a signal first and last reaches it.

    The first frame to reach a threshold is among those that are louder than all before them; the
    last among those louder than all after. Only these are kept.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    """

    FIGURES = ("head_silence_ms", "tail_silence_ms", "edges")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:  # noqa: ARG002 - all accumulators are made alike
        self._rate = sample_rate_hz
        self._seen = 0
        self._peak = 0.0
        self._head_levels = np.empty(0)  # rising
        self._head_frames = np.empty(0, np.int64)
        self._tail_levels = np.empty(0)  # falling
        self._tail_frames = np.empty(0, np.int64)

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        self._peak = max(self._peak, float(block.max()), -float(block.min()))
        for start in range(0, len(block), STRIDE):
            if len(self._head_levels) and self._head_levels[-1] >= CEILING:
                break
            self._extend_head(_magnitudes(block[start : start + STRIDE]), self._seen + start)
        self._renew_tail(block)
        self._seen += len(block)

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
        threshold = min(ratio(below_dbfs), self._peak * BELOW_PEAK, CEILING)
        first = self._head_frames[np.searchsorted(self._head_levels, threshold)]
        last = self._tail_frames[np.searchsorted(-self._tail_levels, -threshold, side="right") - 1]
        return 1000 * float(first) / self._rate, 1000 * float(self._seen - 1 - last) / self._rate

    def _extend_head(self, magnitudes: NDArray[np.float64], offset: int) -> None:
        loudest = float(self._head_levels[-1]) if len(self._head_levels) else 0.0
        levels, frames = _records(magnitudes, loudest)
        self._head_levels = np.concatenate((self._head_levels, levels))
        self._head_frames = np.concatenate((self._head_frames, frames + offset))

    def _renew_tail(self, block: NDArray[np.float64]) -> None:
        end = len(block)
        pieces: list[NDArray[np.float64]] = []
        while end > 0:
            pieces.append(_magnitudes(block[max(0, end - STRIDE) : end])[::-1])
            end -= STRIDE
            if pieces[-1].max() >= CEILING:
                break
        levels, frames = _records(np.concatenate(pieces), 0.0)
        if not len(levels):
            return
        kept = self._tail_levels > levels[-1]
        frames = self._seen + len(block) - 1 - frames
        self._tail_levels = np.concatenate((self._tail_levels[kept], levels[::-1]))
        self._tail_frames = np.concatenate((self._tail_frames[kept], frames[::-1]))


def _magnitudes(block: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the loudest channel of each frame, held at the ceiling."""
    loudest: NDArray[np.float64] = np.abs(block).max(axis=1)
    return np.minimum(loudest, CEILING, out=loudest)


def _records(magnitudes: NDArray[np.float64], loudest: float) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
    """Return what is louder than `loudest` and than all before it, rising, with its places."""
    before = np.maximum.accumulate(np.concatenate(([loudest], magnitudes)))[:-1]
    places = np.flatnonzero(magnitudes > before)
    levels = magnitudes[places]
    if len(levels) > 1:
        grains = np.floor(np.log(levels) / GRAIN)
        distinct = np.concatenate(([True], np.diff(grains) > 0))
        distinct[-1] = True
        levels, places = levels[distinct], places[distinct]
    return levels, places
