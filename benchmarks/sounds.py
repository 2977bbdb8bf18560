"""The sounds that are measured: made from numbers, so that every run has the same."""

from collections.abc import Callable
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


def materials(rate: int, bits: int) -> dict[str, Callable[[], Samples]]:
    """Return what makes a minute of stereo each: material that costs a check more or less than `minute` does."""
    return {
        "sparse events over a noise of three bits": lambda: _sparse(rate, bits),
        "dense music": lambda: _music(rate),
        "white noise": lambda: _white(rate),
        "speech": lambda: _speech(rate),
        "silence with clicks": lambda: _clicks(rate),
    }


def _sparse(rate: int, bits: int) -> Samples:
    rng = np.random.default_rng(10)
    bed = rng.integers(-4, 4, (60 * rate, 2)) * 2.0 ** (1 - bits)
    for place in range(0, 56 * rate, 4 * rate):
        one = effect(rng, rate, 2)
        bed[place : place + len(one)] += one
    return np.clip(bed, -0.95, 0.95)


def _music(rate: int) -> Samples:
    """Chords of twelve harmonics that change twice a second, over a drum four times a second."""
    rng = np.random.default_rng(11)
    beat = rate // 2
    times = np.arange(beat) / rate
    parts = []
    for _ in range(120):
        roots = 110 * 2 ** (rng.choice(24, 3, replace=False) / 12)
        chord = sum(
            np.sin(2 * np.pi * root * number * times + rng.uniform(0, 7)) / number
            for root in roots
            for number in range(1, 13)
        )
        drum = rng.standard_normal(beat) * np.exp(-40 * (times % 0.25))
        parts.append(np.outer(chord, rng.uniform(0.7, 1, 2)) + 2 * drum[:, np.newaxis])
    whole = np.concatenate(parts)
    return np.tanh(whole / whole.std() * 0.5) * 0.9


def _white(rate: int) -> Samples:
    """As loud from start to end: the worst there is for finding the true peak."""
    return np.clip(np.random.default_rng(8).standard_normal((60 * rate, 2)) * 0.2, -0.95, 0.95)


def _speech(rate: int) -> Samples:
    """Pulses of a voice through three resonances, in syllables with pauses, over a quiet room."""
    rng = np.random.default_rng(12)
    frames = np.arange(60 * rate)
    pitch_hz = 120 * (1 + 0.15 * np.sin(2 * np.pi * 0.4 * frames / rate))
    turns = np.cumsum(pitch_hz / rate)
    hz = np.fft.rfftfreq(len(frames), 1 / rate)
    bins = np.fft.rfft(np.diff(np.floor(turns), prepend=0.0))
    bins *= sum(1 / (1 + ((hz - middle) / width) ** 2) for middle, width in ((600, 80), (1_300, 100), (2_600, 150)))
    voice = np.fft.irfft(bins, len(frames))
    syllables = np.clip(np.sin(2 * np.pi * 2 * frames / rate), 0, 1) * (frames // (3 * rate) % 3 < 2)
    voice *= syllables * 0.5 / np.abs(voice).max()
    return voice[:, np.newaxis] + rng.standard_normal((len(frames), 2)) * 1e-4


def _clicks(rate: int) -> Samples:
    rng = np.random.default_rng(13)
    silent = np.zeros((60 * rate, 2))
    for place in rng.integers(0, len(silent) - 50, 600):
        silent[place : place + int(rng.integers(1, 40))] = rng.uniform(-0.9, 0.9)
    return silent


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
