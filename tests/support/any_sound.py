"""Sounds of every shape, each from a seed: what a file may hold, however unlikely."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tests.support.waves import wav_bytes

Samples = NDArray[np.float64]
LISTED_RATES_HZ = (
    8_000,
    11_025,
    12_000,
    16_000,
    22_050,
    24_000,
    32_000,
    44_100,
    48_000,
    88_200,
    96_000,
    176_400,
    192_000,
)
ODD_RATES_HZ = (1_000, 1_001, 3_999, 7_919, 44_056, 47_952, 384_000, 768_000)
FORMATS = ((8, "pcm"), (16, "pcm"), (24, "pcm"), (32, "pcm"), (32, "float"), (64, "float"))
CHANNELS, CHANNEL_ODDS = (1, 2, 3, 4, 5, 6, 7, 8), (0.5, 0.4, 0.02, 0.02, 0.01, 0.02, 0.01, 0.02)
MAX_DURATION_S = 20.0
MAX_SHORT_FRAMES = 30_000
LARGEST_SAMPLES = 1 << 22  # of all channels: 20 s at 96 kHz in stereo


@dataclass(frozen=True)
class AnySound:
    """A WAV file, and what it holds."""

    samples: Samples
    rate_hz: int
    bits: int
    encoding: str

    @property
    def content(self) -> bytes:
        """The whole file."""
        return wav_bytes(self.samples, rate=self.rate_hz, bits=self.bits, encoding=self.encoding)

    @property
    def words(self) -> str:
        """Its form, for a message."""
        frames, channels = self.samples.shape
        return f"{frames} frames, {channels} channels, {self.rate_hz} Hz, {self.bits} bit {self.encoding}"


def any_sound(seed: int, *, longest_s: float = MAX_DURATION_S) -> AnySound:
    """Return the sound of a seed; short ones are common and 20 s are rare, so that many cost little."""
    rng = np.random.default_rng(seed)
    rate = int(rng.choice(ODD_RATES_HZ if rng.random() < 0.05 else LISTED_RATES_HZ))
    channels = int(rng.choice(CHANNELS, p=CHANNEL_ODDS))
    bits, encoding = FORMATS[rng.integers(len(FORMATS))]
    frames = _length(rng, rate, channels, longest_s)
    sound = _Maker(rng, rate, 2.0 ** (1 - min(bits, 32))).sound(frames, channels)
    if encoding == "float":
        sound *= _float_gain(rng)
    return AnySound(sound, rate, bits, encoding)


def _length(rng: np.random.Generator, rate: int, channels: int, longest_s: float) -> int:
    """Return how many frames; most are few, and up to where most figures begin to have enough to go by."""
    draw = rng.random()
    if draw < 0.5:
        frames = int(MAX_SHORT_FRAMES ** rng.random())
    elif draw < 0.97:
        frames = int(rng.integers(1, MAX_SHORT_FRAMES))
    elif draw < 0.997:
        frames = round(rate * 10 ** rng.uniform(-0.3, 0.5))
    else:
        frames = round(rate * 10 ** rng.uniform(0.5, np.log10(MAX_DURATION_S)))
    return max(1, min(frames, round(longest_s * rate), LARGEST_SAMPLES // channels))


def _float_gain(rng: np.random.Generator) -> float:
    """Return 1 mostly; else what only float holds: far beyond full scale, or down to where numbers end."""
    draw = rng.random()
    if draw < 0.7:
        return 1.0
    if draw < 0.85:
        return float(10 ** rng.uniform(0, 6))
    if draw < 0.9:
        return float(10 ** rng.uniform(6, 19))  # 2^64, at 10^19.3, is refused
    return float(10 ** rng.uniform(-44, -6))


class _Maker:
    """Makes the parts of one sound, and joins them."""

    def __init__(self, rng: np.random.Generator, rate: int, step: float) -> None:
        self._rng = rng
        self._rate = rate
        self._step = step

    def sound(self, frames: int, channels: int) -> Samples:
        first = self._channel(frames)
        columns = [first]
        for _ in range(channels - 1):
            draw = self._rng.integers(6)
            other = (first, -first, np.zeros(frames), np.roll(first, 7), first * 0.5, None)[draw]
            columns.append(self._channel(frames) if other is None else other)
        samples = np.stack(columns, axis=1)
        draw = self._rng.random()
        level = 1.0 if draw < 0.3 else 10 ** self._rng.uniform(-1, 0) if draw < 0.8 else 10 ** self._rng.uniform(-7, -1)
        return np.ascontiguousarray(samples * level)

    def _channel(self, frames: int) -> Samples:
        parts, left = [], frames
        for _ in range(int(self._rng.integers(0, 4))):
            length = int(self._rng.integers(0, left + 1))
            parts.append(self._part(length))
            left -= length
        parts.append(self._part(left))
        whole = np.concatenate(parts)
        for change in (self._gap, self._edge, self._offset, self._burst, self._cut, self._reversal):
            if self._rng.random() < 0.2:
                whole = change(whole)
        return whole

    def _part(self, length: int) -> Samples:
        rng = self._rng
        times = np.arange(length) / self._rate
        tone = np.sin(2 * np.pi * rng.uniform(0.001, 0.5) * np.arange(length) + rng.uniform(0, 7))
        match int(rng.integers(14)):
            case 0:
                return np.zeros(length)
            case 1:
                return rng.standard_normal(length) * 0.2
            case 2:
                return rng.integers(0, 2, length) * self._step  # noise of one bit
            case 3:
                return tone
            case 4:
                return np.where(tone >= 0, 1.0, -1.0)  # a square at full scale
            case 5:
                return np.full(length, rng.uniform(-1, 1))  # nothing but an offset
            case 6:
                return rng.standard_normal(length) * 10 ** (-times * rng.uniform(0.1, 300))  # a tail of any slope
            case 7:
                return tone * 10 ** (-times * rng.uniform(0.1, 300))
            case 8:
                block = rng.uniform(-1, 1, max(1, int(rng.integers(1, 4096))))
                return np.resize(block, length)  # equal blocks
            case 9:
                return np.clip(tone * rng.uniform(1, 20), -1, 1)
            case 10:
                return np.full(length, 5e-324 * rng.integers(1, 1000))  # denormal where there is float, else silence
            case 11:
                return np.linspace(-1, 1, length)
            case 12:
                return tone * (np.sin(2 * np.pi * 4 * times) > 0)  # gated four times a second
            case _:
                return rng.standard_normal(length) * 10 ** (-rng.uniform(0, 5))

    def _span(self, whole: Samples) -> slice:
        first, last = np.sort(self._rng.integers(0, len(whole) + 1, 2))
        return slice(int(first), int(last))

    def _gap(self, whole: Samples) -> Samples:
        whole[self._span(whole)] = 0.0
        return whole

    def _edge(self, whole: Samples) -> Samples:
        """Hold one value at the head or at the tail."""
        length = int(self._rng.integers(1, len(whole) + 1))
        if self._rng.random() < 0.5:
            whole[:length] = whole[length - 1]
        else:
            whole[-length:] = whole[-length]
        return whole

    def _offset(self, whole: Samples) -> Samples:
        return whole * 0.5 + self._rng.uniform(-0.5, 0.5)

    def _burst(self, whole: Samples) -> Samples:
        at, length = int(self._rng.integers(len(whole))), int(self._rng.choice([1, 2, 10, 1_000]))
        whole[at : at + length] = self._rng.choice([-1.0, 1.0])
        return whole

    def _cut(self, whole: Samples) -> Samples:
        """Fade in evenly, and end where it is loudest."""
        return whole * np.linspace(0, 1, len(whole))

    def _reversal(self, whole: Samples) -> Samples:
        return np.ascontiguousarray(whole[::-1])
