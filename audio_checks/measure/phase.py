"""How alike the channels are."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel


class Phase:
    """Measures the correlation of every two channels, as a correlation meter does.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    """

    FIGURES = ("channel_correlation",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:  # noqa: ARG002 - all accumulators are made alike
        self._products = np.zeros((channels, channels))

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if len(self._products) > 1:
            kernel.products(kernel.by_channel(block), self._products)

    def result(self) -> dict[str, Any]:
        """Return the least correlation of two channels, -1..1; None where no two channels sound."""
        sounding = np.flatnonzero(np.diag(self._products) > 0)
        if len(sounding) < 2:
            return {"channel_correlation": None}
        products = self._products[np.ix_(sounding, sounding)]
        norms = np.sqrt(np.diag(products))
        least = float((products / np.outer(norms, norms)).min())
        return {"channel_correlation": math.copysign(min(abs(least), 1.0), least)}
