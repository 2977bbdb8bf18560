"""Boosted trees as numbers in a file: models that were trained elsewhere, evaluated with numpy alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Trees:
    """A sum of decision trees.

    Parameters
    ----------
    numbers : mapping
        `start`, the sum before the first tree; `roots`, the place of each tree's first node; and a list each
        of all nodes' `feature`, `threshold`, `left` and `right` (places of nodes) and `value`. A leaf leads to
        itself. A feature that is nan goes left where `nan_left` says 1.
    """

    def __init__(self, numbers: Mapping[str, Any]) -> None:
        self._start = float(numbers["start"])
        self._roots = np.array(numbers["roots"], dtype=np.intp)
        self._feature = np.array(numbers["feature"], dtype=np.intp)
        self._threshold = np.array(numbers["threshold"], dtype=np.float64)
        self._left = np.array(numbers["left"], dtype=np.intp)
        self._right = np.array(numbers["right"], dtype=np.intp)
        self._nan_left = np.array(numbers["nan_left"], dtype=bool)
        self._value = np.array(numbers["value"], dtype=np.float64)

    def sum(self, features: NDArray[np.float64]) -> float:
        """Return the sum of the trees' answers to one sound's features, shape (features,)."""
        node = self._roots
        while True:
            asked = features[self._feature[node]]
            left = np.where(np.isnan(asked), self._nan_left[node], asked <= self._threshold[node])
            following = np.where(left, self._left[node], self._right[node])
            if np.array_equal(following, node):
                return self._start + float(self._value[node].sum())
            node = following
