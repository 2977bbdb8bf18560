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
        self._places = np.empty(0, np.int64)  # where the kernel writes
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
            for channel in range(len(samples)):
                near = slice(start - REACH - before, None)
                sharpness = cells.sharpness[channel, near]
                self._doubtful |= {
                    ((start + cell - REACH) // SEGMENT, channel)
                    for cell in self._outstanding(sharpness, DOUBTFUL, IMPULSE)
                }
                self._keep(cells, channel, start - before, start, sharpness, STANDS_OUT, IMPULSE)
                self._keep(cells, channel, start - before, start, cells.steps[channel, near], STEPS_OUT)
        count = (total - self._segment - REACH) // SEGMENT
        if count > 0:
            at = first + (self._segment - begun) * self._cell
            self._look_closer(cells, self._segment - before, count, samples, at)
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
        index: int,
        start: int,
        sizes: NDArray[np.float64],
        times: float,
        scale: float = 1.0,
    ) -> None:
        """Keep what stands out, of all sizes but the first and the last REACH.

        The first of the others is that of the cell `start`, which stands at an index of `cells`. A size is so many
        times the height of the click that it stands for.
        """
        for cell in self._outstanding(sizes, times, scale):
            place = index + cell - REACH
            quieter, louder = sorted(kernel.means_beside(cells.squares[channel], place, LEVEL_CELLS, CORE))
            if quieter < self._quietest or len(self._found) >= MAX_KEPT:
                continue
            if louder > quieter * GOES_ON:
                lower, higher = sorted(kernel.means_beside(cells.edges[channel], place, LEVEL_CELLS, CORE))
                if higher > lower * GOES_ON:
                    continue
            self._found.add((start + cell - REACH, channel, float(sizes[cell]) / scale, quieter))

    def _outstanding(self, sizes: NDArray[np.float64], times: float, scale: float) -> list[int]:
        """Return the places of what is so many times as large as all that lies around it."""
        if len(self._places) < len(sizes):
            self._places = np.empty(len(sizes), np.int64)
        places = self._places[: len(sizes)]
        found = kernel.outstanding(sizes, REACH, CORE, times, self._lowest * scale, places)
        outstanding: list[int] = places[:found].tolist()
        return outstanding

    def _look_closer(self, cells: Cells, index: int, count: int, samples: NDArray[np.float64], at: int) -> None:
        """Look at the next segments where they are steady, or may hide a click.

        The first starts with the cell at an index, and at frame `at`.
        """
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
        starts = at + (np.arange(count) * SEGMENT - REACH) * self._cell
        wanted &= starts >= ORDER  # of many channels less is kept
        for channel in np.flatnonzero(wanted.any(axis=1)).tolist():
            numbers = np.flatnonzero(wanted[channel])
            heights = np.empty((len(numbers), SEGMENT + 2 * REACH))
            kept = np.empty(len(numbers), np.int64)
            found = kernel.unforeseen(
                samples[channel],
                starts[numbers],
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
            rows = heights[:found]
            high = rows[:, REACH:-REACH].max(axis=1) >= ABOVE_MEAN * rows.mean(axis=1)
            for place, row in zip(kept[:found][high].tolist(), rows[high], strict=True):
                number = int(numbers[place])
                times = STANDS_OUT if steady[channel, number] else FORETOLD_OUT
                segment = number * SEGMENT
                self._keep(cells, channel, index + segment, self._segment + segment, row, times)


def _loudest_nearby(squares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each segment and of those beside it, (channels, segments); inf where one is not known."""
    rows = maxima_of(squares)  # two of them are a segment
    loudest = np.full((len(rows), rows.shape[1] // 2 + 2), np.inf)
    np.maximum(rows[:, ::2], rows[:, 1::2], out=loudest[:, 1:-1])
    nearby: NDArray[np.float64] = np.maximum(np.maximum(loudest[:, :-2], loudest[:, 2:]), loudest[:, 1:-1])
    return nearby
