"""True peak against tones of known crest and against the ideal interpolator."""

import math
import os
from pathlib import Path

import numpy as np
import pytest

from audio_checks import wav
from audio_checks.measure.levels import sample_peak_dbfs
from audio_checks.measure.true_peak import OVERSAMPLING, TAPS, TruePeak, phases, true_peak_dbtp
from tests.support.waves import click, noise, silence

FRAMES = 4_096


def faded_tone(per_frame, phase):
    """A full-scale tone without the overshoot of an abrupt start; its crest is 0 dBTP."""
    frame = np.arange(FRAMES)
    fade = np.clip(np.minimum(frame, FRAMES - 1 - frame) / 1_000, 0, 1)
    return (np.sin(fade * np.pi / 2) ** 2 * np.sin(2 * np.pi * per_frame * frame + phase))[:, np.newaxis]


def ideal_peak_dbtp(samples, times=64):
    """The crest of the band-limited curve, by zero-padding the spectrum."""
    best = 0.0
    for channel in samples.T:
        padded = np.pad(channel, 2_000)
        bins = np.fft.rfft(padded)
        bins = np.pad(bins, (0, (times - 1) * (len(padded) // 2)))
        best = max(best, np.abs(np.fft.irfft(bins, len(padded) * times) * times).max())
    return 20 * math.log10(best)


def test_between_samples_the_curve_is_higher():
    # At a quarter of the sample rate and 45° every sample sits 3.01 dB below the crest.
    tone = faded_tone(1 / 4, np.pi / 4)
    assert sample_peak_dbfs(tone) == pytest.approx(-3.01, abs=0.01)
    assert true_peak_dbtp(tone, 48_000) == pytest.approx(0, abs=0.01)


@pytest.mark.parametrize(
    "per_frame", [0.001, 0.01, 0.1, 1 / 6, 1 / 5, 1 / 4, 1 / 3, 3 / 8, 2 / 5, 5 / 12, 3 / 7, 4 / 9, 0.45]
)
def test_tones_of_any_phase_are_right_to_the_grid(per_frame):
    # 16x points lie at most 1/32 frame from the crest: 20·log10(cos(π·0.45 / 16)) = -0.034 dB at 0.45.
    for phase in np.linspace(0, np.pi, 12):
        assert -0.035 <= true_peak_dbtp(faded_tone(per_frame, phase), 48_000) <= 0.01


@pytest.mark.parametrize("rate", [8_000, 22_050, 44_100, 48_000, 88_200, 96_000, 192_000])
def test_the_grid_is_as_fine_at_every_rate(rate):
    for per_frame in (0.3, 0.4, 0.45):
        assert -0.035 <= true_peak_dbtp(faded_tone(per_frame, 0.3), rate) <= 0.01


@pytest.mark.parametrize("seed", range(4))
def test_noise_to_the_top_of_the_band_agrees_with_the_ideal_interpolator(seed):
    bins = np.fft.rfft(noise(dbfs=-12, seconds=0.25, channels=2, seed=seed), axis=0)
    bins[int(0.98 * len(bins)) :] = 0
    burst = np.fft.irfft(bins, 12_000, axis=0) * np.hanning(12_000)[:, np.newaxis]
    assert -0.1 <= true_peak_dbtp(burst, 48_000) - ideal_peak_dbtp(burst) <= 0.05


@pytest.mark.parametrize("seed", range(6))
def test_effects_agree_with_the_ideal_interpolator(seed):
    # Decaying noise, darker at the top of the band as recordings are.
    rng = np.random.default_rng(seed)
    frames = 12_000
    bins = np.fft.rfft(rng.standard_normal((frames, 2)) * np.exp(-np.arange(frames) / 2_000)[:, np.newaxis], axis=0)
    per_frame = np.fft.rfftfreq(frames)
    bins *= (1 / (1 + (per_frame / 0.15) ** 4))[:, np.newaxis]
    effect = np.fft.irfft(bins, frames, axis=0)
    effect *= 0.9 / np.abs(effect).max()
    assert -0.1 <= true_peak_dbtp(effect, 48_000) - ideal_peak_dbtp(effect) <= 0.05


def test_real_effects_agree_with_the_ideal_interpolator():
    folder = os.environ.get("SOUNDS_DIR")
    if not folder:
        pytest.skip("SOUNDS_DIR does not name a folder of real recordings")
    short = [path for path in sorted(Path(folder).rglob("*.wav")) if path.stat().st_size < 120_000]
    for path in short[::3]:
        with wav.open_regular(path) as file:
            layout = wav.read_layout(file)
            samples = np.concatenate(list(wav.blocks(file, layout)))
        off = true_peak_dbtp(samples, layout.sample_rate_hz) - ideal_peak_dbtp(samples, times=16)
        assert -0.1 <= off <= 0.05, path.name
    assert len(short) >= 20


@pytest.mark.parametrize("size", [1, 7, 31, 32, 33, 255, 256, 1_000])
def test_blocks_of_any_size_give_the_same(size):
    samples = noise(seconds=0.03, channels=2)
    whole, parts = TruePeak(48_000, 2, len(samples)), TruePeak(48_000, 2, len(samples))
    whole.add(samples)
    for start in range(0, len(samples), size):
        parts.add(samples[start : start + size])
    assert parts.result() == pytest.approx(whole.result(), abs=1e-12)


@pytest.mark.parametrize("frame", [0, 1, 500, 998, 999])
def test_a_crest_is_found_wherever_it_is(frame):
    # Two equal samples next to each other: the curve is highest half-way, 4/π for an ideal interpolator.
    samples = np.zeros((1_000, 2))
    samples[frame : frame + 2, 1] = 0.5
    meter = TruePeak(1_000, 2, 1_000)
    meter.add(samples)
    result = meter.result()
    alone = frame == 999
    assert result["true_peak_dbtp"] == pytest.approx(20 * math.log10(0.5 if alone else 2 / np.pi), abs=0.1)
    assert result["true_peak_s"] * 1_000 == pytest.approx(frame + (0 if alone else 0.5), abs=1e-9)


def test_silence_one_frame_and_no_frames():
    assert true_peak_dbtp(silence(seconds=0.1), 48_000) == -math.inf
    assert true_peak_dbtp(np.zeros((0, 2)), 48_000) == -math.inf
    assert true_peak_dbtp(np.array([[0.5]]), 48_000) == pytest.approx(20 * math.log10(0.5), abs=1e-9)
    assert true_peak_dbtp(click(dbfs=-6), 48_000) == pytest.approx(-6, abs=1e-9)


def test_phases_mirror_each_other_and_delay():
    taps = phases()
    assert taps.shape == (OVERSAMPLING - 1, TAPS)
    assert taps == pytest.approx(taps[::-1, ::-1], abs=1e-9)
    assert taps.sum(axis=1) == pytest.approx(1, abs=0.002)
