"""Yet other faults, for the sounds of `second_unseen_sounds`: unseen until they had been looked at once."""

from collections.abc import Callable, Iterator

import numpy as np
from numpy.typing import NDArray
from scipy.signal import butter, sosfilt, sosfiltfilt

from benchmarks.faults.audible import WINDOW_S, heard_over_db, masked_there
from benchmarks.faults.injuries import (
    CLICK_DB,
    CLICK_UNIT,
    DRIVE_DB,
    HOLE_MS,
    HUM_DB,
    HUM_UNIT,
    Fault,
    Injured,
    driven,
    hum_over,
    joint_exceeds,
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
RING_FRAMES = (192.0, 480.0, 960.0, 1920.0)  # 4 to 40 ms of a driver's buffer at 48 kHz
OFFSET_PERCENT = (1.1, 2.0, 5.0)
FLOOR_DBFS = (-58.0, -50.0, -40.0)


def _channels(rng: np.random.Generator, samples: Samples) -> slice:
    """One channel, or all."""
    one = int(rng.integers(0, samples.shape[1]))
    return slice(one, one + 1) if rng.random() < 0.5 else slice(None)


def _changed(
    rng: np.random.Generator, samples: Samples, rate: int, level_db: float, ways: Callable[[Samples], Iterator[Samples]]
) -> Injured | None:
    """The sound with a tenth to a whole millisecond of it changed, in one way of several.

    It is the first that exceeds the sound by so much, by less than 12 dB more, and sharply. The ways are given what is
    to be changed, with the frame before it.
    """
    around, peak, reach = levels_around(samples, rate), np.abs(samples).max(), round(2 * WINDOW_S * rate)
    for _ in range(TRIES):
        length = round(rng.uniform(0.0001, 0.001) * rate)
        at = place_in_sound(rng, samples, rate, length, around)
        if at is None:
            return None
        near, middle = samples[at - reach : at + reach], reach + length // 2  # no more is needed for the level
        masked, channels = masked_there(near, middle, rate), _channels(rng, samples)
        for changed in ways(samples[at - 1 : at + length, channels]):
            tried = near.copy()
            tried[reach : reach + length, channels] = changed
            if sharpness((tried - near)[reach - 6 : reach + length + 6]) <= peak * 0.01:
                continue
            if level_db <= heard_over_db(tried, masked, middle, rate) < level_db + 12:
                faulty = samples.copy()
                faulty[at : at + length, channels] = changed
                return Injured(faulty, at / rate, (at + length) / rate)
    return None


def _stuck_bit(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """One bit of the 24 that stays up, or down, for up to a millisecond, as on a line that is not quite plugged in."""
    up = rng.random() < 0.5

    def ways(there: Samples) -> Iterator[Samples]:
        words = np.floor(there[1:] * 2**23).astype(np.int64)
        for bit in range(10, 23):
            stuck = words | (1 << bit) if up else words & ~(1 << bit)
            yield there[1:] + (stuck - words) / 2**23

    return _changed(rng, samples, rate, level_db, ways)


def _stuck_sample(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A converter that gives one value for up to a millisecond, then the sound again."""

    def ways(there: Samples) -> Iterator[Samples]:
        yield np.repeat(there[:1], len(there) - 1, axis=0)

    return _changed(rng, samples, rate, level_db, ways)


def _slip(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Two clocks that run apart: up to half a millisecond of the sound is left out, or comes twice."""
    around = levels_around(samples, rate)
    for _ in range(TRIES):
        length = round(rng.uniform(0.00005, 0.0005) * rate)
        at = place_in_sound(rng, samples, rate, length, around)
        if at is None:
            return None
        goes_on = at + length if rng.random() < 0.5 else at - length
        slipped = np.concatenate((samples[:at], samples[goes_on:]))
        if joint_exceeds(slipped, samples, at, goes_on, rate, level_db):
            return Injured(slipped, at / rate, at / rate)
    return None


def _joint(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Two takes one after the other without a crossfade: the sound goes on from another of its moments."""
    around = levels_around(samples, rate)
    for _ in range(TRIES):
        at = place_in_sound(rng, samples, rate, around=around)
        goes_on = place_in_sound(rng, samples, rate, around=around)
        if at is None or goes_on is None:
            return None
        joined = np.concatenate((samples[:at], samples[goes_on:]))
        if joint_exceeds(joined, samples, at, goes_on, rate, level_db):
            return Injured(joined, at / rate, at / rate)
    return None


def _contact(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A plug that moves in its socket: two to five contacts within 3 ms, each a band of noise that dies away."""
    length = round(0.004 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    times = np.arange(length) / rate
    low_hz = rng.uniform(1_500, 4_000)
    band = butter(1, (low_hz, low_hz * rng.uniform(1.5, 3)), "band", fs=rate, output="sos")
    starts_s = np.append(0.0, rng.uniform(0.0003, 0.003, rng.integers(1, 5)))
    fall = sum(
        rng.uniform(0.3, 1) * (times >= start_s) * np.exp(-np.maximum(times - start_s, 0) / rng.uniform(1e-4, 2.5e-4))
        for start_s in starts_s
    )
    contacts = sosfilt(band, rng.standard_normal(length) * fall) * np.clip((times[-1] - times) / 0.0005, 0, 1)
    shape = np.zeros_like(samples)
    shape[at : at + length, _channels(rng, samples)] = (contacts / np.abs(contacts).max())[:, np.newaxis]
    faulty = scaled_to(samples, shape, at + int(np.abs(contacts).argmax()), rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, (at + length) / rate)


def _muted(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A driver that has no buffer and mutes: silence of this length, with a ramp of up to 0.5 ms at either end."""
    ramp, length = round(rng.uniform(0.0001, 0.0005) * rate), round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length + 2 * ramp)
    if at is None:
        return None
    gain = np.abs(np.linspace(-1, 1, 2 * ramp))
    faulty = samples.copy()
    end = at + length + 2 * ramp
    faulty[at:end] *= np.concatenate((gain[:ramp], np.zeros(length), gain[ramp:]))[:, np.newaxis]
    return Injured(faulty, at / rate, end / rate)


def _leaking(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A converter that stops: its last value leaks away through the coupling behind it, in 0.3 to 3 ms."""
    length = round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    faulty = samples.copy()
    leak = np.exp(-np.arange(1, length + 1) / (rng.uniform(0.0003, 0.003) * rate))
    faulty[at : at + length] = samples[at - 1] * leak[:, np.newaxis]
    return Injured(faulty, at / rate, (at + length) / rate)


def _ring(rng: np.random.Generator, samples: Samples, rate: int, frames: float) -> Injured | None:
    """A ring of two to four buffers that is not filled in time: the one before as many plays again."""
    length, back = int(frames), int(frames) * int(rng.integers(2, 5))
    at = place_in_sound(rng, samples[back:], rate, length)
    if at is None:
        return None
    at += back
    faulty = samples.copy()
    faulty[at : at + length] = samples[at - back : at - back + length]
    return Injured(faulty, at / rate, (at + length) / rate)


def _dithered(rng: np.random.Generator, samples: Samples) -> Samples:
    dither = rng.random(samples.shape) - rng.random(samples.shape)
    return np.round(samples * 2**15 + dither) / 2**15


def _crest(samples: Samples, at: int, rate: int) -> int:
    """The highest frame within a millisecond of this one."""
    first = at - rate // 1000
    return first + int(np.abs(samples[first : at + rate // 1000 + 1]).max(axis=1).argmax())


def _silence(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    return np.zeros((round(rng.uniform(0.005, 0.3) * rate), samples.shape[1]))


def _start_at_crest(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut where the wave turns, after silence, and dithered to 16 bit with it."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    wait = _silence(rng, samples, rate)
    cut = np.concatenate((wait, samples[_crest(samples, at, rate) :]))
    return Injured(_dithered(rng, cut), len(wait) / rate, len(wait) / rate)


def _tail_at_crest(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut where the wave turns, before silence, and dithered to 16 bit with it."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    last = _crest(samples, at, rate)
    cut = np.concatenate((samples[: last + 1], _silence(rng, samples, rate)))
    return Injured(_dithered(rng, cut), last / rate, last / rate)


def _converted(rng: np.random.Generator, samples: Samples, rate: int) -> Samples:
    """The sound through the steep filter of a converter of sample rates, which rings before and after an edge."""
    corner_hz = rng.uniform(0.4, 0.45) * min(rate, 48_000)
    converted: Samples = sosfiltfilt(butter(6, corner_hz, fs=rate, output="sos"), samples, axis=0)
    return np.clip(converted, -1, 1 - 2**-23)


def _converted_start(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut, moved later on the time line, then brought to another sample rate."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    wait = _silence(rng, samples, rate)
    cut = np.concatenate((wait, samples[at:]))
    return Injured(_converted(rng, cut, rate), len(wait) / rate, len(wait) / rate)


def _converted_tail(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut, filled up with silence, then brought to another sample rate."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    cut = np.concatenate((samples[: at + 1], _silence(rng, samples, rate)))
    return Injured(_converted(rng, cut, rate), at / rate, at / rate)


def _rails(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A recorder whose rails are unequal; it takes off what lies under 1 to 4 Hz, so that the tops lean a little."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    lower, upper = (-1.0, rng.uniform(0.75, 0.95)) if rng.random() < 0.5 else (-rng.uniform(0.75, 0.95), 1.0)
    coupling = butter(1, rng.uniform(1, 4), "high", fs=rate, output="sos")
    clipped = sosfilt(coupling, np.clip(loud, lower, upper), axis=0)
    return Injured(clipped * rng.uniform(0.3, 0.95) / np.abs(clipped).max(), 0.0, len(samples) / rate)


def _knee(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A stage that bends before it stops: from a knee on it follows ever less, and at the rail not at all."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    knee = rng.uniform(0.6, 0.9)
    over = np.clip(np.abs(loud) - knee, 0, 1 - knee)
    bent = np.sign(loud) * (np.minimum(np.abs(loud), knee) + over - np.square(over) / (2 * (1 - knee)))
    return Injured(bent * rng.uniform(0.3, 0.95) / np.abs(bent).max(), 0.0, len(samples) / rate)


def _clipped_channel(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """One channel of two clips; both are lowered afterwards."""
    if samples.shape[1] < 2:
        return None
    channel = int(rng.integers(0, 2))
    loud = driven(samples[:, [channel]], drive_db)
    if loud is None:
        return None
    faulty = samples / np.abs(samples).max()
    faulty[:, [channel]] = np.clip(loud, -1, 1)
    return Injured(faulty * rng.uniform(0.3, 0.95), 0.0, len(samples) / rate)


def _off_centre(samples: Samples, offset: NDArray[np.float64]) -> Samples | None:
    faulty: Samples = 0.9 * (samples - samples.mean(axis=0)) + offset
    return None if np.abs(faulty).max() > 1 else faulty


def _settling(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """A coupling that leaks and was just switched on: further off at first; so much off in the mean."""
    times = np.arange(len(samples)) / len(samples)
    course = 1 + rng.uniform(0.3, 1) * np.exp(-times / rng.uniform(0.1, 0.5))
    offset = rng.choice([-1, 1]) * percent / 100 * course / course.mean()
    faulty = _off_centre(samples, offset[:, np.newaxis])
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _each_channel_its_own(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """Channels that are off to different sides, one of them by so much and the other by less."""
    share = rng.permutation(np.array([1.0, -rng.uniform(0.2, 1)])) if samples.shape[1] == 2 else np.array([1.0])
    faulty = _off_centre(samples, rng.choice([-1, 1]) * percent / 100 * share)
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _generator(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A generator on location, up to one hundredth off its frequency, its low multiples of no set order."""
    faulty = hum_over(rng, samples, rate, level_db, np.arange(1, 6), rng.uniform(0.3, 1, 5), off=0.01)
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _charging(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A rectifier that charges its capacitor in short pulses: even multiples far up, weaker by the sinc of a pulse."""
    multiples = np.arange(2, 18, 2)
    weights = np.sinc(multiples / 2 * rng.uniform(0.05, 0.11))  # the pulse's share of its period
    faulty = hum_over(rng, samples, rate, level_db, multiples, weights)
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _neutral(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A neutral that carries what three phases of dimmers leave: the third multiple and its own odd ones."""
    faulty = hum_over(rng, samples, rate, level_db, np.array([1, 3, 9, 15]), rng.uniform(0.4, 1, 4))
    if faulty is None:
        return None
    if rng.random() < 0.5:
        faulty[:, 1:] = samples[:, 1:]
    return Injured(faulty, 0.0, len(samples) / rate)


def _coloured(noise: Samples, rate: int, slope_db: float, low_hz: float, high_hz: float) -> Samples:
    """Noise whose level goes by so much an octave, between two frequencies."""
    hz = np.fft.rfftfreq(len(noise), 1 / rate)
    inside = (hz >= low_hz) & (hz <= high_hz)
    gain = np.where(inside, np.maximum(hz, low_hz) ** (slope_db / (20 * np.log10(2))), 0.0)
    coloured: Samples = np.fft.irfft(np.fft.rfft(noise, axis=0) * gain[:, np.newaxis], len(noise), axis=0)
    return coloured


def _flicker(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A cheap input: noise that falls by 3 dB an octave, from 20 Hz on."""
    noise = _coloured(noise_for(rng, samples, rate), rate, -3.0, 20, rate / 2)
    return with_noise(samples, noise, rate, floor_dbfs)


def _tape(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A tape: noise that rises by 3 dB an octave, up to where its heads end."""
    noise = _coloured(noise_for(rng, samples, rate), rate, 3.0, 40, rng.uniform(12_000, 18_000))
    return with_noise(samples, noise, rate, floor_dbfs)


FAULTS: tuple[Fault, ...] = (
    Fault("click", "bit that is stuck", CLICK_DB, CLICK_UNIT, _stuck_bit),
    Fault("click", "clock that slips", CLICK_DB, CLICK_UNIT, _slip),
    Fault("click", "joint of two takes", CLICK_DB, CLICK_UNIT, _joint),
    Fault("click", "contacts of a plug", CLICK_DB, CLICK_UNIT, _contact),
    Fault("click", "sample that is stuck", CLICK_DB, CLICK_UNIT, _stuck_sample),
    Fault("dropout", "muted with ramps", HOLE_MS, "ms", _muted),
    Fault("dropout", "last value leaks away", HOLE_MS, "ms", _leaking),
    Fault("dropout", "older buffer of a ring", RING_FRAMES, "frames", _ring),
    Fault("cut-start", "cut at a crest, then dither", (-34.0,), "dB under the peak or louder", _start_at_crest),
    Fault("cut-start", "cut, then converted", (-34.0,), "dB under the peak or louder", _converted_start),
    Fault("cut-tail", "cut at a crest, then dither", (-34.0,), "dB under the peak or louder", _tail_at_crest),
    Fault("cut-tail", "cut, then converted", (-34.0,), "dB under the peak or louder", _converted_tail),
    Fault("clipping", "unequal rails, without the lowest", DRIVE_DB, "dB over", _rails),
    Fault("clipping", "knee, then rail", DRIVE_DB, "dB over", _knee),
    Fault("clipping", "one channel, then lowered", DRIVE_DB, "dB over", _clipped_channel),
    Fault("dc-offset", "settling", OFFSET_PERCENT, "%", _settling),
    Fault("dc-offset", "each channel its own", OFFSET_PERCENT, "%", _each_channel_its_own),
    Fault("hum", "generator off its frequency", HUM_DB, HUM_UNIT, _generator),
    Fault("hum", "pulses of a rectifier", HUM_DB, HUM_UNIT, _charging),
    Fault("hum", "multiples of three", HUM_DB, HUM_UNIT, _neutral),
    Fault("noise-floor", "flicker", FLOOR_DBFS, "dBFS", _flicker),
    Fault("noise-floor", "tape", FLOOR_DBFS, "dBFS", _tape),
)
