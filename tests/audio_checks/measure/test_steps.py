"""The steps of samples: padding is found whatever was done to its level, and nothing else is."""

import numpy as np
import pytest

from audio_checks.measure.steps import LEAST_VALUES, Steps, step_of
from tests.support.waves import join, noise, silence, sine


def step(samples, bits=24, block_frames=65_536):
    """Return the step of samples written at a depth."""
    whole = np.clip(np.rint(samples * 2 ** (bits - 1)), -(2 ** (bits - 1)), 2 ** (bits - 1) - 1) / 2 ** (bits - 1)
    steps = Steps(48_000, whole.shape[1], len(whole), step=2.0 ** (1 - bits))
    for start in range(0, len(whole), block_frames):
        steps.add(whole[start : start + block_frames])
    return steps.result()["sample_step"]


def quantised(samples, bits):
    return np.rint(samples * 2 ** (bits - 1)) / 2 ** (bits - 1)


SOUNDS = {
    "noise": noise(seconds=0.5, channels=2),
    "loud tone": sine(hz=443, dbfs=-0.1),
    "quiet tone": sine(hz=443, dbfs=-60),
    "decay": noise(seconds=0.5, dbfs=-12) * np.exp(-np.linspace(0, 9, 24_000))[:, None],
}


@pytest.mark.parametrize("name", SOUNDS)
@pytest.mark.parametrize("gain_db", [0, -11.3, -6.0206, -0.7, 1.9, 7.1])
def test_16_bits_in_24_whatever_the_gain(name, gain_db):
    gain = 10 ** (gain_db / 20)
    found = step(quantised(SOUNDS[name] / max(gain, 1), 16) * gain)
    assert found == pytest.approx(256 * gain, rel=1e-3)


@pytest.mark.parametrize(("was", "bits"), [(8, 16), (8, 24), (20, 24), (24, 32)])
def test_other_depths(was, bits):
    assert step(quantised(noise(seconds=0.2), was), bits) == pytest.approx(2 ** (bits - was), rel=1e-6)


@pytest.mark.parametrize("name", SOUNDS)
@pytest.mark.parametrize("bits", [8, 16, 24, 32])
def test_a_depth_that_is_made_use_of(name, bits):
    assert step(SOUNDS[name], bits) in ((None, 1.0) if bits < 24 or name == "quiet tone" else (1.0,))


def test_dither_on_the_deeper_depth_hides_nothing():
    rng = np.random.default_rng(1)
    coarse = quantised(noise(seconds=0.5), 16) * 1.3
    dithered = coarse + (rng.random(coarse.shape) - rng.random(coarse.shape)) * 2.0**-23
    assert step(dithered) == pytest.approx(332.8, rel=1e-3)


def test_a_fade_bends_the_steps_only_where_it_is():
    coarse = quantised(noise(seconds=1), 16) * 0.7
    coarse[:4_000] *= np.linspace(0, 1, 4_000)[:, None]
    coarse[-9_000:] *= np.linspace(1, 0, 9_000)[:, None]
    assert step(coarse) == pytest.approx(179.2, rel=1e-3)


def test_a_padded_half_is_a_layer_and_no_padding():
    assert step(join(quantised(noise(seconds=1), 16), noise(seconds=1.2, seed=2))) == 1.0
    assert step(np.hstack([quantised(noise(seconds=1), 16), noise(seconds=1, seed=2)])) == 1.0


@pytest.mark.parametrize(
    "samples",
    [
        silence(),
        silence(seconds=1 / 48_000) + 0.5,
        np.sign(sine(hz=100)) * 0.5,
        np.arange(LEAST_VALUES - 1)[:, None] / 2**15,
    ],
    ids=["silence", "one frame", "square", "too few"],
)
def test_what_says_nothing(samples):
    assert step(samples) is None


def test_floats_have_no_steps():
    steps = Steps(48_000, 1, 100, step=0.0)
    steps.add(noise(seconds=100 / 48_000))
    assert steps.result() == {"sample_step": None}


@pytest.mark.parametrize("block_frames", [1, 7, 1_024, 4_000])
def test_blocks_make_no_difference(block_frames):
    coarse = quantised(noise(seconds=0.1, channels=2), 16) * 0.9
    assert step(coarse, block_frames=block_frames) == step(coarse)


def test_a_thousand_real_depths_are_kept():
    rng = np.random.default_rng(5)
    for _ in range(1_000):
        count = int(rng.integers(30, 1_024))
        values = np.rint(rng.standard_normal(count) * 2 ** rng.uniform(6, 22))
        assert step_of(values) in (1.0, None)
