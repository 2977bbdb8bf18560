"""The drawn shape of a sound: extremes and power per point, whatever the block size."""

import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks.measure.waveform import LARGE_POINTS, SMALL_POINTS, Waveform, WaveShape


def waveform(samples: NDArray[np.float64], sample_rate_hz: int, points: int = SMALL_POINTS) -> WaveShape:
    frames, channels = samples.shape
    accumulator = Waveform(sample_rate_hz, channels, frames, points)
    accumulator.add(samples)
    return accumulator.result()


def test_points_hold_the_extremes_and_power_of_their_frames():
    samples = np.array([0.5, -0.25, 0.0, 0.0, 1.0, -1.0])[:, np.newaxis]
    shape = waveform(samples, 48_000, points=3)
    assert shape.lowest.tolist() == [-0.25, 0.0, -1.0]
    assert shape.highest.tolist() == [0.5, 0.0, 1.0]
    assert shape.rms == pytest.approx([np.sqrt((0.25 + 0.0625) / 2), 0.0, 1.0])


def test_channels_share_one_lane():
    shape = waveform(np.array([[1.0, 0.0], [0.0, -0.5]]), 48_000, points=1)
    assert (shape.lowest[0], shape.highest[0]) == (-0.5, 1.0)
    assert shape.rms[0] == pytest.approx(np.sqrt(1.25 / 4))


@pytest.mark.parametrize("points", [1, 7, 240, LARGE_POINTS])
@pytest.mark.parametrize("cut", [1, 100, 1_001, 65_536])
def test_blocks_may_be_cut_anyhow(points, cut):
    noise = np.random.default_rng(1).uniform(-1, 1, (5_003, 2))
    streamed = Waveform(48_000, 2, len(noise), points)
    for at in range(0, len(noise), cut):
        streamed.add(noise[at : at + cut])
    whole, parts = waveform(noise, 48_000, points), streamed.result()
    assert np.array_equal(parts.lowest, whole.lowest)
    assert np.array_equal(parts.highest, whole.highest)
    assert parts.rms == pytest.approx(whole.rms)
    assert parts.points == points


def test_a_click_of_one_frame_is_seen():
    samples = np.zeros((1_000_000, 1))
    samples[777_777] = -1.0
    shape = waveform(samples, 48_000)
    assert shape.lowest.min() == -1.0
    assert np.argmin(shape.lowest) == 777_777 * 240 // 1_000_000


def test_a_square_and_a_sine_differ_in_power_only():
    turns = 2 * np.pi * np.arange(48_000) / 100
    shape = waveform(np.sin(turns)[:, np.newaxis], 48_000, points=10)
    assert shape.rms == pytest.approx(np.sqrt(0.5), abs=1e-6)
    assert shape.highest == pytest.approx(1.0)


def test_short_sounds_have_a_point_a_frame():
    samples = np.array([[0.1], [-0.2], [0.3]])
    shape = waveform(samples, 48_000)
    assert shape.points == 3
    assert shape.lowest.tolist() == shape.highest.tolist() == [0.1, -0.2, 0.3]


@pytest.mark.parametrize("channels", [1, 2])
def test_silence_and_nothing(channels):
    assert not waveform(np.zeros((1_000, channels)), 48_000).rms.any()
    assert waveform(np.zeros((0, channels)), 48_000).to_dict() == {
        "frames": 0,
        "sample_rate_hz": 48_000,
        "min": [],
        "max": [],
        "rms": [],
    }


def test_plain_numbers():
    shape = waveform(np.array([[0.123456], [-0.00001]]), 48_000).to_dict()
    assert shape == {
        "frames": 2,
        "sample_rate_hz": 48_000,
        "min": [0.1235, 0.0],
        "max": [0.1235, 0.0],
        "rms": [0.1235, 0.0],
    }


def test_in_steps_what_lies_beyond_full_scale_stays_beyond_it():
    shape = waveform(np.array([[0.5], [-1.25], [0.00004], [1e300]]), 48_000).in_steps(10_000)
    assert shape["points"] == 4
    assert shape["min"] == shape["max"] == [5_000, -12_500, 0, 2**31 - 1]
    assert shape["rms"][:3] == [5_000, 12_500, 0]
