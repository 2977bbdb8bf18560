"""Half-millisecond cells: what detectors of short faults look at, instead of at every sample again."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel

CELLS_PER_S = 2_000
HISTORY = 6  # frames that stand before the first cell, for its steps and differences


class Cells(NamedTuple):
    """Figures of cells one after the other, each of shape (channels, cells).

    Attributes
    ----------
    sums, squares : ndarray
        Of the cell's samples, and of their squares.
    steps : ndarray
        The largest step from one sample to the next.
    sharpness : ndarray
        The largest sixth difference: a single sample gives 20 times its height, a step 10 times, and
        what moves slowly nearly nothing.
    edges : ndarray
        The sum of the sixth differences' squares.
    """

    sums: NDArray[np.float64]
    squares: NDArray[np.float64]
    steps: NDArray[np.float64]
    sharpness: NDArray[np.float64]
    edges: NDArray[np.float64]


def cell_frames(sample_rate_hz: int) -> int:
    """Return how many frames a cell has, at least one: half a millisecond, rounded."""
    return max(1, round(sample_rate_hz / CELLS_PER_S))


def cells_of(samples: NDArray[np.float64], first: int, frames: int) -> Cells:
    """Return the whole cells of `samples` from one frame on.

    Parameters
    ----------
    samples : ndarray, shape (channels, n)
        Full scale is ±1.0.
    first : int
        Where the first cell starts, HISTORY or later.
    frames : int
        Of each cell.
    """
    channels, length = samples.shape
    figures = np.empty((len(Cells._fields) * channels, (length - first) // frames))
    kernel.cells(samples, first, frames, figures)
    return Cells(*figures.reshape(len(Cells._fields), channels, -1))
