"""The findings on each block of samples, made once, for all that look at it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.maxima import ROW_FRAMES, maxima_of


class StereoHops:
    """The common part of two channels, hop by hop.

    Parameters
    ----------
    frames : int
        Of each hop, 1 or more.
    count : int
        Hops of the whole signal.

    Attributes
    ----------
    energies : ndarray, shape (count, 4)
        Of each hop the energy of the left channel, of the right one, of left times right, and of left less right;
        zeros for digital silence and for what has not come yet.
    frames : int
        Of the signal that came so far.
    """

    def __init__(self, frames: int, count: int) -> None:
        self._hop = frames
        self.energies = np.zeros((count, 4))
        self.frames = 0

    def place(self) -> tuple[NDArray[np.float64], int, int]:
        """Return the hops from that of the next frame, frames of a hop, and how many of that one came."""
        first = self.frames // self._hop
        return self.energies[first:], self._hop, self.frames - first * self._hop

    def add(self, rows: NDArray[np.float64]) -> None:
        """Take the next samples, shape (2, n)."""
        hops, hop, at = self.place()
        kernel.stereo_products(rows, at, hop, hops)
        self.frames += rows.shape[1]


class Room(NamedTuple):
    """The place of a block while it is decoded.

    Attributes
    ----------
    samples : ndarray, shape (channels, n)
        Full scale will be ±1.0.
    first : int
        The frame of them that the first one becomes; six stand before it at least.
    maxima : ndarray, shape (channels, rows)
        For the highest magnitude of each 32 frames.
    cells : ndarray, shape (5 * channels, count) or (2 * channels, count), or None
        For the figures of so many cells from `first` on, see `measure.cells`; or for the sums and squares alone, of
        cells of four frames or more.
    cell_frames : int
        Of each cell.
    """

    samples: NDArray[np.float64]
    first: int
    maxima: NDArray[np.float64]
    cells: NDArray[np.float64] | None
    cell_frames: int


class Survey:
    """Knows the maxima, the peaks and the sums of the block at hand.

    Accumulators of one stream share it. A block is known by being the same object, so it must not change meanwhile.
    """

    def __init__(self) -> None:
        self._block: NDArray[np.float64] | None = None
        self._maxima = np.empty((0, 0))
        self._sums: NDArray[np.float64] | None = None
        self._peaks: NDArray[np.float64] | None = None
        self._highest: float | None = None
        self._stereo: StereoHops | None = None
        self._compared: NDArray[np.float64] | None = None  # the block that is in the hops already

    def maxima(self, block: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the highest magnitude of each 32 frames, shape (channels, rows); the last row may have fewer.

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. No frames have no rows; digital silence has zeros.
        """
        if block is not self._block:
            self._block, self._sums, self._peaks, self._highest = block, None, None, None
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
            self._peaks = np.maximum.reduce(maxima, axis=1, initial=0.0)
        return self._peaks

    def highest(self, block: NDArray[np.float64]) -> float:
        """Return the highest magnitude of all channels.

        Parameters
        ----------
        block : ndarray, shape (frames, channels)
            Full scale is ±1.0. 0 for no frames and for digital silence.
        """
        peaks = self.peaks(block)
        if self._highest is None:
            self._highest = max(peaks.tolist(), default=0.0)
        return self._highest

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

    def follow(self, stereo: StereoHops) -> None:
        """Compare the channels of every block that is decoded from now on, hop by hop; there must be two."""
        self._stereo = stereo

    def has_compared(self, block: NDArray[np.float64]) -> bool:
        """Return whether a block's samples, shape (frames, channels), are in the hops that are followed."""
        return block is self._compared

    def decode(
        self,
        pieces: Iterable[bytes | memoryview],
        frames: int,
        container_bits: int,
        floats: bool,
        room: Room,
    ) -> tuple[NDArray[np.float64], int, int]:
        """Decode whole frames piece by piece, and measure them meanwhile.

        Parameters
        ----------
        pieces : iterable of bytes or memoryview
            Interleaved PCM or IEEE float, little-endian. All but the last hold whole rows of 32 frames, and whole cells
            where these are wanted; each is looked at before the next is asked for.
        frames : int
            Of all pieces.
        container_bits : int
            Of each sample.
        floats : bool
            Whether they are IEEE float.
        room : Room
            Where all of it goes.

        Returns
        -------
        ndarray, shape (frames, channels)
            The block, part of the room's samples, which this object now knows.
        int
            All PCM samples or-ed together, as `wav.decode` has it.
        int
            The first channel, from 1 on, with a float that is not finite, or too large (< 0); 0 where there is none.
        """
        channels = len(room.samples)
        figures = np.zeros((channels, 3))
        self._maxima = room.maxima
        self._sums, self._peaks, self._highest = figures[:, :2], figures[:, 2], None
        used = broken = done = 0
        for raw in pieces:
            frames_known = done + len(raw) // (channels * container_bits // 8)
            rows = room.maxima[:, done // ROW_FRAMES : -(-frames_known // ROW_FRAMES)]
            cells = room.cells
            if cells is not None:
                cells = cells[
                    :, done // room.cell_frames : frames_known // room.cell_frames if frames_known < frames else None
                ]
            hops, hop, at = self._stereo.place() if self._stereo else (None, 1, 0)
            bits, broken = kernel.survey(
                raw,
                container_bits,
                floats,
                room.samples,
                room.first + done,
                rows,
                figures,
                cells,
                room.cell_frames,
                hops,
                hop,
                at,
            )
            used |= bits
            if self._stereo:
                self._stereo.frames += frames_known - done
            done = frames_known
            if broken:
                break
        self._block = room.samples[:, room.first : room.first + frames].T
        if self._stereo:
            self._compared = self._block
        return self._block, used, broken
