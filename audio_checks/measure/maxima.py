"""The highest magnitudes of short rows of samples."""

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel

ROW_FRAMES = 32  # the kernel's


def maxima_of(rows: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the highest magnitude of each 32 frames, shape (channels, rows), of samples (channels, frames)."""
    maxima = np.empty((rows.shape[0], -(-rows.shape[1] // ROW_FRAMES)))
    kernel.maxima(rows, maxima)
    return maxima


def first_reaching(samples: NDArray[np.float64], maxima: NDArray[np.float64], level: float) -> int:
    """Return the first frame of one channel whose magnitude is `level` or more, which one of its `maxima` is."""
    start = int((maxima >= level).argmax()) * ROW_FRAMES
    return start + int((np.abs(samples[start : start + ROW_FRAMES]) >= level).argmax())
