"""Other whole sounds, by other means than those of `sounds`: unseen until they had been looked at five times."""

import numpy as np
from scipy.signal import butter, lfilter, sosfilt

from benchmarks.faults.sounds import Family, Samples


def plucks(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Strings after Karplus and Strong, strummed."""
    frames = round(seconds * rate)
    mix = np.zeros(frames)
    for at in np.sort(rng.uniform(0, seconds * 0.4, rng.integers(1, 5))):
        delay = round(rate / rng.uniform(90, 600))
        feed = np.zeros(delay + 2)
        feed[0], feed[delay:] = 1.0, -0.498
        start = round(at * rate)
        pick = np.zeros(frames - start)
        pick[:delay] = lfilter([0.4], [1, -0.6], rng.uniform(-1, 1, delay))[: len(pick)]
        mix[start:] += lfilter([1.0], feed, pick)
    return _faded(mix, rate, 0.002, 0.08)[:, np.newaxis]


def grains(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A cloud of short windowed tones, scattered left and right."""
    frames = round(seconds * rate)
    cloud = np.zeros((frames, 2))
    for _ in range(round(seconds * rng.uniform(40, 160))):
        length = round(rng.uniform(0.02, 0.12) * rate)
        at = int(rng.integers(0, max(1, frames - length)))
        grain = np.hanning(length) * np.sin(2 * np.pi * rng.uniform(200, 5000) * np.arange(length) / rate)
        room = min(length, frames - at)
        cloud[at : at + room] += grain[:room, np.newaxis] * rng.uniform(0, 1, 2)
    return _faded(cloud, rate, 0.01, 0.03)


def machine(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Noise through combs: a drone of pipes."""
    frames = round(seconds * rate)
    drone = np.zeros((frames, 2))
    for channel in range(2):
        breath = rng.standard_normal(frames)
        for hz in rng.uniform(60, 400, 3):
            feed = np.zeros(round(rate / hz) + 1)
            feed[0], feed[-1] = 1.0, -rng.uniform(0.9, 0.98)
            drone[:, channel] += lfilter([1.0], feed, breath)
    return _faded(sosfilt(butter(1, rng.uniform(1500, 9000), fs=rate, output="sos"), drone, axis=0), rate, 0.2, 0.3)


def birds(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Chirps over leaves."""
    frames = round(seconds * rate)
    song = 0.004 * lfilter([1, -0.8], [1], rng.standard_normal(frames))
    at = 0.05
    while at < seconds - 0.2:
        length = round(rng.uniform(0.03, 0.15) * rate)
        place = np.linspace(0, 1, length)
        hz = rng.uniform(2500, 6000) * (1 + rng.uniform(-0.3, 0.3) * place + 0.05 * np.sin(place * rng.uniform(5, 60)))
        start = round(at * rate)
        song[start : start + length] += (np.sin(np.pi * place) * np.sin(2 * np.pi * np.cumsum(hz) / rate))[
            : frames - start
        ]
        at += length / rate + rng.uniform(0.01, 0.2)
    return _faded(song, rate, 0.02, 0.05)[:, np.newaxis]


def robot(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Frequency modulation under a ring modulator."""
    times = np.arange(round(seconds * rate)) / rate
    depth = rng.uniform(1, 6) * (1 + np.sin(2 * np.pi * rng.uniform(0.5, 4) * times))
    carrier = rng.uniform(120, 600)
    voice = np.sin(2 * np.pi * carrier * times + depth * np.sin(2 * np.pi * carrier * rng.uniform(0.4, 2.1) * times))
    ring = np.sin(2 * np.pi * rng.uniform(20, 120) * times)
    return _faded(voice * (0.7 + 0.3 * ring), rate, 0.01, 0.02)[:, np.newaxis] * rng.uniform(0.4, 1, 2)


def bubbles(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Water: tones that rise while they die away."""
    frames = round(seconds * rate)
    water = np.zeros((frames, 1))
    for _ in range(round(seconds * rng.uniform(15, 60))):
        start = int(rng.integers(0, frames))
        times = np.arange(min(round(0.15 * rate), frames - start)) / rate
        hz = rng.uniform(300, 2500)
        rise = 1 + rng.uniform(1, 6) * times
        pop = np.sin(2 * np.pi * hz * np.cumsum(rise) / rate) * np.exp(-times * rng.uniform(20, 80))
        water[start : start + len(times), 0] += pop * np.clip(times / 0.002, 0, 1) * rng.uniform(0.1, 1)
    return _faded(water, rate, 0.01, 0.05)


def swell(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A cymbal backwards: noise and metal that grow, then close quickly."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    metal = sum(np.sin(2 * np.pi * hz * times + hz) for hz in rng.uniform(800, 9000, 25))
    hiss = sosfilt(butter(2, 3000, "high", fs=rate, output="sos"), rng.standard_normal((frames, 2)), axis=0)
    grow = np.exp((times - seconds) * rng.uniform(4, 9) / seconds)
    return _faded((metal[:, np.newaxis] * 0.15 + hiss) * grow[:, np.newaxis], rate, 0.05, 0.04)


def choir(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Detuned saws with vibrato through a soft low-pass: a pad."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    pad = np.zeros((frames, 2))
    for note in rng.uniform(110, 440) * np.array([1, 1.26, 1.5]):
        for _ in range(3):
            hz = note * (1 + rng.normal(0, 0.003) + 0.004 * np.sin(2 * np.pi * rng.uniform(4, 6) * times))
            turns = np.cumsum(hz) / rate
            voices = sum(np.sin(2 * np.pi * number * turns) / number for number in range(1, 12))
            pad += voices[:, np.newaxis] * rng.uniform(0, 1, 2)
    return _faded(pad, rate, 0.08, 0.15)


def crackle(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A camp fire: snaps of wood over a rumble of flames."""
    frames = round(seconds * rate)
    fire = 0.15 * sosfilt(butter(2, 400, fs=rate, output="sos"), rng.standard_normal((frames, 2)), axis=0)
    for _ in range(round(seconds * rng.uniform(20, 80))):
        start = int(rng.integers(0, frames))
        times = np.arange(min(round(0.03 * rate), frames - start)) / rate
        snap = lfilter([0.5], [1, -0.5], rng.standard_normal(len(times))) * np.exp(-times / rng.uniform(0.001, 0.006))
        fire[start : start + len(times)] += (snap * rng.pareto(2) * 0.2)[:, np.newaxis] * rng.uniform(0.3, 1, 2)
    return _faded(fire, rate, 0.05, 0.1)


def drums(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A beat of kicks, snares and closed hats."""
    frames = round(seconds * rate)
    beat = np.zeros(frames)
    gap = rng.uniform(0.11, 0.2)
    for number, at in enumerate(np.arange(0.02, seconds - 0.1, gap)):
        start = round(at * rate)
        times = np.arange(min(round(0.3 * rate), frames - start)) / rate
        attack = np.clip(times / 0.0005, 0, 1)
        hit = 0.2 * np.diff(rng.standard_normal(len(times) + 1)) * np.exp(-times / 0.015)
        if number % 4 == 0:
            hit = hit + np.sin(2 * np.pi * (50 * times - 4 * np.exp(-times / 0.03))) * np.exp(-times / 0.1)
        if number % 4 == 2:
            hit = hit + 0.6 * rng.standard_normal(len(times)) * np.exp(-times / 0.06)
        beat[start : start + len(times)] += attack * hit
    return _faded(beat, rate, 0.005, 0.03)[:, np.newaxis]


FAMILIES: dict[str, Family] = {
    family.__name__: family for family in (plucks, grains, machine, birds, robot, bubbles, swell, choir, crackle, drums)
}


def _faded(sound: Samples, rate: int, rise_s: float, fall_s: float) -> Samples:
    """The sound with straight fades at both ends."""
    times = np.arange(len(sound)) / rate
    fades = np.clip(times / rise_s, 0, 1) * np.clip((times[-1] - times) / fall_s, 0, 1)
    return sound * (fades if sound.ndim == 1 else fades[:, np.newaxis])
