"""The noise floor: the level that is left when the sound pauses."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.means import mean_of

CELLS = 20  # of one step: 10 ms
PAUSE = 20  # steps: a pause lasts 0.2 s
DEEP = 16.0  # in power: a pause lies 12 dB under the loudest 0.2 s
STEADY_DB = 6.0  # by which the steps of a pause may differ between their lower and upper quarter
LEVEL_DB = 1.2  # by which the halves of a pause may differ
PLATEAU_DB = 0.6  # a pause whose neighbour before or after is no louder than that is a floor
FALL_DB = 0.4  # what falls by more from pause to pause,
FALLS_ALIKE = 2.5  # and evenly, up to so many times, dies away


class NoiseFloor:
    """Finds the quietest pause in cells.

    Parameters
    ----------
    channels : int
    cell_frames : int
        Frames of each cell.
    """

    FIGURES = ("noise_floor_dbfs",)
    BACK = CELLS - 1  # cells before the new ones that are looked at again

    def __init__(self, channels: int, cell_frames: int) -> None:
        self._frames = CELLS * cell_frames
        self._channels = channels
        self._waiting = 0  # cells that fill no step yet
        self._steps: list[NDArray[np.float64]] = []

    def add(self, cells: Cells, new: int) -> None:
        """Take the next cells, the last `new` of these; at least BACK others come before them."""
        fresh = cells.squares[:, cells.squares.shape[1] - new - self._waiting :]
        count = fresh.shape[1] // CELLS
        sums = np.empty((self._channels, count))
        kernel.group_sums(fresh, CELLS, sums)
        self._steps.append(sums / self._frames)
        self._waiting = fresh.shape[1] - count * CELLS

    def result(self) -> dict[str, Any]:
        """Return `noise_floor_dbfs`, the RMS of the quietest pause in the noisiest channel; None without a pause.

        -inf where a pause is digital silence.
        """
        steps = np.concatenate(self._steps, axis=1)
        floors = [floor for floor in map(_floor, steps) if floor is not None]
        return {"noise_floor_dbfs": power_decibels(max(floors)) if floors else None}


def _floor(steps: NDArray[np.float64]) -> float | None:
    """Return the power of the quietest pause of one channel."""
    if len(steps) < 2 * PAUSE:
        return None
    sums = np.zeros(len(steps) + 1)
    steps.cumsum(dtype=np.float64, out=sums[1:])
    means = (sums[PAUSE:] - sums[:-PAUSE]) / PAUSE
    quietest = int(means.argmin())
    pause = steps[quietest : quietest + PAUSE]
    floor = mean_of(pause)
    if floor * DEEP > means[means.argmax()]:
        return None
    if not floor:
        return 0.0
    ordered = sorted(pause.tolist())
    lower, upper = ordered[PAUSE // 4], ordered[-1 - PAUSE // 4]
    if upper > lower * 10 ** (STEADY_DB / 10):
        return None
    quieter, louder = sorted((mean_of(pause[: PAUSE // 2]), mean_of(pause[PAUSE // 2 :])))
    if louder > quieter * 10 ** (LEVEL_DB / 10):
        return None
    beside = [means[index] for index in (quietest - PAUSE, quietest + PAUSE) if 0 <= index < len(means)]
    if min(beside, default=math.inf) <= floor * 10 ** (PLATEAU_DB / 10) or not _dies_away(means, quietest):
        return floor
    return None


def _dies_away(means: NDArray[np.float64], quietest: int) -> bool:
    """Return whether the level falls evenly up to the quietest pause, over the two pauses before it."""
    if quietest < 2 * PAUSE:
        return False
    before, middle, last = (means[[quietest - 2 * PAUSE, quietest - PAUSE, quietest]]).tolist()
    if min(before, middle, last) <= 0:  # a difference of sums has no digits left after what was far louder
        return False
    falls = sorted((10 * math.log10(before / middle), 10 * math.log10(middle / last)))
    return falls[0] > FALL_DB and falls[1] < FALLS_ALIKE * falls[0]
