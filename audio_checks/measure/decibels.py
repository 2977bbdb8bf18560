"""Between ratios and decibels."""

from __future__ import annotations

import math


def decibels(ratio: float) -> float:
    """Return an amplitude ratio in dB; -inf for zero."""
    return 20 * math.log10(ratio) if ratio > 0 else -math.inf


def power_decibels(ratio: float) -> float:
    """Return a power ratio in dB; -inf for zero."""
    return 10 * math.log10(ratio) if ratio > 0 else -math.inf


def ratio(level_db: float) -> float:
    """Return the amplitude ratio of a level in dB; 0 for -inf."""
    return float(10 ** (level_db / 20))
