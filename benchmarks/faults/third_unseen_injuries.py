"""Faults as they come about in practice, for the sounds of `third_unseen_sounds`: unseen until looked at once."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, resample_poly, sosfilt

from benchmarks.faults.audible import WINDOW_S, heard_over_db, masked_there
from benchmarks.faults.injuries import (
    CLICK_DB,
    CLICK_UNIT,
    DRIVE_DB,
    HOLE_MS,
    HUM_DB,
    HUM_UNIT,
    SILENCE,
    Fault,
    Injured,
    driven,
    hum_over,
    levels_around,
    mid_wave,
    noise_for,
    place_in_sound,
    scaled_to,
    sharpness,
    with_noise,
)
from benchmarks.faults.sounds import Samples

TRIES = 40
FADED_MS = HOLE_MS[1:]  # of silence: with fades next to it a shorter one is hardly audible
CUT_DB = (-34.0,)
CUT_UNIT = "dB under the peak or louder"
OFFSET_PERCENT = (1.1, 2.0, 5.0)
FLOOR_DBFS = (-58.0, -50.0, -40.0)
GRID = 0.004  # the mains stay within 0.2 Hz of 50 Hz


def _overwritten(
    rng: np.random.Generator, samples: Samples, rate: int, level_db: float, block: Callable[[int], Samples]
) -> Injured | None:
    """The sound with a tenth to a whole millisecond of it overwritten, in one channel or all, by what `block` gives.

    It exceeds the sound by so much, by less than 12 dB more, and sharply.
    """
    around, peak, reach = levels_around(samples, rate), np.abs(samples).max(), round(2 * WINDOW_S * rate)
    one = int(rng.integers(0, samples.shape[1]))
    channels = slice(one, one + 1) if rng.random() < 0.4 else slice(None)
    for _ in range(TRIES):
        length = round(rng.uniform(0.0001, 0.001) * rate)
        at = place_in_sound(rng, samples, rate, length, around)
        if at is None:
            return None
        near, middle = samples[at - reach : at + reach], reach + length // 2  # no more is needed for the level
        tried = near.copy()
        tried[reach : reach + length, channels] = block(length)[:, channels]
        if sharpness((tried - near)[reach - 6 : reach + length + 6]) <= peak * 0.01:
            continue
        if level_db <= heard_over_db(tried, masked_there(near, middle, rate), middle, rate) < level_db + 12:
            faulty = samples.copy()
            faulty[at : at + length] = tried[reach : reach + length]
            return Injured(faulty, at / rate, (at + length) / rate)
    return None


def _lost_samples(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A digital line that loses its lock for less than a millisecond: zeros stand where samples should be."""
    return _overwritten(rng, samples, rate, level_db, lambda length: np.zeros((length, samples.shape[1])))


def _wrong_block(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A plug-in that hands over the wrong buffer once: a short block from elsewhere in the sound overwrites its own."""

    def block(length: int) -> Samples:
        first = int(rng.integers(0, len(samples) - length))
        return samples[first : first + length]

    return _overwritten(rng, samples, rate, level_db, block)


def _relay(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A relay or a light switch on the mains: its spark, through an input's low cut and its guard against radio."""
    length = round(0.003 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    spark = np.zeros(length)
    spark[0] = rng.choice([-1.0, 1.0])
    guard = butter(2, rng.uniform(3_000, 9_000), fs=rate, output="sos")
    heard = sosfilt(butter(1, rng.uniform(200, 1_000), "high", fs=rate, output="sos"), sosfilt(guard, spark))
    heard *= np.clip(np.arange(length)[::-1] / (0.001 * rate), 0, 1)
    shape = np.zeros_like(samples)
    sides = np.array([1.0, rng.uniform(0.5, 1)])[: samples.shape[1]]
    shape[at : at + length] = (heard / np.abs(heard).max())[:, np.newaxis] * sides
    faulty = scaled_to(samples, shape, at + int(np.abs(heard).argmax()), rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, (at + length) / rate)


def _faded_hole(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A gap that a repair tool smoothed: silence of this length, with a fade of 1 to 3 ms before it and after it."""
    length, fade = round(length_ms / 1000 * rate), round(rng.uniform(0.001, 0.003) * rate)
    at = place_in_sound(rng, samples, rate, length + 2 * fade)
    if at is None:
        return None
    down = 0.5 + 0.5 * np.cos(np.pi * np.arange(fade) / fade)
    faulty = samples.copy()
    end = at + length + 2 * fade
    faulty[at:end] *= np.concatenate((down, np.zeros(length), down[::-1]))[:, np.newaxis]
    return Injured(faulty, at / rate, end / rate)


def _wireless(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A wireless microphone out of reach: its receiver hisses instead of the sound, 30 to 50 dB under it."""
    around = levels_around(samples, rate)
    length = round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length, around)
    if at is None:
        return None
    level = min(around[0][at], around[1][at + length]) * 10 ** (-rng.uniform(30, 50) / 20)
    faulty = samples.copy()
    faulty[at : at + length] = level * rng.standard_normal((length, samples.shape[1]))
    return Injured(faulty, at / rate, (at + length) / rate)


def _overload(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A computer with too much to do: two to four holes of this length in a row, 3 to 15 ms of the sound between."""
    length, count = round(length_ms / 1000 * rate), int(rng.integers(2, 5))
    between = np.round(rng.uniform(0.003, 0.015, count - 1) * rate).astype(int)
    starts = np.concatenate(([0], np.cumsum(between + length)))
    whole = int(starts[-1]) + length
    at = place_in_sound(rng, samples, rate, whole)
    if at is None:
        return None
    faulty = samples.copy()
    for start in at + starts:
        faulty[start : start + length] = 0.0
    return Injured(faulty, at / rate, (at + whole) / rate)


def _pause(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    return np.zeros((round(rng.uniform(0.005, 0.3) * rate), samples.shape[1]))


def _channel_strip(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    """A low cut at 20 to 60 Hz, and highs that fall by 3 dB at 12 to 18 kHz."""
    cut = sosfilt(butter(1, rng.uniform(20, 60), "high", fs=rate, output="sos"), samples, axis=0)
    rounded: Samples = sosfilt(butter(1, rng.uniform(12_000, 18_000), fs=rate, output="sos"), cut, axis=0)
    return rounded / max(1.0, np.abs(rounded).max())


def _equalised_start(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A clip trimmed too tight, then sent through a channel strip's gentle filters."""
    at = mid_wave(rng, samples, rate)
    return None if at is None else Injured(_channel_strip(rng, samples[at:], rate), 0.0, 0.0)


def _equalised_tail(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A clip trimmed too tight, then sent through a channel strip's gentle filters, which ring out in the silence."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    cut = np.concatenate((samples[: at + 1], _pause(rng, samples, rate)))
    return Injured(_channel_strip(rng, cut, rate), at / rate, at / rate)


def _short_ramp(rng: np.random.Generator, rate: int) -> Samples:
    """A ramp of 0.05 to 0.2 ms from nothing: too short for the ear."""
    length = max(2, round(rng.uniform(0.00005, 0.0002) * rate))
    return (np.arange(length) / length)[:, np.newaxis]


def _ramped_start(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A clip trimmed too tight in an editor whose own fade at an edge is a few samples long; at times after silence."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    ramp = _short_ramp(rng, rate)
    wait = _pause(rng, samples, rate) if rng.random() < 0.5 else samples[:0]
    cut = np.concatenate((wait, ramp * samples[at - len(ramp) : at], samples[at:]))
    return Injured(cut, len(wait) / rate, (len(wait) + len(ramp)) / rate)


def _ramped_tail(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A voice choked by the next one within a few samples; at times silence follows."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    ramp = _short_ramp(rng, rate)
    rest = _pause(rng, samples, rate) if rng.random() < 0.5 else samples[:0]
    cut = np.concatenate((samples[: at + 1], ramp[::-1] * samples[at + 1 : at + 1 + len(ramp)], rest))
    return Injured(cut, at / rate, (at + len(ramp)) / rate)


def _other_side_faded(rng: np.random.Generator, samples: Samples, rate: int, cut: slice, down: bool) -> Samples:
    """This part of the sound, with a fade of 20 to 60 ms at its cut end in one channel only."""
    part = samples[cut].copy()
    share = np.clip(np.arange(len(part)) / (rng.uniform(0.02, 0.06) * rate), 0, 1)
    part[:, int(rng.integers(0, 2))] *= share[::-1] if down else share
    return part


def _highest_side(samples: Samples, at: int, part: Samples, edge: int, rate: int) -> bool:
    """Whether the channel that has no fade is the one high on its wave: else there is no cut to hear."""
    width = round(0.01 * rate)
    near = np.abs(samples[at - width : at + width]).max(axis=0)
    height = np.abs(part[edge])
    return bool((height > 0.3 * near.max()).any())


def _start_on_one_side(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Two mono tracks of a stereo pair trimmed too tight, of which only one was given its fade."""
    for _ in range(TRIES if samples.shape[1] == 2 else 0):
        at = mid_wave(rng, samples, rate)
        if at is None:
            return None
        part = _other_side_faded(rng, samples, rate, slice(at, None), down=False)
        if _highest_side(samples, at, part, 0, rate):
            return Injured(part, 0.0, 0.0)
    return None


def _tail_on_one_side(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Two mono tracks of a stereo pair trimmed too tight at their end, of which only one was given its fade."""
    for _ in range(TRIES if samples.shape[1] == 2 else 0):
        at = mid_wave(rng, samples, rate)
        if at is None:
            return None
        part = _other_side_faded(rng, samples, rate, slice(None, at + 1), down=True)
        if _highest_side(samples, at, part, -1, rate):
            return Injured(part, at / rate, at / rate)
    return None


def _low_cut(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A converter that was overloaded; a low cut at 10 to 30 Hz makes its flat tops lean, and the whole is lowered."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    coupling = butter(1, rng.uniform(10, 30), "high", fs=rate, output="sos")
    leaning = sosfilt(coupling, np.clip(loud, -1, 1), axis=0)
    return Injured(leaning * rng.uniform(0.3, 0.95) / np.abs(leaning).max(), 0.0, len(samples) / rate)


def _resampled(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """Clipped in a session at twice the sample rate; the converter's steep filter leaves ripples on the flat tops."""
    if driven(samples, drive_db) is None:
        return None
    loud = resample_poly(samples / np.abs(samples).max() * 10 ** (drive_db / 20), 2, 1, axis=0)
    heard = resample_poly(np.clip(loud, -1, 1), 1, 2, axis=0)
    return Injured(heard * rng.uniform(0.3, 0.95) / np.abs(heard).max(), 0.0, len(samples) / rate)


def _ridden(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A clipped recording whose volume was ridden by hand: 2 to 6 dB up and down, so that no two tops are as high."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    times = np.arange(len(samples)) / rate
    course = np.sin(2 * np.pi * (rng.uniform(0.4, 1.2) * times + rng.random()))
    ridden = np.clip(loud, -1, 1) * 10 ** (rng.uniform(1, 3) * course / 20)[:, np.newaxis]
    return Injured(ridden * rng.uniform(0.3, 0.95) / np.abs(ridden).max(), 0.0, len(samples) / rate)


def _offset_by(samples: Samples, offset: NDArray[np.float64]) -> Injured | None:
    faulty: Samples = 0.9 * (samples - samples.mean(axis=0)) + offset
    return None if np.abs(faulty).max() > 1 else Injured(faulty, 0.0, 0.0)


def _faded_offset(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """An interface's bias in a recording that was faded afterwards, at 10 to 100 ms: so much off in the mean."""
    frames = np.arange(len(samples)) / rate
    rise_s, fall_s = rng.uniform(0.01, 0.1, 2)
    fades = np.clip(frames / rise_s, 0, 1) * np.clip((frames[-1] - frames) / fall_s, 0, 1)
    offset = rng.choice([-1, 1]) * percent / 100 * fades / fades.mean()
    faulty = _offset_by(samples, offset[:, np.newaxis])
    return None if faulty is None else faulty._replace(end_s=len(samples) / rate)


def _two_interfaces(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """Two takes, of an interface with a bias and of one with less, crossfaded in 20 to 80 ms; so much in the mean."""
    times = np.arange(len(samples)) / rate
    over = np.clip((times - rng.uniform(0.3, 0.7) * times[-1]) / rng.uniform(0.02, 0.08), 0, 1)
    course = 1 - rng.uniform(0.4, 0.8) * (over if rng.random() < 0.5 else 1 - over)
    offset = rng.choice([-1, 1]) * percent / 100 * course / course.mean()
    faulty = _offset_by(samples, offset[:, np.newaxis])
    return None if faulty is None else faulty._replace(end_s=len(samples) / rate)


def _in_channels(rng: np.random.Generator, samples: Samples, rate: int, hummed: Samples | None) -> Injured | None:
    """The hum that was put on top, slowly up and down by 2 dB, and up to 10 dB weaker in one channel of two."""
    if hummed is None:
        return None
    times = np.arange(len(samples)) / rate
    slow = 10 ** (2 * np.sin(2 * np.pi * (rng.uniform(0.1, 0.4) * times + rng.random())) / 20)
    slow /= slow.mean()
    gains = rng.permutation([1.0, 10 ** (-rng.uniform(0, 10) / 20)])[: samples.shape[1]]
    faulty = samples + (hummed - samples) * slow[:, np.newaxis] * gains / gains.max()
    return None if np.abs(faulty).max() > 1 else Injured(faulty, 0.0, len(samples) / rate)


def _ground_loop(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Two devices earthed twice: the mains and ten multiples, the odd ones above the even, each higher one weaker."""
    multiples = np.arange(1, 12)
    weights = rng.uniform(0.7, 1, 11) * np.where(multiples % 2, 1, rng.uniform(0.2, 0.5)) / multiples**0.8
    return _in_channels(rng, samples, rate, hum_over(rng, samples, rate, level_db, multiples, weights, GRID))


def _pickup(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A coil near a power transformer: twice the mains loudest, the mains under it, and weaker multiples up to six."""
    weights = np.array([0.5, 1, 0.35, 0.5, 0.2, 0.3]) * rng.uniform(0.7, 1.3, 6)
    return _in_channels(rng, samples, rate, hum_over(rng, samples, rate, level_db, np.arange(1, 7), weights, GRID))


def _thin_buzz(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A broken shield's buzz into a recorder whose low cut, at 120 to 200 Hz, took most of its lowest lines."""
    multiples = np.arange(1, 17)
    low = np.square(multiples * 55 / rng.uniform(120, 200))
    weights = rng.uniform(0.6, 1, 16) * low / np.sqrt(1 + low**2) / np.sqrt(multiples)
    return _in_channels(rng, samples, rate, hum_over(rng, samples, rate, level_db, multiples, weights, GRID))


def _fan(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A laptop next to the microphone: its fan's rush below some kilohertz, and the whine of the blades in it."""
    white = noise_for(rng, samples, rate)
    rush = sosfilt(butter(1, rng.uniform(1_000, 3_000), fs=rate, output="sos"), white, axis=0)
    rush = sosfilt(butter(1, 100, "high", fs=rate, output="sos"), rush, axis=0)
    times = np.arange(len(white)) / rate
    turns = rng.uniform(350, 900) * (times + 0.002 * np.sin(2 * np.pi * rng.uniform(0.3, 1) * times))
    whine = np.sin(2 * np.pi * turns) + 0.4 * np.sin(4 * np.pi * turns + rng.uniform(0, 6))
    share = rng.uniform(0.1, 0.5) * rush.std()
    return with_noise(samples, rush + share * whine[:, np.newaxis], rate, floor_dbfs)


def _duct(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """An air duct in the ceiling: a rumble between 50 and some 500 Hz, with a little air at its grille."""
    white = noise_for(rng, samples, rate)
    band = butter(1, [50, rng.uniform(350, 700)], "band", fs=rate, output="sos")
    rumble = sosfilt(band, white, axis=0)
    return with_noise(samples, rumble + 0.1 * rumble.std() * rng.standard_normal(white.shape), rate, floor_dbfs)


def _too_few_steps(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """Recorded far too low, with dither, and raised: what is noise has but a few steps."""
    placed = with_noise(samples, noise_for(rng, samples, rate), rate, floor_dbfs)
    if placed is None:
        return None
    loud = samples / (np.abs(samples).max() + SILENCE) * 0.7
    whole = np.concatenate((loud, np.zeros((rate // 2, samples.shape[1])), loud))
    step = 2 * 10 ** (floor_dbfs / 20)  # triangular dither and rounding add half a step of noise
    dither = rng.random(whole.shape) - rng.random(whole.shape)
    return placed._replace(samples=np.round(whole / step + dither) * step)


FAULTS: tuple[Fault, ...] = (
    Fault("click", "samples lost to zeros", CLICK_DB, CLICK_UNIT, _lost_samples),
    Fault("click", "wrong block", CLICK_DB, CLICK_UNIT, _wrong_block),
    Fault("click", "spark of a relay", CLICK_DB, CLICK_UNIT, _relay),
    Fault("dropout", "hole with fades beside it", FADED_MS, "ms", _faded_hole),
    Fault("dropout", "hiss instead of the sound", HOLE_MS, "ms", _wireless),
    Fault("dropout", "several holes in a row", HOLE_MS, "ms", _overload),
    Fault("cut-start", "cut, then equalised", CUT_DB, CUT_UNIT, _equalised_start),
    Fault("cut-start", "cut, with a ramp too short", CUT_DB, CUT_UNIT, _ramped_start),
    Fault("cut-start", "cut, one channel faded", CUT_DB, CUT_UNIT, _start_on_one_side),
    Fault("cut-tail", "cut, then equalised", CUT_DB, CUT_UNIT, _equalised_tail),
    Fault("cut-tail", "cut, with a ramp too short", CUT_DB, CUT_UNIT, _ramped_tail),
    Fault("cut-tail", "cut, one channel faded", CUT_DB, CUT_UNIT, _tail_on_one_side),
    Fault("clipping", "clipped, then low cut", DRIVE_DB, "dB over", _low_cut),
    Fault("clipping", "clipped, then resampled", DRIVE_DB, "dB over", _resampled),
    Fault("clipping", "clipped, then ridden", DRIVE_DB, "dB over", _ridden),
    Fault("dc-offset", "faded with the sound", OFFSET_PERCENT, "%", _faded_offset),
    Fault("dc-offset", "two interfaces", OFFSET_PERCENT, "%", _two_interfaces),
    Fault("hum", "ground loop", HUM_DB, HUM_UNIT, _ground_loop),
    Fault("hum", "coil near a transformer", HUM_DB, HUM_UNIT, _pickup),
    Fault("hum", "buzz through a low cut", HUM_DB, HUM_UNIT, _thin_buzz),
    Fault("noise-floor", "fan of a laptop", FLOOR_DBFS, "dBFS", _fan),
    Fault("noise-floor", "air duct", FLOOR_DBFS, "dBFS", _duct),
    Fault("noise-floor", "too few steps", FLOOR_DBFS, "dBFS", _too_few_steps),
)
