"""The faults that are or were unseen are what and where they say, and touch nothing else. No detector looks here."""

import numpy as np
import pytest

from tests.audio_checks.faults import second_unseen_injuries, unseen_injuries
from tests.audio_checks.faults.audible import excess_db
from tests.audio_checks.faults.injuries import Fault, Injured
from tests.audio_checks.faults.sounds import Samples

RATE = 44_100
FAULTS = second_unseen_injuries.FAULTS + unseen_injuries.FAULTS


def _of(*checks: str) -> pytest.MarkDecorator:
    faults = [fault for fault in FAULTS if fault.check in checks]
    return pytest.mark.parametrize("fault", faults, ids=[f"{fault.check}: {fault.name}" for fault in faults])


@pytest.fixture(scope="module")
def sound() -> Samples:
    """Two channels of two tones over noise that grows, so that each level has its place, with hushed ends."""
    times = np.arange(round(1.3 * RATE))[:, np.newaxis] / RATE
    tones = np.sin(2 * np.pi * np.array([310, 330]) * times) + 0.15 * np.sin(
        2 * np.pi * np.array([2_130, 1_970]) * times
    )
    noise = np.logspace(-4, -1.5, len(times))[:, np.newaxis] * np.random.default_rng(4).standard_normal(tones.shape)
    sound: Samples = (tones + noise) * np.hanning(len(times))[:, np.newaxis] ** 0.3
    return sound * 0.6 / np.abs(sound).max()


def _injured(fault: Fault, level: float, sound: Samples) -> Injured:
    for seed in range(6):
        injured = fault.injure(np.random.default_rng(seed), sound, RATE, level)
        if injured is not None:
            return injured
    pytest.fail(f"{fault.name} at {level} {fault.unit} has no place in six tries")


@_of(*{fault.check for fault in FAULTS})
def test_a_faulty_sound_is_in_range_and_the_sound_itself_stays_as_it_was(fault: Fault, sound: Samples) -> None:
    kept = sound.copy()
    for level in fault.levels[1:3] or fault.levels:
        injured, again = _injured(fault, level, sound), _injured(fault, level, sound)
        assert np.isfinite(injured.samples).all()
        assert np.abs(injured.samples).max() <= 1
        assert injured.samples.shape[1] == 2
        assert 0 <= injured.start_s <= injured.end_s <= len(injured.samples) / RATE
        assert np.array_equal(injured.samples, again.samples)
        assert injured[1:] == again[1:]
    assert np.array_equal(sound, kept)


@_of("click", "dropout")
def test_nothing_but_the_fault_is_touched(fault: Fault, sound: Samples) -> None:
    for level in fault.levels[1:3] or fault.levels:
        faulty, start_s, end_s = _injured(fault, level, sound)
        start, end = round(start_s * RATE), round(end_s * RATE)
        rest = len(faulty) - end
        assert np.array_equal(faulty[:start], sound[:start])
        # A slip or a joint has no length, and goes on from another frame of the sound.
        goes_on = len(sound) - rest
        assert np.array_equal(faulty[end:], sound[goes_on:])
        assert goes_on != end or not np.array_equal(faulty[start:end], sound[start:end])
        assert start == end or goes_on == end


@_of("click")
def test_a_click_exceeds_the_sound_by_its_level(fault: Fault, sound: Samples) -> None:
    for level in fault.levels[1:3] or fault.levels:
        faulty, start_s, end_s = _injured(fault, level, sound)
        reach = range(round(start_s * RATE), round(end_s * RATE) + 1)
        assert max(excess_db(faulty, sound, at, RATE) for at in reach) >= level - 0.5


@_of("dropout")
def test_a_dropout_lasts_as_long_as_it_says(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        _, start_s, end_s = _injured(fault, level, sound)
        told_s = level / 1000 if fault.unit == "ms" else level / RATE
        assert told_s - 1 / RATE <= end_s - start_s <= told_s + 0.0012  # a driver's ramps are outside of it


@_of("cut-start", "cut-tail")
def test_a_cut_is_next_to_silence_and_high_on_the_wave(fault: Fault, sound: Samples) -> None:
    faulty, at_s, _ = _injured(fault, fault.levels[0], sound)
    at = round(at_s * RATE)
    silent = faulty[: at - 40] if fault.check == "cut-start" else faulty[at + 40 :]
    assert np.abs(silent).max() < 10 ** (-60 / 20)
    beside = np.abs(faulty[at - 2 : at + 3]).max()
    assert beside > 0.25 * np.abs(faulty[at - RATE // 100 : at + RATE // 100]).max()
    assert beside > np.abs(faulty).max() * 10 ** (-46 / 20)


@_of("clipping")
def test_a_clipped_sound_has_its_tops_off_and_is_itself_below(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        lost_db = []
        for heard, clean in zip(faulty.T, sound.T, strict=True):
            low = np.abs(clean) < 0.2 * np.abs(sound).max()
            gain = np.dot(heard[low], clean[low]) / np.square(clean[low]).sum()
            assert np.abs(heard[low] - gain * clean[low]).max() < 0.1 * np.abs(faulty).max()
            lost_db.append(20 * np.log10(gain * np.abs(clean).max() / np.abs(heard).max()))
        assert level - 0.3 <= max(lost_db) < level + 5


@_of("dc-offset")
def test_the_mean_of_a_channel_is_as_far_off_as_it_says(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        assert 100 * np.abs(faulty.mean(axis=0)).max() == pytest.approx(level, rel=1e-6)
        offset = faulty - 0.9 * (sound - sound.mean(axis=0))
        assert np.abs(np.diff(offset, axis=0)).max() < 1e-4


@_of("hum")
def test_hum_is_steady_lines_near_multiples_of_the_mains(fault: Fault, sound: Samples) -> None:
    hum = _injured(fault, fault.levels[-1], sound).samples[:, 0] - sound[:, 0]
    power = np.square(np.abs(np.fft.rfft(hum * np.hanning(len(hum)))))
    hz = np.fft.rfftfreq(len(hum), 1 / RATE)
    beside = min(power[np.abs(hz - np.round(hz / mains) * mains) > 2 + 0.011 * hz].sum() for mains in (50, 60))
    assert power.sum() > 0
    assert beside < 0.001 * power.sum()


@_of("noise-floor")
def test_noise_is_as_loud_as_it_says_where_the_sound_is_not(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        between = faulty[len(sound) : len(sound) + RATE // 2]
        assert 20 * np.log10(between.std()) == pytest.approx(level, abs=1)
        assert len(faulty) == 2 * len(sound) + RATE // 2
