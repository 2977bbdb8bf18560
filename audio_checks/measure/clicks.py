"""Clicks: moments far sharper than all that lies around them, in a sound that goes on."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import decibels
from audio_checks.measure.maxima import ROW_FRAMES, maxima_of

STANDS_OUT = 3.5  # times sharper than the sharpest moment of the 20 ms before and the 20 ms after,
STEPS_OUT = 3.0  # or with so many times the largest step: in hiss a step shows better that way
DOUBTFUL = 1.6  # times sharper: a closer look is worth its time, at what cannot be foretold of the sound;
FORETOLD_OUT = 6.0  # what stands out there by so much is a click in any sound, and by STANDS_OUT in a steady one
REACH = 40  # cells on either side that are compared: 20 ms
CORE = 1  # cells beside a click that may belong to it, one of them at a time
LEVEL_CELLS = 20  # 10 ms on either side, by which a sound is said to go on
GOES_ON = 30.0  # power, or that of sixth differences, may fall or rise by 15 dB; more is a sound that starts or stops
BELOW_PEAK = 8e-3  # 42 dB under the file's peak: smaller clicks count for nothing
SOUND_BELOW_PEAK = 1e-5  # in power, 50 dB: what counts as a sound
IMPULSE = 20.0  # the sharpness of a single sample at full scale
GRAIN = 8.0  # steps of the bit depth: smaller clicks are rounding
STEADY = 2.7  # peak over RMS of the sixth differences; below that tones hide small clicks in them
SEGMENT = 2 * ROW_FRAMES  # cells of steady sound that are looked at together
CLICKED = 4  # of them, the sharpest ones, do not say how steady the rest is: the click itself must not
ORDER = 20  # samples that foretell the next one
ABOVE_MEAN = 3.0  # times the mean height: what stands out of a steady sound reaches that, and most segments are over
MAX_KEPT = 1_000
STANDS_OUT_ROW, STEPS_OUT_ROW = np.array([STANDS_OUT]), np.array([STEPS_OUT])


class Click(NamedTuple):
    """One click: when, in which channel (1 is the first), and the single sample that would be as sharp."""

    at_s: float
    channel: int
    level_dbfs: float


class Clicks:
    """Finds clicks in cells; in steady sounds, in what cannot be foretold of them.

    Parameters
    ----------
    cell_frames : int
        Frames of each cell.
    cells_per_s : float
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("clicks", "click_places")
    LATE = SEGMENT + REACH  # cells of silence that must follow the sound, so that all of it is looked at
    BACK = SEGMENT + 3 * REACH  # cells before the new ones that are looked at again

    def __init__(self, cell_frames: int, cells_per_s: float, step: float) -> None:
        self._cell = cell_frames
        self._per_s = cells_per_s
        self._least = max(GRAIN * step, 1e-6)
        self._seen = 0  # cells
        self._segment = 0  # the cell that the next segment starts with
        self._doubtful: set[tuple[int, int]] = set()  # segment, channel
        self._window = np.hanning((SEGMENT + 2 * REACH) * cell_frames + 2)[1:-1].copy()
        self._lowest, self._quietest = self._least, 0.0  # limits by the peak so far
        self._places, self._out = np.empty(0, np.int64), np.empty((MAX_KEPT, 4))  # where the kernel writes
        self._found: set[tuple[int, int, float, float]] = set()  # cell, channel, height, power of the sound around

    def add(self, cells: Cells, new: int, samples: NDArray[np.float64], first: int, peak: float) -> None:
        """Take the next cells, the last `new` of these; they start at frame `first` of `samples`, shape (channels, n).

        At least BACK others come before them, zeros before the first.
        `peak` is the largest sample so far: what is too small or too quiet beside it is so beside the file's.
        """
        self._lowest, self._quietest = self._limits(peak)
        begun, total = self._seen, self._seen + new
        before = total - cells.sums.shape[1]  # the cell that the first of all is
        start = max(0, begun - REACH)
        if total - start > REACH:
            near = slice(start - REACH - before, None)
            starts = np.array([start - REACH])
            for channel in range(len(samples)):
                sharpness, steps = cells.sharpness[channel, near], cells.steps[channel, near]
                for cell in self._doubtful_places(sharpness):
                    self._doubtful.add(((start + cell - REACH) // SEGMENT, channel))
                self._keep(cells, channel, before, starts, sharpness[np.newaxis], STANDS_OUT_ROW, scale=IMPULSE)
                self._keep(cells, channel, before, starts, steps[np.newaxis], STEPS_OUT_ROW)
        count = (total - self._segment - REACH) // SEGMENT
        if count > 0:
            at = first + (self._segment - begun) * self._cell
            self._look_closer(cells, before, count, samples, at)
            self._segment += count * SEGMENT
        self._seen = total

    def result(self, peak: float) -> dict[str, Any]:
        """Return `clicks`, how many there are, and `click_places`; `peak` is the file's largest sample."""
        least, sound = self._limits(peak)
        clicks: list[Click] = []
        last: dict[int, int] = {}
        for cell, channel, height, power in sorted(self._found):
            if height < least or power < sound:
                continue
            if cell - last.get(channel, -9) > CORE:
                clicks.append(Click(cell / self._per_s, channel + 1, decibels(height)))
            last[channel] = cell
        return {"clicks": len(clicks), "click_places": tuple(clicks)}

    def _limits(self, peak: float) -> tuple[float, float]:
        """Return the height that a click must have in a file of that peak, and the power that the sound around must."""
        return max(self._least, peak * BELOW_PEAK), peak**2 * SOUND_BELOW_PEAK * self._cell

    def _keep(
        self,
        cells: Cells,
        channel: int,
        before: int,
        starts: NDArray[np.int64],
        heights: NDArray[np.float64],
        times: NDArray[np.float64],
        *,
        scale: float = 1.0,
        above_mean: float = 0.0,
    ) -> None:
        """Keep what stands out of each row of heights, of all but the first and the last REACH of it.

        Rows start at the cells `starts`; `before` is the cell that the first of `cells` is. A height is `scale` times
        that of the click that it stands for, and so many times as high as what lies around it.
        """
        found = kernel.outstanding_amid(
            heights,
            starts - before,
            times,
            REACH,
            CORE,
            self._lowest * scale,
            above_mean,
            cells.squares[channel],
            cells.edges[channel],
            LEVEL_CELLS,
            self._quietest,
            GOES_ON,
            self._out,
        )
        for row, cell, height, power in self._out[:found].tolist():
            if len(self._found) < MAX_KEPT:
                self._found.add((int(starts[int(row)]) + int(cell), channel, height / scale, power))

    def _doubtful_places(self, sharpness: NDArray[np.float64]) -> list[int]:
        """Return the places of what may be a click, as sharp as it is beside all that lies around it."""
        if len(self._places) < len(sharpness):
            self._places = np.empty(len(sharpness), np.int64)
        places = self._places[: len(sharpness)]
        found = kernel.outstanding(sharpness, REACH, CORE, DOUBTFUL, self._lowest * IMPULSE, places)
        doubtful: list[int] = places[:found].tolist()
        return doubtful

    def _look_closer(self, cells: Cells, before: int, count: int, samples: NDArray[np.float64], at: int) -> None:
        """Look at the next segments where they are steady, or may hide a click.

        The first starts at frame `at`; `before` is the cell that the first of `cells` is.
        """
        index = self._segment - before
        inner = slice(index, index + count * SEGMENT)
        steady = np.empty((len(samples), count), np.bool_)
        most = STEADY**2 / self._cell
        for channel, flags in enumerate(steady):
            sharpness, edges = cells.sharpness[channel, inner], cells.edges[channel, inner]
            kernel.steady_segments(sharpness, edges, SEGMENT, CLICKED, self._least, most, flags)
        wanted, begun = steady.copy(), self._segment // SEGMENT
        for segment, channel in [one for one in self._doubtful if one[0] < begun + count]:
            self._doubtful.remove((segment, channel))
            wanted[channel, segment - begun] = True
        if not wanted.any():
            return
        wanted &= _loudest_nearby(cells.squares[:, inner]) >= self._quietest
        frames = at + (np.arange(count) * SEGMENT - REACH) * self._cell
        wanted &= frames >= ORDER  # of many channels less is kept
        for channel in np.flatnonzero(wanted.any(axis=1)).tolist():
            numbers = np.flatnonzero(wanted[channel])
            heights = np.empty((len(numbers), SEGMENT + 2 * REACH))
            kept = np.empty(len(numbers), np.int64)
            found = kernel.unforeseen(
                samples[channel],
                frames[numbers],
                self._window,
                ORDER,
                self._cell,
                REACH,
                CORE,
                STANDS_OUT,
                self._lowest,
                heights,
                kept,
            )
            numbers = numbers[kept[:found]]
            times = np.where(steady[channel, numbers], STANDS_OUT, FORETOLD_OUT)
            starts = self._segment + numbers * SEGMENT - REACH
            self._keep(cells, channel, before, starts, heights[:found], times, above_mean=ABOVE_MEAN)


def _loudest_nearby(squares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each segment and of those beside it, (channels, segments); inf where one is not known."""
    rows = maxima_of(squares)  # two of them are a segment
    loudest = np.full((len(rows), rows.shape[1] // 2 + 2), np.inf)
    np.maximum(rows[:, ::2], rows[:, 1::2], out=loudest[:, 1:-1])
    nearby: NDArray[np.float64] = np.maximum(np.maximum(loudest[:, :-2], loudest[:, 2:]), loudest[:, 1:-1])
    return nearby
