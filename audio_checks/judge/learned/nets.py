"""Small neural nets as numbers in a file: models that were trained elsewhere, evaluated with numpy alone."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray


class Nets:
    """The mean of some nets that were learned from the same sounds.

    Parameters
    ----------
    numbers : mapping
        `lowest` and `highest`, to which each feature is held, `middle` and `spread`, by which it is scaled; and
        `nets`, each a list of layers of `weights`, shape (from, to), and `offsets`, shape (to,). All layers but
        the last pass on nothing below zero; the last has one output.
    """

    def __init__(self, numbers: Mapping[str, Any]) -> None:
        self._lowest, self._highest, self._middle, self._spread = (
            np.array(numbers[name], dtype=np.float64) for name in ("lowest", "highest", "middle", "spread")
        )
        self._nets = [
            [(np.array(layer["weights"], dtype=np.float64), np.array(layer["offsets"])) for layer in net]
            for net in numbers["nets"]
        ]

    def mean(self, features: NDArray[np.float64]) -> float:
        """Return the nets' mean answer to one sound's features, shape (features,); nan counts as usual."""
        held = np.clip(features, self._lowest, self._highest)
        scaled = np.nan_to_num((held - self._middle) / self._spread, nan=0.0)
        return float(np.mean([_passed(net, scaled) for net in self._nets]))


def _passed(net: list[tuple[NDArray[np.float64], NDArray[np.float64]]], values: NDArray[np.float64]) -> float:
    *hidden, (weights, offsets) = net
    for inner, shifts in hidden:
        values = np.maximum(values @ inner + shifts, 0)
    return float((values @ weights + offsets)[0])
