"""A sound's spectrum over time, in rows of equal pitch, for drawing."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.window_powers import PitchRows, hann_powers

ROWS = 128
MOST_COLUMNS = 1000
TOP_HZ = 20_000.0
BOTTOM_HZ = 60.0
WINDOW_S = 0.043  # 23 Hz between bins: a semitone at 400 Hz
COLUMNS_A_WINDOW = 4  # finer ones add little: a window blurs what is closer


class Spectrogram:
    """Accumulates the levels of a sound over pitch and time, block by block.

    Rows run from 20 kHz at the top to 60 Hz at the bottom in equal steps of pitch, columns from the
    first frame to the last. Windows are Hann's; of those that fall into one column the loudest counts,
    so that a click in a long sound is seen. Channels are averaged as powers, so that none cancel.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound, which has frames.
    """

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:
        length = 1 << max(4, round(math.log2(sample_rate_hz * WINDOW_S)))
        most = min(MOST_COLUMNS, math.ceil(frames / (length // COLUMNS_A_WINDOW)))
        self._a_column = math.ceil(frames / most / (length // 2))
        self._hop = math.ceil(frames / (most * self._a_column))
        self.columns = math.ceil(frames / (self._hop * self._a_column))
        self._left = self.columns * self._a_column
        self._powers = hann_powers(length)
        self._rows = _rows_of(sample_rate_hz, length)
        self._levels: list[NDArray[np.float64]] = []
        # Half a window of silence goes before the sound, so that each window is centred on its share of it.
        self._held = np.zeros((channels, length // 2))
        self._next = self._hop // 2

    def add(self, block: NDArray[np.float64]) -> None:
        """Take in the next frames, shape (frames, channels)."""
        self._held = np.concatenate((self._held, block.T), axis=1)
        ready = min(self._left, (self._held.shape[1] - self._powers.length - self._next) // self._hop + 1)
        if ready >= self._a_column:
            self._measure(ready // self._a_column * self._a_column)
        self._held = self._held[:, self._next :]
        self._next = 0

    def levels(self) -> NDArray[np.float64]:
        """Return the levels in dBFS of a tone, shape (128, columns), and end the stream.

        -inf for silence and above half the sample rate. A tone between two bins and two rows reads up
        to 3 dB low.
        """
        self.add(np.zeros((self._powers.length + (self._a_column + 1) * self._hop, len(self._held))))
        with np.errstate(divide="ignore"):
            return 10 * np.log10(np.concatenate(self._levels).T)

    def _measure(self, count: int) -> None:
        rows = self._powers.by_pitch(self._held, first=self._next, hop=self._hop, count=count, rows=self._rows)
        rows /= (self._powers.length / 4) ** 2
        self._levels.append(rows.reshape(-1, self._a_column, ROWS).max(axis=1))
        self._next += count * self._hop
        self._left -= count


def _rows_of(sample_rate_hz: int, length: int) -> PitchRows:
    """Return the loudest bin of each row, or a place between two bins, for equal steps of pitch."""
    edges_hz = TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** (np.arange(ROWS + 1) / ROWS)
    edges = edges_hz * length / sample_rate_hz
    bins = max(2, min(length // 2 + 1, math.floor(edges[0]) + 2))
    middles = np.sqrt(edges[:-1] * edges[1:])
    is_lit = middles <= bins - 1
    below = np.minimum(middles.astype(np.int64), bins - 2)
    first = np.minimum(np.ceil(edges[1:]).astype(np.int64), bins - 1)
    end = np.minimum(np.floor(edges[:-1]).astype(np.int64) + 1, bins)
    is_wide = is_lit & (end - first >= 2)
    spans = np.where(is_wide[:, np.newaxis], np.stack([first, end], axis=1), 0)
    return PitchRows(np.where(is_lit, below, -1), np.clip(middles - below, 0, 1), spans)
