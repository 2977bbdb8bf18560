"""Segments that stand still or glide, held to plain references."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1), st.integers(0, 7), st.floats(0.5, 3.0), st.sampled_from([0.0, 1.0]))
def test_steady_segments(seed: int, without: int, most: float, least: float):
    # The bound that passes most segments over gives the answer of sorting each.
    rng = np.random.default_rng(seed)
    sharpness, powers = rng.choice([0.2, 0.5, 1.0, 1.5, 7.0], (2, 40))
    flags = np.empty(5, np.bool_)
    kernel.steady_segments(sharpness, powers, 8, without, least, most, flags)
    for flag, sharp, power in zip(flags.tolist(), sharpness.reshape(5, 8), powers.reshape(5, 8), strict=True):
        rest, mean = np.sort(sharp)[: 8 - without], np.sort(power)[: 8 - without].mean()
        if abs(rest[-1] ** 2 / (most * mean) - 1) > 1e-9:
            assert flag == (sharp.max() > least and rest[-1] ** 2 < most * mean)


@pytest.mark.parametrize(("size", "without"), [(9, 1), (8, 8), (8, -1), (24, 17), (0, 0)])
def test_steady_segments_refuse_what_does_not_fit(size: int, without: int):
    with pytest.raises(ValueError, match="wanted"):
        kernel.steady_segments(np.zeros(24), np.zeros(24), size, without, 0.0, 1.0, np.empty(3, np.bool_))


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1), st.integers(2, 11), st.floats(0.01, 1.0))
def test_gliding_segments(seed: int, size: int, most: float):
    rng = np.random.default_rng(seed)
    steps = 1 + rng.uniform(0, 1, (6, 1)) * rng.uniform(-1, 1, (6, size))
    flags = np.empty(6, np.bool_)
    kernel.gliding_segments(steps.ravel(), size, most, flags)
    for flag, row in zip(flags.tolist(), steps, strict=True):
        change = np.abs(np.diff(row)).sum() / row.sum()
        if abs(change / most - 1) > 1e-9:
            assert flag == (change < most)


def test_a_segment_that_stands_still_glides_and_silence_does_not():
    flags = np.empty(2, np.bool_)
    kernel.gliding_segments(np.array([0.3, 0.3, 0.0, 0.0]), 2, 0.1, flags)
    assert flags.tolist() == [True, False]


@pytest.mark.parametrize("size", [1, 0, 9])
def test_gliding_segments_refuse_what_does_not_fit(size: int):
    with pytest.raises(ValueError, match="wanted"):
        kernel.gliding_segments(np.zeros(24), size, 0.1, np.empty(3, np.bool_))
