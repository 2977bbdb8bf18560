"""The steps that samples stand on: what a sound was quantised to before it was written deeper."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

SEGMENTS, SEGMENT_FRAMES = 8, 1_024  # looked at, evenly over the file: a fade bends the steps only where it is
LEAST_STEP = 16.0  # of the file's own smallest: four bits
MOST_PARTS = 8  # steps between the two nearest values, where values are sparse
LEAST_VALUES = 24  # different ones in a segment; fewer prove nothing
MOST_OFF = 2.0  # from its step may a value lie, in the file's own smallest: rounding and dither
SHARE_OFF = 1 / 24  # of the step, where that is less: the finer the step, the easier chance meets it
ROUNDING = 0.75


class Steps:
    """Finds the step that all samples are whole multiples of, within rounding.

    A 16-bit sound padded to 24 bits stands on steps of 256; raised by 3 dB on its way, of 361.6.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest difference the file can hold, full scale being ±1.0; 0 for float samples, in which
        no steps are looked for.
    """

    FIGURES = ("sample_step",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, step: float) -> None:
        self._step = step
        count = min(SEGMENTS, math.ceil(frames / SEGMENT_FRAMES)) if step else 0
        last = max(frames - SEGMENT_FRAMES, 0)
        self._starts = [index * last // max(count - 1, 1) for index in range(count)]
        self._segments: list[list[NDArray[np.float64]]] = [[] for _ in self._starts]
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        end = self._seen + len(block)
        for start, pieces in zip(self._starts, self._segments, strict=True):
            if start < end and self._seen < start + SEGMENT_FRAMES:
                piece = block[max(start - self._seen, 0) : start + SEGMENT_FRAMES - self._seen]
                pieces.append(piece.copy())
        self._seen = end

    def result(self) -> dict[str, Any]:
        """Return the step as a multiple of the file's own smallest; 1 where there is none, None where it is unknown.

        Silence, a handful of different values and float samples give no step. It is a step when more
        than half of the evaluated samples are multiples of it.
        """
        rows = [row for pieces in self._segments if pieces for row in np.concatenate(pieces).T]
        steps: list[float] = []
        without = 0
        for row in rows:
            step = step_of(row / self._step)
            if step is not None and step > 1:
                steps.append(step)
            elif step is not None:
                without += 1
            if 2 * without >= len(rows):  # whatever the rest says
                break
        if not (steps or without):
            return {"sample_step": None}
        return {"sample_step": sorted(steps)[len(steps) // 2] if len(steps) > without else 1.0}


def step_of(values: NDArray[np.float64]) -> float | None:
    """Return the step that all of some values are whole multiples of, within rounding.

    Parameters
    ----------
    values : ndarray
        Whole numbers, in any order.

    Returns
    -------
    float or None
        16 or more; 1 where there is no such step; None where fewer than 24 of the values differ.
    """
    ordered = np.sort(values)
    gaps = ordered[1:] - ordered[:-1]
    if np.count_nonzero(gaps) < LEAST_VALUES - 1:
        return None
    gaps = gaps[gaps > 2 * MOST_OFF]  # closer ones are one step and its dither
    if len(gaps) < LEAST_VALUES - 1 or (nearest := float(gaps.min())) < LEAST_STEP - MOST_OFF:
        return 1.0
    widest = float(gaps.max())
    for parts in range(1, MOST_PARTS + 1):
        step = _fitted(nearest / parts, gaps, nearest, widest, ordered)
        most_off = max(ROUNDING, min(MOST_OFF, SHARE_OFF * step))
        if step >= LEAST_STEP and float(np.abs(ordered - step * np.rint(ordered / step)).max()) <= most_off:
            return step
    return 1.0


def _fitted(
    step: float, gaps: NDArray[np.float64], nearest: float, widest: float, values: NDArray[np.float64]
) -> float:
    """Return a step fitted to the gaps in which it is known well enough to be counted, then to the values."""
    reach = max(step * step / 8, nearest)
    while True:
        near = gaps[gaps <= reach]
        counts = np.rint(near / step)
        step = float(near @ counts / (counts @ counts))
        if reach >= widest:
            break
        reach *= 4
    counts = np.rint(values / step)
    return float(values @ counts / (counts @ counts))
