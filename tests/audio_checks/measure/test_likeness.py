"""The print of a sound: copies are near however they were changed, others are far."""

import itertools

import numpy as np
import pytest

from audio_checks.measure.likeness import Likeness, unlikeness_db
from tests.support.waves import join, noise, silence, sine


def print_of(samples, rate=48_000, block_frames=65_536):
    likeness = Likeness(rate, samples.shape[1], len(samples))
    for start in range(0, len(samples), block_frames):
        likeness.add(samples[start : start + block_frames])
    return likeness.result()["likeness_print"]


def burst(seed=1, seconds=0.5, channels=1):
    """Noise that dies away: one of many hits of the same thing."""
    decay = np.exp(-np.linspace(0, 7, round(seconds * 48_000)))[:, np.newaxis]
    return noise(seconds=seconds, seed=seed, channels=channels, dbfs=-10) * decay


def quantised(samples, bits):
    return np.rint(samples * 2 ** (bits - 1)) / 2 ** (bits - 1)


CHANGES = {
    "itself": lambda samples: samples,
    "12 dB softer": lambda samples: samples * 0.25,
    "turned round in polarity": lambda samples: -samples,
    "16 bit and softer": lambda samples: quantised(samples * 0.5, 16),
    "with noise 50 dB below": lambda samples: samples + noise(seconds=0.5, seed=9, dbfs=-75),
    "without its last tenth": lambda samples: samples[:21_600],
    "with silence after it": lambda samples: join(samples, silence(seconds=0.3)),
    "in both channels": lambda samples: np.repeat(samples, 2, axis=1),
}


@pytest.mark.parametrize("name", CHANGES)
def test_a_copy_is_near(name):
    assert unlikeness_db(print_of(burst()), print_of(CHANGES[name](burst()))) < 0.3


@pytest.mark.parametrize("seconds", [0.1, 0.5, 5])
def test_another_drawing_of_the_same_noise_is_far(seconds):
    prints = [print_of(burst(seed, seconds)) for seed in range(1, 13)]
    assert min(unlikeness_db(one, other) for one, other in itertools.combinations(prints, 2)) > 0.9


def test_tones_of_other_pitch_are_far():
    assert unlikeness_db(print_of(sine(hz=440)), print_of(sine(hz=1_200))) > 3
    assert unlikeness_db(print_of(sine(hz=440)), print_of(sine(hz=440, dbfs=-20))) < 0.1


@pytest.mark.parametrize("rate", [8_000, 11_025, 44_100, 96_000])
def test_the_same_at_another_rate(rate):
    tones = [sine(hz=hz, seconds=1, rate=48_000) for hz in (100, 300, 900, 2_700)]
    others = [sine(hz=hz, seconds=1, rate=rate) for hz in (100, 300, 900, 2_700)]
    assert unlikeness_db(print_of(sum(tones)), print_of(sum(others), rate)) < 0.2


def test_silence_and_too_little():
    assert print_of(silence()) is None
    assert unlikeness_db(print_of(burst(seconds=0.03)), print_of(burst(seconds=0.03))) is None
    one_frame = print_of(np.array([[0.5]]))
    assert unlikeness_db(one_frame, one_frame) is None


@pytest.mark.parametrize("block_frames", [1, 100, 960, 7_777])
def test_blocks_make_no_difference(block_frames):
    samples = burst(channels=2)
    assert print_of(samples, block_frames=block_frames) == print_of(samples)


def test_the_print_is_short():
    assert len(print_of(noise(seconds=70))) < 700
