"""Dry sounds of a game, by family: each draws its own shape, length and materials.

A family is either for development or kept apart: nothing of a kept-apart family is ever learned from.
"""

import numpy as np
from scipy import signal

from training.kept_apart_sources import arcade, cymbal, gong, growl, reload, rustle, splash, thunder
from training.shapes import Draws, Family, Floats, band_noise, gated, hump, log_uniform, modes, placed, struck, times


def impact(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.15, 1.2))
    body = modes(
        draws, t, draws.integers(3, 14), 80, log_uniform(draws, 800, 6000), log_uniform(draws, 0.01, 0.12), 0.4
    )
    crack = band_noise(draws, rate, len(t), 300, 9000) * struck(t, 0.0005, log_uniform(draws, 0.002, 0.03))
    return body + draws.uniform(0.2, 3) * crack


def blip(draws: Draws, rate: int) -> Floats:
    notes = []
    for number in range(draws.integers(1, 5)):
        t = times(rate, log_uniform(draws, 0.03, 0.25))
        hz = log_uniform(draws, 250, 3500) * (1 + draws.uniform(-0.5, 0.5) * t / t[-1])
        index = draws.uniform(0, 4) * np.exp(-t / 0.05)
        x = np.sin(
            2 * np.pi * np.cumsum(hz) / rate
            + index * np.sin(2 * np.pi * np.cumsum(hz) / rate * draws.choice([1.5, 2, 3.01]))
        )
        env = (
            struck(t, 0.002, log_uniform(draws, 0.01, 0.15))
            if draws.random() < 0.6
            else np.clip(np.minimum(t / 0.004, (t[-1] - t) / 0.006), 0, 1)
        )
        notes.append((number * draws.uniform(0.04, 0.16), x * env))
    return placed(rate, 0.05, notes)


def whoosh(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.25, 2.5))
    peak = draws.uniform(0.25, 0.75)
    along = t / t[-1]
    env = np.where(along < peak, along / peak, (1 - along) / (1 - peak)) ** draws.uniform(1, 4)
    bands = [log_uniform(draws, 100, 1500) * 2.0**one for one in range(3)]
    sweep = 0.5 + 0.5 * np.sin(np.pi * along)
    x = sum(
        band_noise(draws, rate, len(t), hz, hz * 2) * sweep ** (number * draws.uniform(0.5, 2))
        for number, hz in enumerate(bands)
    )
    return x * env


def explosion(draws: Draws, rate: int) -> Floats:
    decay = log_uniform(draws, 0.15, 1.2)
    t = times(rate, decay * draws.uniform(3, 6))
    x = np.zeros(len(t))
    for low, high, rel in ((30, 150, 1.3), (100, 600, 1), (400, 2500, 0.6), (2000, 9000, 0.35)):
        stages = struck(t, draws.uniform(0.001, 0.02), decay * rel * draws.uniform(0.5, 1.5))
        if draws.random() < 0.5:
            stages = stages + draws.uniform(0.5, 3) * struck(t, 0.001, 0.04 * rel)
        lumps = (
            1
            + draws.uniform(0, 0.7)
            * signal.sosfilt(
                signal.butter(1, log_uniform(draws, 2, 20), fs=rate, output="sos"), draws.standard_normal(len(t))
            )
            * 30
        )
        x += draws.uniform(0.3, 1.5) * band_noise(draws, rate, len(t), low, high) * stages * np.abs(lumps)
    return np.tanh(x * draws.uniform(0.2, 1.5))


def bell(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.8, 4))
    base = log_uniform(draws, 200, 2000)
    x = np.zeros(len(t))
    for ratio in (0.5, 1, 1.19, 1.5, 2, 2.51, 2.66, 3.01, 4.17, 5.43)[: draws.integers(4, 11)]:
        hz = base * ratio * draws.uniform(0.98, 1.02)
        if hz < 0.45 * rate:
            pair = np.sin(2 * np.pi * hz * t) + draws.uniform(0, 0.7) * np.sin(
                2 * np.pi * hz * draws.uniform(1.0005, 1.004) * t
            )
            x += draws.uniform(0.2, 1) * pair * np.exp(-t / (t[-1] * 0.35 * ratio**-0.6 * draws.uniform(0.4, 1.2)))
    return x * np.clip(t / 0.001, 0, 1)


def engine(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.8, 4))
    hz = log_uniform(draws, 25, 140) * (
        1 + 0.02 * np.sin(2 * np.pi * draws.uniform(0.2, 2) * t) + draws.uniform(-0.2, 0.4) * t / t[-1]
    )
    turn = np.cumsum(hz) / rate
    x = sum(
        draws.uniform(0.2, 1) / (n**0.7) * np.sin(2 * np.pi * n * turn + draws.uniform(0, 6))
        for n in range(1, draws.integers(6, 25))
    )
    puff = (0.5 + 0.5 * np.sin(2 * np.pi * turn)) ** draws.uniform(1, 6)
    x = x + draws.uniform(0.1, 2) * band_noise(draws, rate, len(t), 200, 4000) * puff
    return x if draws.random() < 0.5 else gated(draws, x * np.clip(t / 0.05, 0, 1), rate)


def speech(draws: Draws, rate: int) -> Floats:
    base = log_uniform(draws, 85, 280)
    parts = []
    at = 0.0
    for _ in range(draws.integers(2, 14)):
        length = draws.uniform(0.07, 0.28)
        t = times(rate, length)
        if draws.random() < 0.3:
            low = log_uniform(draws, 1500, 5000)
            x = band_noise(draws, rate, len(t), low, low * 2.2) * hump(t) ** 0.7 * draws.uniform(0.1, 0.4)
        else:
            hz = base * draws.uniform(0.8, 1.25) * (1 + draws.uniform(-0.25, 0.15) * t / t[-1])
            pulses = np.diff(np.floor(np.cumsum(hz * (1 + 0.01 * draws.standard_normal(len(t)))) / rate), prepend=0)
            x = signal.lfilter([1], [1, -0.97], pulses) + 0.01 * draws.standard_normal(len(t))
            voiced = np.zeros(len(t))
            for formant in (
                draws.uniform(250, 850),
                draws.uniform(850, 2400),
                draws.uniform(2300, 3300),
                draws.uniform(3300, 4500),
            ):
                b, a = signal.iirpeak(formant, draws.uniform(4, 12), fs=rate)
                voiced += signal.lfilter(b, a, x) * 300 / formant
            x = (
                voiced
                / (voiced.std() + 1e-9)
                * np.clip(np.minimum(t / 0.02, (t[-1] - t) / draws.uniform(0.015, 0.06)), 0, 1)
            )
        parts.append((at, x))
        at += length * draws.uniform(0.75, 1.0) + (draws.uniform(0.1, 0.4) if draws.random() < 0.2 else 0)
    return placed(rate, at, parts)


def footsteps(draws: Draws, rate: int) -> Floats:
    parts = []
    for step in range(draws.integers(1, 5)):
        for late in (0.0, draws.uniform(0.04, 0.12)):
            t = times(rate, 0.2)
            low = log_uniform(draws, 80, 1500)
            x = band_noise(draws, rate, len(t), low, low * draws.uniform(2, 8)) * struck(
                t, draws.uniform(0.001, 0.01), log_uniform(draws, 0.008, 0.05)
            )
            if draws.random() < 0.5:
                x *= 1 + 2 * (draws.random(len(t)) < 0.004) * draws.standard_normal(len(t)) * 4
            parts.append((step * draws.uniform(0.4, 0.6) + late, x * draws.uniform(0.3, 1)))
    return placed(rate, 0.1, parts)


def gunshot(draws: Draws, rate: int) -> Floats:
    t = times(rate, draws.uniform(0.2, 0.7))
    x = sum(
        band_noise(draws, rate, len(t), low, high)
        * struck(t, 0.0004, log_uniform(draws, 0.005, 0.09))
        * draws.uniform(0.5, 2)
        for low, high in ((50, 300), (300, 1500), (1500, 9000))
    )
    x = x + modes(draws, t, 5, 400, 5000, log_uniform(draws, 0.01, 0.06), 0.3) * draws.uniform(0, 0.6)
    return np.tanh(x * draws.uniform(0.5, 3))


def drum(draws: Draws, rate: int) -> Floats:
    decay = log_uniform(draws, 0.06, 0.5)
    t = times(rate, decay * 5)
    hz = log_uniform(draws, 45, 220) * (1 + draws.uniform(0.2, 3) * np.exp(-t / 0.02))
    x = np.sin(2 * np.pi * np.cumsum(hz) / rate) * struck(t, 0.001, decay)
    rattle = band_noise(draws, rate, len(t), log_uniform(draws, 400, 3000), 9000) * struck(
        t, 0.001, decay * draws.uniform(0.2, 1)
    )
    return x + draws.uniform(0, 1.5) * rattle


def rain(draws: Draws, rate: int) -> Floats:
    seconds = log_uniform(draws, 0.8, 3)
    frames = int(seconds * rate)
    grains = (draws.random(frames) < log_uniform(draws, 20, 4000) / rate) * draws.standard_normal(frames)
    t = times(rate, 0.02)
    grain = modes(draws, t, 5, 800, 7000, log_uniform(draws, 0.001, 0.005), 0.0)
    x = signal.fftconvolve(grains, grain)[:frames]
    x = x / (x.std() + 1e-9) + draws.uniform(0, 0.5) * band_noise(draws, rate, frames, 300, 6000)
    return x * (0.6 + 0.4 * np.sin(2 * np.pi * draws.uniform(0.3, 3) * times(rate, seconds)))


def laser(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.12, 0.8))
    hz = 80 + log_uniform(draws, 800, 6000) * np.exp(-t / log_uniform(draws, 0.03, 0.4))
    turn = np.cumsum(hz) / rate
    x = (
        signal.sawtooth(2 * np.pi * turn)
        if draws.random() < 0.5
        else np.sin(2 * np.pi * turn + 2 * np.sin(2 * np.pi * 1.5 * turn))
    )
    env = struck(t, 0.001, log_uniform(draws, 0.03, 0.3)) if draws.random() < 0.7 else np.ones(len(t))
    return gated(
        draws,
        x * env + draws.uniform(0, 0.3) * band_noise(draws, rate, len(t), 500, 8000) * struck(t, 0.001, 0.03),
        rate,
    )


def plucked(draws: Draws, rate: int) -> Floats:
    parts = []
    for number in range(draws.integers(1, 4)):
        period = int(rate / log_uniform(draws, 80, 700))
        frames = int(rate * log_uniform(draws, 0.5, 2.5))
        start = np.zeros(frames)
        start[:period] = draws.standard_normal(period)
        damp = draws.uniform(0.985, 0.9995)
        taps = np.zeros(period + 2)
        taps[0], taps[period], taps[period + 1] = 1, -damp * 0.5, -damp * 0.5
        parts.append((number * draws.uniform(0.1, 0.5), signal.lfilter([1], taps, start)))
    return placed(rate, 0.05, parts)


def debris(draws: Draws, rate: int) -> Floats:
    parts = []
    length = log_uniform(draws, 0.3, 1.5)
    for _ in range(draws.integers(6, 45)):
        t = times(rate, 0.15)
        at = length * draws.random() ** 1.7
        parts.append(
            (
                at,
                modes(draws, t, 4, 600, 9000, log_uniform(draws, 0.004, 0.04), 0.2)
                * draws.uniform(0.05, 1)
                * np.exp(-at / length),
            )
        )
    return placed(rate, length, parts)


def servo(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.3, 1.8))
    speed = np.clip(np.minimum(t / draws.uniform(0.05, 0.2), (t[-1] - t) / draws.uniform(0.03, 0.2)), 0, 1)
    turn = np.cumsum(log_uniform(draws, 150, 900) * (0.4 + 0.6 * speed)) / rate
    x = sum(draws.uniform(0.1, 1) / n * np.sin(2 * np.pi * n * turn) for n in range(1, 9)) + 0.3 * band_noise(
        draws, rate, len(t), 1500, 7000
    )
    return gated(draws, x * speed ** draws.uniform(0.3, 1), rate)


def boom(draws: Draws, rate: int) -> Floats:
    decay = log_uniform(draws, 0.2, 1.4)
    t = times(rate, decay * 4)
    hz = log_uniform(draws, 25, 70) * (1 + draws.uniform(0.5, 3) * np.exp(-t / log_uniform(draws, 0.03, 0.4)))
    x = np.sin(2 * np.pi * np.cumsum(hz) / rate) * struck(t, 0.004, decay)
    for low in (60, 300, 1500):
        x += (
            draws.uniform(0, 0.8)
            * band_noise(draws, rate, len(t), low, low * 5)
            * struck(t, log_uniform(draws, 0.002, 0.08), decay * draws.uniform(0.1, 1))
        )
    return np.tanh(x * draws.uniform(0.5, 2))


def steam(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.2, 2))
    hold = draws.uniform(0.1, 0.8) * t[-1]
    env = np.clip(t / log_uniform(draws, 0.003, 0.1), 0, 1) * np.exp(
        -np.maximum(t - hold, 0) / log_uniform(draws, 0.01, 0.3)
    )
    low = log_uniform(draws, 300, 4000)
    return gated(draws, band_noise(draws, rate, len(t), low, low * draws.uniform(2, 6)) * env, rate)


def chimes(draws: Draws, rate: int) -> Floats:
    parts = []
    for _ in range(draws.integers(2, 12)):
        t = times(rate, log_uniform(draws, 0.4, 2))
        hz = log_uniform(draws, 900, 5000)
        x = sum(
            draws.uniform(0.1, 1)
            * np.sin(2 * np.pi * hz * ratio * t + draws.uniform(0, 6))
            * np.exp(-t / (t[-1] * 0.2 / ratio**0.7))
            for ratio in (1, 2.76, 5.4)
            if hz * ratio < 0.45 * rate
        )
        parts.append((draws.exponential(0.3), x * draws.uniform(0.2, 1)))
    return placed(rate, 0.2, parts)


def power(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.3, 2))
    along = t / t[-1] if draws.random() < 0.5 else 1 - t / t[-1]
    turn = np.cumsum(log_uniform(draws, 40, 300) * 2 ** (along * draws.uniform(0.5, 4))) / rate
    x = sum(draws.uniform(0, 1) / n * np.sin(2 * np.pi * n * turn) for n in range(1, 12))
    x = x * (1 + draws.uniform(0, 0.8) * np.sin(2 * np.pi * draws.uniform(4, 30) * t))
    env = along ** draws.uniform(0.3, 2) if draws.random() < 0.5 else np.ones(len(t))
    return gated(draws, x * env + draws.uniform(0, 0.3) * draws.standard_normal(len(t)) * env, rate)


def pad(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 1, 4))
    x = np.zeros(len(t))
    for _ in range(draws.integers(4, 20)):
        hz = log_uniform(draws, 80, 1200)
        x += signal.sawtooth(2 * np.pi * hz * draws.uniform(0.995, 1.005) * t + draws.uniform(0, 6)) / (1 + hz / 400)
    rise, end = draws.uniform(0.02, 0.5), draws.uniform(0.02, 0.8)
    return x * np.clip(np.minimum(t / rise, (t[-1] - t) / end), 0, 1)


def keys(draws: Draws, rate: int) -> Floats:
    """Notes struck and let go: a decay that a damper cuts short."""
    parts = []
    for number in range(draws.integers(1, 6)):
        t = times(rate, log_uniform(draws, 0.2, 1.5))
        hz = log_uniform(draws, 100, 1200)
        x = sum(
            np.sin(2 * np.pi * hz * n * np.sqrt(1 + 0.0005 * n * n) * t) / n**1.2 * np.exp(-t * n**0.5 / 0.6)
            for n in range(1, 10)
        )
        release = log_uniform(draws, 0.01, 0.15)
        parts.append(
            (number * draws.uniform(0.1, 0.5), x * np.clip((t[-1] - t) / release, 0, 1) * np.clip(t / 0.003, 0, 1))
        )
    return placed(rate, 0.1, parts)


def scrape(draws: Draws, rate: int) -> Floats:
    t = times(rate, log_uniform(draws, 0.3, 1.8))
    push = np.abs(
        signal.sosfilt(signal.butter(1, draws.uniform(2, 25), fs=rate, output="sos"), draws.standard_normal(len(t)))
    ) * hump(t)
    x = draws.standard_normal(len(t)) * push
    body = times(rate, 0.1)
    ring = modes(draws, body, 8, 400, 6000, log_uniform(draws, 0.002, 0.03), 0.2)
    return signal.fftconvolve(x, ring)[: len(t) + len(body) // 2]


FAMILIES = (
    Family("impact", "event", impact),
    Family("blip", "event", blip),
    Family("whoosh", "event", whoosh),
    Family("explosion", "natural-decay", explosion),
    Family("bell", "natural-decay", bell),
    Family("engine", "ambience", engine),
    Family("speech", "voice", speech),
    Family("footsteps", "event", footsteps),
    Family("gunshot", "event", gunshot),
    Family("drum", "natural-decay", drum),
    Family("rain", "ambience", rain),
    Family("laser", "event", laser),
    Family("plucked", "natural-decay", plucked),
    Family("debris", "event", debris),
    Family("servo", "event", servo),
    Family("boom", "natural-decay", boom),
    Family("steam", "event", steam),
    Family("chimes", "natural-decay", chimes),
    Family("power", "event", power),
    Family("pad", "music", pad),
    Family("keys", "music", keys),
    Family("scrape", "event", scrape),
    Family("cymbal", "natural-decay", cymbal, is_kept_apart=True),
    Family("thunder", "natural-decay", thunder, is_kept_apart=True),
    Family("gong", "natural-decay", gong, is_kept_apart=True),
    Family("rustle", "event", rustle, is_kept_apart=True),
    Family("arcade", "event", arcade, is_kept_apart=True),
    Family("splash", "event", splash, is_kept_apart=True),
    Family("growl", "event", growl, is_kept_apart=True),
    Family("reload", "event", reload, is_kept_apart=True),
)
