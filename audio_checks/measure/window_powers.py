"""The power of every bin of windows that follow each other at even distances."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from audio_checks import kernel

PRIMES = (2, 3, 5, 7, 11)  # of which the kernel's transforms are made


class PitchRows(NamedTuple):
    """The bins of a spectrum that make each of some rows.

    Attributes
    ----------
    below : ndarray of int64, shape (rows,)
        The bin at or below the middle of a row; -1 for one that is silent.
    shares : ndarray, shape (rows,)
        How far the middle lies on the way to the next bin, 0..1.
    spans : ndarray of int64, shape (rows, 2)
        The first bin that a row spans and the one after its last; 0 and 0 for one that lies between two bins.
    """

    below: NDArray[np.int64]
    shares: NDArray[np.float64]
    spans: NDArray[np.int64]


def is_transformed(length: int) -> bool:
    """Whether the kernel transforms so many frames, one or more."""
    for prime in PRIMES:
        while length % prime == 0:
            length //= prime
    return length == 1


def twiddle_factors(length: int) -> NDArray[np.float64]:
    """Return the turns of a transform, shape (length, 2)."""
    turns: NDArray[np.float64] = np.exp(-2j * np.pi * np.arange(length) / length).view(np.float64)
    return turns.reshape(length, 2)


class WindowPowers:
    """One shape of window, and what its transform takes.

    Parameters
    ----------
    window : ndarray, shape (length,)
        What each frame of a window is multiplied by.
    """

    def __init__(self, window: NDArray[np.float64]) -> None:
        self.length = length = len(window)
        self._window = np.ascontiguousarray(window)
        self._turns = twiddle_factors(length) if is_transformed(length) else None

    def of(
        self, signal: NDArray[np.float64], *, first: int, hop: int, count: int, bins: int | None = None
    ) -> NDArray[np.float64]:
        """Return the squared magnitudes of the lowest bins of each window.

        Parameters
        ----------
        signal : ndarray, shape (channels, frames)
            Each channel contiguous.
        first, hop, count : int
            Where the first window starts, frames between two starts, and how many windows there are;
            the last one ends inside the signal.
        bins : int, optional
            Of each window; all up to half the sample rate if left out.

        Returns
        -------
        ndarray, shape (count, channels, bins)
            A sine of amplitude a in the middle of a bin gives (a · sum(window) / 2)²; silence gives 0.
        """
        bins = self.length // 2 + 1 if bins is None else bins
        if self._turns is None:
            windows = sliding_window_view(signal, self.length, axis=1)[:, first::hop][:, :count]
            spectra = np.fft.rfft(windows * self._window, axis=2)[:, :, :bins]
            return (np.square(spectra.real) + np.square(spectra.imag)).swapaxes(0, 1)
        powers = np.empty((count * len(signal), bins))
        kernel.powers(signal, self._window, first, hop, self._turns, powers, False)
        return powers.reshape(count, len(signal), bins)

    def by_bin(self, signal: NDArray[np.float64], *, first: int, hop: int, powers: NDArray[np.float64]) -> None:
        """Find the same as `of`, with what happens to each bin in a row.

        Parameters
        ----------
        signal : ndarray, shape (channels, frames)
            Each channel contiguous.
        first, hop : int
            Where the first window starts, and frames between two starts; the last one ends inside the signal.
        powers : ndarray, shape (channels * bins, count)
            What is filled, the bins of one channel after each other, each row contiguous; silence gives 0.
        """
        if self._turns is None:
            bins, count = len(powers) // len(signal), powers.shape[1]
            powers[:] = self.of(signal, first=first, hop=hop, count=count, bins=bins).reshape(count, -1).T
        else:
            kernel.powers(signal, self._window, first, hop, self._turns, powers, True)

    def by_pitch(
        self, signal: NDArray[np.float64], *, first: int, hop: int, count: int, rows: PitchRows
    ) -> NDArray[np.float64]:
        """Return the power of rows of pitch, the mean of all channels.

        Parameters
        ----------
        signal : ndarray, shape (channels, frames)
            Each channel contiguous.
        first, hop, count : int
            Where the first window starts, frames between two starts, and how many windows there are;
            the last one ends inside the signal. Their length must be one that the kernel transforms.
        rows : PitchRows
            What each row is made of.

        Returns
        -------
        ndarray, shape (count, rows)
            Of the loudest bin of a row that spans some; silence gives 0.
        """
        if self._turns is None:
            raise ValueError(f"the kernel does not transform {self.length} frames")
        powers = np.empty((count, len(rows.below)))
        kernel.pitch_rows(signal, self._window, first, hop, self._turns, *rows, powers)
        return powers

    def add_to(self, sums: NDArray[np.float64], signal: NDArray[np.float64], *, hop: int, count: int) -> None:
        """Add the squared magnitudes of each bin over all channels and windows.

        Parameters
        ----------
        sums : ndarray, shape (length // 2 + 1,)
            What is added to; silence adds 0.
        signal : ndarray, shape (channels, frames)
            Each channel contiguous.
        hop, count : int
            Frames between two starts, the first at the signal's first frame, and how many windows there are.
        """
        if self._turns is None:
            sums += self.of(signal, first=0, hop=hop, count=count).sum(axis=(0, 1))
        else:
            kernel.power_sums(signal, self._window, 0, hop, count, self._turns, sums)


@lru_cache(maxsize=16)
def hann_powers(length: int) -> WindowPowers:
    """Return a Hann window of so many frames, the first of them 0."""
    return WindowPowers(np.hanning(length + 1)[:-1])
