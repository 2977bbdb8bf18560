"""Bandwidth and loop seams, from theory."""

import math

import numpy as np
import pytest

from audio_checks.measure.seam import Seam
from audio_checks.measure.spectrum import Spectrum
from tests.support.waves import noise, pcm_bytes, silence, sine


def bandwidth(samples, rate=48_000, step=0.0, size=5_000):
    meter = Spectrum(rate, samples.shape[1], len(samples), step=step)
    for start in range(0, len(samples), size):
        meter.add(samples[start : start + size])
    return meter.result()["bandwidth_hz"]


def band_limited(hz, seconds=1.0, rate=48_000, seed=3):
    samples = noise(dbfs=-12, seconds=seconds, rate=rate, seed=seed)
    bins = np.fft.rfft(samples, axis=0)
    bins[np.fft.rfftfreq(len(samples), 1 / rate) > hz] = 0
    return np.fft.irfft(bins, len(samples), axis=0)


@pytest.mark.parametrize("hz", [4_000, 11_025, 16_000, 20_000])
@pytest.mark.parametrize("seconds", [0.05, 0.5, 2.0])
def test_band_limited_noise(hz, seconds):
    assert bandwidth(band_limited(hz, seconds)) == pytest.approx(hz, abs=100)


@pytest.mark.parametrize("bits", [16, 24])
def test_dither_is_not_bandwidth(bits):
    rng = np.random.default_rng(1)
    step = 2.0 ** (1 - bits)
    quiet = band_limited(5_000) * 0.05
    dithered = np.round(quiet / step + rng.random(quiet.shape) - rng.random(quiet.shape)) * step
    assert bandwidth(dithered, step=step) == pytest.approx(5_000, rel=0.05)


def test_white_noise_reaches_the_top():
    assert bandwidth(noise(seconds=0.3, channels=2), rate=48_000) == 24_000


def test_silence_and_single_frames():
    assert bandwidth(silence(seconds=0.5)) == 0
    assert bandwidth(np.zeros((1, 1))) == 0
    assert math.isfinite(bandwidth(np.ones((1, 1))))


@pytest.mark.parametrize("size", [1, 333, 4_096, 50_000])
def test_blocks_of_any_size_give_the_same_spectrum(size):
    samples = band_limited(7_000, seconds=0.2)
    assert bandwidth(samples, size=size) == bandwidth(samples, size=len(samples))


def test_the_end_of_the_file_counts():
    samples = np.concatenate([sine(hz=500, seconds=0.1), sine(hz=9_000, seconds=0.02)])
    assert bandwidth(samples) > 9_000


def seam(samples, loop=None, size=700):
    meter = Seam(48_000, samples.shape[1], len(samples), loops=[(*loop, False)] if loop else [])
    for start in range(0, len(samples), size):
        meter.add(samples[start : start + size])
    figures = meter.result()
    seams = figures.pop("loop_seams")
    assert seams == (((figures["seam_step_db"], figures["seam_slope_db"]),) if loop else ())
    return figures


def test_whole_periods_loop_without_a_seam():
    figures = seam(sine(hz=480, seconds=1.0))
    assert figures["seam_step_db"] == pytest.approx(0, abs=0.1)
    assert figures["seam_slope_db"] < 0.1


def test_half_a_period_too_many_bends_the_slope():
    figures = seam(sine(hz=480, seconds=1.0 + 0.5 / 480))
    assert figures["seam_step_db"] <= 0.1
    assert figures["seam_slope_db"] > 20


def test_a_quarter_period_too_many_steps():
    # From the crest back to zero: one amplitude, against the steepest step 2·sin(π·480 / 48000).
    figures = seam(sine(hz=480, seconds=1.0 + 0.25 / 480))
    assert figures["seam_step_db"] == pytest.approx(20 * math.log10(1 / (2 * math.sin(math.pi * 0.01))), abs=0.1)


def test_the_loop_points_are_used():
    samples = noise(seconds=1, dbfs=-30)
    samples[10_000:20_000] = sine(hz=480, seconds=10_000 / 48_000)
    assert seam(samples, loop=(10_000, 19_999))["seam_step_db"] == pytest.approx(0, abs=0.1)
    assert seam(samples, loop=(10_000, 19_975))["seam_step_db"] > 20


@pytest.mark.parametrize("frames", [1, 2, 3, 100])
def test_short_and_silent_loops(frames):
    assert set(seam(np.zeros((frames, 2))).values()) == {-math.inf}
    assert all(value < math.inf for value in seam(np.ones((frames, 1)) * 0.5).values())


def test_a_step_of_one_bit_is_no_seam():
    samples = np.frombuffer(pcm_bytes(np.zeros((4_800, 1)), 16), "<i2")[:, np.newaxis] / 32_768
    samples[2_400:] += 1 / 32_768
    assert seam(samples)["seam_step_db"] < 0
