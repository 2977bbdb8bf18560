"""What is found of each block of samples once, for all that look at it."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.maxima import ROW_FRAMES, maxima_of


class Survey:
    """Knows the maxima, the peaks and the sums of the block at hand.

    Accumulators of one stream share it. A block is known by being the same object, so it must not change meanwhile.
    """

    def __init__(self) -> None:
        self._block: NDArray[np.float64] | None = None
        self._maxima = np.empty((0, 0))
        self._sums: NDArray[np.float64] | None = None
        self._peaks: NDArray[np.float64] | None = None

    def maxima(self, block: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the highest magnitude of each 32 frames, shape (channels, rows); the last row may have fewer.

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. No frames have no rows; digital silence has zeros.
        """
        if block is not self._block:
            self._block, self._sums, self._peaks = block, None, None
            self._maxima = maxima_of(kernel.by_channel(block))
        return self._maxima

    def peaks(self, block: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the highest magnitude of each channel, shape (channels,).

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. Zeros for no frames and for digital silence.
        """
        maxima = self.maxima(block)
        if self._peaks is None:
            self._peaks = maxima.max(axis=1, initial=0.0)
        return self._peaks

    def sums(self, block: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the sum and the sum of squares of each channel, shape (channels, 2).

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. Zeros for no frames and for digital silence.
        """
        if block is not self._block or self._sums is None:
            sums = np.zeros((block.shape[1], 2))
            kernel.sums(kernel.by_channel(block), sums)
            return sums
        return self._sums

    def decode(
        self,
        raw: bytes | memoryview,
        container_bits: int,
        floats: bool,
        samples: NDArray[np.float64],
        first: int,
        cells: NDArray[np.float64] | None,
        cell_frames: int,
    ) -> tuple[NDArray[np.float64], int, int]:
        """Decode whole frames to `samples`, and measure them meanwhile.

        Parameters
        ----------
        raw : bytes or memoryview
            Interleaved PCM or IEEE float, little-endian.
        container_bits : int
            Of each sample.
        floats : bool
            Whether they are IEEE float.
        samples : ndarray, shape (channels, n)
            Where they go, full scale ±1.0.
        first : int
            The frame that the first one becomes; six stand before it at least.
        cells : ndarray, shape (5 * channels, count), optional
            Where the figures of so many cells from `first` on go; see `measure.cells`.
        cell_frames : int
            Of each cell.

        Returns
        -------
        ndarray, shape (frames, channels)
            The block, part of `samples`, which this object now knows.
        int
            All PCM samples or-ed together, as `wav.decode` has it.
        int
            The first channel, from 1 on, with a float that is not finite; 0 where all are.
        """
        channels = len(samples)
        frames = len(raw) // (channels * container_bits // 8)
        self._maxima = np.empty((channels, -(-frames // ROW_FRAMES)))
        self._sums, self._peaks = np.zeros((channels, 2)), None
        used, broken = kernel.survey(
            raw, container_bits, floats, samples, first, self._maxima, self._sums, cells, cell_frames
        )
        self._block = samples[:, first : first + frames].T
        return self._block, used, broken
