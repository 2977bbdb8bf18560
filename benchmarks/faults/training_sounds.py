"""The families of sounds that judgements learn from, for clicks to be put into: the wider half of what is known.

Those that imitate nothing (`training.layers`) are among them. Some hold by their nature what a click leaves, so whole
sounds of these are not held to anything.
"""

import numpy as np

from benchmarks.faults.sounds import Family, Samples
from training import dataset, layers
from training.shapes import Family as Source

FADE_S = 0.01


class _Family:
    """One source as a family; an object, since processes hand families to one another."""

    def __init__(self, source: Source) -> None:
        self._make = source.make
        self.__name__ = f"training {source.name}"

    def __call__(self, rng: np.random.Generator, rate: int, seconds: float) -> Samples:
        sound = self._make(rng, rate)[: round(seconds * rate)]
        fade = np.minimum(1.0, np.arange(len(sound))[::-1] / (FADE_S * rate))
        return (sound if sound.ndim == 2 else sound[:, np.newaxis]) * fade[:, np.newaxis]


FAMILIES: dict[str, Family] = {
    family.__name__: family
    for family in map(_Family, [*dataset.families(is_kept_apart=False), *dict.fromkeys(layers.FAMILIES)])
}
