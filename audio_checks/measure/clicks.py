"""Clicks: moments far sharper than all that lies around them, in a sound that goes on."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import decibels

STANDS_OUT = 3.5  # times sharper than the sharpest moment of the 20 ms before and the 20 ms after
REACH = 40  # cells on either side that are compared: 20 ms
CORE = 1  # cells beside a click that may belong to it, one of them at a time
LEVEL_CELLS = 20  # 10 ms on either side, by which a sound is said to go on
GOES_ON = 10.0  # power may fall or rise tenfold across a click; more is a sound that starts or stops
BELOW_PEAK = 8e-3  # 42 dB under the file's peak: smaller clicks count for nothing
SOUND_BELOW_PEAK = 1e-5  # in power, 50 dB: what counts as a sound
IMPULSE = 20.0  # the sharpness of a single sample at full scale
GRAIN = 8.0  # steps of the bit depth: smaller clicks are rounding
MAX_KEPT = 1_000


class Click(NamedTuple):
    """One click: when, in which channel (1 is the first), and the single sample that would be as sharp."""

    at_s: float
    channel: int
    level_dbfs: float


class Clicks:
    """Finds clicks in cells.

    Parameters
    ----------
    channels : int
    cells_per_s : float
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("clicks", "click_places")

    def __init__(self, channels: int, cells_per_s: float, step: float) -> None:
        self._per_s = cells_per_s
        self._least = max(GRAIN * step, 1e-6)
        self._sharp = np.zeros((channels, REACH))
        self._squares = np.zeros((channels, REACH))
        self._first = -REACH  # the cell that the first of those kept is
        self._found: list[tuple[int, int, float, float]] = []  # cell, channel, sharpness, power of the sound around

    def add(self, cells: Cells) -> None:
        """Take the next cells."""
        sharp = np.concatenate((self._sharp, cells.sharpness), axis=1)
        squares = np.concatenate((self._squares, cells.squares), axis=1)
        count = sharp.shape[1] - 2 * REACH
        if count > 0:
            self._search(sharp, squares)
            self._first += count
            sharp, squares = sharp[:, count:], squares[:, count:]
        self._sharp, self._squares = sharp, squares

    def result(self, peak: float, cell_frames: int) -> dict[str, Any]:
        """Return `clicks`, how many there are, and `click_places`; `peak` is the file's largest sample."""
        silence = np.zeros((len(self._sharp), REACH))
        self.add(Cells(silence, silence, silence, silence))
        least = max(self._least, peak * BELOW_PEAK) * IMPULSE
        sound = peak**2 * SOUND_BELOW_PEAK * cell_frames
        clicks: list[Click] = []
        last: dict[int, int] = {}
        for cell, channel, sharp, power in sorted(self._found):
            if sharp < least or power < sound:
                continue
            if cell - last.get(channel, -9) > CORE:
                clicks.append(Click(cell / self._per_s, channel + 1, decibels(sharp / IMPULSE)))
            last[channel] = cell
        return {"clicks": len(clicks), "click_places": tuple(clicks)}

    def _search(self, sharp: NDArray[np.float64], squares: NDArray[np.float64]) -> None:
        """Look at all cells but the first and the last REACH."""
        highest = _sliding_maximum(sharp, REACH - CORE)
        after = highest[:, REACH + CORE + 1 :]
        before = highest[:, : after.shape[1]]
        here = sharp[:, REACH : REACH + after.shape[1]]
        beside = np.minimum(sharp[:, REACH - 1 :][:, : here.shape[1]], sharp[:, REACH + 1 :][:, : here.shape[1]])
        around = np.maximum(np.maximum(np.maximum(before, after), beside) * STANDS_OUT, self._least * IMPULSE)
        for channel, cell in zip(*np.nonzero(here > around), strict=True):
            power_before = squares[channel, cell + REACH - LEVEL_CELLS : cell + REACH - CORE].mean()
            power_after = squares[channel, cell + REACH + CORE + 1 : cell + REACH + LEVEL_CELLS + 1].mean()
            quieter, louder = sorted((float(power_before), float(power_after)))
            if louder <= quieter * GOES_ON and len(self._found) < MAX_KEPT:
                found = (self._first + REACH + int(cell), int(channel), float(here[channel, cell]), quieter)
                self._found.append(found)


def _sliding_maximum(values: NDArray[np.float64], width: int) -> NDArray[np.float64]:
    """Return the maximum of each `width` values in a row, along the last axis."""
    highest, reach = values, 1
    while reach * 2 <= width:
        highest = np.maximum(highest[:, :-reach], highest[:, reach:])
        reach *= 2
    rest = width - reach
    return np.maximum(highest[:, :-rest], highest[:, rest:]) if rest else highest
