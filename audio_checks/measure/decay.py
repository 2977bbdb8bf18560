"""The rise and decay of a sound: energy by octave band every 5 ms, and the make-up of its parts."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel import decay_rows
from audio_checks.measure.window_powers import is_transformed, twiddle_factors

HOP_S = 0.005
LONGEST_S = 8.0  # of the sound, from its first frame that is no silence
OCTAVES_HZ = (125.0, 250.0, 500.0, 1_000.0, 2_000.0, 4_000.0, 8_000.0)
FINE_BANDS = 24  # from the lowest edge of the octaves to the highest, in equal steps of pitch where bins allow
TINY = 1e-20
COLUMNS = np.cumsum((7, FINE_BANDS, 7, 7, 2, 4 * 7))  # where each figure of the kernel's rows ends


@dataclass(frozen=True, eq=False)
class DecayFigures:
    """The course of a sound every 5 ms. Powers are mean squares, full scale ±1.0, the mean over all channels.

    Attributes
    ----------
    hop_s : float
        From one row to the next; 5 ms to the nearest frame, or a little more at rates that no sound has.
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
        while not is_transformed(2 * self._hop):  # no common rate is changed
            self._hop += 1
        self._hop_s = self._hop / sample_rate_hz
        self._channels = channels
        size = 2 * self._hop
        self._window = np.hanning(size + 1)[:-1]
        self._window /= np.sqrt(float(np.square(self._window).sum()) * size / 2)
        self._turns = twiddle_factors(size)
        bins_hz = np.arange(size // 2 + 1) * sample_rate_hz / size
        lowest, highest = OCTAVES_HZ[0] / np.sqrt(2), OCTAVES_HZ[-1] * np.sqrt(2)
        octaves = np.searchsorted(bins_hz, [*(hz / np.sqrt(2) for hz in OCTAVES_HZ), highest])
        bins = int(octaves[-1])
        starts = np.minimum(octaves[:-1], bins - 1)
        ends = np.maximum(np.append(starts[1:], bins), starts + 1)
        self._octaves = np.stack((starts, ends, np.maximum(1, np.diff(octaves))), axis=1)
        self._whole = np.array([hz < sample_rate_hz * 0.45 for hz in OCTAVES_HZ])
        pitches = lowest * (highest / lowest) ** (np.arange(FINE_BANDS + 1) / FINE_BANDS)
        fine = np.unique(np.clip(np.searchsorted(bins_hz, pitches), 1, len(bins_hz)))
        self._fine = np.minimum(np.concatenate((fine, np.full(FINE_BANDS + 1 - len(fine), fine[-1]))), bins)
        self._levels = np.empty((channels, bins, 2))  # of the bins in the last two rows
        self._held = np.zeros((channels, 1 + self._hop))  # from the frame before the next window on
        self._begun = False
        self._left = min(frames, round(LONGEST_S * sample_rate_hz))
        self._rows: list[NDArray[np.float64]] = []

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
            self._read(block.T)

    def result(self) -> dict[str, Any]:
        """Return `decay`, the figures of all rows."""
        if self._begun:
            self._read(np.zeros((self._channels, self._hop)))
        rows = np.concatenate(self._rows) if self._rows else np.empty((0, COLUMNS[-1]))
        energies, fine, flatness, flutter, edges, sides = np.split(rows, COLUMNS[:-1], axis=1)
        energies[:, ~self._whole] = np.nan
        by_octave = sides.reshape(len(rows), len(OCTAVES_HZ), 4) if self._channels > 1 else None
        return {"decay": DecayFigures(self._hop_s, energies, fine, flatness, flutter, edges, by_octave)}

    def _read(self, samples: NDArray[np.float64]) -> None:
        """Make rows of all whole windows, and let go what no further one needs."""
        self._held = np.concatenate((self._held, samples), axis=1)
        count = max(0, (self._held.shape[1] - 1) // self._hop - 1)
        rows = np.empty((count, COLUMNS[-1]))
        decay_rows(
            self._held,
            self._window,
            self._hop,
            self._turns,
            self._octaves,
            self._fine,
            self._levels,
            not self._rows,
            rows,
        )
        if count:
            self._rows.append(rows)
        self._held = self._held[:, count * self._hop :]
