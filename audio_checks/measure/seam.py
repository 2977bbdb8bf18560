"""The seam of a loop: what the ear meets between its last frame and its first."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import decibels

NEARBY_S = 0.01
INAUDIBLE = 1e-4  # -80 dBFS: nearby changes count as no smaller,
SHARE = 2e-3  # nor as smaller than this share of the largest sample nearby


class Seam:
    """Compares step and change of slope at a loop's seam with those in the 10 ms around it.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    loop : (int, int), optional
        First and last frame of the loop; otherwise the whole signal.
    """

    FIGURES = ("seam_step_db", "seam_slope_db")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, loop: tuple[int, int] | None = None) -> None:
        start, last = loop or (0, frames - 1)
        width = max(1, min(round(NEARBY_S * sample_rate_hz), last + 1 - start))
        self._spans = ((last + 1 - width, last + 1), (start, start + width))  # before the seam, after it
        self._sides = np.zeros((2, width, channels))
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        for side, (start, end) in zip(self._sides, self._spans, strict=True):
            first, last = max(start, self._seen), min(end, self._seen + len(block))
            if first < last:
                side[first - start : last - start] = block[first - self._seen : last - self._seen]
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return, in dB over the largest nearby, the step and the change of slope; the worst channel counts.

        Above 0 dB the seam moves faster than the sound around it. -inf where it does not move at all.
        """
        width = self._sides.shape[1]
        across = np.ascontiguousarray(self._sides.reshape(2 * width, -1).T)  # channel by channel
        steps = across[:, 1:] - across[:, :-1]
        slopes = steps[:, 1:] - steps[:, :-1]
        least = np.maximum(INAUDIBLE, SHARE * np.abs(across).max(axis=1))
        return {
            "seam_step_db": _excess(steps, width - 1, 1, least),
            "seam_slope_db": _excess(slopes, width - 2, 2, least),
        }


def _excess(changes: NDArray[np.float64], first: int, count: int, least: NDArray[np.float64]) -> float:
    """Return the largest change at the seam over the largest elsewhere, in dB."""
    sizes = np.abs(changes)
    at_seam = sizes[:, max(first, 0) : first + count].copy()
    if not at_seam.size:
        return decibels(0.0)
    sizes[:, max(first, 0) : first + count] = 0.0
    elsewhere = np.maximum(sizes.max(axis=1), least)
    return decibels(float((at_seam.max(axis=1) / elsewhere).max()))
