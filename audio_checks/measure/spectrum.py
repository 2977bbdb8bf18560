"""The long-term spectrum, and how far up it reaches."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.window_powers import WindowPowers

WINDOW_FRAMES = 4_096
BLACKMAN_HARRIS = (0.35875, -0.48829, 0.14128, -0.01168)  # leaks less than -92 dB, so the 80 dB below are seen
BELOW_PEAK = 1e-8  # 80 dB under the strongest bin a part of the spectrum counts no more
ABOVE_NOISE = 16.0  # 12 dB over the mean of the dither: its largest bin of a single window stays below


@dataclass(frozen=True)
class MeanSpectrum:
    """The mean power spectrum of a whole sound, all channels together.

    Attributes
    ----------
    sample_rate_hz : int
        Of the sound.
    levels_db : ndarray, shape (bins,)
        From 0 Hz to Nyquist, full scale being ±1.0: white noise of RMS r has 20·log10(r) in each; -inf for silence.
    dither_db : float
        What the dither of the file's bit depth would have at most; -inf for float.
    """

    sample_rate_hz: int
    levels_db: NDArray[np.float64]
    dither_db: float


class Spectrum:
    """Averages power spectra of Blackman-Harris windows that overlap by half, all channels together.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("bandwidth_hz", "mean_spectrum")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, step: float = 0.0) -> None:
        self._rate = sample_rate_hz
        self._step = step
        self._channels = channels
        self._length = max(2, min(WINDOW_FRAMES, frames))
        self._hop = max(1, self._length // 2)
        self._powers, self._window_energy = _blackman_harris(self._length)
        self._power = np.zeros(self._length // 2 + 1)
        self._windows = 0
        self._kept = np.empty((channels, 0))  # from the start of the last window read
        self._next = 0  # where in `_kept` the next window starts

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        kept = np.concatenate((self._kept, block.T), axis=1)
        count = max(0, (kept.shape[1] - self._next - self._length) // self._hop + 1)
        if count:
            self._read(kept[:, self._next :], count)
        self._next += count * self._hop
        done = max(0, self._next - self._hop)
        self._kept, self._next = kept[:, done:], self._next - done

    def result(self) -> dict[str, Any]:
        """Return `bandwidth_hz`, the highest frequency that stands out; 0 for silence; and `mean_spectrum`.

        It stands out of the dither that the bit depth has at most, and of the level 80 dB under the
        strongest frequency.
        """
        covered = self._next - self._hop + self._length
        if self._kept.shape[1] > covered >= self._length:
            self._read(self._kept[:, -self._length :], 1)
        dither = self._step**2 / 4 * self._window_energy * self._windows * self._channels
        floor = max(float(self._power.max()) * BELOW_PEAK, dither * ABOVE_NOISE)
        above = np.flatnonzero(self._power > floor)
        return {
            "bandwidth_hz": float(above[-1] * self._rate / self._length) if len(above) else 0.0,
            "mean_spectrum": self._mean(),
        }

    def _mean(self) -> MeanSpectrum:
        whole = self._window_energy * max(1, self._windows) * self._channels
        with np.errstate(divide="ignore"):  # silence has no level
            levels = 10 * np.log10(self._power / whole)
            dither = 10 * np.log10(np.float64(self._step**2 / 4))
        return MeanSpectrum(self._rate, levels, float(dither))

    def _read(self, kept: NDArray[np.float64], count: int) -> None:
        """Add the power of `count` windows from the start of `kept`."""
        self._powers.add_to(self._power, kept, hop=self._hop, count=count)
        self._windows += count


@lru_cache(maxsize=8)
def _blackman_harris(length: int) -> tuple[WindowPowers, float]:
    """Return a window of so many frames, and the sum of its squares."""
    turns = 2 * np.pi * (np.arange(length) + 0.5) / length
    window = sum((share * np.cos(term * turns) for term, share in enumerate(BLACKMAN_HARRIS)), np.zeros(length))
    return WindowPowers(window), float(np.square(window).sum())
