"""How a sound rises and dies away: energy by octave band every 5 ms, and what its parts are made of."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

HOP_S = 0.005
LONGEST_S = 8.0  # of the sound, from its first frame that is no silence
OCTAVES_HZ = (125.0, 250.0, 500.0, 1_000.0, 2_000.0, 4_000.0, 8_000.0)
FINE_BANDS = 24  # from the lowest edge of the octaves to the highest, in equal steps of pitch where bins allow
TINY = 1e-20
_AT_ONCE = 256  # windows


@dataclass(frozen=True)
class DecayFigures:
    """What a sound does every 5 ms. Powers are mean squares, full scale ±1.0, the mean over all channels.

    Attributes
    ----------
    hop_s : float
        From one row to the next; 5 ms to the nearest frame.
    energies : ndarray, shape (rows, octaves)
        Power in each octave of OCTAVES_HZ; nan where the sample rate has no such octave.
    fine : ndarray, shape (rows, bands)
        Power in narrower bands.
    flatness_db : ndarray, shape (rows, octaves)
        Geometric over arithmetic mean of the bins: about -2.5 for noise, far lower for tones.
    flutter_db : ndarray, shape (rows, octaves)
        Mean unsigned change of a bin's level over two rows: about 7 for noise, near 0 for a steady tone.
    edges : ndarray, shape (rows, 2)
        Means of the second and the fourth power of the steps between samples: 3 is their kurtosis in noise.
    sides : ndarray, shape (rows, octaves, 4), or None
        Powers of the first and the second channel, and their product's real and imaginary part; None for mono.
    """

    hop_s: float
    energies: NDArray[np.float64]
    fine: NDArray[np.float64]
    flatness_db: NDArray[np.float64]
    flutter_db: NDArray[np.float64]
    edges: NDArray[np.float64]
    sides: NDArray[np.float64] | None


class Decay:
    """Follows the power of a sound by bands, in Hann windows of 10 ms that overlap by half.

    Rows begin with the first frame that is no silence, with half a window of silence before it. Silence
    and no frames give no rows.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound.
    """

    FIGURES = ("decay",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:
        self._hop = max(1, round(HOP_S * sample_rate_hz))
        self._hop_s = self._hop / sample_rate_hz
        self._channels = channels
        size = 2 * self._hop
        self._window = np.hanning(size + 1)[:-1]
        self._window /= np.sqrt(float(np.square(self._window).sum()) * size / 2)
        bins_hz = np.arange(size // 2 + 1) * sample_rate_hz / size
        lowest, highest = OCTAVES_HZ[0] / np.sqrt(2), OCTAVES_HZ[-1] * np.sqrt(2)
        self._octaves = np.searchsorted(bins_hz, [*(hz / np.sqrt(2) for hz in OCTAVES_HZ), highest])
        self._whole = np.array([hz < sample_rate_hz * 0.45 for hz in OCTAVES_HZ])
        pitches = lowest * (highest / lowest) ** (np.arange(FINE_BANDS + 1) / FINE_BANDS)
        fine = np.unique(np.clip(np.searchsorted(bins_hz, pitches), 1, len(bins_hz)))
        self._fine = np.concatenate((fine, np.full(FINE_BANDS + 1 - len(fine), fine[-1])))
        self._held = np.zeros((channels, self._hop))
        self._begun = False
        self._left = min(frames, round(LONGEST_S * sample_rate_hz))
        self._before = np.zeros(channels)
        self._levels: list[NDArray[np.float64]] = []  # of the bins in the last two rows, by channel
        self._rows: list[tuple[NDArray[np.float64], ...]] = []

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not self._begun:
            sounding = np.flatnonzero(block.any(axis=1))
            if not len(sounding):
                return
            block = block[sounding[0] :]
            self._begun = True
        block = block[: self._left]
        self._left -= len(block)
        if len(block):
            self._held = np.concatenate((self._held, block.T), axis=1)
            self._read()

    def result(self) -> dict[str, Any]:
        """Return `decay`, the figures of all rows."""
        if self._begun:
            self._held = np.concatenate((self._held, np.zeros((self._channels, self._hop))), axis=1)
            self._read()
        columns = [np.concatenate(column) for column in zip(*self._rows, strict=True)] if self._rows else self._none()
        energies, fine, flatness, flutter, edges, sides = columns
        energies[:, ~self._whole] = np.nan
        return {
            "decay": DecayFigures(
                self._hop_s, energies, fine, flatness, flutter, edges, sides if self._channels > 1 else None
            )
        }

    def _none(self) -> list[NDArray[np.float64]]:
        octaves = len(OCTAVES_HZ)
        return [
            np.empty((0, *shape)) for shape in ((octaves,), (FINE_BANDS,), (octaves,), (octaves,), (2,), (octaves, 4))
        ]

    def _read(self) -> None:
        """Make rows of all whole windows that are held, and let go what no further one needs."""
        while (count := min(_AT_ONCE, self._held.shape[1] // self._hop - 1)) > 0:
            self._take(self._held[:, : (count + 1) * self._hop], count)
            self._held = self._held[:, count * self._hop :]

    def _take(self, samples: NDArray[np.float64], count: int) -> None:
        size = 2 * self._hop
        windows = np.lib.stride_tricks.sliding_window_view(samples, size, axis=1)[:, :: self._hop]
        spectra = np.fft.rfft(windows * self._window, axis=2)[:, :, : self._octaves[-1]]
        powers = np.square(spectra.real) + np.square(spectra.imag)
        levels = 10 * np.log10(powers + TINY)
        known = np.concatenate((*[one[:, np.newaxis] for one in self._levels], levels), axis=1)
        while known.shape[1] < count + 2:  # before the first row there was nothing to change from
            known = np.concatenate((known[:, :1], known), axis=1)
        flutter = np.abs(known[:, 2:] - known[:, :-2])
        self._levels = [known[:, -2], known[:, -1]]
        mean = powers.mean(axis=0)
        energies = self._by_octave(mean)
        width = np.maximum(1, np.diff(self._octaves))
        arithmetic = 10 * np.log10(self._by_octave(powers) / width + TINY)
        flatness = (self._by_octave(levels) / width - arithmetic).mean(axis=0)
        sums = np.concatenate((np.zeros((count, 1)), np.cumsum(mean, axis=1)), axis=1)
        fine = np.diff(sums[:, np.minimum(self._fine, mean.shape[1])], axis=1)
        self._rows.append(
            (
                energies,
                np.maximum(fine, 0.0),
                flatness,
                (self._by_octave(flutter) / width).mean(axis=0),
                self._edges(samples, count),
                self._sides(spectra, powers) if self._channels > 1 else np.empty((count, len(OCTAVES_HZ), 4)),
            )
        )

    def _by_octave(self, bins: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return sums of bins, the last axis, by octave."""
        starts = np.minimum(self._octaves[:-1], bins.shape[-1] - 1)
        sums: NDArray[np.float64] = np.add.reduceat(bins, starts, axis=-1)
        return sums

    def _edges(self, samples: NDArray[np.float64], count: int) -> NDArray[np.float64]:
        steps = np.diff(samples[:, : count * self._hop], axis=1, prepend=self._before[:, np.newaxis])
        self._before = samples[:, count * self._hop - 1]
        squares = np.square(steps).reshape(self._channels, count, self._hop)
        return np.stack((squares.mean(axis=(0, 2)), np.square(squares).mean(axis=(0, 2))), axis=1)

    def _sides(self, spectra: NDArray[np.complex128], powers: NDArray[np.float64]) -> NDArray[np.float64]:
        left, right = spectra[0], spectra[1]
        together = left.real * right.real + left.imag * right.imag
        turned = left.imag * right.real - left.real * right.imag
        return np.stack([self._by_octave(part) for part in (powers[0], powers[1], together, turned)], axis=2)
