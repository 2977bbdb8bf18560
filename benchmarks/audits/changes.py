"""What happens to a sound on its way into a game, done by tools that are not under test."""

from __future__ import annotations

import io
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

import numpy as np
import soundfile
from scipy.signal import lfilter, resample_poly

from tests.support.waves import Samples, write_wav

Rng = np.random.Generator


@dataclass(frozen=True)
class Made:
    """A changed sound: what a file holds, and the gain that was put on it."""

    samples: Samples
    rate: int
    bits: int = 16
    coded: bytes | None = None
    ending: str = ".wav"
    gain_db: float = 0.0

    def write(self, path: Path) -> Path:
        """Write it under a name with the right ending."""
        path = path.with_name(path.name + self.ending)
        if self.coded is not None:
            path.write_bytes(self.coded)
            return path
        return write_wav(path, self.samples, rate=self.rate, bits=self.bits)


def gain(samples: Samples, rate: int, rng: Rng) -> Made:
    """Softer by 1 to 18 dB, or louder by half of the headroom."""
    headroom_db = -20 * np.log10(np.abs(samples).max())
    put_db = float(rng.choice([-rng.uniform(1, 18), headroom_db / 2]))
    return Made(samples * 10 ** (put_db / 20), rate, gain_db=put_db)


def to_rate(wanted: int) -> Callable[[Samples, int, Rng], Made]:
    """To another rate, by scipy's filter."""

    def change(samples: Samples, rate: int, rng: Rng) -> Made:
        share = Fraction(wanted if wanted != rate else 44_100 * 48_000 // rate, rate)
        return Made(resample_poly(samples, share.numerator, share.denominator, axis=0), int(rate * share))

    return change


def eight_bits(samples: Samples, rate: int, rng: Rng) -> Made:
    """To 8 bits without dither."""
    return Made(samples, rate, bits=8)


def equaliser(samples: Samples, rate: int, rng: Rng) -> Made:
    """A peak, a shelf or two shelves against each other (a tilt), up to 6 dB."""
    kind = int(rng.integers(3))
    db = float(rng.choice([-1, 1]) * rng.uniform(3, 6))
    hz = float(rng.uniform(200, 5_000))
    if kind == 0:
        return Made(lfilter(*_peak(hz, db, rate), samples, axis=0) / 2, rate)
    changed = lfilter(*_shelf(hz, db, rate, high=True), samples, axis=0)
    if kind == 2:
        changed = lfilter(*_shelf(hz, -db, rate, high=False), changed, axis=0)
    return Made(changed / 2, rate)


def vorbis(samples: Samples, rate: int, rng: Rng) -> Made:
    """Ogg Vorbis at libsndfile's quality."""
    return _coded(samples, rate, "OGG", "VORBIS", ".ogg")


def mp3(samples: Samples, rate: int, rng: Rng) -> Made:
    """MP3 at libsndfile's quality."""
    return _coded(samples, rate, "MP3", "MPEG_LAYER_III", ".mp3")


def opus(samples: Samples, rate: int, rng: Rng) -> Made:
    """Ogg Opus, which wants 48 kHz."""
    samples = resample_poly(samples, 48_000, rate, axis=0) if rate != 48_000 else samples
    return _coded(samples, 48_000, "OGG", "OPUS", ".opus")


def head(samples: Samples, rate: int, rng: Rng) -> Made:
    """Up to half of it cut off its start."""
    return Made(samples[round(len(samples) * rng.uniform(0.05, 0.5)) :], rate)


def tail(samples: Samples, rate: int, rng: Rng) -> Made:
    """Up to half of it cut off its end."""
    return Made(samples[: len(samples) - round(len(samples) * rng.uniform(0.05, 0.5))], rate)


def both_ends(samples: Samples, rate: int, rng: Rng) -> Made:
    """Up to half of it cut off, at both ends."""
    cut = round(len(samples) * rng.uniform(0.05, 0.5))
    first = round(cut * rng.uniform(0.2, 0.8))
    return Made(samples[first : len(samples) - cut + first], rate)


Change = Callable[[Samples, int, Rng], Made]
CHANGES: dict[str, Change] = {
    "gain": gain,
    "44.1 to 48 kHz or back": to_rate(48_000),
    "to 22.05 kHz": to_rate(22_050),
    "to 11.025 kHz": to_rate(11_025),
    "8 bit": eight_bits,
    "EQ": equaliser,
    "Ogg Vorbis": vorbis,
    "MP3": mp3,
    "Opus": opus,
}
TRIMS: dict[str, Change] = {"head cut": head, "tail cut": tail, "both ends cut": both_ends}
MEASURED_GAIN = ("gain", "44.1 to 48 kHz or back", "to 22.05 kHz", "to 11.025 kHz")


def _coded(samples: Samples, rate: int, kind: str, subtype: str, ending: str) -> Made:
    file = io.BytesIO()
    soundfile.write(file, samples, rate, format=kind, subtype=subtype)
    return Made(samples, rate, coded=file.getvalue(), ending=ending)


def _peak(hz: float, db: float, rate: int) -> tuple[list[float], list[float]]:
    """A peak an octave wide (Bristow-Johnson's cookbook)."""
    height, turn = 10 ** (db / 40), 2 * np.pi * hz / rate
    width = np.sin(turn) / 2 * np.sqrt(2)
    middle = -2 * np.cos(turn)
    return [1 + width * height, middle, 1 - width * height], [1 + width / height, middle, 1 - width / height]


def _shelf(hz: float, db: float, rate: int, *, high: bool) -> tuple[list[float], list[float]]:
    """A shelf (Bristow-Johnson's cookbook)."""
    height, turn = 10 ** (db / 40), 2 * np.pi * hz / rate
    side = 1 if high else -1
    cosine, width = side * np.cos(turn), np.sqrt(height) * np.sin(turn) * np.sqrt(2)
    up, down = height + 1, height - 1
    return (
        [
            height * (up + down * cosine + width),
            -2 * side * height * (down + up * cosine),
            height * (up + down * cosine - width),
        ],
        [up - down * cosine + width, 2 * side * (down - up * cosine), up - down * cosine - width],
    )
