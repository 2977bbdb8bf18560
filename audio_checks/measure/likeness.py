"""A short print of a sound, by which nearly equal sounds are known whatever their level."""

from __future__ import annotations

import base64
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

SLICE_S = 0.02
CLOSE_SLICES = 32  # one after the other from the start; later ones stand ever farther apart
FAR_SLICES, SPACING = 32, 1.15  # the last begins after 56 s
EDGES_HZ = 62.5 * 2.0 ** np.arange(9)  # of eight octave bands
STEP_DB, RANGE_DB = 0.25, 50.0
FLOOR = round(RANGE_DB / STEP_DB)  # steps under the loudest cell that mean nothing at all
LEAST_CELLS = 12  # that either sound fills; fewer are not compared
LOUD = round(40.0 / STEP_DB)  # steps under the loudest cell that count as filled


class Likeness:
    """Takes the level of eight octave bands in slices of 20 ms, at the same times in every sound.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    """

    FIGURES = ("likeness_print",)

    def __init__(self, sample_rate_hz: int, channels: int, frames: int) -> None:
        self._length = max(1, round(SLICE_S * sample_rate_hz))
        starts = (slice_starts_s() * sample_rate_hz).round().astype(np.int64)
        self._starts = starts[starts < frames].tolist()
        self._weights = 0.7 ** np.arange(channels)  # so that opposite channels do not cancel
        self._slices = np.zeros((len(self._starts), self._length))
        self._rate = sample_rate_hz
        self._next = 0  # slices before it are whole
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        end = self._seen + len(block)
        index = self._next
        while index < len(self._starts) and self._starts[index] < end:
            start = self._starts[index]
            until = min(start + self._length, end)
            first = max(start, self._seen)
            piece = block[first - self._seen : until - self._seen] @ self._weights
            self._slices[index, first - start : until - start] = piece
            if until == start + self._length:
                self._next = index + 1
            index += 1
        self._seen = end

    def result(self) -> dict[str, Any]:
        """Return the print as text; None for silence.

        One byte a cell: the level under the loudest cell in steps of 0.25 dB, at most 50 dB; slices after
        one another, eight bands each.
        """
        window, to_bands = _analysis(self._rate, self._length)
        power = np.abs(np.fft.rfft(self._slices * window, axis=1)) ** 2 @ to_bands
        loudest = power.max(initial=0.0)
        if not loudest:
            return {"likeness_print": None}
        under_db = -10 * np.log10(np.maximum(power / loudest, 10 ** (-RANGE_DB / 10)))
        cells = np.rint(under_db / STEP_DB).astype(np.uint8)
        return {"likeness_print": base64.b64encode(cells.tobytes()).decode("ascii")}


@lru_cache(maxsize=8)
def slice_starts_s() -> NDArray[np.float64]:
    """Return the starts of the slices, in seconds: close together at first, later ever farther apart."""
    close = SLICE_S * np.arange(CLOSE_SLICES)
    far = SLICE_S * CLOSE_SLICES * SPACING ** np.arange(FAR_SLICES)
    return np.concatenate((close, far))


@lru_cache(maxsize=8)
def _analysis(sample_rate_hz: int, length: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the window, and the matrix that sums bins into bands."""
    hz = np.fft.rfftfreq(length, 1 / sample_rate_hz)
    to_bands = (hz[:, np.newaxis] >= EDGES_HZ[:-1]) & (hz[:, np.newaxis] < EDGES_HZ[1:])
    return np.hanning(length + 2)[1:-1], to_bands.astype(np.float64)


def unlikeness_db(one: str, other: str) -> float | None:
    """Return the difference of two sounds cell by cell once their levels are matched, in dB.

    Parameters
    ----------
    one, other : str
        Prints. Of a longer sound the part counts that the shorter one has too.

    Returns
    -------
    float or None
        The mean over the cells that either sound fills: below 0.2 for a copy at another level, depth or
        rate, about 1 for two drawings of the same noise. None where too few cells are filled.
    """
    a, b = _cells(one), _cells(other)
    count = min(len(a), len(b))
    a, b = a[:count], b[:count]
    either = (a < LOUD) | (b < LOUD)
    if np.count_nonzero(either) < LEAST_CELLS:
        return None
    both = either & (a < FLOOR) & (b < FLOOR)
    louder = np.median((a - b)[both]) if both.any() else 0.0
    return float(np.abs((a - b)[either] - louder).mean() * STEP_DB)


@lru_cache(maxsize=1_024)
def _cells(text: str) -> NDArray[np.float64]:
    return np.frombuffer(base64.b64decode(text), np.uint8).astype(np.float64)
