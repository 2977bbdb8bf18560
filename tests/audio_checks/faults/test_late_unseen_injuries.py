"""The faults of the third and the fourth half are what and where they say, and touch nothing else."""

import numpy as np
import pytest

from benchmarks.faults import (
    fourth_unseen_injuries,
    injuries,
    known,
    once_unseen_injuries,
    second_unseen_injuries,
    third_unseen_injuries,
    unseen,
)
from benchmarks.faults.audible import excess_db
from benchmarks.faults.injuries import Fault, Injured
from benchmarks.faults.sounds import Samples
from benchmarks.faults.trial import CHECKS

RATE = 44_100
HALVES = (
    injuries.FAULTS,
    once_unseen_injuries.FAULTS,
    second_unseen_injuries.FAULTS,
    third_unseen_injuries.FAULTS,
    fourth_unseen_injuries.FAULTS,
)
LATE = HALVES[3:]
FAULTS = tuple(fault for half in LATE for fault in half)


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
    return sound * 0.8 / np.abs(sound).max()


def _injured(fault: Fault, level: float, sound: Samples) -> Injured:
    for seed in range(6):
        injured = fault.injure(np.random.default_rng(seed), sound, RATE, level)
        if injured is not None:
            return injured
    pytest.fail(f"{fault.name} at {level} {fault.unit} has no place in six tries")


def _frames(injured: Injured) -> tuple[int, int]:
    return round(injured.start_s * RATE), round(injured.end_s * RATE)


def _level(there: Samples) -> float:
    return float(np.sqrt(np.square(there).mean()))


@pytest.mark.parametrize("half", LATE, ids=("third", "fourth"))
def test_each_check_has_two_or_three_ways(half: tuple[Fault, ...]) -> None:
    ways = [fault.check for fault in half]
    assert {ways.count(check) for check in CHECKS} <= {2, 3}


def test_no_way_is_in_two_halves() -> None:
    names = [(fault.check, fault.name) for half in HALVES for fault in half]
    assert len(names) == len(set(names))
    known_ways = {fault for faults, _ in known.TRIED for fault in faults}
    assert not known_ways & set(fourth_unseen_injuries.FAULTS)
    assert {fault for faults, _ in unseen.TRIED for fault in faults} == known_ways | set(fourth_unseen_injuries.FAULTS)


@_of(*{fault.check: None for fault in FAULTS})
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
        injured = _injured(fault, level, sound)
        start, end = _frames(injured)
        assert len(injured.samples) == len(sound)
        assert np.array_equal(injured.samples[:start], sound[:start])
        assert np.array_equal(injured.samples[end:], sound[end:])
        assert not np.array_equal(injured.samples, sound)


@_of("click")
def test_a_click_exceeds_the_sound_by_its_level_and_is_short(fault: Fault, sound: Samples) -> None:
    for level in fault.levels[1:3]:
        injured = _injured(fault, level, sound)
        start, end = _frames(injured)
        assert 0 < end - start <= 0.003 * RATE + 1
        assert max(excess_db(injured.samples, sound, at, RATE) for at in range(start, end + 1)) >= level - 0.5


@_of("dropout")
def test_a_dropout_is_far_lower_for_as_long_as_it_says_or_heard_before(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        injured = _injured(fault, level, sound)
        start, end = _frames(injured)
        there = injured.samples[start:end]
        touched = (there != sound[start:end]).any(axis=0)
        if fault.unit == "frames":
            back = [number * int(level) for number in (1, 2, 3, 4)]
            earlier = [injured.samples[start - one : end - one] for one in back]
            assert any(np.array_equal(there[:, touched], one[:, touched]) for one in earlier)
            assert end - start in back
            continue
        length = round(level / 1000 * RATE)
        beside = min(_level(sound[start - RATE // 100 : start]), _level(sound[end : end + RATE // 100]))
        low = np.abs(there[:, touched]).max(axis=1) < 0.2 * beside
        runs = np.diff(np.flatnonzero(np.diff(np.concatenate(([0], low, [0])))))[::2]
        assert length <= runs.max() <= length + 0.004 * RATE  # the quietest part of a fade is as good as silent
        assert (runs >= length).sum() <= 4
        assert end - start <= 4 * length + 0.05 * RATE


@_of("cut-start", "cut-tail")
def test_a_cut_is_next_to_silence_and_high_on_the_wave(fault: Fault, sound: Samples) -> None:
    injured = _injured(fault, fault.levels[0], sound)
    faulty, (first, last) = injured.samples, _frames(injured)
    silent = faulty[:first] if fault.check == "cut-start" else faulty[last + 5 :]
    assert (
        np.abs(silent).max(initial=0) < 0.1 * np.abs(faulty).max()
    )  # a low cut's answer to the edge is the most there
    beside = np.abs(faulty[max(0, first - 2) : last + 3]).max()
    assert beside > 0.2 * np.abs(faulty[max(0, first - RATE // 100) : last + RATE // 100]).max()
    assert beside > np.abs(faulty).max() * 10 ** (-46 / 20)
    assert last - first <= 0.0002 * RATE + 1


@_of("clipping")
def test_a_clipped_sound_has_its_tops_off(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        lost_db = []
        width = RATE // 10
        for at in range(width, len(sound) - 2 * width, width):  # a ridden volume is nearly steady for so long
            heard, clean = faulty[at : at + width, 0], sound[at : at + width, 0]
            low = np.abs(clean) < 0.2 * np.abs(sound).max()
            gain, rest = np.polyfit(clean[low], heard[low], 1)  # what is cut on one side rests aside behind a low cut
            assert np.abs(heard[low] - gain * clean[low] - rest).max() < 0.3 * np.abs(faulty).max()
            sides = (gain * clean.max() / (heard.max() - rest), gain * clean.min() / (heard.min() - rest))
            lost_db.append(20 * np.log10(max(sides)))
        assert level - 1.5 <= max(lost_db) < level + 3


@_of("dc-offset")
def test_the_mean_of_a_channel_is_as_far_off_as_it_says(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        assert 100 * np.abs(faulty.mean(axis=0)).max() == pytest.approx(level, rel=1e-6)
        for heard, clean in zip(faulty.T, sound.T, strict=True):
            assert np.corrcoef(heard, clean)[0, 1] > 0.99  # it is the sound still


@_of("hum")
def test_hum_is_nearly_steady_lines_near_multiples_of_the_mains(fault: Fault, sound: Samples) -> None:
    hums = _injured(fault, fault.levels[-1], sound).samples - sound
    assert min(_level(hum) for hum in hums.T) > 10 ** (-10.5 / 20) * max(_level(hum) for hum in hums.T)
    for hum in hums.T:
        power = np.square(np.abs(np.fft.rfft(hum * np.hanning(len(hum)))))
        hz = np.fft.rfftfreq(len(hum), 1 / RATE)
        beside = min(power[np.abs(hz - np.round(hz / mains) * mains) > 3 + 0.005 * hz].sum() for mains in (50, 60))
        assert power.sum() > 0
        assert beside < 0.001 * power.sum()


@_of("noise-floor")
def test_noise_is_as_loud_as_it_says_where_the_sound_is_not(fault: Fault, sound: Samples) -> None:
    for level in fault.levels:
        faulty = _injured(fault, level, sound).samples
        half_seconds = np.lib.stride_tricks.sliding_window_view(faulty, RATE // 2, axis=0)[:: RATE // 100]
        quietest = min(_level(there) for there in half_seconds)
        assert 20 * np.log10(quietest) == pytest.approx(level, abs=1)
        assert len(faulty) >= len(sound) + RATE // 2
