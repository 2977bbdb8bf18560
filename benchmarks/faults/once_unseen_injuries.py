"""Other faults, put in by other means than those of `injuries`: unseen until they had been looked at five times."""

import numpy as np
from scipy.signal import butter, lfilter, sosfilt, sosfiltfilt

from benchmarks.faults.injuries import (
    BUFFER_FRAMES,
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
    mid_wave,
    noise_for,
    place_in_sound,
    scaled_to,
    with_noise,
)
from benchmarks.faults.sounds import Samples


def _burst(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """Three to eight samples of anything."""
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros_like(samples)
    count = int(rng.integers(3, 9))
    shape[at : at + count] = rng.uniform(-1, 1, (count, samples.shape[1]))
    faulty = scaled_to(samples, shape, at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, (at + count) / rate)


def _dull(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A click that went through a converter's filter, at 8 to 16 kHz."""
    at = place_in_sound(rng, samples, rate)
    if at is None:
        return None
    shape = np.zeros_like(samples)
    shape[at] = rng.choice([-1.0, 1.0], samples.shape[1])
    shape = sosfiltfilt(butter(3, rng.uniform(8_000, 16_000), fs=rate, output="sos"), shape, axis=0)
    faulty = scaled_to(samples, shape / np.abs(shape).max(), at, rate, level_db)
    return None if faulty is None else Injured(faulty, at / rate, at / rate)


def _turned(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """One or two samples with their sign the wrong way round, as a broken converter gives them."""
    for _ in range(60):
        at = place_in_sound(rng, samples, rate)
        if at is None:
            return None
        shape = np.zeros_like(samples)
        count = int(rng.integers(1, 3))
        shape[at : at + count] = -2 * samples[at : at + count]
        if np.abs(shape).max() < np.abs(samples).max() * 0.01:
            continue
        over = scaled_to(samples, shape, at, rate, level_db)
        if over is not None and np.abs(over - samples).max() <= np.abs(shape).max() * 1.001:
            return Injured(over, at / rate, (at + count) / rate)
    return None


def _dithered_hole(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """A hole made before the file was dithered to 16 bit."""
    length = round(length_ms / 1000 * rate)
    at = place_in_sound(rng, samples, rate, length)
    if at is None:
        return None
    faulty = samples.copy()
    faulty[at : at + length] = 0.0
    dither = rng.random(samples.shape) - rng.random(samples.shape)
    return Injured(np.round(faulty * 2**15 + dither) / 2**15, at / rate, (at + length) / rate)


def _lost_channel(rng: np.random.Generator, samples: Samples, rate: int, length_ms: float) -> Injured | None:
    """One channel of two loses its sound for a moment."""
    if samples.shape[1] < 2:
        return None
    length = round(length_ms / 1000 * rate)
    channel = int(rng.integers(0, 2))
    alone = samples[:, [channel]]
    at = place_in_sound(rng, alone, rate, length)
    if at is None or np.abs(alone).max() < 0.1 * np.abs(samples).max():
        return None
    faulty = samples.copy()
    faulty[at : at + length, channel] = 0.0
    return Injured(faulty, at / rate, (at + length) / rate)


def _stuck_buffer(rng: np.random.Generator, samples: Samples, rate: int, frames: float) -> Injured | None:
    """A buffer that plays three times in all, put in between: nothing of the sound is lost."""
    length = int(frames)
    at = place_in_sound(rng, samples, rate)
    if at is None or at < length:
        return None
    again = np.tile(samples[at - length : at], (2, 1))
    faulty = np.concatenate((samples[:at], again, samples[at:]))
    return Injured(faulty, at / rate, (at + 2 * length) / rate)


def _start_after_silence(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut, then moved later on the time line."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    wait = round(rng.uniform(0.001, 0.2) * rate)
    return Injured(np.concatenate((np.zeros((wait, samples.shape[1])), samples[at:])), wait / rate, wait / rate)


def _tail_before_silence(rng: np.random.Generator, samples: Samples, rate: int, level: float) -> Injured | None:
    """Cut, and filled up with silence to a round length."""
    at = mid_wave(rng, samples, rate)
    if at is None:
        return None
    rest = round(rng.uniform(0.001, 0.2) * rate)
    return Injured(np.concatenate((samples[: at + 1], np.zeros((rest, samples.shape[1])))), at / rate, at / rate)


def _one_side(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """A stage whose supply is short on one side, lowered afterwards."""
    loud = driven(np.maximum(samples, 0.0), drive_db)
    if loud is None:
        return None
    cut = np.minimum(samples / samples.max() * 10 ** (drive_db / 20), 1.0)
    return Injured(cut / np.abs(cut).max() * rng.uniform(0.3, 0.95), 0.0, len(samples) / rate)


def _clipped_and_dithered(rng: np.random.Generator, samples: Samples, rate: int, drive_db: float) -> Injured | None:
    """Clipped, lowered, then brought to 16 bit with dither."""
    loud = driven(samples, drive_db)
    if loud is None:
        return None
    dither = rng.random(samples.shape) - rng.random(samples.shape)
    return Injured(
        np.round(np.clip(loud, -1, 1) * rng.uniform(0.3, 0.95) * 2**15 + dither) / 2**15, 0.0, len(samples) / rate
    )


def _shifted_channel(rng: np.random.Generator, samples: Samples, rate: int, percent: float) -> Injured | None:
    """One channel alone is off centre."""
    centred = 0.9 * (samples - samples.mean(axis=0))
    centred[:, -1] += percent / 100
    return Injured(centred, 0.0, len(samples) / rate)


def _odd_hum(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A dimmer: odd multiples only, in one channel."""
    multiples = np.array([1, 3, 5, 7])
    faulty = hum_over(rng, samples, rate, level_db, multiples, rng.uniform(0.5, 1, 4))
    if faulty is None:
        return None
    faulty[:, 1:] = samples[:, 1:]
    return Injured(faulty, 0.0, len(samples) / rate)


def _buzz(rng: np.random.Generator, samples: Samples, rate: int, level_db: float) -> Injured | None:
    """A rectifier: even multiples only."""
    multiples = np.array([2, 4, 6, 8])
    faulty = hum_over(rng, samples, rate, level_db, multiples, rng.uniform(0.3, 1, 4))
    return None if faulty is None else Injured(faulty, 0.0, len(samples) / rate)


def _room(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """A room with its ventilation: noise that falls with frequency."""
    noise = lfilter([1], [1, -0.97], noise_for(rng, samples, rate), axis=0)
    return with_noise(samples, noise, rate, floor_dbfs)


def _preamplifier(rng: np.random.Generator, samples: Samples, rate: int, floor_dbfs: float) -> Injured | None:
    """Hiss without lows."""
    noise = sosfilt(butter(2, 2_000, "high", fs=rate, output="sos"), noise_for(rng, samples, rate), axis=0)
    return with_noise(samples, noise, rate, floor_dbfs)


FAULTS = (
    Fault("click", "burst of samples", CLICK_DB, CLICK_UNIT, _burst),
    Fault("click", "dull click", CLICK_DB, CLICK_UNIT, _dull),
    Fault("click", "sample with its sign turned", CLICK_DB, CLICK_UNIT, _turned),
    Fault("dropout", "hole, then dither", HOLE_MS, "ms", _dithered_hole),
    Fault("dropout", "hole in one channel", HOLE_MS, "ms", _lost_channel),
    Fault("dropout", "buffer that plays three times", BUFFER_FRAMES, "frames", _stuck_buffer),
    Fault("cut-start", "cut, after silence", (-34.0,), "dB under the peak or louder", _start_after_silence),
    Fault("cut-tail", "cut, before silence", (-34.0,), "dB under the peak or louder", _tail_before_silence),
    Fault("clipping", "one side only, then lowered", DRIVE_DB, "dB over", _one_side),
    Fault("clipping", "lowered, then dither", DRIVE_DB, "dB over", _clipped_and_dithered),
    Fault("dc-offset", "one channel", (1.1, 2.0, 5.0), "%", _shifted_channel),
    Fault("hum", "odd multiples in one channel", HUM_DB, HUM_UNIT, _odd_hum),
    Fault("hum", "even multiples", HUM_DB, HUM_UNIT, _buzz),
    Fault("noise-floor", "room", (-58.0, -50.0, -40.0), "dBFS", _room),
    Fault("noise-floor", "preamplifier", (-58.0, -50.0, -40.0), "dBFS", _preamplifier),
)
