"""The spread of a whole sound's energy over frequency, in bands of equal pitch, for drawing."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.window_powers import WindowPowers

WINDOW_FRAMES = 8_192
BANDS_AN_OCTAVE = 6
LOWEST_HZ = 20.0


@dataclass(frozen=True)
class BandLevels:
    """The level of each band.

    Attributes
    ----------
    centres_hz : ndarray, shape (bands,)
        Rising, from 20 Hz to half the sample rate.
    levels_dbfs : ndarray, shape (bands,)
        RMS within the band, over all channels and the whole length; −inf where nothing does.
        A full-scale sine has −3.01 dBFS, in the band of its frequency.
    """

    centres_hz: NDArray[np.float64]
    levels_dbfs: NDArray[np.float64]


class AverageSpectrum:
    """Accumulates the energy of a sound by bands, block by block.

    Windows are the half of a sine and overlap by half, with silence before the first frame and
    after the last: squared they add up to one, so that all bands and the range below them hold
    exactly the energy of the sound (Parseval's theorem). A bin that two bands share is divided.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound.
    bands_of_hz : int, optional
        The sample rate whose bands are taken, so that sounds of several rates can be laid over each
        other; windows then last as long for all of them.
    """

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, bands_of_hz: int | None = None) -> None:
        self._rate = sample_rate_hz
        self._frames = frames
        self._channels = channels
        self._size = size = WINDOW_FRAMES if bands_of_hz is None else _frames_of_window(sample_rate_hz)
        self._hop = size // 2
        self._powers = _half_of_a_sine(size)
        self._held = np.zeros((channels, self._hop))
        self._power = np.zeros(size // 2 + 1)
        self._bands_of_hz = bands_of_hz or sample_rate_hz
        self._edges_hz = _edges(self._bands_of_hz)
        self._ended = False

    def add(self, block: NDArray[np.float64]) -> None:
        """Take in the next frames, shape (frames, channels)."""
        held = np.concatenate((self._held, block.T), axis=1)
        count = max(0, (held.shape[1] - self._size) // self._hop + 1)
        self._powers.add_to(self._power, held, hop=self._hop, count=count)
        self._held = held[:, count * self._hop :]

    def result(self) -> BandLevels:
        """Return the levels, and end the stream; −inf everywhere for silence and for no frames."""
        of_bin, of_band, shares = _pieces(self._size, self._rate, self._bands_of_hz)
        energies = np.bincount(of_band, self._energy()[of_bin] * shares, len(self._edges_hz) - 1)
        bands = energies / max(1, self._frames * self._channels)
        centres = np.sqrt(self._edges_hz[:-1] * self._edges_hz[1:])
        return BandLevels(centres, np.array([power_decibels(band) for band in bands.tolist()]))

    def above_db(self, hz: float) -> float:
        """Return the energy above a frequency against all of it, in dB, and end the stream; −inf for none."""
        energy = self._energy()
        whole = float(energy.sum())
        middles = np.arange(len(energy)) * (self._rate / self._size)
        return power_decibels(float(energy[middles > hz].sum()) / whole) if whole else -math.inf

    def _energy(self) -> NDArray[np.float64]:
        """Return the energy of each bin, once the windows have run out over the end."""
        if not self._ended:
            self.add(np.zeros((self._size, self._channels)))
            self._ended = True
        energy = 2 * self._power / self._size
        energy[[0, -1]] /= 2  # 0 Hz and half the sample rate have no mirror image
        return energy


def _frames_of_window(sample_rate_hz: int) -> int:
    """Return the power of two whose windows last nearest to those of WINDOW_FRAMES at 48 kHz."""
    return max(2, 1 << round(math.log2(WINDOW_FRAMES * sample_rate_hz / 48_000)))


@lru_cache(maxsize=8)  # else 0.7 ms of each spectrum
def _pieces(
    size: int, sample_rate_hz: int, bands_of_hz: int
) -> tuple[NDArray[np.int64], NDArray[np.int64], NDArray[np.float64]]:
    """Return the pieces of bins between the edges of bands: of which bin and band each is, and its share of the bin."""
    edges_hz = _edges(bands_of_hz)
    bins = np.clip((np.arange(size // 2 + 2) - 0.5) * sample_rate_hz / size, 0, sample_rate_hz / 2)
    cuts = np.union1d(bins, edges_hz)
    cuts = cuts[(cuts >= edges_hz[0]) & (cuts <= bins[-1])]  # bands may reach further than this rate
    middles = (cuts[:-1] + cuts[1:]) / 2
    of_bin = np.searchsorted(bins, middles) - 1
    return of_bin, np.searchsorted(edges_hz, middles) - 1, np.diff(cuts) / np.diff(bins)[of_bin]


def _edges(sample_rate_hz: int) -> NDArray[np.float64]:
    """Return the edges of the bands; the last one reaches half the sample rate."""
    nyquist_hz = sample_rate_hz / 2
    count = max(1, math.ceil(BANDS_AN_OCTAVE * math.log2(nyquist_hz / LOWEST_HZ)))
    edges: NDArray[np.float64] = LOWEST_HZ * 2.0 ** (np.arange(count + 1) / BANDS_AN_OCTAVE)
    edges[-1] = nyquist_hz
    return edges


@lru_cache(maxsize=8)
def _half_of_a_sine(size: int) -> WindowPowers:
    return WindowPowers(np.sin(np.pi * (np.arange(size) + 0.5) / size))
