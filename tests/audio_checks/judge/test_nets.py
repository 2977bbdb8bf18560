"""Nets as numbers: two small ones, asked by hand."""

import numpy as np
import pytest

from audio_checks.judge.learned.nets import Nets

# One net has a hidden layer of two, the other is a sum alone. Feature 0 is scaled by (x - 1) / 2 and held to 0..5.
TWO = Nets(
    {
        "lowest": [0.0, -10.0],
        "highest": [5.0, 10.0],
        "middle": [1.0, 0.0],
        "spread": [2.0, 1.0],
        "nets": [
            [
                {"weights": [[1.0, -1.0], [0.0, 2.0]], "offsets": [0.0, 1.0]},
                {"weights": [[10.0], [100.0]], "offsets": [0.5]},
            ],
            [{"weights": [[2.0], [4.0]], "offsets": [-1.5]}],
        ],
    }
)


@pytest.mark.parametrize(
    ("features", "said"),
    [
        ([3.0, 0.0], (10 * 1 + 100 * 0 + 0.5 + 2 - 1.5) / 2),
        (
            [0.0, 3.0],
            (10 * 0 + 100 * 7.5 + 0.5 - 1 + 12 - 1.5) / 2,
        ),  # what a hidden layer says below zero is not passed on
        ([99.0, 0.0], (10 * 2 + 0 + 0.5 + 4 - 1.5) / 2),
        ([np.nan, np.nan], (0 + 100 * 1 + 0.5 - 1.5) / 2),
    ],
)
def test_the_nets_are_averaged_over_scaled_features(features, said):
    assert TWO.mean(np.array(features)) == pytest.approx(said)
