"""The highest point of the curve, held to a curve that is drawn everywhere."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from audio_checks.measure.true_peak import HISTORY, TruePeak, half_phases, middle_taps
from tests.audio_checks.kernel.signals import Samples, cut, signals
from tests.support.waves import join, noise, sine


def whole_curve(samples: Samples) -> float:
    """The highest of all fine points between all samples, and of the samples themselves."""
    padded = np.pad(samples, ((HISTORY, HISTORY), (0, 0)))
    return max(float(np.abs(samples).max(initial=0)), *(_highest(channel) for channel in padded.T))


def _highest(channel: Samples) -> float:
    middles = np.convolve(channel, middle_taps(), "valid")
    twice = np.empty(2 * len(middles))
    twice[0::2] = channel[len(middle_taps()) // 2 - 1 :][: len(middles)]  # the sample before each middle
    twice[1::2] = middles
    between = [np.convolve(twice, taps[::-1], "valid") for taps in half_phases()]
    return max(float(np.abs(points).max()) for points in (twice, *between))


def measured(blocks: list[Samples], channels: int, frames: int) -> dict[str, float]:
    meter = TruePeak(1_000, channels, frames)
    for block in blocks:
        meter.add(block)
    return meter.result()


@settings(max_examples=40)
@given(signals(most_frames=500, most_channels=3), st.integers(0, 99))
def test_skipping_changes_nothing(samples: Samples, seed: int):
    figures = measured(cut(samples, np.random.default_rng(seed)), samples.shape[1], len(samples))
    level, highest = figures["true_peak_dbtp"], whole_curve(samples)
    if highest == 0:
        assert level == -math.inf
    elif highest > 1e-300:  # below that doubles lose their digits
        # What 24 taps cannot see of the treble is estimated: a hair may be missed in white noise.
        assert -0.01 <= level - 20 * math.log10(highest) <= 1e-9


@pytest.mark.parametrize(
    "samples",
    [
        noise(seconds=0.2, channels=2),
        noise(seconds=0.3, rate=96_000, seed=4),
        join(noise(seconds=0.1, dbfs=-50), sine(hz=9_000, seconds=0.1)),
        join(sine(hz=23_500, seconds=0.05, phase=0.4), noise(seconds=0.1, dbfs=-40)),
        np.sign(sine(hz=997, seconds=0.1)),
    ],
)
def test_sounds_and_noise_miss_nothing(samples: Samples):
    level = measured([samples], samples.shape[1], len(samples))["true_peak_dbtp"]
    assert level == pytest.approx(20 * math.log10(whole_curve(samples)), abs=1e-9)


@settings(max_examples=40)
@given(signals(most_frames=900, most_channels=3), st.integers(0, 99))
def test_blocks_of_any_length_give_the_same(samples: Samples, seed: int):
    frames, channels = samples.shape
    whole = measured([samples], channels, frames)
    parts = measured(cut(samples, np.random.default_rng(seed)), channels, frames)
    assert parts["true_peak_dbtp"] == pytest.approx(whole["true_peak_dbtp"], abs=0.01)


@pytest.mark.parametrize("place", [2_290, 2_300, 2_303, 2_304, 2_335, 2_336, 4_340, 4_352, 4_400, 6_390])
def test_a_curve_that_rises_after_many_rows_of_silence(place: int):
    samples = np.zeros((6_400, 1))
    samples[100] = 1.0
    samples[place : place + 4, 0] = 0.95, 0.95, -0.95, -0.95  # between these the curve is higher than the sample before
    whole = measured([samples], 1, len(samples))
    assert whole == measured(np.split(samples, range(500, 6_400, 500)), 1, len(samples))
    assert whole["true_peak_dbtp"] > 1.0
    assert whole["true_peak_s"] * 1_000 == pytest.approx(place + 1.5, abs=2)
