"""Peak, RMS, offset and bits, from theory."""

import math

import numpy as np
import pytest

from audio_checks.measure.bits import effective_bits
from audio_checks.measure.levels import Levels, dc_offset_percent, rms_dbfs, sample_peak_dbfs
from tests.support.waves import click, join, noise, silence, sine


def measured(accumulator, samples, size=1_000):
    for start in range(0, len(samples), size):
        accumulator.add(samples[start : start + size])
    return accumulator.result()


def levels(samples, rate=48_000):
    return measured(Levels(rate, samples.shape[1], len(samples)), samples)


def test_a_sine():
    figures = levels(sine(hz=1_000, dbfs=-6, channels=2))
    assert figures["sample_peak_dbfs"] == pytest.approx(-6, abs=1e-9)
    assert figures["rms_dbfs"] == pytest.approx(-9.0103, abs=1e-4)
    assert figures["crest_db"] == pytest.approx(3.0103, abs=1e-4)
    assert figures["dc_offset_percent"] == pytest.approx(0, abs=1e-9)
    assert figures["sample_peak_s"] == pytest.approx(0.25e-3)
    assert figures["silent_channels"] == ()
    assert not figures["is_silence"]


def test_a_full_scale_square_is_0_dbfs_rms():
    square = np.where(np.arange(960) % 96 < 48, 1.0, -1.0)[:, np.newaxis]
    assert rms_dbfs(square) == 0
    assert levels(square)["crest_db"] == 0


def test_the_last_sample_of_the_last_channel_counts():
    samples = silence(channels=3, seconds=0.1)
    samples[-1, 2] = -0.5
    figures = levels(samples)
    assert figures["sample_peak_dbfs"] == pytest.approx(-6.0206, abs=1e-4)
    assert figures["sample_peak_s"] == pytest.approx(4_799 / 48_000)
    assert figures["silent_channels"] == (1, 2)


def test_the_first_of_equal_peaks_is_named():
    samples = join(click(at_s=0.5, channels=2), click(at_s=0.2, channels=2))
    samples[30_000] = -samples[24_000]
    assert levels(samples)["sample_peak_s"] == 0.5


@pytest.mark.parametrize("offset", [0.01, -0.01])
def test_offset_of_the_worst_channel(offset):
    samples = sine(hz=100, channels=2) + np.array([0.002, offset])
    assert levels(samples)["dc_offset_percent"] == pytest.approx(1.0, abs=1e-6)
    assert dc_offset_percent(samples) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.parametrize("samples", [silence(channels=2), np.zeros((1, 1))])
def test_silence(samples):
    figures = levels(samples)
    assert figures["is_silence"]
    assert figures["sample_peak_dbfs"] == figures["rms_dbfs"] == -math.inf
    assert figures["crest_db"] == figures["dc_offset_percent"] == figures["sample_peak_s"] == 0


def test_each_channel_has_its_peak():
    samples = np.hstack([sine(hz=1_000, dbfs=-6), sine(hz=1_000, dbfs=-20), silence()])
    assert levels(samples)["channel_peaks_dbfs"] == (
        pytest.approx(-6, abs=0.01),
        pytest.approx(-20, abs=0.01),
        -math.inf,
    )


def test_no_frames_at_all():
    nothing = np.zeros((0, 2))
    assert sample_peak_dbfs(nothing) == rms_dbfs(nothing) == -math.inf
    assert dc_offset_percent(nothing) == 0


def test_plain_functions_agree_with_blocks():
    samples = noise(channels=2)
    figures = levels(samples)
    assert figures["sample_peak_dbfs"] == pytest.approx(sample_peak_dbfs(samples), abs=1e-12)
    assert figures["rms_dbfs"] == pytest.approx(rms_dbfs(samples), abs=1e-9)
    assert figures["dc_offset_percent"] == pytest.approx(dc_offset_percent(samples), abs=1e-9)


@pytest.mark.parametrize(
    ("values", "container", "bits"),
    [([0], 16, 0), ([1], 16, 16), ([-1], 16, 16), ([256, -512], 16, 8), ([0x7FFF00], 24, 16), ([-(2**31)], 32, 1)],
)
def test_effective_bits(values, container, bits):
    used = 0
    for value in values:
        used |= value << (8 if container == 24 else 0)
    assert effective_bits(used, container) == bits


@pytest.mark.parametrize("peak", [1e-200, 1e-300, 5e-324])
def test_numbers_whose_squares_are_zero_have_no_crest(peak):
    figures = levels(np.full((100, 1), peak))
    assert (figures["crest_db"], figures["rms_dbfs"]) == (0.0, -np.inf)
    assert figures["sample_peak_dbfs"] < -3_900
