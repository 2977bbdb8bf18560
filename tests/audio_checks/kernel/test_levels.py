"""Peaks, sums and products, held to numpy."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel
from tests.audio_checks.kernel.signals import Samples, cut, signals


@given(signals(), st.integers(0, 99))
def test_levels_of_blocks_of_any_length(samples: Samples, seed: int):
    frames, channels = samples.shape
    figures, seen, peak_frame = np.zeros((channels, 3)), 0, 0
    for block in cut(samples, np.random.default_rng(seed)):
        place = kernel.levels(kernel.by_channel(block), figures)
        peak_frame = seen + place if place >= 0 else peak_frame
        seen += len(block)
    peaks = np.abs(samples).max(axis=0, initial=0)
    np.testing.assert_array_equal(figures[:, 0], peaks)
    np.testing.assert_allclose(figures[:, 1], samples.sum(axis=0), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(figures[:, 2], np.square(samples).sum(axis=0), rtol=1e-12, atol=1e-300)
    loud = np.abs(samples).max(axis=1, initial=0)
    assert peak_frame == (int(np.argmax(loud)) if frames and peaks.max() else 0)
    assert kernel.highest(kernel.by_channel(samples)) == peaks.max()


@given(signals(most_channels=5), st.integers(0, 99))
def test_products_of_every_two_channels(samples: Samples, seed: int):
    channels = samples.shape[1]
    sums = np.zeros((channels, channels))
    for block in cut(samples, np.random.default_rng(seed)):
        kernel.products(kernel.by_channel(block), sums)
    loudest = np.square(samples).max(initial=0)
    np.testing.assert_allclose(sums, samples.T @ samples, rtol=1e-11, atol=1e-9 * (1 + loudest))
    np.testing.assert_array_equal(sums, sums.T)


def test_the_same_block_gives_the_same_bits():
    # At any address, so whether or not the registers' loads are aligned.
    samples = np.random.default_rng(1).standard_normal(1_003)
    answers = set()
    for shift in range(4):
        row = np.concatenate((np.zeros(shift), samples))[np.newaxis, shift:]
        figures = np.zeros((1, 3))
        kernel.levels(row, figures)
        answers.add(figures.tobytes())
    assert len(answers) == 1
