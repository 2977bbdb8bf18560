"""Half-millisecond cells: what detectors of short faults look at, instead of at every sample again."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure import buffer_pool

CELLS_PER_S = 2_000
LEAST_CELL = 4  # frames of a cell of which the sums and squares can be had alone
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
    """Return the number of frames of a cell, at least one: half a millisecond, rounded."""
    return max(1, round(sample_rate_hz / CELLS_PER_S))


class CellStream:
    """The newest cells of a stream, after as many earlier ones as are looked back at; zeros before the first.

    Parameters
    ----------
    channels : int
    frames : int
        Of each cell.
    kept, kept_sums : int
        How many cells stand before the new ones, and how many of which only the sums are asked for.
    most : int
        New ones at a time.
    """

    def __init__(self, channels: int, frames: int, kept: int, kept_sums: int, most: int) -> None:
        self._frames = frames
        self._kept, self._first = kept, max(kept, kept_sums)  # the latter is where new ones begin
        shape = len(Cells._fields) * channels, self._first + most
        self._room = buffer_pool.acquire("cells", math.prod(shape) * np.dtype(np.float64).itemsize)
        self._figures = self._room.view(np.float64).reshape(shape)
        self._sums = self._figures[:channels]
        self._sums[:, : self._first - kept] = 0.0  # the other figures are not needed so far back
        self._figures[:, self._first - kept : self._first] = 0.0

    def room(self, count: int) -> NDArray[np.float64]:
        """Return the room for the figures of so many new cells, shape (5 * channels, count)."""
        return self._figures[:, self._first : self._first + count]

    def measure(self, samples: NDArray[np.float64], first: int) -> int:
        """Measure the whole cells of `samples` from one frame on, and return how many there are.

        Parameters
        ----------
        samples : ndarray, shape (channels, n)
            Full scale is ±1.0.
        first : int
            Where the first cell starts, HISTORY or later.
        """
        count: int = (samples.shape[1] - first) // self._frames
        kernel.cells(samples, first, self._frames, self.room(count))
        return count

    def end(self) -> None:
        """Leave the room to the next stream; nothing is asked of this one any more."""
        buffer_pool.release("cells", self._room)
        self._figures = self._sums = self._figures[:, :0]

    def newest(self, count: int) -> Cells:
        """Return so many new cells, after those that are kept."""
        figures = self._figures[:, self._first - self._kept : self._first + count]
        return Cells(*figures.reshape(len(Cells._fields), -1, figures.shape[1]))

    def newest_sums(self, count: int) -> NDArray[np.float64]:
        """Return the sums of so many new cells, after all that are kept, shape (channels, n)."""
        return self._sums[:, : self._first + count]

    def keep(self, count: int) -> None:
        """Make the last ones of what came with so many new cells those that stand before the next."""
        whole = self._first - self._kept
        self._sums[:, :whole] = self._sums[:, count : count + whole].copy()
        self._figures[:, whole : self._first] = self._figures[:, count + whole : count + self._first].copy()
