"""Lulls: stretches in which a sound gives way to something faint and level, such as hiss, and comes back at once."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

UNDER_NEAREST = 250.0  # in power, 24 dB: how far a lull lies under the louder of the two nearest cells on either side,
UNDER = 316.0  # and 25 dB under the median of 10 ms there
LEVEL = 2.25  # times a lull's mean power: its highest cell, which in white noise reaches twice of it
HALVES = 2.5  # times, 4 dB: what the power of one half of it may be of the other's; what dies away is a pause
ABRUPT = 0.15  # of the median power beside it: what one of the two nearest cells must reach; a fade does not
EDGE = 1.6  # times the mean sixth difference of a lull: that at both edges, where one sound is cut off for another;
TREBLE = 1.5  # or so much must the treble change: where it goes on, only a low wave is between two of its beats
SHORTEST = 3  # cells; of longer ones the outermost may hold some of the sound


def is_hole(squares: NDArray[np.float64], sharpness: NDArray[np.float64], start: int, end: int, reach: int) -> bool:
    """Return whether a lull is a hole in a sound, rather than a pause of it or a trough between two of its beats.

    Parameters
    ----------
    squares, sharpness : ndarray, shape (cells,)
        As `measure.cells` has them, of one channel.
    start, end : int
        The lull's first cell, and the one after its last, as `kernel.lulls` found them.
    reach : int
        Cells on either side that are looked at; there must be as many.
    """
    core = slice(start + 1, end - 1) if end - start > SHORTEST else slice(start, end)
    sides = slice(start - 2, start - reach - 1, -1), slice(end + 1, end + reach)
    sums = np.add.accumulate(squares[core])
    half, whole = float(sums[len(sums) // 2 - 1]), float(sums[-1])
    means = half / (len(sums) // 2), (whole - half) / (len(sums) - len(sums) // 2)
    if max(means) > HALVES * min(means):
        return False
    for side in sides:
        median = _median(squares[side])
        if median < UNDER * whole / len(sums) or squares[side][:2].max() < ABRUPT * median:
            return False
    treble = float(sharpness[start + 1 : end - 1].mean())
    if min(sharpness[start - 2 : start + 1].max(), sharpness[end - 1 : end + 2].max()) >= EDGE * treble:
        return True
    beside = [_median(sharpness[side]) for side in sides]
    return min(beside) > TREBLE * treble or max(beside) * TREBLE < treble


def _median(cells: NDArray[np.float64]) -> float:
    return float(np.sort(cells)[len(cells) // 2])
