"""Dry sounds of the families that are kept apart: nothing of them is ever learned from."""

import numpy as np
from scipy import signal

from training.shapes import Draws, Floats, band_noise, hump, log_uniform, modes, placed, struck, times


def cymbal(draws: Draws, rate: int) -> Floats:
    decay = log_uniform(draws, 0.2, 1.2)
    t = times(rate, decay * 4)
    x = modes(draws, t, 120, 300, 11000, decay, draws.uniform(0, 0.2))
    return x * np.clip(t / 0.001, 0, 1) + band_noise(draws, rate, len(t), 3000, 11000) * struck(t, 0.001, 0.02) * 3


def thunder(draws: Draws, rate: int) -> Floats:
    decay = log_uniform(draws, 0.3, 1.5)
    t = times(rate, decay * 4)
    brown = signal.sosfilt(
        signal.butter(1, [40, log_uniform(draws, 150, 900)], "bandpass", fs=rate, output="sos"),
        draws.standard_normal(len(t)),
    )
    claps = sum(
        draws.uniform(0.2, 1)
        * struck(np.maximum(t - draws.uniform(0, decay), 0), 0.01, decay * draws.uniform(0.15, 0.6))
        * (t > 0)
        for _ in range(draws.integers(1, 7))
    )
    return brown * (claps + struck(t, 0.02, decay))


def rustle(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.3, 1.8))
    flow = np.abs(
        signal.sosfilt(signal.butter(2, draws.uniform(6, 30), fs=rate, output="sos"), draws.standard_normal(len(t)))
    )
    x = band_noise(draws, rate, len(t), log_uniform(draws, 800, 2500), 10000) * flow**1.3
    return x * np.clip(np.minimum(t / 0.03, (t[-1] - t) / 0.04), 0, 1)


def arcade(draws: Draws, rate: int) -> Floats:
    notes = []
    base = log_uniform(draws, 200, 900)
    step = draws.uniform(0.03, 0.12)
    for number in range(draws.integers(2, 9)):
        t = times(rate, step)
        x = signal.square(
            2 * np.pi * base * 2 ** (draws.integers(0, 24) / 12) * t, duty=draws.choice([0.125, 0.25, 0.5])
        )
        notes.append((number * step, np.round(x * np.linspace(1, draws.uniform(0, 1), len(t)) * 8) / 8))
    return placed(rate, 0.01, notes)


def splash(draws: Draws, rate: int) -> Floats:
    t = times(rate, 0.5)
    parts = [
        (
            0.0,
            band_noise(draws, rate, len(t), 400, 8000)
            * struck(t, draws.uniform(0.002, 0.03), log_uniform(draws, 0.03, 0.12)),
        )
    ]
    for _ in range(draws.integers(5, 50)):
        tb = times(rate, 0.08)
        hz = log_uniform(draws, 400, 3500) * (1 + draws.uniform(1, 8) * tb)
        parts.append(
            (
                draws.exponential(0.25),
                np.sin(2 * np.pi * np.cumsum(hz) / rate)
                * np.exp(-tb / log_uniform(draws, 0.005, 0.025))
                * draws.uniform(0.1, 1),
            )
        )
    return placed(rate, 0.3, parts)


def growl(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.4, 1.8))
    hz = log_uniform(draws, 45, 140) * (1 + 0.3 * np.sin(np.pi * t / t[-1]))
    turn = np.cumsum(hz * (1 + 0.05 * draws.standard_normal(len(t)))) / rate
    x = np.sign(np.sin(2 * np.pi * turn)) * (1 + np.sin(np.pi * turn)) + 0.5 * draws.standard_normal(len(t))
    for formant in (draws.uniform(300, 700), draws.uniform(900, 1800)):
        b, a = signal.iirpeak(formant, draws.uniform(1.5, 5), fs=rate)
        x = x * 0.4 + signal.lfilter(b, a, x)
    return np.tanh(x) * hump(t) ** draws.uniform(0.3, 1.5)


def reload(draws: Draws, rate: int) -> Floats:
    parts = []
    at = 0.0
    for _ in range(draws.integers(2, 6)):
        t = times(rate, 0.12)
        x = modes(draws, t, 8, 900, 8000, log_uniform(draws, 0.003, 0.02), 0.1) + 2 * draws.standard_normal(
            len(t)
        ) * struck(t, 0.0003, 0.002)
        parts.append((at, x))
        if draws.random() < 0.4:
            slide = times(rate, draws.uniform(0.06, 0.2))
            parts.append((at + 0.03, band_noise(draws, rate, len(slide), 1500, 6000) * hump(slide) * 0.5))
        at += draws.uniform(0.08, 0.35)
    return placed(rate, 0.1, parts)


def gong(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 1, 4))
    x = np.zeros(len(t))
    for _ in range(draws.integers(15, 40)):
        hz = log_uniform(draws, 90, 3000)
        swell = log_uniform(draws, 0.005, 0.15)
        x += (
            draws.uniform(0.1, 1)
            * (300 / (hz + 300))
            * np.sin(2 * np.pi * hz * t + draws.uniform(0, 6))
            * struck(t, swell, t[-1] * 0.25 * (200 / (hz + 200)) ** 0.3)
        )
    return x
