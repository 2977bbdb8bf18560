"""Detects whether one sound contains another, at which level, and which part of it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.audit.fingerprint import PIECE, RATE_HZ, Wave, next_fast_len, wave_of

Spectrum = NDArray[np.complexfloating[Any, Any]]
Lines = NDArray[np.floating[Any]]

HELD = 0.9  # of a build's sound must lie where the approved one has some
LEAST_SHARE = 1e-5  # of the approved sound's power is in the part that the build has
LEAST_OF_LENGTH = (
    0.42  # of the approved sound, from its first to its last sound: any short tone fits somewhere in a long one
)
SOUND_SHARE = 1e-6  # of the loudest 5 ms: what is fainter before and after is silence
AS_GOOD = 0.995  # as the best place: then the sound was not moved, as of a tone that fits anywhere
EDGES_HZ = (60.0, 250.0, 500.0, 1_000.0, 2_000.0, 3_800.0)
CELL = RATE_HZ // 100  # 10 ms
CELL_FLOOR = 1e-3  # of the loudest cell's power: fainter cells do not show the shape
FAINT_BAND = 1e-4  # of the power: a band with less is not used
FAINT_FOR_GAIN = 0.02  # of the power: with less, the noise of four bits hides a band's gain
SAME, SAME_IF_SHORT = 0.85, 0.9
SHORT_S = 0.05  # fewer periods agree by chance
UNSTEADY_DB = 3.0  # another envelope on the same tone


@dataclass(frozen=True)
class Likeness:
    """The match of one sound within another.

    Attributes
    ----------
    score : float
        0..1: how the two waves agree over the bands, each weighted by the fourth root of its share in both.
    offset_s : float
        Where in the approved sound the build's begins; negative if something comes before it.
    gain_db : float
        By how much the build's is louder, over the part that both have.
    tilt_db : float
        By how much the gain differs between octaves: 0 for a mere gain.
    shape_db : float
        How unsteady the gain is along the time.
    overlap_s : float
        How long the part is that both have.
    """

    score: float
    offset_s: float
    gain_db: float
    tilt_db: float
    shape_db: float
    overlap_s: float

    @property
    def is_same_sound(self) -> bool:
        """Whether the two are one recording, whatever was done to it since."""
        threshold = SAME if self.overlap_s >= SHORT_S else SAME_IF_SHORT
        return self.score >= threshold and self.shape_db <= UNSTEADY_DB


class Waves:
    """The wave of a sound, and what comparing it with many others needs again and again."""

    def __init__(self, packed: bytes) -> None:
        self.wave: Wave = wave_of(packed)
        squares = self.wave.astype(np.float64) ** 2
        self.power_until = np.concatenate(([0.0], np.cumsum(squares)))
        pieces = np.add.reduceat(squares, np.arange(0, len(squares), PIECE))
        sounding = np.flatnonzero(pieces > SOUND_SHARE * pieces.max())
        self.span = int(sounding[-1] - sounding[0] + 1) * PIECE if len(sounding) else 0
        self._spectra: dict[int, Spectrum] = {}

    @property
    def power(self) -> float:
        """Of all of it."""
        return float(self.power_until[-1])

    def spectrum(self, length: int) -> Spectrum:
        """Return its transform at a length."""
        if length not in self._spectra:
            self._spectra = {length: np.fft.rfft(self.wave, length)}
        return self._spectra[length]


def likeness(approved: Waves, built: Waves) -> Likeness | None:
    """Return the match of a build's sound within an approved one; None if there cannot be one.

    Parameters
    ----------
    approved, built : Waves
        Of the two fingerprints.

    Returns
    -------
    Likeness or None

    Notes
    -----
    Normalised cross-correlation, for every place at which the approved sound reaches nine tenths of the build's
    power; at the best one, moved by a fraction of a sample, coherence band by band.
    """
    if built.power == 0.0 or len(built.wave) < LEAST_OF_LENGTH * approved.span:
        return None
    alignment = _best_place(approved, built)
    if alignment is None:
        return None
    at, fraction = alignment
    first, last = max(0, at), min(len(approved.wave), at + len(built.wave))
    mine, theirs = approved.wave[first:last], built.wave[first - at : last - at]
    length = next_fast_len(len(mine) + 16)
    mine_spectrum, other = np.fft.rfft(mine, length), np.fft.rfft(theirs, length)
    cross = mine_spectrum * np.conj(other)
    hz = np.arange(len(cross)) * (RATE_HZ / length)
    cross = cross * np.exp(2j * math.pi * fraction / RATE_HZ * hz)
    score, tilt_db = _by_bands(cross, _powers(mine_spectrum), _powers(other), hz)
    power, built_power = (float(np.vdot(part, part)) for part in (mine, theirs))
    return Likeness(
        score,
        offset_s=(at + fraction) / RATE_HZ,
        gain_db=10 * math.log10(built_power / power),
        tilt_db=tilt_db,
        shape_db=_shape_db(mine, theirs),
        overlap_s=len(mine) / RATE_HZ,
    )


def _powers(spectrum: Spectrum) -> NDArray[np.float64]:
    return spectrum.real.astype(np.float64) ** 2 + spectrum.imag.astype(np.float64) ** 2


def _best_place(approved: Waves, built: Waves) -> tuple[int, float] | None:
    """Return the start of the build's sound in the approved one: in whole samples, and a fraction of one."""
    mine, theirs = len(approved.wave), len(built.wave)
    length = next_fast_len(mine + theirs)
    halves = np.abs(np.fft.irfft(approved.spectrum(length) * np.conj(built.spectrum(length)), 2 * length)) * 2
    together = np.maximum(np.maximum(halves[0::2], halves[1::2]), np.roll(halves[1::2], 1))
    places = np.arange(-theirs + 1, mine)
    first, last = np.maximum(places, 0), np.minimum(places + theirs, mine)
    in_approved = approved.power_until[last] - approved.power_until[first]
    in_built = built.power_until[last - places] - built.power_until[first - places]
    held = (in_built >= HELD * built.power) & (in_approved > LEAST_SHARE * approved.power)
    held &= last - first >= LEAST_OF_LENGTH * approved.span
    if not held.any():
        return None
    agreeing = np.where(held, together[places], 0) / np.sqrt(np.where(held, in_approved * in_built, 1))
    best = int(np.argmax(agreeing))
    here = theirs - 1  # not moved at all
    at = 0 if agreeing[here] >= AS_GOOD * agreeing[best] else int(places[best])
    return at, _fraction(halves, at)


def _fraction(halves: Lines, index: int) -> float:
    """Return the offset of the best place from a whole sample, as a fraction: the crest of a parabola."""
    around = halves[np.arange(2 * index - 2, 2 * index + 3) % len(halves)].astype(np.float64)
    middle = 1 + int(np.argmax(around[1:4]))
    before, here, after = around[middle - 1 : middle + 2]
    bend = before - 2 * here + after
    return (middle - 2) / 2 + (0.25 * float((before - after) / bend) if bend < 0 else 0.0)


def _by_bands(
    cross: Spectrum, mine: NDArray[np.float64], theirs: NDArray[np.float64], hz: Lines
) -> tuple[float, float]:
    """Return the score and the tilt."""
    places = np.searchsorted(hz, EDGES_HZ)
    sums = np.array([(mine[a:b].sum(), theirs[a:b].sum(), abs(cross[a:b].sum())) for a, b in pairwise(places)])
    shares = sums[:, :2] / np.maximum((mine.sum(), theirs.sum()), 1e-30)
    usable = (shares > FAINT_BAND).all(axis=1)
    if not usable.any():
        return 0.0, 0.0
    sums, weights = sums[usable], (shares[usable].prod(axis=1)) ** 0.25
    agreeing = sums[:, 2] / np.sqrt(sums[:, 0] * sums[:, 1])
    score = float(weights @ agreeing / weights.sum())
    loud = (shares[usable] > FAINT_FOR_GAIN).all(axis=1)
    if not loud.any():
        return score, 0.0
    gains_db = 20 * np.log10(np.maximum(sums[loud, 2] / sums[loud, 0], 1e-9))
    weights = weights[loud] / weights[loud].sum()
    return score, math.sqrt(float(weights @ (gains_db - weights @ gains_db) ** 2))


def _shape_db(mine: Wave, theirs: Wave) -> float:
    """Return the unsteadiness of the gain from one 10 ms to the next, weighted towards loud parts."""
    cells = max(1, len(mine) // CELL)
    cell_energies, other = (
        np.add.reduceat(part.astype(np.float64) ** 2, np.arange(cells) * (len(part) // cells))
        for part in (mine, theirs)
    )
    normalised, other = cell_energies / max(cell_energies.max(), 1e-30), other / max(other.max(), 1e-30)
    weights = np.sqrt(normalised * other)
    gains_db = 10 * np.log10((other + CELL_FLOOR) / (normalised + CELL_FLOOR))
    total = weights.sum()
    if not total:
        return 0.0
    mean = float(weights @ gains_db / total)
    return math.sqrt(float(weights @ (gains_db - mean) ** 2 / total))
