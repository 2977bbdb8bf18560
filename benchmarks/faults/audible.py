"""How far a fault stands out of the sound around it, by a plain model of masking, so that levels can be stated."""

import numpy as np
from numpy.typing import NDArray

from benchmarks.faults.sounds import Samples

WINDOW_S = 0.02
LOWEST = 8  # of the Bark bands that count: a click is heard above 1 kHz; below it is a thump
UPWARD_DB, DOWNWARD_DB = 10.0, 27.0  # a Bark: how fast a masker's effect falls towards higher and lower bands


def excess_db(faulty: Samples, clean: Samples, at: int, rate: int) -> float:
    """By how much the fault at frame `at` exceeds the sound itself, in its most audible Bark band above 1 kHz."""
    return heard_over_db(faulty, masked_there(clean, at, rate), at, rate)


def masked_there(clean: Samples, at: int, rate: int) -> NDArray[np.float64]:
    """What the sound has in each band: the spread excitation of the 20 ms there, before and after, the largest."""
    width = round(WINDOW_S * rate)
    masked: NDArray[np.float64] = np.max(
        [_spread(_bands(clean, at + shift, width, rate)) for shift in (-width, 0, width)], axis=0
    )
    return masked


def heard_over_db(faulty: Samples, masked: NDArray[np.float64], at: int, rate: int) -> float:
    """By how much the 20 ms at frame `at` exceed what is masked, in the band above 1 kHz where they do most."""
    heard = _bands(faulty, at, round(WINDOW_S * rate), rate)
    return float(10 * np.log10((heard / masked)[LOWEST:].max()))


def _bands(sound: Samples, at: int, width: int, rate: int) -> NDArray[np.float64]:
    """Power in the Bark bands of the loudest channel; the ear's own floor, -100 dBFS, in each."""
    piece = np.zeros((width, sound.shape[1]))
    first = at - width // 2
    taken = sound[max(first, 0) : first + width]
    piece[max(-first, 0) : max(-first, 0) + len(taken)] = taken
    power = np.square(np.abs(np.fft.rfft(piece * np.hanning(width)[:, np.newaxis], axis=0))) * (8 / 3) / width**2
    hz = np.fft.rfftfreq(width, 1 / rate)
    bark = np.minimum(13 * np.arctan(0.00076 * hz) + 3.5 * np.arctan(np.square(hz / 7500)), 23.9).astype(int)
    bands = np.array([np.bincount(bark, weights=channel, minlength=24) for channel in power.T])
    return bands.max(axis=0) + 1e-10


def _spread(bands: NDArray[np.float64]) -> NDArray[np.float64]:
    """What masks in each band, with all the others' share (Zwicker's slopes, made straight)."""
    distance = np.arange(24)[:, np.newaxis] - np.arange(24)
    slopes = 10 ** (-np.where(distance > 0, UPWARD_DB * distance, -DOWNWARD_DB * distance) / 10)
    return slopes @ bands
