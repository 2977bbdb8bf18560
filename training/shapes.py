"""What dry sounds are made of: times, envelopes, noise in a band, modes and events."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy import signal

Floats = NDArray[np.float64]
Draws = np.random.Generator


@dataclass(frozen=True)
class Family:
    """One way of making dry sounds."""

    name: str
    kind: str  # as a spec's category says it
    make: Callable[[Draws, int], Floats]  # shape (frames,) or (frames, 2)
    is_kept_apart: bool = False


def times(rate: int, seconds: float) -> Floats:
    return np.arange(max(1, int(seconds * rate))) / rate


def log_uniform(draws: Draws, low: float, high: float) -> float:
    return float(np.exp(draws.uniform(np.log(low), np.log(high))))


def struck(t: Floats, attack_s: float, decay_s: float) -> Floats:
    return np.clip(t / attack_s, 0, 1) * np.exp(-np.maximum(t - attack_s, 0) / decay_s)


def hump(t: Floats) -> Floats:
    """From nothing to one and back over the whole time."""
    return np.clip(np.sin(np.pi * t / t[-1]), 0, 1)


def band_noise(draws: Draws, rate: int, frames: int, low_hz: float, high_hz: float) -> Floats:
    high = min(high_hz, 0.49 * rate)
    low = min(low_hz, high / 1.2)
    filters = signal.butter(2, [low, high], "bandpass", fs=rate, output="sos")
    noise = signal.sosfilt(filters, draws.standard_normal(frames))
    return noise / (noise.std() + 1e-12)


def modes(draws: Draws, t: Floats, count: int, low_hz: float, high_hz: float, decay_s: float, slant: float) -> Floats:
    """Damped partials; `slant` makes high ones die sooner."""
    total = np.zeros(len(t))
    for _ in range(count):
        hz = log_uniform(draws, low_hz, high_hz)
        decay = decay_s * (low_hz / hz) ** slant * draws.uniform(0.5, 1.5)
        total += draws.uniform(0.1, 1) * np.sin(2 * np.pi * hz * t + draws.uniform(0, 6.28)) * np.exp(-t / decay)
    return total


def placed(rate: int, seconds: float, events: list[tuple[float, Floats]]) -> Floats:
    out = np.zeros(max(int(seconds * rate), *(int(at * rate) + len(one) for at, one in events)))
    for at, one in events:
        start = int(at * rate)
        out[start : start + len(one)] += one
    return out


def gated(draws: Draws, x: Floats, rate: int) -> Floats:
    """The end that an editor gives a sound: a short fade."""
    fade = min(len(x), int(rate * log_uniform(draws, 0.001, 0.04)))
    x = x.copy()
    x[len(x) - fade :] *= np.linspace(1, 0, fade) ** draws.uniform(0.5, 2)
    return x
