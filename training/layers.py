"""Dry sounds that imitate nothing: layers of noise, partials and grains under envelopes drawn at random.

Named families (`sources`) teach what games are made of; these teach what a sound may be at all, so that the judgement
goes less by how known families happen to be built.
"""

import numpy as np
from scipy import signal

from training.shapes import Draws, Family, Floats, band_noise, gated, log_uniform, times


def passing(draws: Draws, rate: int) -> Floats:
    """A short event: one to four layers, none of which rings long."""
    length_s = log_uniform(draws, 0.06, 2.0)
    return gated(draws, _layered(draws, rate, length_s, longest_decay_s=0.25), rate)


def ringing(draws: Draws, rate: int) -> Floats:
    """A long decay of its own: layers that start together and die away, each band at its own pace."""
    length_s = log_uniform(draws, 0.5, 5.0)
    return gated(draws, _layered(draws, rate, length_s, longest_decay_s=length_s / 3, is_struck=True), rate)


def lasting(draws: Draws, rate: int) -> Floats:
    """A bed that goes on: layers that come and go."""
    return _layered(draws, rate, log_uniform(draws, 1.0, 5.0), longest_decay_s=0.5, is_held=True)


def _layered(
    draws: Draws, rate: int, length_s: float, longest_decay_s: float, *, is_struck: bool = False, is_held: bool = False
) -> Floats:
    t = times(rate, length_s)
    total = np.zeros(len(t))
    for number in range(draws.integers(1, 5)):
        start = 0.0 if number == 0 or is_held else length_s * draws.uniform(0, 0.5) ** (3 if is_struck else 1)
        own = np.maximum(t - start, 0)
        carrier = CARRIERS[draws.integers(len(CARRIERS))](draws, rate, own)
        if is_held:
            shape = _wavering(draws, rate, len(t))
        elif is_struck:
            shape = _dying(draws, own, log_uniform(draws, 0.05, longest_decay_s))
        else:
            shape = _passing_by(draws, own, length_s - start, longest_decay_s)
        layer = carrier * shape * (t >= start)
        total += layer / (np.abs(layer).max() + 1e-12) * log_uniform(draws, 0.05, 1)
    if draws.random() < 0.25:
        total = np.tanh(total / (np.abs(total).max() + 1e-12) * log_uniform(draws, 0.7, 6))
    return total


# --- what sounds


def _noise(draws: Draws, rate: int, own: Floats) -> Floats:
    low = log_uniform(draws, 40, 5000)
    return band_noise(draws, rate, len(own), low, low * log_uniform(draws, 1.5, 60))


def _partials(draws: Draws, rate: int, own: Floats) -> Floats:
    """Few or very many, harmonic or not; each may die at a pace of its own, high ones sooner, later or alike."""
    count = int(log_uniform(draws, 1, 150))
    low = log_uniform(draws, 50, 1500)
    high = min(0.45 * rate, low * log_uniform(draws, 1.5, 60))
    is_harmonic = draws.random() < 0.3
    slant, decay, tilt = draws.uniform(-0.3, 1.2), log_uniform(draws, 0.02, 2.5), draws.uniform(0, 1.2)
    swell = log_uniform(draws, 0.0005, 0.2) if draws.random() < 0.3 else 0.0
    total = np.zeros(len(own))
    for number in range(count):
        hz = low * (number + 1) if is_harmonic else log_uniform(draws, low, high)
        if hz >= 0.48 * rate:
            break
        pace = decay * (low / hz) ** slant * draws.uniform(0.4, 1.6)
        level = (low / hz) ** tilt * draws.uniform(0.1, 1) * np.exp(-own / max(pace, 0.002))
        if swell:
            level = level * np.clip(own / (swell * draws.uniform(0.3, 2)), 0, 1)
        total += level * np.sin(2 * np.pi * hz * own + draws.uniform(0, 6.28))
    return total


def _gliding(draws: Draws, rate: int, own: Floats) -> Floats:
    """One voice that slides, of some wave, perhaps modulated by another."""
    hz = log_uniform(draws, 40, 3000) * 2 ** (draws.uniform(-3, 3) * (own / own[-1]) ** draws.uniform(0.3, 2))
    turn = np.cumsum(np.clip(hz, 20, 0.4 * rate)) / rate
    turn = turn + draws.choice([0.0, log_uniform(draws, 0.05, 3)]) * np.sin(
        2 * np.pi * turn * log_uniform(draws, 0.3, 7)
    )
    wave = draws.integers(3)
    if wave == 0:
        return np.sin(2 * np.pi * turn)
    return np.sign(np.sin(2 * np.pi * turn)) if wave == 1 else 2 * (turn % 1) - 1


def _grains(draws: Draws, rate: int, own: Floats) -> Floats:
    """Many small events, ever fewer or at a steady rate: debris, drops, crackle, a rattle."""
    total = np.zeros(len(own))
    for _ in range(int(log_uniform(draws, 4, 300))):
        start = int(len(own) * draws.uniform(0, 1) ** draws.choice([1.0, 2.0, 4.0]))
        grain = times(rate, log_uniform(draws, 0.002, 0.12))[: len(own) - start]
        if len(grain) < 8:
            continue
        if draws.random() < 0.5:
            body = np.sin(2 * np.pi * log_uniform(draws, 150, 8000) * (1 + draws.uniform(-3, 6) * grain) * grain)
        else:
            body = draws.standard_normal(len(grain))
        total[start : start + len(grain)] += draws.uniform(0.05, 1) * body * np.exp(-grain / (grain[-1] / 4))
    corner = log_uniform(draws, 300, 8000)
    return signal.sosfilt(signal.butter(1, corner, draws.choice(["low", "high"]), fs=rate, output="sos"), total)


def _pulses(draws: Draws, rate: int, own: Floats) -> Floats:
    """A train of pulses through resonances: throats, motors, buzzers."""
    hz = log_uniform(draws, 20, 250) * (1 + draws.uniform(0, 0.4) * np.sin(2 * np.pi * own * draws.uniform(0.2, 6)))
    x = np.diff(np.floor(np.cumsum(hz) / rate), prepend=0) + draws.uniform(0, 0.1) * draws.standard_normal(len(own))
    total = np.zeros(len(own))
    for _ in range(draws.integers(1, 5)):
        b, a = signal.iirpeak(log_uniform(draws, 150, 6000), log_uniform(draws, 1, 15), fs=rate)
        total += draws.uniform(0.2, 1) * signal.lfilter(b, a, x)
    return total


CARRIERS = (_noise, _noise, _partials, _partials, _gliding, _grains, _pulses)


# --- how it comes and goes


def _dying(draws: Draws, own: Floats, decay_s: float) -> Floats:
    """Struck, then falling: straight, bent, in two stages, or with knocks that come back."""
    attack = log_uniform(draws, 0.0003, 0.15)
    way = draws.integers(4)
    if way == 0:
        fall = np.exp(-own / decay_s)
    elif way == 1:
        fall = np.exp(-((own / decay_s) ** draws.uniform(0.5, 1.8)))
    elif way == 2:
        share = log_uniform(draws, 0.03, 0.7)
        fall = (1 - share) * np.exp(-own / (decay_s * draws.uniform(0.05, 0.5))) + share * np.exp(-own / decay_s)
    else:
        fall = np.exp(-own / decay_s)
        for _ in range(draws.integers(1, 6)):
            later = np.maximum(own - draws.exponential(decay_s), 0)
            fall = fall + draws.uniform(0.05, 0.8) * (later > 0) * np.exp(-later / (decay_s * draws.uniform(0.1, 1)))
    if draws.random() < 0.25:
        fall = fall * (1 + draws.uniform(0.1, 0.9) * np.sin(2 * np.pi * log_uniform(draws, 2, 30) * own))
    return np.clip(own / attack, 0, 1) * fall


def _passing_by(draws: Draws, own: Floats, length_s: float, longest_decay_s: float) -> Floats:
    """A level drawn as an editor's line from point to point, or a strike that is soon over."""
    if draws.random() < 0.5:
        return _dying(draws, own, log_uniform(draws, 0.003, longest_decay_s))
    points = draws.integers(3, 8)
    at = np.concatenate(([0], np.sort(draws.uniform(0, length_s, points)), [length_s]))
    levels_db = np.concatenate(([-70], draws.uniform(-30, 0, points), [-70]))
    return 10 ** (np.interp(own, at, levels_db) / 20)


def _wavering(draws: Draws, rate: int, frames: int) -> Floats:
    slow = signal.sosfilt(
        signal.butter(1, log_uniform(draws, 0.3, 20), fs=rate, output="sos"), draws.standard_normal(frames)
    )
    return 10 ** (np.clip(slow / (slow.std() + 1e-12), -3, 3) * draws.uniform(0, 8) / 20)


FAMILIES = [  # long decays are hardest to distinguish from a room
    *[Family("passing", "event", passing)] * 2,
    *[Family("ringing", "natural-decay", ringing)] * 3,
    Family("lasting", "ambience", lasting),
]
