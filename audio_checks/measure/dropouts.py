"""Dropouts: holes in a sound that goes on before and after: zeros, a value that is held or leaks away, or hiss."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells
from audio_checks.measure.lulls import LEVEL, UNDER_NEAREST, is_hole

STILL = 1.4e-4  # steps up to 4.5 units of 16 bit, dither in the hole included, are not movement
SMOOTH, SMOOTH_STEPS = 1e-6, 40.0  # sixth differences of what glides by itself, and in steps of the bit depth: dither
COARSE_STEP = 2.0**-14  # with fewer bits than 15 only samples that are exactly equal stand still
FINE_STEP = 2.0**-20  # coarser ones let two cells fall alike by chance, but not three
SHORTEST, LONGEST = 2, 500  # cells that are still from end to end: 1 ms to 250 ms
REACH = 20  # cells on either side in which the sound must go on: 10 ms
LIVELY = 0.08  # of the side's median step: what the quietest quarter of its cells must reach
ABRUPT = 0.25  # of the side's median step, or level: what the two cells next to the hole must reach; a fade does not
LOUDER = 10.0  # times: the sides' median step over the largest in the hole; or so of their sixth differences
LEAK = 0.98  # of one cell's sum the next one's at most, and
LEAK_ALIKE = 0.002  # so near its steps' and its squares' shares: an exponential alone falls like that
BETWEEN = 4  # cells of sound at least between two holes of a row
ALIKE = 16.0  # power of the sides may differ by 12 dB
CREST = 0.9  # of the file's peak: what is held so high is a crest that was cut off
SOUND_BELOW_PEAK = 3e-5  # in power, 45 dB under the file's peak: quieter holes count for nothing
BEAT = 1  # cells by which holes of one rhythm may differ
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
        self._step = step
        self._smooth = max(SMOOTH, SMOOTH_STEPS * step)
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
        holes = [hole for hole in _as_one(self._found) if hole.around >= sound and hole.held < crest]
        if _rhythmic(holes):
            holes = []
        places = [Dropout(hole.start / self._per_s, hole.end / self._per_s, hole.channel + 1) for hole in holes]
        return {"dropouts": len(places), "dropout_places": tuple(places)}

    def _search(self, channel: int, cells: Cells, until: int) -> None:
        squares, steps, sharpness = cells.squares[channel], cells.steps[channel], cells.sharpness[channel]
        first = self._seen - len(steps)  # the cell that the first of these is
        if len(self._runs) < len(steps) // 2 + 1:
            self._runs = np.empty((len(steps) // 2 + 1, 2), np.int64)
        where = REACH - first, self._searched - first, min(until - first, len(steps) - REACH - 1), self._runs
        holes: list[tuple[int, int]] = []
        count = kernel.low_runs(steps, self._still, 0.0, SHORTEST, LONGEST, *where)
        runs = self._runs[:count]
        held = _longest_held(steps, runs, self._step)
        for (start, end), may_go_on in zip(runs.tolist(), _may_go_on_beside(steps, runs), strict=True):
            if may_go_on and _goes_on_beside(steps, steps, squares, start, end):
                holes.append((start, end))
            elif start in held and _goes_on_beside(steps, steps, squares, *held[start], self._step):
                holes.append(held[start])
        count = kernel.low_runs(sharpness, self._smooth, LOUDER * self._smooth, SHORTEST, LONGEST, *where)
        runs = self._runs[:count]
        runs = runs[_may_go_on_beside(sharpness, runs)]
        for start, end in runs.tolist():
            if _goes_on_beside(sharpness, steps, squares, start, end) and self._leaks(cells, channel, start, end):
                holes.append((start, end))
        count = kernel.lulls(squares, UNDER_NEAREST, LEVEL, LONGEST, *where)
        for start, end in self._runs[:count].tolist():
            if is_hole(squares, sharpness, start, end, REACH):
                holes.append((start, end))
        for start, end in holes[: MAX_KEPT - len(self._found)]:
            quieter, louder = sorted(self._power(steps[side], squares[side]) for side in _sides(start, end))
            if louder <= quieter * ALIKE:
                self._found.append(_Hole(first + start, first + end, channel, quieter, held=float(squares[start])))

    def _leaks(self, cells: Cells, channel: int, start: int, end: int) -> bool:
        """Return whether all that moves in a smooth stretch is one value that leaks away, or a straight line."""
        sums, steps, squares = (figures[channel, start:end] for figures in (cells.sums, cells.steps, cells.squares))
        grain = 2 * self._step
        at = np.flatnonzero(steps[:-1] > self._still + grain)
        if not len(at):
            return True
        if len(steps) > SHORTEST and np.ptp(steps) <= LEAK_ALIKE * steps[0] + grain:
            return True
        if len(at) == 1 and self._step > FINE_STEP:
            return False
        share: NDArray[np.float64] = sums[at + 1] / np.where(sums[at], sums[at], np.inf)
        alike = (share > 0) & (share <= LEAK)
        alike &= np.abs(steps[at + 1] - share * steps[at]) <= LEAK_ALIKE * steps[at] + grain
        alike &= np.abs(squares[at + 1] - share**2 * squares[at]) <= 4 * LEAK_ALIKE * squares[at]
        return bool(alike.all())

    def _power(self, steps: NDArray[np.float64], squares: NDArray[np.float64]) -> float:
        """Return the mean power of cells, but for those of the next hole of a row."""
        moving = squares[steps > self._still]
        return float((moving if len(moving) else squares).mean())


def _sides(start: int, end: int) -> tuple[slice, slice]:
    """Return the places of sound on either side of a hole, the nearest cell first; a cell of both is left out."""
    return slice(start - 2, start - REACH - 1, -1), slice(end + 1, end + REACH)


def _may_go_on_beside(figures: NDArray[np.float64], runs: NDArray[np.int64], grain: float = 0.0) -> NDArray[np.bool_]:
    """Return False for each run, shape (runs, 2), for which `_goes_on_beside` is certainly False.

    The median of a side, or of its BETWEEN cells or more before the next hole, exceeds what the hole has only if half
    of BETWEEN cells do. Noise near the bit depth has thousands of still runs: this looks at all of them together.
    """
    if not len(runs):
        return np.empty(0, dtype=bool)
    starts, ends = runs.T
    most = LOUDER * np.maximum(np.maximum.reduceat(figures, runs.ravel())[::2], max(grain, 1e-6))
    nearest = np.arange(2, REACH + 1)
    before = figures[np.maximum(starts[:, np.newaxis] - nearest, 0)] > most[:, np.newaxis]
    after = figures[np.minimum(ends[:, np.newaxis] + nearest - 1, len(figures) - 1)] > most[:, np.newaxis]
    enough = BETWEEN - BETWEEN // 2
    at_the_edge = (starts < REACH) | (ends + REACH > len(figures))
    may: NDArray[np.bool_] = at_the_edge | ((before.sum(axis=1) >= enough) & (after.sum(axis=1) >= enough))
    return may


def _longest_held(steps: NDArray[np.float64], runs: NDArray[np.int64], grain: float) -> dict[int, tuple[int, int]]:
    """Return, by the start of a run, the longest part of it that holds a value, where sound may go on beside that.

    Runs, shape (runs, 2), are in order and apart.
    """
    if not len(runs):
        return {}
    turns = np.flatnonzero(np.diff(np.concatenate(([False], steps == 0.0, [False]))))
    stretches = turns.reshape(-1, 2)
    lengths = np.diff(stretches).ravel()
    stretches, lengths = stretches[lengths >= SHORTEST], lengths[lengths >= SHORTEST]
    of_run = np.searchsorted(runs[:, 1], stretches[:, 0], side="right")
    order = np.lexsort((-lengths, of_run))
    _, longest = np.unique(of_run[order], return_index=True)
    stretches, of_run = stretches[order[longest]], of_run[order[longest]]
    inside = of_run < len(runs)
    stretches, whole = stretches[inside], runs[of_run[inside]]
    inside = (whole[:, 0] <= stretches[:, 0]) & (np.diff(stretches).ravel() < np.diff(whole).ravel())
    stretches, whole = stretches[inside], whole[inside]
    may_go_on = _may_go_on_beside(steps, stretches, grain)
    starts = whole[may_go_on, 0].tolist()
    return {start: (first, last) for start, (first, last) in zip(starts, stretches[may_go_on].tolist(), strict=True)}


def _goes_on_beside(
    figures: NDArray[np.float64],
    steps: NDArray[np.float64],
    squares: NDArray[np.float64],
    start: int,
    end: int,
    grain: float = 0.0,
) -> bool:
    """Return whether there is sound on either side of a hole throughout, up to its edges.

    `figures` of cells, steps or sixth differences, are what the hole has little of: `grain` at least. On one side the
    next hole of a row may be near.
    """
    most = max(float(figures[start:end].max()), grain, 1e-6)
    short = 0
    for side in _sides(start, end):
        sound = figures[side]
        still = np.flatnonzero(sound <= most)
        if len(still) and still[0] >= BETWEEN:
            sound = sound[: still[0]]
            short += 1
        ranked = np.sort(sound)
        median = ranked[len(ranked) // 2]
        if short == 2 or median <= LOUDER * most or ranked[len(ranked) // 4] < LIVELY * median:
            return False
        if _reaches(steps[side], ABRUPT) or _reaches(squares[side], ABRUPT**2):
            continue
        if figures is steps or sound[:2].min() < ABRUPT * median:  # noise goes on where a wave passes zero
            return False
    return True


def _reaches(side: NDArray[np.float64], share: float) -> bool:
    """Return whether one of the two nearest cells has such a share of the median."""
    return bool(side[:2].max() >= share * np.sort(side)[len(side) // 2])


def _as_one(holes: list[_Hole]) -> list[_Hole]:
    """Return holes in order, those of a channel that overlap as one: they were found in two ways."""
    apart: list[_Hole] = []
    for hole in sorted(holes, key=lambda candidate: (candidate.channel, candidate.start)):
        if apart and apart[-1].channel == hole.channel and hole.start < apart[-1].end:
            apart[-1] = apart[-1]._replace(end=max(hole.end, apart[-1].end))
        else:
            apart.append(hole)
    return sorted(apart)


def _rhythmic(holes: list[_Hole]) -> bool:
    """Return whether three or more holes are alike and come on a beat: a gate that is meant."""
    gaps = np.diff(sorted({hole.start for hole in holes}))
    gaps = gaps[gaps > BEAT]
    lengths = [hole.end - hole.start for hole in holes]
    if len(gaps) < 2 or max(lengths) - min(lengths) > BEAT:
        return False
    beats = np.rint(gaps / gaps.min())
    return bool(np.all(np.abs(gaps - beats * gaps.min()) <= BEAT * beats))
