"""How differently a sound rises and falls: features of a sound that is played backwards."""

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
    for band in range(_WIDE + 1):
        if not np.isnan(levels[0, band]):
            table[band] = _lean_of(levels[:, band])
    octaves = table[:_WIDE]
    known = octaves[~np.isnan(octaves[:, 0])]
    over = (
        np.concatenate((np.median(known, axis=0), known.mean(axis=0))) if len(known) else np.full(2 * _EACH, math.nan)
    )
    return np.concatenate((table[_WIDE], over, octaves[:, 1], _between(levels)))


def rises_and_falls(decay: DecayFigures) -> list[dict[str, Any]]:
    """Return by octave how fast it rises at its fastest, and falls, over 20 ms, in dB a second; what a picture shows.

    Octaves that the sample rate lacks, and those far under the loudest, are left out; silence has none.
    """
    levels = _levels(decay)
    if levels is None:
        return []
    found = []
    for hz, column in zip(OCTAVES_HZ, levels.T, strict=False):
        if np.isnan(column[0]):
            continue
        steps = _steps(column, EVIDENCE_LAG) / (EVIDENCE_LAG * decay.hop_s)
        found.append({"hz": hz, "rise_db_s": round(float(steps.max())), "fall_db_s": round(float(-steps.min()))})
    return found


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


def _steps(level: Floats, lag: int) -> Floats:
    """Return the changes over some rows, with rest before the sound and after it."""
    held = np.concatenate((np.zeros(lag), level, np.zeros(lag)))
    steps: Floats = held[lag:] - held[:-lag]
    return steps


def _lean_of(level: Floats) -> list[float]:
    """Return how one band rises against how it falls, and its position in time."""
    found: list[float] = []
    for lag in LAGS:
        steps = _steps(level, lag)
        rise, fall = np.maximum(steps, 0), np.maximum(-steps, 0)
        squares = np.square(steps)
        found += [
            float(rise.max() - fall.max()),
            math.log((float(np.square(rise).mean()) + 1e-2) / (float(np.square(fall).mean()) + 1e-2)),
            float((steps * squares).mean() / (squares.mean() ** 1.5 + 1e-9)),
        ]
    along = np.linspace(-1, 1, len(level))
    power = 10 ** (level / 10)
    loud = np.flatnonzero(level > level.max() - 20)
    top = int(level.argmax())
    before, after = top - int(loud[0]) + 1, int(loud[-1]) - top + 1
    return [
        *found,
        float(along @ power / power.sum()),
        float(along @ level / (level.sum() + 1e-9)),
        float(along[top]),
        math.log(after / before),
    ]


def _between(levels: Floats) -> list[float]:
    """Return what the octaves do together: who starts and ends at once, and where the highs lie in time."""
    known = [place for place in range(_WIDE) if not np.isnan(levels[0, place])]
    if len(known) < 2:
        return [math.nan] * 2
    starts, ends = [], []
    for place in known:
        loud = np.flatnonzero(levels[:, place] > levels[:, place].max() - 15)
        starts.append(float(loud[0]))
        ends.append(float(loud[-1]))
    together = math.log((np.std(ends) + 1) / (np.std(starts) + 1))
    rows = np.linspace(-1, 1, len(levels))
    powers = 10 ** (levels[:, known] / 10)
    centres = (rows @ powers) / powers.sum(axis=0)
    order = np.arange(len(known)) - (len(known) - 1) / 2
    tilt = float(order @ centres / (order @ order))
    return [together, tilt]
