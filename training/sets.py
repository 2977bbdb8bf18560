"""Sets of sounds by what is known of each and what was measured of it."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from training.dataset import Known

Floats = NDArray[np.float64]
KINDS = ("event", "natural-decay", "ambience", "voice", "music", "unknown")
LAYOUTS = ("mono", "stereo")


@dataclass
class Set:
    """Some sounds: what is known of each, its features, and what the judgement says."""

    known: list[Known]
    features: Floats

    def column(self, of: Callable[[Known], Any]) -> NDArray[Any]:
        return np.array([of(one) for one in self.known])

    @property
    def wet(self) -> NDArray[np.bool_]:
        return self.column(lambda one: one.is_wet)


def together(parts: Sequence[Set]) -> Set:
    return Set([one for part in parts for one in part.known], np.concatenate([part.features for part in parts]))


def layouts_of(some: Set) -> NDArray[Any]:
    return some.column(lambda one: "mono" if one.channels == 1 else "stereo")
