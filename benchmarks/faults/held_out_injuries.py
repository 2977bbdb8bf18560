"""Faults as studios, drivers and editors make them, for the held-out sounds: no detector was tuned on them."""

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
    levels_around,
    mid_wave,
    place_in_sound,
    quiet_bands,
    scaled_to,
    sharpness,
)
from benchmarks.faults.sounds import Samples

TRIES = 40
ASIO_FRAMES = (64.0, 441.0, 960.0, 2048.0)  # as drivers offer them, powers of two or so many milliseconds
CUT_DB = (-34.0,)
CUT_UNIT = "dB under the peak or louder"
OFFSET_PERCENT = (1.1, 2.0, 5.0)
FLOOR_DBFS = (-58.0, -50.0, -40.0)
MP3_FRAMES = 1152


def _whole(samples: Samples, rate: int) -> Injured:
    """A sound whose fault lasts as long as it does."""
    return Injured(samples, 0.0, len(samples) / rate)


def _one_or_all(rng: np.random.Generator, samples: Samples) -> slice:
    one = int(rng.integers(0, samples.shape[1]))
    return slice(one, one + 1) if rng.random() < 0.4 else slice(None)


def _dithered(rng: np.random.Generator, samples: Samples, bits: int) -> Samples:
    steps = 2 ** (bits - 1)
    dither = rng.random(samples.shape) - rng.random(samples.shape)
    return np.clip(np.round(samples * steps + dither) / steps, -1, 1 - 1 / steps)


def _replaced(
    rng: np.random.Generator,
    samples: Samples,
    rate: int,
    level_db: float,
    longest_s: float,
    ways: Callable[[Samples], Samples],
) -> Injured | None:
    """The sound with a moment of it redrawn, in one channel or all, from itself and one frame on either side.

    It exceeds the sound by so much, by less than 12 dB more, and sharply.
    """
    around, peak, reach = levels_around(samples, rate), np.abs(samples).max(), round(2 * WINDOW_S * rate)
    channels = _one_or_all(rng, samples)
    for _ in range(TRIES):
        length = round(rng.uniform(0.0001, longest_s) * rate)
        at = place_in_sound(rng, samples, rate, length, around)
        if at is None:
            return None
        near, middle = samples[at - reach : at + reach], reach + length // 2  # no more is needed for the level
        tried = near.copy()
        tried[reach : reach + length, channels] = ways(near[reach - 1 : reach + length + 1, channels])
        if np.abs(tried).max() > 1 or sharpness((tried - near)[reach - 6 : reach + length + 6]) <= peak * 0.01:
            continue
        if level_db <= heard_over_db(tried, masked_there(near, middle, rate), middle, rate) < level_db + 12:
            faulty = samples.copy()
            faulty[at : at + length] = tried[reach : reach + length]
            return Injured(faulty, at / rate, (at + length) / rate)
    return None


def _scratch(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A scratch on a record: the needle is thrown up one wall of the groove, and its arm swings back."""
    length = round(0.0025 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    times = np.arange(length) / rate
    swing_hz = rng.uniform(900, 3_000)
    thrown = np.exp(-times / rng.uniform(4e-5, 1.5e-4)) * (times > 0)
    swung = np.sin(2 * np.pi * swing_hz * times) * np.exp(-times / rng.uniform(2e-4, 5e-4))
    heard = (thrown - rng.uniform(0.2, 0.6) * swung) * np.clip((times[-1] - times) / 0.0008, 0, 1)
    walls = np.array([1.0, rng.choice([-1, 1]) * rng.uniform(0.1, 0.9)])[: samples.shape[1]]
    shape = np.zeros_like(samples)
    shape[at : at + length] = (rng.choice([-1, 1]) * heard / np.abs(heard).max())[:, np.newaxis] * walls
    faulty = scaled_to(samples, shape, at + int(np.abs(heard).argmax()), rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, (at + length) / rate)


def _stale_gain(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A volume automation whose one short block is drawn at another value: 2 to 14 dB louder or softer."""
    gain = 10 ** (rng.choice([-1, 1]) * rng.uniform(2, 14) / 20)
    return _replaced(rng, samples, rate, level_db, 0.0015, lambda there: gain * there[1:-1])


def _ruled_line(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A reader that bridges what it cannot read of a disc with a straight line, at times from a value gone wrong."""
    wrong = rng.uniform(0.5, 2) if rng.random() < 0.5 else 0.0

    def ways(there: Samples) -> Samples:
        share = np.linspace(0, 1, len(there))[1:-1, np.newaxis]
        first = there[0] + wrong * np.ptp(there, axis=0) * np.sign(there[0])
        return first + share * (there[-1] - first)

    return _replaced(rng, samples, rate, level_db, 0.0015, ways)


def _restarting_decoder(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """One to three lost packets on Bluetooth: silence at once, and each time the decoder comes back in 1 to 3 ms."""
    length, fade = round(length_ms / 1000 * rate), round(rng.uniform(0.001, 0.003) * rate)
    good, count = round(rng.uniform(0.005, 0.015) * rate), int(rng.integers(1, 4))
    whole = count * (length + fade + good) - good
    at = place_in_sound(rng, samples, rate, whole)
    if at is None:
        return None
    gain = np.concatenate((np.zeros(length), 0.5 - 0.5 * np.cos(np.pi * np.arange(fade) / fade), np.ones(good)))
    faulty = samples.copy()
    faulty[at : at + whole] *= np.tile(gain, count)[:whole, np.newaxis]
    return Injured(faulty, at / rate, (at + whole) / rate)


def _idle_converter(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A converter that loses its clock, on one channel or all: it idles a little off zero, with its own last bits."""
    length, channels = round(length_ms / 1000 * rate), _one_or_all(rng, samples)
    heard = samples[:, channels]
    if np.abs(heard).max() < 0.1 * np.abs(samples).max():
        return None
    around = levels_around(heard, rate)
    at = place_in_sound(rng, heard, rate, length, around)
    if at is None:
        return None
    rest = rng.uniform(-0.1, 0.1) * min(around[0][at], around[1][at + length])
    faulty = samples.copy()
    faulty[at : at + length, channels] = _dithered(
        rng, np.full((length, heard.shape[1]), rest), int(rng.choice([16, 24]))
    )
    return Injured(faulty, at / rate, (at + length) / rate)


def _other_half(rng: np.random.Generator, samples: Samples, rate: int, frames: float) -> Injured | None:
    """A driver with two halves of a buffer that swaps them late: one or two halves play again, at times on one side."""
    length, channels = int(frames), _one_or_all(rng, samples)
    back = length * int(rng.integers(1, 3))
    heard = samples[:, channels]
    if np.abs(heard).max() < 0.1 * np.abs(samples).max():
        return None
    at = place_in_sound(rng, heard[back:], rate, back)
    if at is None:
        return None
    at += back
    faulty = samples.copy()
    faulty[at : at + back, channels] = samples[at - back : at, channels]
    return Injured(faulty, at / rate, (at + back) / rate)


def _exported(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    """What an editor exports of a session at another rate, with dither if the file is of 16 bit."""
    session_hz = int(rng.choice([one for one in (44_100, 48_000, 88_200, 96_000) if one != rate]))
    common = int(np.gcd(session_hz, rate))
    exported = np.clip(resample_poly(samples, rate // common, session_hz // common, axis=0), -1, 1 - 2**-23)
    return _dithered(rng, exported, 16) if rng.random() < 0.5 else exported


def _exported_start(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A region whose start was set in mid-wave, exported alone or after silence to a file of another rate."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    wait = np.zeros((round(rng.uniform(0.01, 0.2) * rate), samples.shape[1])) if rng.random() < 0.5 else samples[:0]
    faulty = _exported(rng, np.concatenate((wait, samples[at:])), rate)
    start_s = len(wait) / (len(wait) + len(samples) - at) * len(faulty) / rate
    return Injured(faulty, start_s, start_s)


def _exported_tail(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A region whose end was set in mid-wave, with silence after it, exported to a file of another rate."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    rest = np.zeros((round(rng.uniform(0.01, 0.2) * rate), samples.shape[1]))
    faulty = _exported(rng, np.concatenate((samples[: at + 1], rest)), rate)
    end_s = at / (at + 1 + len(rest)) * len(faulty) / rate
    return Injured(faulty, end_s, end_s)


def _start_point(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A sampler's start point moved into the wave: its guard of 0.05 to 0.2 ms, then lowered and dithered to 16 bit."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    guard = np.sin(np.pi / 2 * np.linspace(0, 1, max(2, round(rng.uniform(0.00005, 0.0002) * rate)))) ** 2
    wait = np.zeros((round(rng.uniform(0.005, 0.1) * rate), samples.shape[1]))
    cut = np.concatenate((wait, guard[:, np.newaxis] * samples[at - len(guard) : at], samples[at:]))
    lowered = _dithered(rng, cut * 10 ** (-rng.uniform(0, 9) / 20), 16)
    return Injured(lowered, len(wait) / rate, (len(wait) + len(guard)) / rate)


def _whole_frames(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """A capture that stops with the last whole frame of its coder, 1152 samples each: what comes after is lost."""
    at = mid_wave(rng, samples, rate)
    length = 0 if at is None else (at + 1) // MP3_FRAMES * MP3_FRAMES
    if at is None or length < 0.1 * rate:
        return None
    fade = np.clip(np.arange(length) / (0.01 * rate), 0, 1)[:, np.newaxis]
    return Injured(samples[at + 1 - length : at + 1] * fade, (length - 1) / rate, (length - 1) / rate)


def _pushed_passage(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A fader pushed for a passage: the mix clips while it is up, and everything is lowered for delivery."""
    times = np.arange(len(samples)) / rate
    loudest_s = np.abs(samples).max(axis=1).argmax() / rate + rng.uniform(-0.05, 0.05)
    near = np.clip(1 - np.abs(times - loudest_s) / rng.uniform(0.4, 1.2), 0, 1)
    course = 10 ** (drive_db / 20 * (np.sin(np.pi / 2 * near) ** 2 - 1))  # as much lower where the fader is down
    loud = driven(samples * course[:, np.newaxis], drive_db)
    return None if loud is None else _whole(np.clip(loud, -1, 1) * rng.uniform(0.3, 0.95), rate)


def _sagging_rails(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A preamplifier on a tired battery: its rails, not quite alike, sink by 1 to 3 dB while much is drawn."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    drawn = sosfilt(butter(1, rng.uniform(0.3, 1), fs=rate, output="sos"), np.square(loud).mean(axis=1))
    rails = 10 ** (-rng.uniform(1, 3) / 20 * drawn / drawn.max())[:, np.newaxis]
    lower, upper = rng.permutation([1.0, rng.uniform(0.85, 1)])
    clipped = np.clip(loud, -lower * rails, upper * rails)
    return _whole(clipped * rng.uniform(0.3, 0.95), rate)


def _coupled_side(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A badly biased stage that meets one of its rails alone, a coupling of 5 to 30 Hz behind it, then 16 bit."""
    turned = samples * rng.choice([-1, 1])
    loud = driven(np.maximum(turned, 0.0), drive_db)
    if loud is None:
        return None
    cut = np.minimum(turned / turned.max() * 10 ** (drive_db / 20), 1.0)
    leaning = sosfilt(butter(1, rng.uniform(5, 30), "high", fs=rate, output="sos"), cut, axis=0)
    return _whole(_dithered(rng, leaning / np.abs(leaning).max() * rng.uniform(0.3, 0.95), 16), rate)


def _off(samples: Samples, rate: int, offset: NDArray[np.float64]) -> Injured | None:
    faulty: Samples = 0.9 * (samples - samples.mean(axis=0)) + offset
    return None if np.abs(faulty).max() > 1 else _whole(faulty, rate)


def _warming(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """An amplifier whose bias drifts as it warms, in one channel more than in the other: so much off in the mean."""
    drift = 1 + rng.uniform(-0.7, 0.7) * (2 * np.arange(len(samples)) / len(samples) - 1)
    sides = rng.permutation([1.0, rng.uniform(0, 1)]) if samples.shape[1] == 2 else np.ones(1)
    return _off(samples, rate, rng.choice([-1, 1]) * percent / 100 * (drift / drift.mean())[:, np.newaxis] * sides)


def _rectifying(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """A saturation plug-in without a blocker: its offset stands at rest and grows with the loudness behind it."""
    follow = sosfilt(butter(1, rng.uniform(1.5, 5), fs=rate, output="sos"), np.abs(samples).max(axis=1))
    course = 1 + rng.uniform(0.5, 2) * follow / (follow.max() + SILENCE)
    return _off(samples, rate, rng.choice([-1, 1]) * percent / 100 * (course / course.mean())[:, np.newaxis])


def _hummed(
    rng: np.random.Generator,
    samples: Samples,
    rate: int,
    level_db: float,
    weights: NDArray[np.float64],
    gain: NDArray[np.float64],
    *,
    wander: float = 0.0005,
    aligned: bool = False,
) -> Injured | None:
    """The sound with multiples 1, 2, ... of the mains, three of them or more so far over what the sound has there.

    The third strongest is among these, and the first or the second. The mains wander slowly by up to this share; the
    lines start together where they are `aligned`.
    """
    if len(samples) < 1.2 * rate:
        return None
    multiples = np.arange(1, len(weights) + 1)
    mains_hz = rng.choice([50.0, 60.0]) * (1 + rng.uniform(-0.002, 0.002))
    wanted = np.sqrt(2 * (quiet_bands(samples, rate, mains_hz * multiples) + 1e-12)) * 10 ** (level_db / 20)
    heights = wanted / weights
    height = max(np.sort(heights)[2], heights[:2].min(), heights[np.argsort(weights)[-3]], 10 ** (-50 / 20))
    times = np.arange(len(samples)) / rate
    pace_hz = rng.uniform(0.1, 0.4)
    turns = mains_hz * (times + wander / (2 * np.pi * pace_hz) * np.sin(2 * np.pi * (pace_hz * times + rng.random())))
    first = rng.random()
    hum = np.zeros(len(samples))
    for multiple, weight in zip(multiples, weights, strict=True):
        late = first * multiple if aligned else rng.random()
        hum += height * weight * np.sin(2 * np.pi * (multiple * turns + late))
    sides = rng.permutation([1.0, 10 ** (-rng.uniform(0, 8) / 20)])[: samples.shape[1]]
    faulty = samples + (hum * gain / gain.mean())[:, np.newaxis] * sides / sides.max()
    return None if np.abs(faulty).max() > 1 else _whole(faulty, rate)


def _dimmer(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A stage dimmer next to the cable: it cuts each half wave on, all even multiples come as one sharp edge."""
    multiples = np.arange(1, 25)
    weights = np.where(multiples % 2, rng.uniform(0.05, 0.25), 1.0) * multiples ** -rng.uniform(0.5, 1)
    return _hummed(rng, samples, rate, level_db, weights, np.ones(len(samples)), aligned=True)


def _under_compressor(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A guitar amplifier's hum through a compressor, which presses it by up to 4 dB while the sound is loud."""
    loud = sosfilt(butter(1, rng.uniform(0.6, 2), fs=rate, output="sos"), np.abs(samples).max(axis=1))
    gain = 10 ** (-rng.uniform(1, 4) / 20 * loud / (loud.max() + SILENCE))
    weights = np.array([1.0, 0.8, 0.6, 0.3, 0.4]) * rng.uniform(0.7, 1.3, 5)
    return _hummed(rng, samples, rate, level_db, weights, gain)


def _inverter(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A car's inverter: a stepped wave whose odd multiples fall off late, and which wanders by up to 0.4 %."""
    weights = np.array([1.0, 0.1, 0.5, 0.05, 0.35, 0.05, 0.25, 0.05, 0.2]) * rng.uniform(0.7, 1.3, 9)
    return _hummed(rng, samples, rate, level_db, weights, np.ones(len(samples)), wander=rng.uniform(0.001, 0.004))


def _with_pauses(
    samples: Samples, rate: int, floor_dbfs: float, before_s: float, after_s: float, noise: Callable[[int], Samples]
) -> Injured | None:
    """The sound with so much before it and after it, over noise; where its loudest 0.2 s lies 15 dB over the noise."""
    loud = samples / np.abs(samples).max() * 0.7
    pauses = [np.zeros((round(pause_s * rate), samples.shape[1])) for pause_s in (before_s, after_s)]
    whole = np.concatenate((pauses[0], loud, pauses[1]))
    loudest, _ = levels_around(whole, 20 * rate)  # 20 times 10 ms
    if 20 * np.log10(loudest.max()) < floor_dbfs + 15:
        return None
    heard = noise(len(whole))
    return _whole(whole + heard / heard.std() * 10 ** (floor_dbfs / 20), rate)


def _room_tone(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A stage's room tone before the take, the same on both sides: it falls by 4 dB an octave above 100 Hz."""

    def noise(frames: int) -> Samples:
        hz = np.maximum(np.fft.rfftfreq(frames, 1 / rate), 1.0)
        tone = np.fft.irfft(np.fft.rfft(rng.standard_normal(frames)) * (hz / 40) / (1 + (hz / 100) ** 1.66), frames)
        return np.repeat(tone[:, np.newaxis], samples.shape[1], axis=1)

    return _with_pauses(samples, rate, floor_dbfs, rng.uniform(0.6, 1.2), 0.0, noise)


def _field_recorder(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A field recorder left running after the sound: its input's hiss, and what its low cut leaves under 200 Hz."""

    def noise(frames: int) -> Samples:
        white = rng.standard_normal((2, frames, samples.shape[1]))
        low = sosfilt(butter(1, (rng.uniform(40, 80), 200), "band", fs=rate, output="sos"), white[0], axis=0)
        hiss = sosfilt(butter(1, 16_000, fs=rate, output="sos"), white[1], axis=0)
        return low / low.std() * rng.uniform(0.3, 1) + hiss / hiss.std()

    return _with_pauses(samples, rate, floor_dbfs, 0.0, rng.uniform(0.6, 1.5), noise)


def _shaped_dither(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """An old console's few bits, with dither that was shaped: noise that rises by 6 dB an octave, all around."""

    def noise(frames: int) -> Samples:
        dither = rng.random((frames + 1, samples.shape[1])) - rng.random((frames + 1, samples.shape[1]))
        return np.diff(dither, axis=0)

    return _with_pauses(samples, rate, floor_dbfs, rng.uniform(0.1, 0.4), rng.uniform(0.55, 0.8), noise)


FAULTS: tuple[Fault, ...] = (
    Fault("click", "scratch of a record", CLICK_DB, CLICK_UNIT, _scratch),
    Fault("click", "block at a stale gain", CLICK_DB, CLICK_UNIT, _stale_gain),
    Fault("click", "bridged by a straight line", CLICK_DB, CLICK_UNIT, _ruled_line),
    Fault("dropout", "decoder that restarts", HOLE_MS, "ms", _restarting_decoder),
    Fault("dropout", "converter that idles", HOLE_MS, "ms", _idle_converter),
    Fault("dropout", "halves swapped late", ASIO_FRAMES, "frames", _other_half),
    Fault("cut-start", "cut, exported at another rate", CUT_DB, CUT_UNIT, _exported_start),
    Fault("cut-start", "start point of a sampler", CUT_DB, CUT_UNIT, _start_point),
    Fault("cut-tail", "cut, exported at another rate", CUT_DB, CUT_UNIT, _exported_tail),
    Fault("cut-tail", "stopped at a whole frame", CUT_DB, CUT_UNIT, _whole_frames),
    Fault("clipping", "pushed for a passage", DRIVE_DB, "dB over", _pushed_passage),
    Fault("clipping", "rails that sag", DRIVE_DB, "dB over", _sagging_rails),
    Fault("clipping", "one side, coupled, 16 bit", DRIVE_DB, "dB over", _coupled_side),
    Fault("dc-offset", "drifts as it warms", OFFSET_PERCENT, "%", _warming),
    Fault("dc-offset", "grows with the loudness", OFFSET_PERCENT, "%", _rectifying),
    Fault("hum", "edges of a dimmer", HUM_DB, HUM_UNIT, _dimmer),
    Fault("hum", "under a compressor", HUM_DB, HUM_UNIT, _under_compressor),
    Fault("hum", "inverter that wanders", HUM_DB, HUM_UNIT, _inverter),
    Fault("noise-floor", "room tone before the take", FLOOR_DBFS, "dBFS", _room_tone),
    Fault("noise-floor", "recorder left running", FLOOR_DBFS, "dBFS", _field_recorder),
    Fault("noise-floor", "dither shaped upwards", FLOOR_DBFS, "dBFS", _shaped_dither),
)
