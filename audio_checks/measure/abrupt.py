"""Abrupt edges that are not one step: a ramp of a few samples, or one that filters rounded and rang after."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

NEAR_S = 0.01  # of the sound, which its edge is compared with
REST = 0.03  # of the largest sample nearby: what is lower is rest,
START_RESTS_S, END_RESTS_S = 0.0001, 0.001  # from which a sound rises within so long, and to which it falls
REACHES = 0.25  # of the largest sample nearby: an edge reaches it
AT_ONCE_S = 1 / 48_000  # from rest, or
RAMP_S = 0.0001  # as soon as this: a fade of half a millisecond, an everyday one, has reached less
LOUD = 0.25  # of the level nearby, which the sound has from its edge on
PASSED_S = 0.0002  # from its edge a ramp is over; from what comes then it is predicted
PREDICTS = 8  # samples that predict the wave beyond them
PREDICTED = 0.1  # of the largest sample nearby: what errs no more can be predicted,
OTHERWISE, TIMES = 0.15, 4.0  # and is otherwise by so much, or so many times the usual error, in a ramp
DIES, GROWS = 0.8, 1.6  # times level and slope of the first 5 ms come 10 to 40 ms after a start that is not an attack
SMOOTH = 0.03  # of the height of a filter's answer: how far it bends within the time of a ramp, at most
ANSWER = 0.7  # of the largest sample: a low cut answers an edge with no more
GRAIN, STEPS = 4e-6, 4.0  # of full scale, and of the bit depth, as dither steps: what steps less is smooth


def edge(samples: NDArray[np.float64], rate_hz: int, step: float, least: float, *, start: bool) -> tuple[float, int]:
    """Return the height and place of a sound's jump from rest, within so few samples that no ear hears it rise.

    Parameters
    ----------
    samples : ndarray, shape (frames,)
        One channel, from its outermost sample into the sound, so turned round for an end. What is deeper than 0.1 s
        is not asked for.
    rate_hz : int
        Frames per second.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    least : float
        The height, of full scale, under which no edge matters.
    start : bool
        Whether it starts here. Then it is no edge where the sound beyond dies away or grows, as after an attack; and
        filters have not answered yet.

    Returns
    -------
    float
        Height, of full scale; 0 where the sound fades, where the wave passes through zero by itself, and for silence.
    int
        The frame from which it rises, counted from the outermost; 0 without an edge.
    """
    near = round(NEAR_S * rate_hz)
    answered, rest = (0, 0.0) if start else _answer(samples, rate_hz, step)
    sizes = np.abs(samples[answered : answered + near] - rest)
    largest = float(sizes.max(initial=0.0))
    waits = round((START_RESTS_S if start else END_RESTS_S) * rate_hz)
    ramp = max(1, round(RAMP_S * rate_hz))
    least = max(least, REACHES * largest)
    if not largest or len(sizes) < near or sizes[: waits + ramp + 1].max() < least:
        return 0.0, 0
    rests = int((sizes >= REST * largest).argmax())
    sound = samples[answered + rests : answered + round(5 * NEAR_S * rate_hz)] - rest
    sizes = sizes[rests:]
    height = float(sizes[: ramp + 1].max())
    if rests > waits or height < least or len(sound) < near or (start and not _steady(sound, rate_hz)):
        return 0.0, 0
    for rise_s, gap_s in ((AT_ONCE_S, AT_ONCE_S), (RAMP_S, PASSED_S)):
        rise, gap = max(1, round(rise_s * rate_hz)), max(1, round(gap_s * rate_hz))
        loud = _rms(sound[: rise + 1]) >= LOUD * _rms(sound[rise:near])
        if loud and sizes[: rise + 1].max() >= REACHES * largest and not _natural(sound, gap, near):
            return height, answered + rests
    return 0.0, 0


def _answer(samples: NDArray[np.float64], rate_hz: int, step: float) -> tuple[int, float]:
    """Return the length of a low cut's smooth answer after the edge, and its height there; else 0 and 0."""
    ramp, grain = max(1, round(PASSED_S * rate_hz)), max(GRAIN, STEPS * step)
    outer = samples[: 4 * ramp : ramp].tolist()
    if len(samples) <= 4 * ramp or any(abs(deeper) < abs(shallower) - grain for shallower, deeper in pairwise(outer)):
        return 0, 0.0
    first = samples[: 4 * ramp]
    if np.abs(np.diff(first)).max() > SMOOTH * np.abs(first).max() + grain:
        return 0, 0.0
    largest = float(np.abs(samples).max())
    sharp = np.abs(np.diff(samples, prepend=samples[0])) >= max(grain, REST * largest / ramp)
    edge = int(sharp.argmax())
    answer = samples[: max(0, edge - ramp)]
    if len(answer) <= 2 * ramp:
        return 0, 0.0
    bend = float(np.abs(answer[2 * ramp :] - 2 * answer[ramp:-ramp] + answer[: -2 * ramp]).max())
    height = float(1.5 * answer[-1] - 0.5 * answer[-1 - ramp])
    if abs(height) > ANSWER * largest or bend > SMOOTH * abs(height) + 2 * grain:
        return 0, 0.0
    return edge, height


def _steady(sound: NDArray[np.float64], rate_hz: int) -> bool:
    """Return whether level and slope stay as they are at first for 40 ms: an attack dies away, or the sound grows."""
    passed, near = round(PASSED_S * rate_hz), round(NEAR_S * rate_hz)
    for wave in (sound, np.diff(sound)):
        later = _rms(wave[near : 4 * near]) / max(_rms(wave[passed : near // 2]), GRAIN)
        if not DIES <= later <= GROWS:
            return False
    return True


def _natural(sound: NDArray[np.float64], gap: int, near: int) -> bool:
    """Return whether the wave, predicted from what comes `gap` samples later, is as predicted, and begins at zero."""
    later = sound[gap : gap + near + PREDICTS]
    count = len(later) - gap - PREDICTS
    if count <= 2 * PREDICTS:
        return False
    targets, history = later[:count], _lagged(later, gap + 1, count)
    products = history @ history.T
    products[np.diag_indices(PREDICTS)] += 1e-9 * np.trace(products) + 1e-15
    weights = np.linalg.solve(products, history @ targets)
    largest = float(np.abs(sound[:near]).max())
    error = _rms(targets - weights @ history)
    if error > PREDICTED * largest:
        return False
    margin = max(3, gap)
    before = np.concatenate(((0.0,), sound[: 2 * margin + PREDICTS + 1]))
    predicted = weights @ _lagged(before, gap + 1, margin)
    least = max(OTHERWISE * largest, TIMES * error)
    if predicted[0] * predicted[1] > 0 and float(np.abs(predicted[:2]).min()) >= least:
        return False
    ramp = slice(1, 1 + max(1, gap // 2))
    worst = 1 + int(np.abs(predicted[ramp] - before[ramp]).argmax())
    share = before[worst] / predicted[worst] if predicted[worst] else 1.0
    return not (abs(predicted[worst] - before[worst]) >= least and -0.1 <= share <= 0.9)


def _lagged(samples: NDArray[np.float64], first: int, count: int) -> NDArray[np.float64]:
    """Return `count` samples from `first` on, and as many from each of the next that predict, shape (8, count)."""
    return np.array([samples[at : at + count] for at in range(first, first + PREDICTS)])


def _rms(samples: NDArray[np.float64]) -> float:
    return math.sqrt(float(np.vdot(samples, samples)) / len(samples)) if len(samples) else 0.0
