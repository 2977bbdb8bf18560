"""The likeness of the channels, and the fate of a stereo sound in mono."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.survey import StereoHops, Survey

HOP_S = 0.1
MOST_HOPS = 65_536  # 1.8 h; the hops of what lasts longer are longer
MOST_LOSS_DB = 120.0  # shown where nothing is left
LOUD_ENOUGH = 1e-4  # of the mean power: a hop 40 dB below it loses nothing audible

Spans = list[tuple[float, float]]


class Phase:
    """Measures the correlation of every two channels, as a correlation meter does; of stereo, what its mono sum loses.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = ("channel_correlation", "mono_loss_db", "channel_difference_db", "mono_loss_spans")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, survey: Survey | None = None) -> None:
        self._rate = sample_rate_hz
        self._survey = survey or Survey()
        self._hop = max(1, round(HOP_S * sample_rate_hz), -(-frames // MOST_HOPS))
        self._products = np.zeros((channels, channels))
        self._stereo = StereoHops(self._hop, -(-frames // self._hop) if channels == 2 else 0)
        if channels == 2:
            self._survey.follow(self._stereo)

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if self._survey.has_compared(block):
            return
        rows = kernel.by_channel(block)
        if len(rows) > 2:
            kernel.products(rows, self._products)
        elif len(rows) == 2:
            self._stereo.add(rows)

    def result(self) -> dict[str, Any]:
        """Return the figures, by name.

        `channel_correlation` is the least of two channels, -1..1; None where no two channels sound.
        `mono_loss_db` is the mean power of the channels over the power of (left + right) / 2: 0 for equal
        channels, 3 for unrelated ones, 120 where nothing is left. `channel_difference_db` is the level of
        left − right under the louder channel: -inf for equal channels, 0 where only one sounds.
        `mono_loss_spans` is a function that returns where more than a limit is lost, in seconds. The last
        three are None for anything but two channels, and for silence.
        """
        if len(self._products) != 2:
            return {**dict.fromkeys(self.FIGURES), "channel_correlation": _least_correlation(self._products)}
        left, right, both, apart = (float(energy) for energy in self._stereo.energies.sum(axis=0))
        if not (left or right):
            return dict.fromkeys(self.FIGURES)
        sums, means = self._by_hop()
        loss = power_decibels(float(means.sum())) - power_decibels(float(sums.sum()))
        return {
            "channel_correlation": _least_correlation(np.array([[left, both], [both, right]])),
            "mono_loss_db": min(max(loss, 0.0), MOST_LOSS_DB),
            "channel_difference_db": power_decibels(apart) - power_decibels(max(left, right)),
            "mono_loss_spans": self._spans,
        }

    def _by_hop(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the energy of the mono sum and the mean energy of the channels, hop by hop."""
        left, right, both, _ = self._stereo.energies.T
        return np.maximum((left + right + 2 * both) / 4, 0.0), (left + right) / 2

    def _spans(self, limit_db: float) -> Spans:
        sums, means = self._by_hop()
        lost = (means > LOUD_ENOUGH * means.mean()) & (means > sums * 10 ** (limit_db / 10))
        turns = np.flatnonzero(np.diff(np.concatenate(([0], lost.astype(np.int8), [0]))))
        seconds = self._hop / self._rate
        end_s = self._stereo.frames / self._rate
        return [(int(a) * seconds, min(int(b) * seconds, end_s)) for a, b in zip(turns[::2], turns[1::2], strict=True)]


def _least_correlation(products: NDArray[np.float64]) -> float | None:
    """Return the least correlation of two channels that sound, from the products of all."""
    sounding = np.flatnonzero(np.diag(products) > 0)
    if len(sounding) < 2:
        return None
    products = products[np.ix_(sounding, sounding)]
    norms = np.sqrt(np.diag(products))
    least = float((products / np.outer(norms, norms)).min())
    return math.copysign(min(abs(least), 1.0), least)
