"""The fingerprint of a sound: its wave between 60 Hz and 3.8 kHz, at 8 kHz and four bits a sample.

The wave itself distinguishes one recording from another of the same thing, which levels of bands do not: two
footsteps have the same bands, and waves that have nothing to do with each other. What games do to a
sound (gain, other rates down to 11,025 Hz, 8 bit, equalisers, codecs, cuts) leaves it recognisable.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

Wave = NDArray[np.float32]

FINGERPRINT_VERSION = 1
RATE_HZ = 8_000
LARGEST = 1e6  # 120 dB over full scale; squares of what is far larger are endless in 32 bits
FINGERPRINTED_S = 60  # of a longer sound its first minute counts
LOW_HZ, TOP_HZ = 60.0, 3_800.0
NYQUIST_SHARE = 0.9  # of a lower rate's band; the rest above belongs to its filter
PIECE = 40  # samples that share a step: 5 ms
PIECE_BYTES = 1 + PIECE // 2
STEPS = 7.5  # on either side of zero: sixteen levels
LOUDEST_DBFS = 24.0  # float files may pass full scale
SILENT_DB = 160  # under the loudest: a piece as faint is kept as silence
FAINT_SHARE = 1e-6  # of a sound's power: with less of it in the band a sound cannot be recognised
OPPOSED_SHARE = 0.02  # of the channels' power: where their mean keeps less, the first is used for all


def fingerprint(blocks: Iterable[NDArray[np.float64]], sample_rate_hz: int) -> bytes | None:
    """Return the fingerprint of a sound.

    Parameters
    ----------
    blocks : iterable of ndarray, shape (n, channels)
        The sound in its order, full scale ±1.0; read no further than its first minute.
    sample_rate_hz : int
        Frames per second.

    Returns
    -------
    bytes or None
        21 bytes for each 5 ms. None for silence, for no frames at all, and where there is next to nothing
        between 60 Hz and 3.8 kHz, as of a constant or a dog's whistle.

    Notes
    -----
    Channels are mixed to their mean, so a mono fold-down has the same fingerprint; where they cancel out, the
    first channel is taken. The wave is weighted by +3 dB an octave, so that low tones don't drown all else.
    """
    mono, power = _mono(blocks, FINGERPRINTED_S * sample_rate_hz)
    if not power:
        return None
    wave, share = _banded(mono, sample_rate_hz)
    return None if share < FAINT_SHARE else _packed(wave)


def wave_of(packed: bytes) -> Wave:
    """Return the wave that a fingerprint keeps, at 8 kHz; the inverse of packing but for its four bits.

    Parameters
    ----------
    packed : bytes
        A fingerprint: whole pieces.

    Returns
    -------
    ndarray, shape (frames,)
        40 samples a piece.
    """
    pieces = np.frombuffer(packed, np.uint8).reshape(-1, PIECE_BYTES)
    steps = np.where(pieces[:, :1] < SILENT_DB, _step(pieces[:, :1]), 0.0)
    levels = np.empty((len(pieces), PIECE), np.float32)
    levels[:, 0::2] = pieces[:, 1:] >> 4
    levels[:, 1::2] = pieces[:, 1:] & 15
    return ((levels - STEPS) * steps.astype(np.float32)).ravel()


def pieces_of(frames: int, sample_rate_hz: int) -> int:
    """Return the number of pieces of a sound's fingerprint, by the sound's length."""
    listened = min(frames, FINGERPRINTED_S * sample_rate_hz)
    return -(-_frames_at_8_khz(listened, sample_rate_hz) // PIECE)


def as_text(packed: bytes) -> str:
    """Return a fingerprint as a manifest keeps it: base64."""
    return base64.b64encode(packed).decode("ascii")


def from_text(text: str) -> bytes:
    """Return the fingerprint that a text holds; ValueError when it holds none."""
    packed = base64.b64decode(text, validate=True)
    if not packed or len(packed) % PIECE_BYTES:
        raise ValueError("not a whole number of pieces")
    return packed


def next_fast_len(least: int) -> int:
    """Return the smallest product of twos, threes and fives that is no less: a length that transforms fast."""
    best = 1 << max(0, least - 1).bit_length()
    fives = 1
    while fives < best:
        odd = fives
        while odd < best:
            best = min(best, odd << max(0, -(-least // odd) - 1).bit_length())
            odd *= 3
        fives *= 5
    return best


def _mono(blocks: Iterable[NDArray[np.float64]], most: int) -> tuple[Wave, float]:
    """Return the channels' mean, or the first where they cancel out; and their mean power, summed up."""
    means, firsts, power, left = [], [], 0.0, most
    for block in blocks:
        part = block[:left]
        means.append(part.mean(axis=1).clip(-LARGEST, LARGEST).astype(np.float32))
        firsts.append(part[:, 0].clip(-LARGEST, LARGEST).astype(np.float32))
        power += float(np.einsum("ij,ij->", part, part)) / part.shape[1]
        left -= len(part)
        if left <= 0:
            break
    if not means:
        return np.zeros(0, np.float32), 0.0
    mean = np.concatenate(means)
    opposed = float(mean @ mean) < OPPOSED_SHARE * power
    return (np.concatenate(firsts) if opposed else mean), power


def _frames_at_8_khz(frames: int, sample_rate_hz: int) -> int:
    return -(-frames * RATE_HZ // sample_rate_hz)


def _banded(mono: Wave, sample_rate_hz: int) -> tuple[NDArray[np.float64], float]:
    """Return the weighted wave at 8 kHz, and the share of the power in its band."""
    common = math.gcd(sample_rate_hz, RATE_HZ)
    unit = sample_rate_hz // common  # whole units last a whole number of samples at both rates
    units = next_fast_len(-(-(len(mono) + sample_rate_hz // 50) // unit))
    length, short = units * unit, units * (RATE_HZ // common)
    spectrum = np.fft.rfft(mono, length)
    kept = spectrum[: min(short // 2, len(spectrum) - 1) + 1]
    hz = np.arange(len(kept)) * (sample_rate_hz / length)
    top = min(TOP_HZ, NYQUIST_SHARE * sample_rate_hz / 2)
    gate = np.clip((top - hz) / (0.1 * top), 0, 1) * np.clip(2 * hz / LOW_HZ - 1, 0, 1)
    weighted = np.zeros(short // 2 + 1, np.complex128)
    weighted[: len(kept)] = kept * gate * np.sqrt(hz / TOP_HZ) * (short / length)
    power = float(np.vdot(spectrum, spectrum).real)
    share = float(np.sum(np.abs(kept * gate) ** 2)) / power if power else 0.0
    wave = np.fft.irfft(weighted, short)
    return wave[: _frames_at_8_khz(len(mono), sample_rate_hz)], share


def _packed(wave: NDArray[np.float64]) -> bytes:
    whole = np.zeros(-(-len(wave) // PIECE) * PIECE)
    whole[: len(wave)] = wave
    pieces = whole.reshape(-1, PIECE)
    peaks = np.abs(pieces).max(axis=1, keepdims=True)
    under_db = np.floor(LOUDEST_DBFS - 20 * np.log10(np.maximum(peaks, 1e-9)))
    under_db = np.clip(under_db, 0, SILENT_DB).astype(np.uint8)
    levels = np.clip(np.rint(pieces / _step(under_db) + STEPS), 0, 15).astype(np.uint8)
    packed = np.empty((len(pieces), PIECE_BYTES), np.uint8)
    packed[:, :1] = under_db
    packed[:, 1:] = levels[:, 0::2] << 4 | levels[:, 1::2]
    return packed.tobytes()


def _step(under_db: NDArray[np.uint8]) -> NDArray[np.float64]:
    return np.asarray(10 ** ((LOUDEST_DBFS - under_db) / 20) / (STEPS + 0.5))
