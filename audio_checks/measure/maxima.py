"""The highest magnitudes of short rows of samples: found once for all that look at a block."""

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel

ROW_FRAMES = 32  # the kernel's


class Maxima:
    """Finds the maxima of the block at hand, once.

    Accumulators of one stream share it. A block is known by being the same object, so it must not change meanwhile.
    """

    def __init__(self) -> None:
        self._block: NDArray[np.float64] | None = None
        self._maxima = np.empty((0, 0))

    def of(self, block: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the highest magnitude of each 32 frames, shape (channels, rows); the last row may have fewer.

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. No frames have no rows; digital silence has zeros.
        """
        if block is not self._block:
            self._block = block
            self._maxima = maxima_of(kernel.by_channel(block))
        return self._maxima


def maxima_of(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the highest magnitude of each 32 frames, shape (channels, rows), of samples (channels, frames)."""
    maxima = np.empty((rows.shape[0], -(-rows.shape[1] // ROW_FRAMES)))
    kernel.maxima(rows, maxima)
    return maxima


def first_reaching(samples: NDArray[np.float64], maxima: NDArray[np.float64], level: float) -> int:
    """Return the first frame of one channel whose magnitude is `level` or more, which one of its `maxima` is."""
    start = int((maxima >= level).argmax()) * ROW_FRAMES
    return start + int((np.abs(samples[start : start + ROW_FRAMES]) >= level).argmax())
