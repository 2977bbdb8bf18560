"""The lift that the top octave needs to weigh as much as the highs that a lower rate loses."""

import math
from collections.abc import Iterable
from itertools import chain

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel import fourier
from audio_checks.render.twiddles import cos_sin_pi, gain_of, twiddle_factors

WINDOW_FRAMES = 4_096
MOST_GAIN = gain_of(6.0)
LEAST_GAIN = gain_of(0.05)  # inaudible parts are left,
LEAST_SHARE = 1e-6  # as are highs 60 dB under the whole sound: a tone's first frame makes more


def compensating_gain(blocks: Iterable[NDArray[np.float64]], channels: int, sample_rate_hz: int, to_hz: int) -> float:
    """Return the gain that gives the octave below the new Nyquist frequency the energy of all above its start.

    Parameters
    ----------
    blocks : iterable of ndarray, shape (n, channels)
        The master, in order.
    channels : int
        Of every block.
    sample_rate_hz, to_hz : int
        Of the master, and of the render.

    Returns
    -------
    float
        1 (for silence, and where next to nothing is lost) to 2, which is 6 dB. The same to the last bit on
        every machine, for it decides bytes: own transforms, and sums that are rounded once.
    """
    power = np.zeros(WINDOW_FRAMES)
    hop = WINDOW_FRAMES // 2
    window = cos_sin_pi((np.arange(WINDOW_FRAMES) + 0.5) / WINDOW_FRAMES)[1]
    turns = twiddle_factors(WINDOW_FRAMES)
    held = np.zeros((channels, hop))
    for block in chain(blocks, [np.zeros((WINDOW_FRAMES, channels))]):
        held = np.concatenate((held, block.T), axis=1)
        start = 0
        while start + WINDOW_FRAMES <= held.shape[1]:
            real = held[:, start : start + WINDOW_FRAMES] * window
            imaginary = np.zeros_like(real)
            fourier(real, imaginary, turns)
            for row in real * real + imaginary * imaginary:
                power += row
            start += hop
        held = held[:, start:]
    nyquist_bin = WINDOW_FRAMES * to_hz // (2 * sample_rate_hz)
    top = math.fsum(power[nyquist_bin // 2 : nyquist_bin])
    lost = math.fsum(power[nyquist_bin : WINDOW_FRAMES // 2 + 1])
    if lost <= LEAST_SHARE * math.fsum(power[: WINDOW_FRAMES // 2 + 1]):
        return 1.0
    gain = math.sqrt((top + lost) / top) if top else MOST_GAIN
    return 1.0 if gain < LEAST_GAIN else min(gain, MOST_GAIN)
