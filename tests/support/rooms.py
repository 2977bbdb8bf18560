"""Struck sounds and a plain room to put them in, for judgements."""

import numpy as np
from numpy.typing import NDArray

Samples = NDArray[np.float64]


def hits(*, seconds: float = 2.0, rate: int = 48_000, channels: int = 1, seed: int = 1) -> Samples:
    """Four dull knocks that die within 50 ms, in the middle, then silence to the end."""
    draws = np.random.default_rng(seed)
    times = np.arange(round(0.3 * rate)) / rate
    knock = sum(np.sin(2 * np.pi * hz * times) for hz in (310, 770, 1_830)) * np.exp(-times / 0.012)
    knock += 0.8 * draws.standard_normal(len(times)) * np.exp(-times / 0.004)
    out = np.zeros(round(seconds * rate))
    for at in (0.0, 0.35, 0.6, 0.95):
        start = round(at * rate)
        out[start : start + len(knock)] += knock[: len(out) - start]
    return np.repeat((out / 6)[:, np.newaxis], channels, axis=1)


def knell(*, rate: int = 48_000, channels: int = 1) -> Samples:
    """Three partials, struck at once, the highest dying first."""
    times = np.arange(rate)[:, np.newaxis] / rate
    falls = ((220, 0.25), (910, 0.15), (2_700, 0.08))
    partials = [np.sin(2 * np.pi * hz * times) * np.exp(-times / fall) / 6 for hz, fall in falls]
    return np.repeat(np.sum(partials, axis=0), channels, axis=1)


def in_a_room(dry: Samples, *, rt60_s: float = 1.5, wet_db: float = -6.0, rate: int = 48_000, seed: int = 2) -> Samples:
    """The sound and its reverb: noise of its own in each channel that falls by 60 dB in `rt60_s`."""
    draws = np.random.default_rng(seed)
    times = np.arange(round(rt60_s * rate)) / rate
    response = draws.standard_normal((len(times), dry.shape[1])) * 10 ** (-3 * times / rt60_s)[:, np.newaxis]
    frames = 1 << (len(dry) + len(times)).bit_length()
    wet = np.fft.irfft(np.fft.rfft(dry, frames, axis=0) * np.fft.rfft(response, frames, axis=0), frames, axis=0)
    wet = wet[: len(dry) + len(times)]
    wet *= 10 ** (wet_db / 20) * np.sqrt(np.square(dry).sum() / np.square(wet).sum())
    wet[: len(dry)] += dry
    return wet
