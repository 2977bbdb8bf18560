"""The mean of a few values is numpy's own."""

import numpy as np
import pytest

from audio_checks.measure.means import mean_of


@pytest.mark.parametrize("count", [1, 2, 7, 8, 9, 10, 20, 127, 128, 129, 1000, 10_001])
def test_it_is_numpys_to_the_last_bit(count):
    values = np.random.default_rng(count).standard_normal(count) ** 2
    assert mean_of(values) == values.mean()
    assert mean_of(values[::-1]) == values[::-1].mean()


def test_it_is_a_plain_number():
    assert mean_of(np.array([1.0, 2.0, 6.0])) == 3.0
    assert type(mean_of(np.ones(3))) is float
