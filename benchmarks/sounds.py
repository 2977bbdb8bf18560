"""The sounds that are measured: made from numbers, so that every run has the same."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from tests.support.waves import wav_bytes

Samples = NDArray[np.float64]
SHORTEST_S, MAX_DURATION_S = 0.2, 3.0


def coloured(rng: np.random.Generator, frames: int, channels: int, corner: float) -> Samples:
    """Noise that falls by 12 dB an octave above `corner`, a share of the sample rate."""
    bins = np.fft.rfft(rng.standard_normal((frames, channels)), axis=0)
    bins /= 1 + (np.fft.rfftfreq(frames)[:, np.newaxis] / corner) ** 2
    return np.fft.irfft(bins, frames, axis=0)


def effect(rng: np.random.Generator, rate: int, channels: int) -> Samples:
    """One effect of 0.2 to 3 s: coloured noise that dies away, its peak between -12 and -2 dBFS."""
    frames = round(rate * SHORTEST_S * (MAX_DURATION_S / SHORTEST_S) ** rng.uniform())
    samples = coloured(rng, frames, channels, 10 ** rng.uniform(-2.5, -0.6))
    samples *= np.exp(-np.arange(frames) / frames * rng.uniform(3, 9))[:, np.newaxis]
    return samples * 10 ** (rng.uniform(-12, -2) / 20) / np.abs(samples).max()


def minute(rate: int) -> Samples:
    """60 s of stereo: effects over an ambience, as a reel of a game's sounds is."""
    rng = np.random.default_rng(7)
    bed = coloured(rng, 60 * rate, 2, 0.02)
    bed *= 10 ** (-45 / 20) / bed.std()
    place = 0
    while place < len(bed) - 4 * rate:
        one = effect(rng, rate, 2)
        bed[place : place + len(one)] += one
        place += int(len(one) * rng.uniform(0.5, 1.2))
    return bed * (10 ** (-1.5 / 20) / np.abs(bed).max())


def noise_minute(rate: int) -> Samples:
    """60 s of white noise in stereo, as loud from start to end: the worst there is for finding the true peak."""
    return np.clip(np.random.default_rng(8).standard_normal((60 * rate, 2)) * 0.2, -0.95, 0.95)


def write(path: Path, samples: Samples, rate: int, bits: int) -> Path:
    """Write a WAV file, and return its path."""
    path.write_bytes(wav_bytes(samples, rate=rate, bits=bits))
    return path


def effects(folder: Path, count: int) -> list[Path]:
    """Write short effects, 48 kHz and 24 bit, mono and stereo in turns; they are 1.0 s long on average."""
    folder.mkdir()
    rng = np.random.default_rng(9)
    return [
        write(folder / f"effect_{number:04}.wav", effect(rng, 48_000, 1 + number % 2), 48_000, 24)
        for number in range(count)
    ]
