"""Faults put into whole sounds, each at a stated level, for tuning detectors."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, resample_poly, sosfilt

from benchmarks.faults.audible import WINDOW_S, excess_db, heard_over_db, masked_there
from benchmarks.faults.sounds import Samples

SILENCE = 1e-9


class Injured(NamedTuple):
    """A sound with one fault in it, from when to when."""

    samples: Samples
    start_s: float
    end_s: float


Levels = tuple[NDArray[np.float64], NDArray[np.float64]]
Injure = Callable[[np.random.Generator, Samples, int, float], Injured | None]
"""Puts one fault into a sound at a level; None where the sound has no place for it."""


class Fault(NamedTuple):
    """A kind of fault: the check that finds it, the levels at which it is tried, and their unit."""

    check: str
    name: str
    levels: tuple[float, ...]
    unit: str
    injure: Injure


CLICK_DB = (6.0, 12.0, 20.0, 30.0)
CLICK_UNIT = "dB over the sound"
HOLE_MS = (2.0, 5.0, 20.0, 60.0)
BUFFER_FRAMES = (128.0, 512.0, 1024.0, 2048.0)
DRIVE_DB = (3.0, 6.0, 12.0)
HUM_DB = (0.0, 6.0, 12.0)
HUM_UNIT = "dB over the sound's quiet quarter"


def levels_around(samples: Samples, rate: int) -> Levels:
    """RMS of the loudest channel in the 10 ms before each frame, and after it."""
    width = round(0.01 * rate)
    sums = np.concatenate((np.zeros((1, samples.shape[1])), np.cumsum(np.square(samples), axis=0)))
    means = (sums[width:] - sums[:-width]) / width
    level = np.sqrt(np.maximum(means.max(axis=1), 0)) + SILENCE
    before, after = np.full(len(samples), SILENCE), np.full(len(samples), SILENCE)
    before[width - 1 :] = level
    after[: len(level)] = level
    return before, after


def place_in_sound(
    rng: np.random.Generator, samples: Samples, rate: int, length: int = 0, around: Levels | None = None
) -> int | None:
    """A frame where a sound goes on: as loud, within 10 dB, before it as after it and `length` frames more.

    Repeated callers pass the levels `around` each frame.
    """
    before, after = around or levels_around(samples, rate)
    if length:
        after = np.concatenate((after[length:], np.full(min(length, len(after)), SILENCE)))
    loud = np.abs(samples).max() * 10 ** (-35 / 20)
    wanted = (before > loud) & (after > loud) & (np.abs(20 * np.log10(before / after)) < 10)
    edge = round(0.04 * rate)
    wanted[:edge] = wanted[max(0, len(wanted) - edge - length) :] = False
    places = np.flatnonzero(wanted)
    return int(rng.choice(places)) if len(places) else None


def sharpness(shape: Samples) -> float:
    """How sharp a shape is: as a single sample of this height."""
    return float(np.abs(np.diff(shape, n=6, axis=0)).max() / 20)


def scaled_to(samples: Samples, shape: Samples, at: int, rate: int, level_db: float) -> Samples | None:
    """The sound with `shape` added, so that it exceeds the sound by so much.

    It is as sharp as a single sample 40 dB under the sound's peak, or sharper.
    """
    low, high = -90.0, 0.0
    first = max(0, at - round(2 * WINDOW_S * rate))
    heard = slice(first, at + round(2 * WINDOW_S * rate))  # no more is needed for the level
    masked = masked_there(samples[heard], at - first, rate)
    for _ in range(14):
        middle = (low + high) / 2
        tried = samples[heard] + shape[heard] * 10 ** (middle / 20)
        if heard_over_db(tried, masked, at - first, rate) < level_db:
            low = middle
        else:
            high = middle
    peak_db = 20 * np.log10(np.abs(samples).max() / sharpness(shape))
    faulty = samples + shape * 10 ** (max(high, peak_db - 40) / 20)
    if excess_db(faulty, samples, at, rate) < level_db - 0.5 or np.abs(faulty).max() > 1:
        return None
    return faulty


def _in_one_or_all(rng: np.random.Generator, shape: NDArray[np.float64], channels: int) -> Samples:
    spread = np.repeat(shape[:, np.newaxis], channels, axis=1)
    if rng.random() < 0.5:
        spread[:, 1:] = 0.0
    return spread


def _one_sample(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros(len(samples))
    shape[at] = rng.choice([-1.0, 1.0])
    faulty = scaled_to(samples, _in_one_or_all(rng, shape, samples.shape[1]), at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, at / rate)


def _tick(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A few cycles at 4 to 12 kHz that die away within a third of a millisecond."""
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros(len(samples))
    times = np.arange(round(0.001 * rate)) / rate
    ring = np.cos(2 * np.pi * rng.uniform(4_000, 12_000) * times) * np.exp(-times / rng.uniform(5e-5, 1e-4))
    shape[at : at + len(ring)] = ring[: len(shape) - at]
    faulty = scaled_to(samples, _in_one_or_all(rng, shape, samples.shape[1]), at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, at / rate)


def _step(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros(len(samples))
    shape[at:] = rng.choice([-1.0, 1.0]) * np.exp(-np.arange(len(samples) - at) / (0.02 * rate))
    faulty = scaled_to(samples, _in_one_or_all(rng, shape, samples.shape[1]), at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, at / rate)


def _pop(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A round pulse of a tenth to half a millisecond, without a corner."""
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros(len(samples))
    pulse = np.hanning(round(rng.uniform(1e-4, 5e-4) * rate) + 2)
    first = at - len(pulse) // 2
    shape[first : first + len(pulse)] = rng.choice([-1.0, 1.0]) * pulse
    faulty = scaled_to(samples, _in_one_or_all(rng, shape, samples.shape[1]), at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, at / rate)


def _any_pulse(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A pulse that imitates nothing: up to a millisecond of noise, rung through a filter drawn at random."""
    for _ in range(4):
        at = place_in_sound(rng, samples, rate)
        if at is None:
            return None
        length = max(2, round(np.exp(rng.uniform(np.log(4e-5), np.log(8e-4))) * rate))
        fade = np.hanning(length + 2)[1:-1] if rng.random() < 0.5 else np.exp(-4 * np.arange(length) / length)
        corner_hz = np.exp(rng.uniform(np.log(700), np.log(16_000)))
        ring = np.append(rng.standard_normal(length) * fade, np.zeros(round(0.002 * rate)))
        ring = sosfilt(butter(rng.integers(1, 4), corner_hz, fs=rate, output="sos"), ring)
        if rng.random() < 0.4:
            ring = sosfilt(butter(1, corner_hz * rng.uniform(0.2, 0.8), "high", fs=rate, output="sos"), ring)
        ring[-(rate // 1000) :] *= np.linspace(1, 0, rate // 1000)
        shape = np.zeros(len(samples))
        shape[at : at + len(ring)] = ring[: len(shape) - at]
        highest = int(np.abs(shape).argmax())
        spread = _in_one_or_all(rng, shape / np.abs(shape[highest]), samples.shape[1])
        faulty = scaled_to(samples, spread, highest, rate, level_db)
        if faulty is not None:
            return Injured(faulty, highest / rate, highest / rate)
    return None


def _garbled(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Two to eight samples in the wrong order."""
    around = levels_around(samples, rate)
    for _ in range(40):
        at, length = place_in_sound(rng, samples, rate, around=around), int(rng.integers(2, 9))
        if at is None:
            return None
        faulty = samples.copy()
        faulty[at : at + length] = samples[at : at + length][::-1]
        exceeds = excess_db(faulty, samples, at, rate)
        sharp = sharpness((faulty - samples)[at - 6 : at + 14]) > np.abs(samples).max() * 0.01
        if level_db <= exceeds < level_db + 12 and sharp:
            return Injured(faulty, at / rate, at / rate)
    return None


def joint_exceeds(joined: Samples, samples: Samples, at: int, goes_on: int, rate: int, level_db: float) -> bool:
    """Whether a joint at frame `at`, after which the sound goes on from another frame of it, is a click of this level.

    It exceeds the sound on either side by so much, and by less than 12 dB more.
    """
    reach = round(1.6 * WINDOW_S * rate)  # no more is needed for the level
    near = joined[at - reach : at + reach]
    both = [excess_db(near, samples[one - reach : one + reach], reach, rate) for one in (at, goes_on)]
    sharp = sharpness(joined[at - 6 : at + 6]) > np.abs(samples).max() * 0.01
    return sharp and min(both) >= level_db and max(both) < level_db + 12


def _splice(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    around = levels_around(samples, rate)
    for _ in range(40):
        length = round(rng.uniform(0.001, 0.02) * rate)
        at = place_in_sound(rng, samples, rate, length, around)
        if at is None:
            return None
        spliced = np.delete(samples, slice(at, at + length), axis=0)
        if joint_exceeds(spliced, samples, at, at + length, rate, level_db):
            return Injured(spliced, at / rate, at / rate)
    return None


def _zeros(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    length = round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    faulty = samples.copy()
    faulty[at : at + length] = 0.0
    return Injured(faulty, at / rate, (at + length) / rate)


def _held(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    length = round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    faulty = samples.copy()
    faulty[at : at + length] = samples[at - 1]
    return Injured(faulty, at / rate, (at + length) / rate)


def _repeated(rng: np.random.Generator, samples: Samples, rate: int, frames: float) -> Injured | None:
    length = int(frames)
    at = place_in_sound(rng, samples, rate, length)
    if at is None or at < length:
        return None
    faulty = samples.copy()
    faulty[at : at + length] = samples[at - length : at]
    return Injured(faulty, at / rate, (at + length) / rate)


def mid_wave(rng: np.random.Generator, samples: Samples, rate: int) -> int | None:
    """A frame that lies high on its wave: three tenths of what is largest within 10 ms either way."""
    sizes = np.abs(samples).max(axis=1)
    width = round(0.01 * rate)
    near = sizes.copy()
    reach = 1
    while reach < width:
        near[reach:] = np.maximum(near[reach:], near[:-reach])
        near[:-reach] = np.maximum(near[:-reach], near[reach:])
        reach *= 2
    wanted = (sizes > 0.3 * near) & (near > sizes.max() * 10 ** (-34 / 20))
    wanted[: 2 * width] = wanted[-2 * width :] = False
    places = np.flatnonzero(wanted)
    return int(rng.choice(places)) if len(places) else None


def _start(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    at = mid_wave(rng, samples, rate)
    return None if at is None else Injured(samples[at:], 0.0, 0.0)


def _tail(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    at = mid_wave(rng, samples, rate)
    return None if at is None else Injured(samples[: at + 1], at / rate, at / rate)


def driven(samples: Samples, drive_db: float) -> Samples | None:
    """The sound so loud that its peak lies over full scale, where that cuts off five crests for three samples each."""
    loud = samples / np.abs(samples).max() * 10 ** (drive_db / 20)
    over = np.abs(loud) >= 1
    runs = over[2:] & over[1:-1] & over[:-2]
    starts = runs & ~np.concatenate((np.zeros((1, samples.shape[1]), dtype=bool), runs[:-1]))
    return loud if starts.sum() >= 5 else None


def _clipped(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    loud = driven(samples, drive_db)
    return None if loud is None else Injured(np.clip(loud, -1, 1 - 2**-23), 0.0, len(samples) / rate)


def _lowered(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    return Injured(np.clip(loud, -1, 1) * 10 ** (rng.uniform(-12, -0.5) / 20), 0.0, len(samples) / rate)


def _resampled(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """Clipped in a session at twice the sample rate; the converter's steep filter leaves ripples on the flat tops."""
    if driven(samples, drive_db) is None:
        return None
    loud = resample_poly(samples / np.abs(samples).max() * 10 ** (drive_db / 20), 2, 1, axis=0)
    heard = resample_poly(np.clip(loud, -1, 1), 1, 2, axis=0)
    return Injured(heard * rng.uniform(0.3, 0.95) / np.abs(heard).max(), 0.0, len(samples) / rate)


def _shifted(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    centred = samples - samples.mean(axis=0)
    return Injured(0.9 * centred + rng.choice([-1, 1]) * percent / 100, 0.0, len(samples) / rate)


def quiet_bands(samples: Samples, rate: int, hz: NDArray[np.float64]) -> NDArray[np.float64]:
    """Power of the sound in the 100 Hz around each frequency, in the quietest quarter of its tenths of a second."""
    width = round(0.1 * rate)
    windows = samples[: len(samples) // width * width].reshape(-1, width, samples.shape[1])
    power = np.square(np.abs(np.fft.rfft(windows * np.hanning(width)[:, np.newaxis], axis=1))) * (16 / 3) / width**2
    bins = np.fft.rfftfreq(width, 1 / rate)
    bands = [power[:, np.abs(bins - one) <= 50].sum(axis=1).max(axis=1) for one in hz]
    return np.quantile(np.array(bands), 0.25, axis=1)


def hum_over(
    rng: np.random.Generator,
    samples: Samples,
    rate: int,
    level_db: float,
    multiples: NDArray[np.int64],
    weights: NDArray[np.float64],
    off: float = 0.002,
) -> Samples | None:
    """The sound with hum whose lines, three of them at least, are so far over the sound's level next to them.

    The mains are up to the share `off` away from 50 or 60 Hz.
    """
    if len(samples) < 1.2 * rate:
        return None
    lines = rng.choice([50.0, 60.0]) * (1 + rng.uniform(-off, off)) * multiples
    wanted = np.sqrt(2 * (quiet_bands(samples, rate, lines) + 1e-12)) * 10 ** (level_db / 20)
    height = max(float(np.sort(wanted / weights)[2]), 10 ** (-50 / 20))  # of a line of weight 1
    times = np.arange(len(samples)) / rate
    hum = sum(
        height * weight * np.sin(2 * np.pi * line * times + rng.uniform(0, 6))
        for line, weight in zip(lines, weights, strict=True)
    )
    faulty: Samples = samples + np.asarray(hum)[:, np.newaxis]
    return None if np.abs(faulty).max() > 1 else faulty


def _hum(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    multiples = np.arange(1, 7)
    faulty = hum_over(rng, samples, rate, level_db, multiples, rng.uniform(0.3, 1, 6) / multiples)
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _buzz(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Three or four multiples, no two sounds the same ones; in one channel of two at times."""
    multiples = np.sort(np.append(rng.integers(1, 4), rng.permutation(np.arange(4, 9))[: rng.integers(2, 4)]))
    faulty = hum_over(rng, samples, rate, level_db, multiples, rng.uniform(0.3, 1, len(multiples)))
    if faulty is None:
        return None
    if rng.random() < 0.5:
        faulty[:, 1:] = samples[:, 1:]
    return Injured(faulty, 0.0, len(samples) / rate)


def _neutral(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A neutral that carries what three phases of dimmers leave: the third multiple and its own odd ones."""
    faulty = hum_over(rng, samples, rate, level_db, np.array([1, 3, 9, 15]), rng.uniform(0.4, 1, 4))
    if faulty is None:
        return None
    if rng.random() < 0.5:
        faulty[:, 1:] = samples[:, 1:]
    return Injured(faulty, 0.0, len(samples) / rate)


def with_noise(samples: Samples, noise: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """The sound twice, half a second between, over noise; where its loudest 0.2 s lies 15 dB over the noise."""
    loud = samples / np.abs(samples).max() * 0.7
    whole = np.concatenate((loud, np.zeros((rate // 2, samples.shape[1])), loud))
    before, _ = levels_around(whole, 20 * rate)  # 20 times 10 ms
    if 20 * np.log10(before.max()) < floor_dbfs + 15:
        return None
    noise = noise[: len(whole)]
    return Injured(whole + noise / noise.std() * 10 ** (floor_dbfs / 20), 0.0, len(whole) / rate)


def noise_for(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    """White noise, as long as a sound that comes twice."""
    return rng.standard_normal((2 * len(samples) + rate // 2, samples.shape[1]))


def _noisy(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    return with_noise(samples, noise_for(rng, samples, rate), rate, floor_dbfs)


FAULTS = (
    Fault("click", "one sample", CLICK_DB, CLICK_UNIT, _one_sample),
    Fault("click", "tick", CLICK_DB, CLICK_UNIT, _tick),
    Fault("click", "step", CLICK_DB, CLICK_UNIT, _step),
    Fault("click", "splice", CLICK_DB, CLICK_UNIT, _splice),
    Fault("dropout", "zeros", HOLE_MS, "ms", _zeros),
    Fault("dropout", "held sample", HOLE_MS, "ms", _held),
    Fault("dropout", "repeated buffer", BUFFER_FRAMES, "frames", _repeated),
    Fault("cut-start", "cut in mid-wave", (-34.0,), "dB under the peak or louder", _start),
    Fault("cut-tail", "cut in mid-wave", (-34.0,), "dB under the peak or louder", _tail),
    Fault("clipping", "at full scale", DRIVE_DB, "dB over", _clipped),
    Fault("clipping", "at full scale, then lowered", DRIVE_DB, "dB over", _lowered),
    Fault("dc-offset", "shifted", (1.1, 2.0, 5.0), "%", _shifted),
    Fault("hum", "six multiples", HUM_DB, HUM_UNIT, _hum),
    Fault("noise-floor", "hiss", (-58.0, -50.0, -40.0), "dBFS", _noisy),
    Fault("click", "pop", CLICK_DB, CLICK_UNIT, _pop),
    Fault("click", "samples in the wrong order", CLICK_DB, CLICK_UNIT, _garbled),
    Fault("hum", "three or four multiples", HUM_DB, HUM_UNIT, _buzz),
    Fault("click", "pulse of any shape", CLICK_DB, CLICK_UNIT, _any_pulse),
    Fault("clipping", "clipped, then resampled", DRIVE_DB, "dB over", _resampled),
    Fault("hum", "multiples of three", HUM_DB, HUM_UNIT, _neutral),
)
