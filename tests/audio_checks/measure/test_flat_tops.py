"""Flat tops: at full scale, under it, and soft ones; round crests and square waves are none."""

import numpy as np
import pytest

from audio_checks.measure.faults import Faults
from tests.support.waves import noise, sine


def flat_tops(samples, size=1_000, step=2.0**-23, rate=1_000):
    meter = Faults(rate, samples.shape[1], len(samples), step=step)
    for start in range(0, len(samples), size):
        meter.add(samples[start : start + size])
    return meter.result()


@pytest.mark.parametrize("size", [1, 2, 3, 5, 100])
def test_runs_at_full_scale_are_found_whatever_the_blocks(size):
    samples = np.zeros((100, 2))
    samples[10:13, 0] = 1.0
    samples[20:22, 0] = 1.0  # two are a crest
    samples[30:40, 1] = -1.0
    samples[40:43, 1] = 1.0  # the other rail is another run
    samples[97:, 0] = -1.0
    figures = flat_tops(samples, size)
    assert figures["clipped_runs"] == 4
    assert figures["clipped_spans"] == (
        (0.010, 0.013, 1, 0.0),
        (0.030, 0.040, 2, 0.0),
        (0.040, 0.043, 2, 0.0),
        (0.097, 0.100, 1, 0.0),
    )


@pytest.mark.parametrize(("step", "level", "runs"), [(2.0**-7, 127 / 128, 1), (2.0**-15, 127 / 128, 0), (0.0, 1.2, 1)])
def test_full_scale_is_the_largest_sample_of_the_depth(step, level, runs):
    assert flat_tops(np.full((10, 1), level), step=step)["clipped_runs"] == runs


def test_a_normalised_sine_is_not_clipped():
    assert flat_tops(sine(hz=997, dbfs=0))["clipped_runs"] == 0


def test_a_driven_sine_is_clipped_twice_a_period():
    assert flat_tops(np.clip(sine(hz=100, dbfs=6), -1, 1))["clipped_runs"] == 200


def test_many_runs_are_counted_and_the_first_kept():
    samples = np.tile(np.array([1.0, 1.0, 1.0, 0.0]), 3_000)[:, np.newaxis]
    figures = flat_tops(samples)
    assert figures["clipped_runs"] == 3_000
    assert len(figures["clipped_spans"]) == 1_000


@pytest.mark.parametrize("hz", [50, 200, 1_000])
@pytest.mark.parametrize("bits", [16, 24])
def test_a_lower_level_leaves_the_flat_tops_in(hz, bits):
    step = 2.0 ** (1 - bits)
    lowered = np.round(np.clip(sine(hz=hz, dbfs=3), -1, 1) * 0.37 / step) * step
    figures = flat_tops(lowered, step=step, rate=48_000)
    assert figures["clipped_runs"] == 2 * hz
    assert figures["clipped_spans"][0].level_dbfs == pytest.approx(20 * np.log10(0.37), abs=0.01)


@pytest.mark.parametrize("hz", [20, 50, 200, 1_000])
@pytest.mark.parametrize("bits", [8, 16, 24])
def test_round_crests_are_not_flat_however_coarse_the_steps(hz, bits):
    step = 2.0 ** (1 - bits)
    figures = flat_tops(np.round(sine(hz=hz, dbfs=-6) / step) * step, step=step, rate=48_000)
    assert figures["clipped_runs"] == figures["soft_tops"] == 0


def test_two_crests_as_high_are_chance_and_three_a_ceiling():
    tops = np.tile(np.sin(np.pi * np.arange(100) / 100) * 0.2, 5)
    for place in (1, 3):
        tops[100 * place : 100 * (place + 1)] = np.minimum(tops[:100] * 3, 0.4)
    assert flat_tops(tops[:, np.newaxis], rate=48_000)["clipped_runs"] == 0
    tops[:100] = tops[100:200]
    assert flat_tops(tops[:, np.newaxis], rate=48_000)["clipped_runs"] == 3


def test_soft_tops_of_a_saturator():
    hard_driven = np.tanh(6 * sine(hz=300, dbfs=0)) * 0.5
    figures = flat_tops(hard_driven, rate=48_000)
    assert figures["clipped_runs"] == 0
    assert figures["soft_tops"] == pytest.approx(600, abs=1)
    assert flat_tops(np.tanh(1.5 * sine(hz=300, dbfs=0)) * 0.5, rate=48_000)["soft_tops"] == 0


@pytest.mark.parametrize("hz", [100, 440])
def test_a_square_wave_is_flat_by_nature(hz):
    square = np.sign(sine(hz=hz, phase=0.01)) * 0.5
    figures = flat_tops(square, rate=48_000)
    assert figures["clipped_runs"] == figures["soft_tops"] == 0


def test_noise_under_full_scale_is_not_clipped():
    figures = flat_tops(noise(dbfs=-20, channels=2), rate=48_000)
    assert figures["clipped_runs"] == figures["soft_tops"] == 0
