"""Whole sounds of the kinds that games use, for faults to be put into while detectors are tuned.

Each family draws its own parameters, so that no two sounds of it are alike. Peaks lie between -12 and -1 dBFS.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, lfilter, sosfilt

Samples = NDArray[np.float64]
Family = Callable[[np.random.Generator, int, float], Samples]


def bell(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Inharmonic modes that ring out after a soft stroke."""
    times = np.arange(round(seconds * rate)) / rate
    base = rng.uniform(200, 900)
    modes = base * np.sort(rng.uniform(1, 8, rng.integers(4, 9)))
    ring = sum(
        rng.uniform(0.3, 1) / (place + 1) * np.exp(-times * rng.uniform(2, 6) / seconds) * _tone(rng, hz, times)
        for place, hz in enumerate(modes)
    )
    return _stereo(rng, ring * _rise(times, rng.uniform(0.001, 0.008)) * _fall(times, 0.03))


def wind(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Noise in a band, in gusts."""
    frames = round(seconds * rate)
    low = rng.uniform(80, 400)
    band = butter(2, [low, low * rng.uniform(4, 20)], "band", fs=rate, output="sos")
    blown = sosfilt(band, rng.standard_normal((frames, int(rng.integers(1, 3)))), axis=0)
    times = np.arange(frames) / rate
    gusts = 0.6 + 0.4 * np.sin(2 * np.pi * rng.uniform(0.3, 1.5) * times + rng.uniform(0, 6))
    return blown * (gusts * _rise(times, 0.1) * _fall(times, 0.15))[:, np.newaxis]


def beep(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A steady note with a dozen harmonics, gated by short fades."""
    times = np.arange(round(seconds * rate)) / rate
    base = rng.uniform(150, 1800)
    note = sum(
        rng.uniform(0.2, 1) / number * _tone(rng, base * number, times)
        for number in range(1, int(min(12, 0.45 * rate / base)))
    )
    return _stereo(rng, note * _rise(times, 0.004) * _fall(times, 0.01))


def impact(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A burst of noise over a thud and a few modes."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    burst = rng.standard_normal(frames) * np.exp(-times / rng.uniform(0.01, 0.08))
    tail = lfilter([0.1], [1, -0.9], rng.standard_normal(frames)) * np.exp(-times * rng.uniform(4, 8) / seconds)
    thud = _tone(rng, rng.uniform(50, 140), times) * np.exp(-times / rng.uniform(0.05, 0.2))
    return _stereo(rng, (burst * 0.7 + tail * 0.5 + thud) * _rise(times, 0.0008) * _fall(times, 0.05))


def explosion(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Noise through a low-pass that closes, over a rumble."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    noise = rng.standard_normal((frames, 2))
    bright = sosfilt(butter(2, rng.uniform(3000, 8000), fs=rate, output="sos"), noise, axis=0)
    dark = sosfilt(butter(2, rng.uniform(90, 300), fs=rate, output="sos"), noise, axis=0) * 6
    blast = bright * np.exp(-times / 0.15)[:, np.newaxis] + dark * np.exp(-times * 4 / seconds)[:, np.newaxis]
    return blast * (_rise(times, 0.002) * _fall(times, 0.1))[:, np.newaxis]


def footsteps(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Heel and toe, again and again, over the room's faint noise."""
    frames = round(seconds * rate)
    walk = 0.001 * rng.standard_normal(frames)
    for at in np.arange(0.05, seconds - 0.15, rng.uniform(0.25, 0.5)):
        for delay, loud in ((0.0, 1.0), (rng.uniform(0.04, 0.09), 0.5)):
            start = round((at + delay) * rate)
            times = np.arange(min(round(0.12 * rate), frames - start)) / rate
            step = rng.standard_normal(len(times)) * np.exp(-times / rng.uniform(0.008, 0.02)) * _rise(times, 0.001)
            walk[start : start + len(times)] += loud * lfilter([0.3], [1, -0.7], step)
    times = np.arange(frames) / rate
    return (walk * _rise(times, 0.02) * _fall(times, 0.05))[:, np.newaxis]


def laser(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A bright tone that falls, with vibrato."""
    times = np.arange(round(seconds * rate)) / rate
    high, low = rng.uniform(2000, 7000), rng.uniform(150, 700)
    hz = low + (high - low) * np.exp(-times * rng.uniform(2, 8) / seconds)
    hz *= 1 + 0.02 * np.sin(2 * np.pi * rng.uniform(4, 30) * times)
    turns = 2 * np.pi * np.cumsum(hz) / rate
    sweep = np.sin(turns) + 0.3 * np.sin(2 * turns) + 0.1 * np.sin(3 * turns)
    return _stereo(rng, sweep * np.exp(-times * 1.5 / seconds) * _rise(times, 0.002) * _fall(times, 0.03))


def rain(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Hundreds of drops a second over hiss: full of tiny transients, none of them a fault."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    drops = np.zeros((frames, 2))
    for _ in range(round(seconds * rng.uniform(150, 500))):
        at = rng.integers(0, frames)
        length = min(round(0.004 * rate), frames - at)
        ring = np.sin(2 * np.pi * rng.uniform(1500, 6000) * times[:length]) * np.exp(-times[:length] / 0.0008)
        drops[at : at + length] += ring[:, np.newaxis] * rng.pareto(2.5) * rng.uniform(0.2, 1, 2)
    hiss = 0.3 * sosfilt(butter(1, 500, "high", fs=rate, output="sos"), rng.standard_normal((frames, 2)), axis=0)
    return (drops + hiss) * (_rise(times, 0.05) * _fall(times, 0.1))[:, np.newaxis]


def voice(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Pulses of a throat through vowels, in words with pauses between them."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    hz = rng.uniform(90, 240) * (1 + 0.1 * np.sin(2 * np.pi * rng.uniform(0.5, 2) * times))
    turns = np.cumsum(hz) / rate
    pulses = np.diff(np.floor(turns), prepend=0.0)
    throat = lfilter([1], np.poly([0.98, 0.97]), pulses) + 0.02 * rng.standard_normal(frames)
    synthesize_speech = np.diff(throat, prepend=0.0)
    for centre, width in ((rng.uniform(300, 800), 80), (rng.uniform(900, 2200), 120), (rng.uniform(2400, 3200), 180)):
        radius = np.exp(-np.pi * width / rate)
        synthesize_speech = lfilter(
            [1 - radius], [1, -2 * radius * np.cos(2 * np.pi * centre / rate), radius**2], synthesize_speech
        )
    words = np.clip(np.sin(2 * np.pi * times / rng.uniform(0.6, 1.0) - 0.5) * 4, 0, 1)
    return (synthesize_speech * lfilter([0.002], [1, -0.998], words) * _rise(times, 0.02) * _fall(times, 0.05))[
        :, np.newaxis
    ]


def engine(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Harmonics of a speed that rises and falls, with noise in their rhythm."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    speed = rng.uniform(25, 70) * (1 + 0.4 * np.sin(2 * np.pi * rng.uniform(0.2, 0.6) * times))
    turns = 2 * np.pi * np.cumsum(speed) / rate
    drone = sum(np.sin(number * turns + rng.uniform(0, 6)) / number**0.8 for number in range(1, 30))
    breath = lfilter([0.3], [1, -0.7], rng.standard_normal(frames)) * (1 + np.sin(2 * turns))
    return _stereo(rng, (drone + 0.5 * breath) * _rise(times, 0.05) * _fall(times, 0.1))


def stutter(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A synthesiser chopped in rhythm by a gate with short fades: gaps that are meant."""
    sound = beep(rng, rate, seconds) + 0.1 * wind(rng, rate, seconds)[:, :1]
    times = np.arange(len(sound)) / rate
    gate = np.clip(np.sin(2 * np.pi * rng.uniform(6, 18) * times) * 40 + rng.uniform(-10, 20), 0, 1)
    gate = lfilter([0.01], [1, -0.99], gate)
    return sound * np.where(gate < 1e-3, 0, gate)[:, np.newaxis]


def square(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A chip's square wave: flat tops that are its nature."""
    times = np.arange(round(seconds * rate)) / rate
    hz = rng.uniform(80, 900)
    wave = np.where((times * hz) % 1 < rng.choice([0.125, 0.25, 0.5]), 1.0, -1.0)
    wave -= wave.mean()
    return (wave * np.exp(-times / seconds) * _rise(times, 0.003) * _fall(times, 0.01))[:, np.newaxis]


def jingle(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Short notes of few partials, one after the other, with gaps and over a soft pad: the level never rests."""
    frames = round(seconds * rate)
    times = np.arange(frames) / rate
    tune = 0.003 * _tone(rng, rng.uniform(200, 500), times)
    at = 0.02
    while at < seconds - 0.1:
        start = round(at * rate)
        note_s = rng.uniform(0.04, 0.25)
        inside = times[: min(round(note_s * rate), frames - start)]
        base = 440 * 2 ** (rng.integers(-5, 30) / 12)
        note = sum(_tone(rng, base * number, inside) / number**2 for number in range(1, 4))
        tune[start : start + len(inside)] += note * np.exp(-inside * 5 / note_s) * _rise(inside, 0.003)
        tune[start : start + len(inside)] *= 1 - 0.97 * _rise(inside - inside[-1] + 0.004, 0.004)
        at += note_s * rng.uniform(0.6, 1.6)
    return _stereo(rng, tune * _rise(times, 0.005) * _fall(times, 0.02))


def whistle(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A tone with tremolo, over breath."""
    times = np.arange(round(seconds * rate)) / rate
    hz = rng.uniform(600, 4000) * (1 + 0.03 * np.sin(2 * np.pi * rng.uniform(3, 9) * times))
    tone = np.sin(2 * np.pi * np.cumsum(hz) / rate) * (1 + 0.8 * np.sin(2 * np.pi * rng.uniform(3, 25) * times))
    breath = lfilter([1, -0.9], [1], rng.standard_normal(len(times))) * 10 ** (rng.uniform(-60, -35) / 20)
    return _stereo(rng, (tone + breath) * _rise(times, 0.03) * _fall(times, 0.05))


def drips(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Drops into water: short tones that rise, some a second, over a cave's faint noise."""
    frames = round(seconds * rate)
    cave = lfilter([0.02], [1, -0.98], rng.standard_normal(frames)) * 10 ** (rng.uniform(-50, -30) / 20)
    at = 0.03
    while at < seconds - 0.1:
        start = round(at * rate)
        inside = np.arange(min(round(rng.uniform(0.03, 0.15) * rate), frames - start)) / rate
        hz = rng.uniform(400, 2500) * (1 + rng.uniform(2, 12) * inside)
        drop = np.sin(2 * np.pi * np.cumsum(hz) / rate) * np.exp(-inside * 5 / inside[-1])
        cave[start : start + len(inside)] += rng.uniform(0.2, 1) * drop * _rise(inside, 0.002)
        at += rng.uniform(0.02, 0.3)
    times = np.arange(frames) / rate
    return _stereo(rng, cave * _rise(times, 0.02) * _fall(times, 0.05))


def knocks(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """Strokes on a hollow body that ring at a few low modes, some of them close together."""
    frames = round(seconds * rate)
    struck = np.zeros(frames)
    modes = rng.uniform(70, 220) * np.array([1.0, 1.59, 2.14, 2.65])
    at = 0.01
    while at < seconds - 0.1:
        start = round(at * rate)
        inside = np.arange(frames - start) / rate
        body = sum(_tone(rng, hz, inside) / (place + 1) for place, hz in enumerate(modes))
        slap = rng.standard_normal(len(inside)) * np.exp(-inside / 0.004)
        stroke = body * np.exp(-inside / rng.uniform(0.04, 0.12)) + 0.5 * slap
        struck[start:] += rng.uniform(0.3, 1) * stroke * _rise(inside, 0.0007)
        at += rng.uniform(0.1, 0.5)
    times = np.arange(frames) / rate
    return _stereo(rng, struck * _fall(times, 0.05))


def chirps(rng: np.random.Generator, rate: int, seconds: float) -> Samples:
    """A small animal's calls: tones that sweep fast, with gaps, over faint air."""
    frames = round(seconds * rate)
    calls = 10 ** (rng.uniform(-70, -45) / 20) * rng.standard_normal(frames)
    at = 0.02
    while at < seconds - 0.1:
        start = round(at * rate)
        inside = np.arange(min(round(rng.uniform(0.03, 0.2) * rate), frames - start)) / rate
        share = inside / inside[-1]
        hz = rng.uniform(2000, 6000) * (1 + rng.uniform(-0.4, 0.6) * share)
        hz *= 1 + rng.uniform(0, 0.1) * np.sin(2 * np.pi * rng.uniform(10, 40) * inside)
        calls[start : start + len(inside)] += (
            rng.uniform(0.3, 1) * np.sin(2 * np.pi * np.cumsum(hz) / rate) * np.sin(np.pi * share)
        )
        at += inside[-1] + rng.uniform(0.005, 0.15)
    times = np.arange(frames) / rate
    return _stereo(rng, calls * _rise(times, 0.02) * _fall(times, 0.05))


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in (
        bell,
        wind,
        beep,
        impact,
        explosion,
        footsteps,
        laser,
        rain,
        voice,
        engine,
        stutter,
        square,
        jingle,
        whistle,
        drips,
        knocks,
        chirps,
    )
}


def draw(family: Family, seed: int) -> tuple[Samples, int]:
    """One sound of a family, and its sample rate."""
    rng = np.random.default_rng([seed, sum(map(ord, family.__name__))])
    rate = int(rng.choice([44_100, 48_000, 96_000]))
    sound = family(rng, rate, float(rng.uniform(0.5, 2.5)))
    return sound / np.abs(sound).max() * 10 ** (rng.uniform(-12, -1) / 20), rate


def _tone(rng: np.random.Generator, hz: float, times: NDArray[np.float64]) -> NDArray[np.float64]:
    tone: NDArray[np.float64] = np.sin(2 * np.pi * hz * times + rng.uniform(0, 2 * np.pi))
    return tone


def _rise(times: NDArray[np.float64], seconds: float) -> NDArray[np.float64]:
    rise: NDArray[np.float64] = np.sin(np.pi / 2 * np.clip(times / seconds, 0, 1)) ** 2
    return rise


def _fall(times: NDArray[np.float64], seconds: float) -> NDArray[np.float64]:
    return _rise(times[-1] - times, seconds)


def _stereo(rng: np.random.Generator, mono: NDArray[np.float64]) -> Samples:
    """One channel, or two with the sound somewhere between them."""
    if rng.random() < 0.5:
        return mono[:, np.newaxis]
    place = rng.uniform(0.2, 0.8)
    return mono[:, np.newaxis] * np.sqrt([place, 1 - place])
