"""Dropouts: holes in a sound, where samples are zero or held while it goes on before and after."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells

STILL = 1.4e-4  # steps up to 4.5 units of 16 bit, dither in the hole included, are no movement
COARSE_STEP = 2.0**-14  # with fewer bits than 15 only samples that are exactly equal stand still
SHORTEST, LONGEST = 2, 500  # cells that are still from end to end: 1 ms to 250 ms
REACH = 20  # cells on either side in which the sound must go on: 10 ms
LIVELY = 0.08  # of the side's median step: what the quietest quarter of its cells must reach
ABRUPT = 0.25  # of the side's median step, or level: what the two cells next to the hole must reach; a fade does not
LOUDER = 10.0  # times: the sides' median step over the largest in the hole
ALIKE = 16.0  # power of the sides may differ by 12 dB
CREST = 0.9  # of the file's peak: what is held so high is a crest that was cut off
SOUND_BELOW_PEAK = 1e-4  # in power, 40 dB under the file's peak: quieter holes count for nothing
BEAT = 2  # cells by which holes of one rhythm may differ
MAX_KEPT = 1_000


class Dropout(NamedTuple):
    """One hole: from when to when, and in which channel (1 is the first)."""

    start_s: float
    end_s: float
    channel: int


class _Hole(NamedTuple):
    """One hole in cells; its own power and that of the sound around it, both a cell."""

    start: int
    end: int
    channel: int
    around: float
    held: float


class Dropouts:
    """Finds holes in cells.

    Parameters
    ----------
    channels : int
    cells_per_s : float
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("dropouts", "dropout_places")
    BACK = LONGEST + 2 * REACH + 4  # cells before the new ones that are looked at again

    def __init__(self, channels: int, cells_per_s: float, step: float) -> None:
        self._per_s = cells_per_s
        self._still = STILL if step < COARSE_STEP else 0.0
        self._channels = channels
        self._seen = 0  # cells
        self._searched = 0  # holes that end up to here are known
        self._found: list[_Hole] = []
        self._runs = np.empty((0, 2), np.int64)  # where the kernel writes

    def add(self, cells: Cells, new: int) -> None:
        """Take the next cells, the last `new` of these; BACK others or more come before, zeros before the first."""
        self._seen += new
        until = self._seen - REACH
        for channel in range(self._channels):
            self._search(channel, cells, until)
        self._searched = max(self._searched, until)

    def result(self, peak: float, cell_frames: int) -> dict[str, Any]:
        """Return `dropouts`, how many there are, and `dropout_places`; `peak` is the file's largest sample."""
        sound, crest = peak**2 * SOUND_BELOW_PEAK * cell_frames, (CREST * peak) ** 2 * cell_frames
        holes = [hole for hole in sorted(self._found) if hole.around >= sound and hole.held < crest]
        if _rhythmic(holes):
            holes = []
        places = [Dropout(hole.start / self._per_s, hole.end / self._per_s, hole.channel + 1) for hole in holes]
        return {"dropouts": len(places), "dropout_places": tuple(places)}

    def _search(self, channel: int, cells: Cells, until: int) -> None:
        steps, squares = cells.steps[channel], cells.squares[channel]
        first = self._seen - len(steps)  # the cell that the first of these is
        if len(self._runs) < len(steps) // 2 + 1:
            self._runs = np.empty((len(steps) // 2 + 1, 2), np.int64)
        ends_by = min(until - first, len(steps) - REACH - 1)
        count = kernel.still_runs(
            steps, self._still, SHORTEST, LONGEST, REACH - first, self._searched - first, ends_by, self._runs
        )
        for start, end in self._runs[:count].tolist():
            before, after = slice(start - REACH, start - 1), slice(end + 1, end + REACH)
            least = LOUDER * max(float(steps[start:end].max()), 1e-6)
            if not _goes_on(steps[before][::-1], squares[before][::-1], least):
                continue
            if not _goes_on(steps[after], squares[after], least):
                continue
            quieter, louder = sorted((float(squares[before].mean()), float(squares[after].mean())))
            if louder <= quieter * ALIKE and len(self._found) < MAX_KEPT:
                held = float(squares[start])
                self._found.append(_Hole(first + start, first + end, channel, quieter, held))


def _goes_on(steps: NDArray[np.float64], squares: NDArray[np.float64], least: float) -> bool:
    """Tell whether there is sound on one side of a hole, up to its very edge; the nearest cell comes first."""
    ranked = np.sort(steps)
    median = float(ranked[len(ranked) // 2])
    if median <= least or ranked[len(ranked) // 4] < LIVELY * median:
        return False
    level = float(np.sort(squares)[len(squares) // 2]) * ABRUPT**2
    return bool(steps[:2].max() >= ABRUPT * median or squares[:2].max() >= level)


def _rhythmic(holes: list[_Hole]) -> bool:
    """Tell whether three or more holes are alike and come on a beat: a gate that is meant."""
    gaps = np.diff(sorted({hole.start for hole in holes}))
    gaps = gaps[gaps > BEAT]
    lengths = [hole.end - hole.start for hole in holes]
    if len(gaps) < 2 or max(lengths) - min(lengths) > BEAT:
        return False
    beats = np.rint(gaps / gaps.min())
    return bool(np.all(np.abs(gaps - beats * gaps.min()) <= BEAT * beats))
