"""The difference of a sound's rise and fall: features of a sound that is played backwards."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decay import OCTAVES_HZ, TINY, DecayFigures

Floats = NDArray[np.float64]
REACH_DB = 45.0  # under the loudest row of a band; anything lower counts as this level
PART_OF_IT_DB = 50.0  # a band this far under the loudest one says nothing
LAGS = (1, 4, 12)  # rows: 5, 20 and 60 ms
FEWEST_ROWS = 8
EVIDENCE_LAG = 4
_WIDE = len(OCTAVES_HZ)
_EACH = 3 * len(LAGS) + 4


def features_of(decay: DecayFigures) -> Floats | None:
    """Return the features that distinguish forwards from backwards.

    Each is the opposite, or nearly, of the same sound turned round; a sound alike from both ends gives zeros.

    Parameters
    ----------
    decay : DecayFigures
        Of one sound.

    Returns
    -------
    ndarray, shape (features,), or None
        nan for what is unknown; None for silence, and for less than 40 ms of sound.
    """
    levels = _levels(decay)
    if levels is None:
        return None
    table = np.full((_WIDE + 1, _EACH), math.nan)
    heard = ~np.isnan(levels[0])
    table[heard] = _leans_of(levels[:, heard])
    octaves = table[:_WIDE]
    measured = octaves[~np.isnan(octaves[:, 0])]
    over = (
        np.concatenate((np.median(measured, axis=0), measured.mean(axis=0)))
        if len(measured)
        else np.full(2 * _EACH, math.nan)
    )
    return np.concatenate((table[_WIDE], over, octaves[:, 1], _between(levels)))


def rises_and_falls(decay: DecayFigures) -> list[dict[str, Any]]:
    """Return the fastest rise and fall of each octave, over 20 ms, in dB a second; what a picture shows.

    Octaves that the sample rate lacks, and those far under the loudest, are left out; silence has none.
    """
    levels = _levels(decay)
    if levels is None:
        return []
    bands = []
    for hz, column in zip(OCTAVES_HZ, levels.T, strict=False):
        if np.isnan(column[0]):
            continue
        steps = _steps(column, EVIDENCE_LAG) / (EVIDENCE_LAG * decay.hop_s)
        bands.append({"hz": hz, "rise_db_s": round(float(steps.max())), "fall_db_s": round(float(-steps.min()))})
    return bands


def _levels(decay: DecayFigures) -> Floats | None:
    """Return the level of each octave, and of all together, over the rows that sound, shape (rows, octaves + 1).

    0 is REACH_DB under the loudest row of a band; columns that say nothing are nan.
    """
    energies = decay.energies
    if not len(energies):
        return None
    power = np.column_stack((energies, np.nansum(energies, axis=1)))
    power = (power + np.vstack((power[:1], power[:-1])) + np.vstack((power[1:], power[-1:]))) / 3
    levels = 10 * np.log10(power + TINY)
    tops = levels.max(axis=0)
    if tops[_WIDE] <= 10 * math.log10(TINY) + 1:
        return None
    sounding = np.flatnonzero(levels[:, _WIDE] > tops[_WIDE] - REACH_DB)
    levels = levels[sounding[0] : sounding[-1] + 1]
    if len(levels) < FEWEST_ROWS:
        return None
    held: Floats = np.maximum(levels - tops + REACH_DB, 0.0)
    held[:, np.isnan(tops) | (tops < tops[_WIDE] - PART_OF_IT_DB)] = math.nan
    return held


def _steps(levels: Floats, lag: int) -> Floats:
    """Return the changes over some rows, with rest before the sound and after it."""
    rest = np.zeros((lag, *levels.shape[1:]))
    held = np.concatenate((rest, levels, rest))
    steps: Floats = held[lag:] - held[:-lag]
    return steps


def _leans_of(levels: Floats) -> Floats:
    """Return the rise of each band against its fall, and its position in time, shape (bands, _EACH)."""
    leans: list[Floats] = []
    for lag in LAGS:
        steps = _steps(levels, lag)
        squares = np.square(steps)
        means = squares.mean(axis=0)
        rising = np.where(steps > 0, squares, 0.0).mean(axis=0)
        leans += [
            steps.max(axis=0) + steps.min(axis=0),
            np.log((rising + 1e-2) / (means - rising + 1e-2)),
            (steps * squares).mean(axis=0) / (means**1.5 + 1e-9),
        ]
    along = np.linspace(-1, 1, len(levels))
    power = 10 ** (levels / 10)
    is_loud = levels > levels.max(axis=0) - 20
    tops = levels.argmax(axis=0)
    before, after = tops - is_loud.argmax(axis=0) + 1, len(levels) - is_loud[::-1].argmax(axis=0) - tops
    return np.stack(
        [
            *leans,
            along @ power / power.sum(axis=0),
            along @ levels / (levels.sum(axis=0) + 1e-9),
            along[tops],
            np.log(after / before),
        ],
        axis=1,
    )


def _between(levels: Floats) -> list[float]:
    """Return the octaves' joint course: starts and ends at once, and the place of the highs in time."""
    measured = [index for index in range(_WIDE) if not np.isnan(levels[0, index])]
    if len(measured) < 2:
        return [math.nan] * 2
    starts, ends = [], []
    for band in measured:
        loud = np.flatnonzero(levels[:, band] > levels[:, band].max() - 15)
        starts.append(float(loud[0]))
        ends.append(float(loud[-1]))
    together = math.log((np.std(ends) + 1) / (np.std(starts) + 1))
    rows = np.linspace(-1, 1, len(levels))
    powers = 10 ** (levels[:, measured] / 10)
    centres = (rows @ powers) / powers.sum(axis=0)
    order = np.arange(len(measured)) - (len(measured) - 1) / 2
    tilt = float(order @ centres / (order @ order))
    return [together, tilt]
