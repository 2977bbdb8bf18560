"""What becomes of a stereo sound in mono."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import power_decibels

HOP_S = 0.1
MOST_LOSS_DB = 120.0  # shown where nothing is left
LOUD_ENOUGH = 1e-4  # of the mean power: a hop 40 dB below it loses nothing that is heard

Spans = list[tuple[float, float]]


class MonoSum:
    """Measures how much of two channels is left when they are summed, and how far they differ.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    """

    FIGURES = ("mono_loss_db", "channel_difference_db", "mono_loss_spans")

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:  # noqa: ARG002 - all accumulators are made alike
        self._rate = sample_rate_hz
        self._hop = max(1, round(HOP_S * sample_rate_hz))
        self._is_stereo = channels == 2
        self._sums: list[float] = []  # energy of the mono sum, hop by hop
        self._means: list[float] = []  # mean energy of the channels
        self._difference = 0.0
        self._left = self._right = 0.0
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not self._is_stereo:
            return
        at = 0
        while at < len(block):
            place = self._seen // self._hop
            until = min(len(block), at + (place + 1) * self._hop - self._seen)
            self._take(place, block[at:until, 0], block[at:until, 1])
            self._seen += until - at
            at = until

    def _take(self, hop: int, left: NDArray[np.float64], right: NDArray[np.float64]) -> None:
        if hop == len(self._sums):
            self._sums.append(0.0)
            self._means.append(0.0)
        in_left, in_right, both = float(left @ left), float(right @ right), float(left @ right)
        apart = left - right
        self._left += in_left
        self._right += in_right
        self._difference += float(apart @ apart)
        self._sums[hop] += max((in_left + in_right + 2 * both) / 4, 0.0)
        self._means[hop] += (in_left + in_right) / 2

    def result(self) -> dict[str, Any]:
        """Return the figures, by name.

        `mono_loss_db` is the mean power of the channels over the power of (left + right) / 2: 0 for equal
        channels, 3 for unrelated ones, 120 where nothing is left. `channel_difference_db` is the level of
        left − right under the louder channel: -inf for equal channels, 0 where only one sounds.
        `mono_loss_spans` is a function that returns where more than a limit is lost, in seconds. All are
        None for anything but two channels, and for silence.
        """
        if not (self._left or self._right):
            return dict.fromkeys(self.FIGURES)
        loss = power_decibels(math.fsum(self._means)) - power_decibels(math.fsum(self._sums))
        difference = power_decibels(self._difference) - power_decibels(max(self._left, self._right))
        return {
            "mono_loss_db": min(max(loss, 0.0), MOST_LOSS_DB),
            "channel_difference_db": difference,
            "mono_loss_spans": self._spans,
        }

    def _spans(self, limit_db: float) -> Spans:
        sums, means = np.array(self._sums), np.array(self._means)
        lost = (means > LOUD_ENOUGH * means.mean()) & (means > sums * 10 ** (limit_db / 10))
        turns = np.flatnonzero(np.diff(np.concatenate(([0], lost.astype(np.int8), [0]))))
        seconds = self._hop / self._rate
        end_s = self._seen / self._rate
        return [(int(a) * seconds, min(int(b) * seconds, end_s)) for a, b in zip(turns[::2], turns[1::2], strict=True)]
