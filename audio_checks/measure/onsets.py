"""Distinguish a click from an attack and from crackle, by the half-milliseconds around it."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.cells import Cells

BEYOND = 2  # cells: where the surroundings of a click begin, on either side
CLOSE = 6  # cells that are close to a click: 3 ms
LATE = 8  # cells, 4 ms, after which a click of any shape is over
SPANS = (10, 20)  # cells, 5 and 10 ms, in which the sound before and after it are compared
LEAD = (30, 80)  # cells, 15 to 40 ms, before a click: where these are silent, the sound begins at the click
TAIL = 30  # cells of the sound that begins there
BLOCK = 6  # cells, 3 ms, of which the sharpest counts as one moment
TINY = 1e-24
# From one cell, counted from a click, to another: close before and after it, and of each span after and before.
_STRETCHES = np.array(
    [
        (1 - CLOSE - BEYOND, 1 - BEYOND),
        (BEYOND, CLOSE + BEYOND),
        *(stretch for span in SPANS for stretch in ((LATE, LATE + span), (-span - BEYOND, -BEYOND))),
    ]
)

ISOLATED_DB = 35.0  # a click that stands out so far of both sides is one, wherever it is in a sound,
FIRST_DB = 50.0  # and so far where the sound begins at it
LOUDER_DB = 6.0  # a sound whose highs are louder by this after a click is struck there
SILENT_DB, NOTHING_DB = 40.0, 60.0  # under the sound that begins: what counts as a pause before it, and as silence
TRANSIENT_DB = 16.0  # of crackle and creaks each moment stands out so far of its sides:
ALIKE_DB, ALIKE = 12.0, 40  # so many moments of a file within so many dB of it,
NEARLY_DB, NEARLY = 4.0, 4  # and so many of them nearly as sharp, itself among them


class Surroundings(NamedTuple):
    """Levels around a click, in dB.

    Attributes
    ----------
    sharpness_db : float
        The square of its largest sixth difference.
    over_before_db, over_after_db : float
        How far that stands over the mean square of the sixth differences in the 3 ms before and after.
    louder_db : float
        How much more power sixth differences have from 4 ms after it than before it, in 5 or 10 ms.
    begins_db : float
        How far the sound in the 15 ms from it on stands over what came 15 to 40 ms before it.
    """

    sharpness_db: float
    over_before_db: float
    over_after_db: float
    louder_db: float
    begins_db: float


class Heights:
    """Counts the moments of each channel by how sharp they are, in steps of 1 dB."""

    LOWEST_DB, COUNT = -200, 280

    def __init__(self) -> None:
        self._counts = np.zeros((0, self.COUNT), np.int64)

    def add(self, sharpness: NDArray[np.float64]) -> None:
        """Take the sharpness of the next cells, shape (channels, cells)."""
        channels, count = sharpness.shape
        if not len(self._counts):
            self._counts = np.zeros((channels, self.COUNT), np.int64)
        if not count:
            return
        levels = _decibels(np.square(_highest_of_blocks(sharpness))) - self.LOWEST_DB
        steps = np.minimum(np.maximum(levels, 0), self.COUNT - 1).astype(np.intp)
        for channel, row in enumerate(steps):
            self._counts[channel] += np.bincount(row, minlength=self.COUNT)

    def reaching(self, level_db: float, channel: int) -> int:
        """Return the number of moments of a channel about as sharp as a level, or sharper."""
        first = min(max(0, round(level_db) - self.LOWEST_DB), self.COUNT - 1)
        return int(self._counts[channel, first:].sum())


def surroundings(cells: Cells, places: Sequence[tuple[int, int]], before: int, cell_frames: int) -> list[Surroundings]:
    """Return the surroundings of some clicks.

    Parameters
    ----------
    cells : Cells
        Those looked at, with 80 before each click and 30 after it; what is missing counts as silence.
    places : sequence of (int, int)
        Cell and channel of each click.
    before : int
        The cell that the first of `cells` is.
    cell_frames : int
        Frames of each cell.
    """
    by_cell: dict[tuple[int, int], Surroundings] = {}
    for channel in {channel for _, channel in places}:
        own_cells = np.array([cell - before for cell, other in places if other == channel], np.int64)
        for cell, around in zip(own_cells.tolist(), _around(cells, own_cells, cell_frames, channel), strict=True):
            by_cell[cell + before, channel] = around
    return [by_cell[position] for position in places]


def is_isolated(around: Surroundings, heights: Heights, channel: int) -> bool:
    """Return whether a sharp moment is a click: neither the attack of a sound nor one of many alike."""
    over_db = min(around.over_before_db, around.over_after_db)
    if over_db >= (FIRST_DB if around.begins_db > NOTHING_DB else ISOLATED_DB):
        return True
    if around.louder_db > LOUDER_DB or around.begins_db > SILENT_DB:
        return False
    alike = heights.reaching(around.sharpness_db - ALIKE_DB, channel)
    nearly = heights.reaching(around.sharpness_db - NEARLY_DB, channel)
    return over_db < TRANSIENT_DB or alike < ALIKE or nearly < NEARLY


def _highest_of_blocks(sharpness: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the highest of each BLOCK cells, shape (channels, blocks); the last block may be shorter."""
    channels, count = sharpness.shape
    whole = count // BLOCK
    blocks = np.empty((channels, -(-count // BLOCK)))
    tops = blocks[:, :whole]
    tops[:] = sharpness[:, : whole * BLOCK : BLOCK]
    for place in range(1, BLOCK):  # one place of all blocks at a time: five times as fast as block by block
        np.maximum(tops, sharpness[:, place : whole * BLOCK : BLOCK], out=tops)
    if count % BLOCK:
        blocks[:, whole] = sharpness[:, whole * BLOCK :].max(axis=1)
    return blocks


def _around(cells: Cells, places: NDArray[np.int64], cell_frames: int, channel: int) -> list[Surroundings]:
    edges, powers = cells.edges[channel], cells.squares[channel]
    sums = np.concatenate(([0.0], np.cumsum(edges)))
    # Mean squares of the sixth differences in each stretch.
    first = np.minimum(np.maximum(places + _STRETCHES[:, :1], 0), len(edges))
    last = np.minimum(np.maximum(places + _STRETCHES[:, 1:], 0), len(edges))
    before, after, *beside = (sums[last] - sums[first]) / (np.diff(_STRETCHES) * cell_frames)

    def highest(values: NDArray[np.float64], start: int, end: int) -> NDArray[np.float64]:
        """Return the highest value from one cell, counted from each click, to another; 0 where there is none."""
        windows = places[:, np.newaxis] + np.arange(start, end)
        inside = (windows >= 0) & (windows < len(values))
        tops: NDArray[np.float64] = np.where(inside, values.take(windows, mode="clip"), 0.0).max(axis=1)
        return tops

    sharpest = np.square(highest(cells.sharpness[channel], -1, 2))
    lively, silent = highest(powers, 0, TAIL), highest(powers, -LEAD[1], -LEAD[0])
    levels_db = _decibels(np.stack((sharpest, before, after, *beside, lively, silent)))
    sharpest_db, before_db, after_db, *beside_db, lively_db, silent_db = levels_db
    columns = (
        sharpest_db,
        sharpest_db - before_db,
        sharpest_db - after_db,
        np.maximum(beside_db[0] - beside_db[1], beside_db[2] - beside_db[3]),
        lively_db - silent_db,
    )
    return [Surroundings(*row) for row in np.stack(columns, axis=1).tolist()]


def _decibels(powers: NDArray[np.float64]) -> NDArray[np.float64]:
    return 10 * np.log10(powers + TINY)
