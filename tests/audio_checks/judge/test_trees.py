"""Trees as numbers: two small ones, asked by hand."""

import numpy as np
import pytest

from audio_checks.judge.learned.trees import Trees

# One tree asks feature 0 whether it is at most 2.5, then feature 1 whether it is at most -1; the other is one leaf.
TWO = Trees(
    {
        "start": 0.5,
        "roots": [0, 5],
        "feature": [0, 1, 0, 0, 0, 0],
        "threshold": [2.5, -1.0, 0, 0, 0, 0],
        "left": [1, 3, 2, 3, 4, 5],
        "right": [2, 4, 2, 3, 4, 5],
        "nan_left": [0, 1, 0, 0, 0, 0],
        "value": [0, 0, 10.0, 1.0, 2.0, 100.0],
    }
)


@pytest.mark.parametrize(
    ("features", "said"),
    [
        ([2.5, -1.0], 101.5),
        ([2.5, -0.9], 102.5),
        ([2.6, -1.0], 110.5),
        ([np.nan, -1.0], 110.5),
        ([0.0, np.nan], 101.5),
    ],
)
def test_each_tree_says_one_leaf(features, said):
    assert TWO.sum(np.array(features)) == said
