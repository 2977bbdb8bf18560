"""The level of a click over the sound around it: its power in each critical band against what masks it there.

Source: the bands of Zwicker and Terhardt (1980), "Analytical expressions for critical-band rate and critical
bandwidth", J. Acoust. Soc. Am. 68; the slopes of masking in Zwicker and Fastl, Psychoacoustics, chapter 4, straight.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.window_powers import WindowPowers

Floats = NDArray[np.float64]
WINDOW_CELLS = 40  # 20 ms
AFTER_CELLS = 3 * WINDOW_CELLS // 2 + 1  # of the sound that must be known from a click on
BANDS = 24
LOWEST = 8  # of the bands that count: a click is heard above 1 kHz; below it is a thump
UPWARD_DB, DOWNWARD_DB = 10.0, 27.0  # a band: how fast a masker's effect falls towards higher and lower ones
THRESHOLD = 1e-10  # -100 dBFS in a band: what no one hears


def heard_over_db(samples: Floats, frames: NDArray[np.int64], cell_frames: int, sample_rate_hz: int) -> Floats:
    """Return the level of clicks over the masked threshold around them, each in the band where it is highest.

    Parameters
    ----------
    samples : ndarray, shape (n,)
        One channel; what is missing before and after it counts as silence.
    frames : ndarray of int, shape (clicks,)
        Where the cells of the clicks begin.
    cell_frames : int
        Frames of half a millisecond.
    sample_rate_hz : int
        Frames per second.

    Returns
    -------
    ndarray, shape (clicks,)
        In dB: the 20 ms around the click over the 20 ms before and after, whichever mask more in a band.
    """
    width = WINDOW_CELLS * cell_frames
    pieces = np.zeros((len(frames), 3 * width))
    for piece, start in zip(pieces, (frames + (cell_frames - width) // 2 - width).tolist(), strict=True):
        first, end = max(start, 0), min(start + 3 * width, len(samples))
        piece[first - start : end - start] = samples[first:end]
    powers = _windows_of(width).of(pieces.reshape(1, -1), first=0, hop=width, count=3 * len(frames))
    bands = powers.reshape(len(frames), 3, -1) @ _bands_of(width, sample_rate_hz) * (8 / 3) / width**2 + THRESHOLD
    masked = np.maximum(bands[:, 0] @ _SPREAD, bands[:, 2] @ _SPREAD)
    over_db: Floats = 10 * np.log10((bands[:, 1] / masked)[:, LOWEST:].max(axis=1))
    return over_db


@lru_cache(maxsize=8)
def _windows_of(width: int) -> WindowPowers:
    return WindowPowers(np.hanning(width))


@lru_cache(maxsize=8)
def _bands_of(width: int, sample_rate_hz: int) -> Floats:
    """Return the critical band of each bin of a window's spectrum, shape (bins, bands): 1 there, 0 elsewhere."""
    hz = np.fft.rfftfreq(width, 1 / sample_rate_hz)
    rates = 13 * np.arctan(0.00076 * hz) + 3.5 * np.arctan(np.square(hz / 7500))
    bands: Floats = np.eye(BANDS)[np.minimum(rates, BANDS - 1).astype(int)]
    return bands


def _spread() -> Floats:
    """Return the share of each band's power that masks in each other, shape (from band, to band)."""
    above = np.arange(BANDS) - np.arange(BANDS)[:, np.newaxis]
    spread: Floats = 10 ** (-np.where(above > 0, UPWARD_DB * above, -DOWNWARD_DB * above) / 10)
    return spread


_SPREAD = _spread()
