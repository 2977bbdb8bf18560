"""Peaks, sums and products, held to numpy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel
from audio_checks.measure.levels import Levels
from audio_checks.measure.maxima import maxima_of
from tests.audio_checks.kernel.signals import Samples, cut, signals


@pytest.mark.slow
@given(signals(), st.integers(0, 99))
def test_sums_of_blocks_of_any_length(samples: Samples, seed: int):
    figures = np.zeros((samples.shape[1], 2))
    for block in cut(samples, np.random.default_rng(seed)):
        kernel.sums(kernel.by_channel(block), figures)
    np.testing.assert_allclose(figures[:, 0], samples.sum(axis=0), rtol=1e-12, atol=1e-12)
    np.testing.assert_allclose(figures[:, 1], np.square(samples).sum(axis=0), rtol=1e-12, atol=1e-300)


@pytest.mark.slow
@given(signals())
def test_the_highest_of_each_row(samples: Samples):
    sizes = np.abs(samples)
    assert kernel.highest(kernel.by_channel(samples)) == sizes.max(initial=0)
    rows = [sizes[start : start + 32].max(axis=0) for start in range(0, len(samples), 32)]
    np.testing.assert_array_equal(maxima_of(kernel.by_channel(samples)), np.array(rows).reshape(-1, samples.shape[1]).T)


@pytest.mark.slow
@given(signals(), st.integers(0, 99))
def test_the_first_frame_at_the_peak(samples: Samples, seed: int):
    meter = Levels(1, samples.shape[1], len(samples))
    for block in cut(samples, np.random.default_rng(seed)):
        meter.add(block)
    loud = np.abs(samples).max(axis=1, initial=0)
    assert meter.result()["sample_peak_s"] == (int(np.argmax(loud)) if loud.any() else 0)


@pytest.mark.slow
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
        figures = np.zeros((1, 2))
        kernel.sums(row, figures)
        answers.add(figures.tobytes())
    assert len(answers) == 1


@pytest.mark.slow
@given(signals(most_channels=2), st.integers(1, 200), st.integers(0, 99))
def test_products_of_stereo_by_hops(samples: Samples, hop: int, seed: int):
    if samples.shape[1] != 2:
        samples = np.hstack((samples, samples[::-1]))
    hops = np.zeros((-(-len(samples) // hop) + 1, 4))
    seen = 0
    for block in cut(samples, np.random.default_rng(seed)):
        kernel.stereo_products(kernel.by_channel(block), seen % hop, hop, hops[seen // hop :])
        seen += len(block)
    left, right = samples.T
    figures = np.stack((left * left, right * right, left * right, (left - right) ** 2), axis=1)
    loudest = np.square(samples).max(initial=0)
    wanted = [figures[start : start + hop].sum(axis=0) for start in range(0, len(hops) * hop, hop)]
    np.testing.assert_allclose(hops, wanted, rtol=1e-11, atol=1e-9 * (1 + loudest))


@pytest.mark.slow
@given(signals(), st.sampled_from([0.0, 1e-3, 0.5]))
def test_the_first_and_the_last_loud_frame(samples: Samples, level: float):
    block = kernel.by_channel(samples)
    loud = np.flatnonzero((np.abs(samples) > level).any(axis=1)).tolist()
    assert kernel.loud_frames(block, maxima_of(block), level) == ((loud[0], loud[-1]) if loud else (-1, -1))


@pytest.mark.slow
@given(signals(), st.integers(1, 40))
def test_groups_are_added_up_as_numpy_does(samples: Samples, size: int):
    rows = kernel.by_channel(samples)
    whole = rows[:, : len(samples) // size * size].reshape(len(rows), -1, size)
    sums = np.empty(whole.shape[:2])
    kernel.group_sums(rows, size, sums)
    np.testing.assert_array_equal(sums, whole.sum(axis=2))


@pytest.mark.parametrize(("size", "rows", "sums"), [(0, 2, 1), (-1, 2, 1), (10, 2, 11), (10, 1, 10), (10, 3, 10)])
def test_whole_groups_are_wanted(size: int, rows: int, sums: int):
    with pytest.raises(ValueError, match="wanted"):
        kernel.group_sums(np.zeros((2, 100)), size, np.empty((rows, sums)))


@pytest.mark.parametrize(("at", "hop", "room"), [(0, 10, 9), (10, 10, 11), (-1, 10, 11), (0, 0, 11), (5, 10, 10)])
def test_room_for_every_hop_is_wanted(at: int, hop: int, room: int):
    with pytest.raises(ValueError, match="wanted"):
        kernel.stereo_products(np.zeros((2, 100)), at, hop, np.zeros((room, 4)))


@pytest.mark.slow
@given(signals(), st.integers(1, 50))
def test_shapes_of_points(samples: Samples, size: int):
    rows = kernel.by_channel(samples)
    starts = np.arange(0, len(samples), size)
    lowest, highest, squares = np.full(len(starts), np.inf), np.full(len(starts), -np.inf), np.zeros(len(starts))
    kernel.shape_points(rows, starts, lowest, highest, squares)
    np.testing.assert_array_equal(lowest, np.minimum.reduceat(samples.min(axis=1), starts))
    np.testing.assert_array_equal(highest, np.maximum.reduceat(samples.max(axis=1), starts))
    wanted = np.add.reduceat(np.square(samples).sum(axis=1), starts)
    np.testing.assert_allclose(squares, wanted, rtol=1e-12, atol=1e-300)


@pytest.mark.parametrize("starts", [[0, 101], [-1, 5], [5, 4]])
def test_points_inside_the_block_are_wanted(starts: list[int]):
    with pytest.raises(ValueError, match="wanted"):
        kernel.shape_points(np.zeros((2, 100)), np.array(starts), np.zeros(2), np.zeros(2), np.zeros(2))
