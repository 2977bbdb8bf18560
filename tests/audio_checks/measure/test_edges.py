"""Silence at head and tail for any threshold, against a search of the whole signal."""

import numpy as np
import pytest

from audio_checks.measure.edges import Edges
from tests.support.waves import join, noise, silence, sine


def edges_of(samples, size=5_000, rate=48_000):
    meter = Edges(rate, samples.shape[1], len(samples))
    for start in range(0, len(samples), size):
        meter.add(samples[start : start + size])
    return meter


def searched(samples, below_dbfs, rate=48_000):
    """Head and tail by looking at every sample."""
    loudest = np.abs(samples).max(axis=1)
    heard = np.flatnonzero(loudest >= min(10 ** (below_dbfs / 20), loudest.max() * 1e-3))
    return 1_000 * heard[0] / rate, 1_000 * (len(samples) - 1 - heard[-1]) / rate


def test_silence_before_and_after():
    tone = sine(hz=1_000, dbfs=-3, seconds=0.5, channels=2, phase=0.1)
    head, tail = edges_of(join(silence(seconds=0.02, channels=2), tone, silence(seconds=0.3, channels=2))).edges(-60)
    assert head == pytest.approx(20, abs=1e-9)
    assert tail == pytest.approx(300, abs=0.03)


def test_one_channel_is_enough_to_be_heard():
    samples = join(silence(seconds=0.1, channels=2), noise(seconds=0.1, channels=2))
    samples[100, 1] = 0.5
    assert edges_of(samples).edges(-60)[0] == pytest.approx(1_000 * 100 / 48_000)


@pytest.mark.parametrize("below_dbfs", [-40, -60, -72.5, -90, -130])
@pytest.mark.parametrize("gain", [1, 0.3, 0.01])
@pytest.mark.parametrize("size", [1_000, 4_096, 100_000])
def test_every_threshold_is_answered_from_one_pass(below_dbfs, gain, size):
    frames = np.arange(60_000)
    swell = np.exp(-(((frames - 25_000) / 5_000) ** 2))[:, np.newaxis]
    samples = np.round(noise(seconds=1.25, dbfs=-12, channels=2) * swell * gain * 2**23) / 2**23
    assert edges_of(samples, size).edges(below_dbfs) == pytest.approx(searched(samples, below_dbfs), abs=1e-9)


def test_quiet_files_are_measured_against_their_peak():
    # The whole effect lies below -60 dBFS, yet it has no silence at its edges.
    assert edges_of(sine(hz=1_000, dbfs=-62, phase=1)).edges(-60) == (0, 0)


def test_slow_fades_take_bounded_memory():
    fade = np.linspace(0, 1, 1_000_000)[:, np.newaxis] ** 3
    meter = edges_of(join(fade, fade[::-1]), 65_536)
    assert len(meter._head_levels) < 150_000
    head, tail = meter.edges(-60)
    assert (head, tail) == pytest.approx(searched(join(fade, fade[::-1]), -60), rel=1e-4)


@pytest.mark.parametrize("frames", [1, 480])
def test_silence_is_silent_from_end_to_end(frames):
    length = 1_000 * frames / 48_000
    assert edges_of(np.zeros((frames, 2))).edges(-60) == (length, length)


def test_one_loud_frame():
    figures = edges_of(np.array([[0.5]])).result()
    assert (figures["head_silence_ms"], figures["tail_silence_ms"]) == (0, 0)


def test_offset_is_not_silence():
    assert edges_of(np.full((4_800, 1), 0.01)).edges(-60) == (0, 0)
