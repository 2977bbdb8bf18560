"""Whether a sound is heard among others: its excitation of the ear's bands against theirs, block by block.

Source: the filters of the ear are those of Glasberg and Moore (1990), "Derivation of auditory filter shapes from
notched-noise data", Hearing Research 47: bandwidth 24.7·(4.37·f + 1) Hz with f in kHz, rounded-exponential shape, its
lower slope flatter at higher levels as in Moore, Glasberg and Baer (1997), "A model for the prediction of thresholds,
loudness, and partial loudness", J. Audio Eng. Soc. 45, which also has the ratio at threshold.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.window_powers import hann_powers

BLOCK_S = 0.04  # from block to block; a window is twice as long
LOWEST_ERB, HIGHEST_ERB = 2, 38  # on the scale of ERB numbers: 55 Hz and 13.4 kHz
LEVEL_DB = 70.0  # of each filter's input, in dB SPL: a mix at the level of a living room
THRESHOLD_DB = -3.0  # of a sound just heard against what covers it, from 500 Hz on
PART_OF_SOUND_DB = 40.0  # below its loudest band and block a sound is not missed
BLOCKS_AT_ONCE = 128


def _centres_hz() -> NDArray[np.float64]:
    numbers = np.arange(LOWEST_ERB, HIGHEST_ERB + 1)
    return (10 ** (numbers / 21.4) - 1) * (1_000 / 4.37)


CENTRES_HZ = _centres_hz()
BANDS = len(CENTRES_HZ)


class Excitation:
    """An accumulator of a sound's excitation of each band of the ear, block by block.

    Windows are Hann's, 80 ms long and 40 ms apart, the first centred on the first frame. Channels are averaged as
    powers. What a browser plays in 30 s takes 0.3 s of one processor and 3 MB.

    Parameters
    ----------
    sample_rate_hz, channels : int
        Of the whole sound.
    """

    def __init__(self, sample_rate_hz: int, channels: int) -> None:
        self._hop = max(1, round(sample_rate_hz * BLOCK_S))
        self._powers = hann_powers(2 * self._hop)
        self._weights = _weights(sample_rate_hz, 2 * self._hop)
        self._held = np.zeros((channels, self._hop))
        self._frames = 0
        self._blocks: list[NDArray[np.float64]] = []

    def add(self, block: NDArray[np.float64]) -> None:
        """Take in the next frames, shape (frames, channels)."""
        self._frames += len(block)
        self._take(block.T)

    def power(self) -> NDArray[np.float64]:
        """Return the excitation of each block and band, shape (blocks, bands), and end the stream.

        1 is what a full-scale square wave would have in one band; a full-scale sine has 0.5 in the band of its
        frequency. Silence has 0 everywhere, and no frames have no blocks.
        """
        blocks = math.ceil(self._frames / self._hop)
        self._take(np.zeros((len(self._held), 2 * self._hop)))
        power = np.concatenate(self._blocks) if self._blocks else np.zeros((0, BANDS))
        return power[:blocks]

    def _take(self, frames: NDArray[np.float64]) -> None:
        held = np.ascontiguousarray(np.concatenate((self._held, frames), axis=1))
        count = max(0, held.shape[1] // self._hop - 1)
        for first in range(0, count, BLOCKS_AT_ONCE):
            now = min(BLOCKS_AT_ONCE, count - first)
            powers = self._powers.of(held, first=first * self._hop, hop=self._hop, count=now)
            self._blocks.append(powers.mean(axis=1) @ self._weights)
        self._held = held[:, count * self._hop :]


@dataclass(frozen=True)
class Masking:
    """The audible share of a sound among others.

    Attributes
    ----------
    is_part : ndarray of bool, shape (bands,)
        Whether the sound has anything in a band: within 40 dB of its loudest band and block.
    sound_db, cover_db : ndarray, shape (bands,)
        Mean excitation where the sound has something, and the level from which it would be heard there; dB of a
        full-scale square wave, −inf for nothing.
    margin_db : ndarray, shape (bands,)
        How far the sound stands above that level; +inf where nothing covers, −inf where the sound has nothing.
    covers : ndarray of int, shape (bands,)
        Which of the other sounds is strongest in a band; −1 where none is.
    energy_share, time_share : float
        Of the sound's energy, and of the blocks in which it has any, what is heard, 0..1; 0 for silence.
    """

    is_part: NDArray[np.bool_]
    sound_db: NDArray[np.float64]
    cover_db: NDArray[np.float64]
    margin_db: NDArray[np.float64]
    covers: NDArray[np.int64]
    energy_share: float
    time_share: float

    @property
    def is_heard(self) -> NDArray[np.bool_]:
        """Whether the sound is heard in a band, shape (bands,)."""
        return self.is_part & (self.margin_db >= 0)


def masking(sound: NDArray[np.float64], others: Sequence[NDArray[np.float64]]) -> Masking:
    """Return the audible share of a sound among others that sound at the same time.

    The figure is of simultaneous masking alone. It leaves out that a loud sound covers what follows it for up to
    0.2 s, that a sound from another direction is heard better, and the threshold of hearing in quiet. All levels
    moved alike give the same figure.

    Parameters
    ----------
    sound : ndarray, shape (blocks, bands)
        From `Excitation.power`, at the level at which it is played.
    others : sequence of ndarray, each of the same shape
        What sounds with it; an empty sequence covers nothing.

    Returns
    -------
    Masking
        For silence and no blocks nothing is part of the sound, and nothing is heard.
    """
    cover = np.sum(others, axis=0) if len(others) else np.zeros_like(sound)
    loudest = sound.max(initial=0.0)
    part = (sound >= loudest * 10 ** (-PART_OF_SOUND_DB / 10)) & (sound > 0)
    threshold = cover * 10 ** (THRESHOLD_DB / 10)
    heard = part & (sound >= threshold)
    energy = float(sound[part].sum())
    blocks = int(part.any(axis=1).sum())
    is_part = part.any(axis=0)
    sound_db, cover_db = _mean_db(sound, part), _mean_db(threshold, part)
    with np.errstate(invalid="ignore"):
        margin_db = np.where(is_part, sound_db - cover_db, -math.inf)
    return Masking(
        is_part=is_part,
        sound_db=sound_db,
        cover_db=cover_db,
        margin_db=margin_db,
        covers=_strongest(others, part),
        energy_share=float(sound[heard].sum()) / energy if energy else 0.0,
        time_share=int(heard.any(axis=1).sum()) / blocks if blocks else 0.0,
    )


def _strongest(others: Sequence[NDArray[np.float64]], part: NDArray[np.bool_]) -> NDArray[np.int64]:
    if not len(others):
        return np.full(part.shape[1], -1, dtype=np.int64)
    energies = np.stack([np.sum(other, axis=0, where=part) for other in others])
    return np.where(energies.max(axis=0) > 0, energies.argmax(axis=0), -1)


def _mean_db(power: NDArray[np.float64], part: NDArray[np.bool_]) -> NDArray[np.float64]:
    cells = np.maximum(1, part.sum(axis=0))
    with np.errstate(divide="ignore"):
        mean_db: NDArray[np.float64] = 10 * np.log10(np.sum(power, axis=0, where=part) / cells)
    return mean_db


@lru_cache(maxsize=8)  # 8 ms each
def _weights(sample_rate_hz: int, length: int) -> NDArray[np.float64]:
    """Return the weight of each bin of a window in each band, shape (bins, bands): the filters of the ear."""
    bins_hz = np.arange(length // 2 + 1)[:, np.newaxis] * (sample_rate_hz / length)
    bandwidths_hz = 24.7 * (4.37 * CENTRES_HZ / 1_000 + 1)
    slopes = 4 * CENTRES_HZ / bandwidths_hz
    at_1_khz = 4_000 / (24.7 * 5.37)
    lower = slopes * (1 - 0.35 * (LEVEL_DB - 51) / at_1_khz)
    away = np.abs(bins_hz - CENTRES_HZ) / CENTRES_HZ
    steps = away * np.where(bins_hz < CENTRES_HZ, lower, slopes)
    weights = (1 + steps) * np.exp(-steps)
    # A mean square of 1 in a window gives its bins this much together: Parseval's theorem for Hann's window.
    weights *= 2 / (length * np.square(np.hanning(length + 1)[:-1]).sum())
    weights[0] = 0  # an offset is not heard
    return weights
