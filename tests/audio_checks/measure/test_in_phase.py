"""Lines that go through a sound in one phase, and what is not such a line."""

import numpy as np
import pytest

from audio_checks.measure.in_phase import lines_in_phase

RATE_HZ = 2_000.0


def lines(multiples=(1, 2, 3), hz=50.07, height=0.001, seconds=2.0, phase=0.0):
    times_s = np.arange(round(seconds * RATE_HZ)) / RATE_HZ
    return sum(height * np.sin(2 * np.pi * hz * multiple * times_s + multiple + phase) for multiple in multiples)


def strokes(seconds=2.0, seed=1):
    """Noise a hundred times as high as the lines, that dies away four times a second."""
    times_s = np.arange(round(seconds * RATE_HZ)) / RATE_HZ
    return 0.1 * np.random.default_rng(seed).standard_normal(len(times_s)) * np.exp(-(times_s % 0.25) / 0.015)


def found_in(samples, mains_hz=50.0):
    return lines_in_phase(samples, RATE_HZ, mains_hz, 8, 0.004)


@pytest.mark.parametrize("multiples", [(1, 2, 3), (2, 4, 6), (1, 5, 7, 8)])
@pytest.mark.parametrize("hz", [49.85, 50.0, 50.19])
def test_which_there_are_and_their_power(multiples, hz):
    found = found_in(lines(multiples, hz) + strokes())
    assert found.multiples == multiples
    assert found.power == pytest.approx(len(multiples) * 0.001**2 / 2, rel=0.1)


def test_no_more_than_the_beginning_is_looked_at():
    sound = lines(seconds=4) + strokes(4)
    assert found_in(np.concatenate((sound, np.ones(5_000)))) == found_in(sound)


def test_lines_that_stop_halfway_are_none():
    half = lines()
    half[len(half) // 2 :] = 0.0
    assert found_in(half + strokes()).multiples == ()


def test_lines_that_only_one_half_can_show_are_no_three():
    hidden, rng = lines(height=0.005), np.random.default_rng(3)
    hidden[:2_000] += 0.0003 * rng.standard_normal(2_000)
    hidden[2_000:] += 0.25 * rng.standard_normal(2_000)
    assert len(found_in(hidden).multiples) < 3


def test_lines_that_stop_for_a_while_are_none():
    broken = lines()
    broken[1_200:1_900] = 0.0
    assert found_in(broken + strokes()).multiples == ()


def test_lines_that_turn_their_phase_are_no_three():
    # One of them may pass for a line of a frequency close by; the others are out of tune with that.
    turned = np.concatenate((lines(seconds=1), lines(seconds=1, phase=2.0)))
    assert len(found_in(turned + strokes()).multiples) < 3


@pytest.mark.parametrize(("hz", "mains_hz"), [(51.0, 50.0), (50.0, 60.0), (58.27, 60.0)])
def test_lines_of_something_else_are_none(hz, mains_hz):
    assert len(found_in(lines(hz=hz), mains_hz).multiples) < 3


@pytest.mark.parametrize("seed", range(20))
def test_noise_has_no_three(seed):
    assert len(found_in(np.random.default_rng(seed).standard_normal(4_000)).multiples) < 3


@pytest.mark.parametrize("samples", [np.zeros(2_000), np.full(2_000, 0.5), np.eye(1, 2_000)[0]])
def test_silence_a_constant_and_an_impulse_have_none(samples):
    assert found_in(samples) == ((), 0.0)


def test_less_than_a_window_is_refused():
    with pytest.raises(ValueError, match="window"):
        found_in(np.zeros(150))
