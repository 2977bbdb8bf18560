"""The excitation of a stored sound as one byte a band and block, and its place in a scene."""

import base64
import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from audio_checks import BLOCK_S, CENTRES_HZ

STEP_DB = 0.5
SILENCE = 255  # steps under full scale that mean nothing at all


def packed(power: NDArray[np.float64]) -> bytes:
    """Return an excitation in steps of half a decibel under full scale, blocks after one another."""
    with np.errstate(divide="ignore"):
        steps = -10 * np.log10(power) / STEP_DB
    return np.clip(np.rint(np.minimum(steps, SILENCE)), 0, SILENCE).astype(np.uint8).tobytes()


def as_text(steps: bytes) -> str:
    """Return the kept part of an excitation."""
    return base64.b64encode(steps).decode("ascii")


def unpacked(text: str) -> NDArray[np.float64]:
    """Return an excitation as it was kept, shape (blocks, bands)."""
    steps = np.frombuffer(base64.b64decode(text), np.uint8).reshape(-1, len(CENTRES_HZ))
    return np.where(steps == SILENCE, 0.0, 10 ** (steps * (-STEP_DB / 10)))


def placed(
    power: NDArray[np.float64], *, starts_s: Sequence[float], loops: bool, length_s: float, gain_db: float
) -> NDArray[np.float64]:
    """Return a sound's excitation over a scene: from each start once, or without an end from its first start."""
    whole = np.zeros((math.ceil(round(length_s / BLOCK_S, 6)), len(CENTRES_HZ)))
    if not len(power):
        return whole
    for start_s in starts_s:
        first = round(start_s / BLOCK_S)
        left = max(0, len(whole) - first)
        blocks = np.resize(power, (left, power.shape[1])) if loops else power[:left]
        whole[first : first + len(blocks)] += blocks
    return whole * 10 ** (gain_db / 10)
