"""The loudness of a sound from row to row, and the rows of its head and of its tail."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decay import OCTAVES_HZ, TINY, DecayFigures

Floats = NDArray[np.float64]
Rows = NDArray[np.bool_]
RANGE_DB = 60.0  # under the loudest row nothing counts
BAND_RANGE_DB = 45.0  # a band that never comes nearer to the whole is not heard
ABOVE_FLOOR_DB = 8.0
LOUD_DB = 12.0  # under the loudest row a row is loud
FEWEST_ROWS = 8
WIDE = len(OCTAVES_HZ)  # the place of the whole range after the octaves


@dataclass(frozen=True)
class Course:
    """The loudness of a sound in each row and band, and the rows of head and of tail.

    Attributes
    ----------
    levels, smooth : ndarray, shape (rows, octaves + 1)
        In dB, as they are and as means over three rows; the last column is the whole range.
    floors : ndarray, shape (octaves + 1,)
        Lower levels count for nothing.
    active : ndarray, shape (rows, octaves + 1)
        The cells that count.
    head, tail : ndarray, shape (rows,)
        The head is near what was loudest of late, the tail well under it.
    last, end : int
        The last row that is loud, and the last that counts.
    """

    levels: Floats
    smooth: Floats
    floors: Floats
    active: Rows
    head: Rows
    tail: Rows
    last: int
    end: int

    @classmethod
    @lru_cache(maxsize=1)  # three look at the same sound
    def of(cls, decay: DecayFigures) -> Course | None:
        """Return the course of a sound; None for silence, and for what is shorter than 40 ms."""
        energies = np.nan_to_num(decay.energies)
        if len(energies) < FEWEST_ROWS or energies.max() <= TINY:
            return None
        powers = np.column_stack((energies, energies.sum(axis=1)))
        around = np.concatenate((powers[:1], powers, powers[-1:]))
        smooth = 10 * np.log10((around[:-2] + powers + around[2:]) / 3 + TINY)
        tops = smooth.max(axis=0)
        floors = np.maximum(tops - RANGE_DB, _noise_under(smooth) + ABOVE_FLOOR_DB)
        active = (smooth > floors) & (tops > tops[WIDE] - BAND_RANGE_DB)
        if not active[:, WIDE].any():  # no louder than TINY
            return None
        wide, top = smooth[:, WIDE], tops[WIDE]
        forgotten = 0.1 * np.arange(len(wide))  # what was loudest counts for 20 dB less a second later
        under = np.maximum.accumulate(wide + forgotten) - forgotten - wide
        last = int(np.flatnonzero(wide >= top - LOUD_DB)[-1])
        return cls(
            levels=10 * np.log10(powers + TINY),
            smooth=smooth,
            floors=floors,
            active=active,
            head=(under < 4) & active[:, WIDE] & (wide > top - 25),
            tail=(under > 10) & active[:, WIDE],
            last=last,
            end=max(last, int(np.flatnonzero(active[:, WIDE])[-1])),
        )

    def last_fall(self, band: int) -> tuple[int, int]:
        """Return the rows from where a band was last loud to where it no longer counts."""
        first = max(0, self.last - 6)
        start = first + int(np.argmax(self.smooth[first : self.last + 7, band]))
        under = np.flatnonzero(self.smooth[start:, band] <= self.floors[band])
        return start, start + (int(under[0]) if len(under) else len(self.smooth) - start)


def _noise_under(smooth: Floats) -> Floats:
    """Return by band the level of a steady noise under the sound, by its quietest rows; -200 where there is none."""
    quiet = np.sort(smooth, axis=0)[: max(1, len(smooth) // 10)]
    steady = (quiet[-1] - quiet[0] < 6) & (quiet[-1] < smooth.max(axis=0) - 25)
    floors: Floats = np.where(steady, quiet.mean(axis=0), -200.0)
    return floors
