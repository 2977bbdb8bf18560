"""Clicks: moments far sharper than all that lies around them, in a sound that goes on."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells
from audio_checks.measure.decibels import decibels

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
SEGMENT = 64  # cells of steady sound that are looked at together
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
    channels : int
    cell_frames : int
        Frames of each cell.
    cells_per_s : float
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = ("clicks", "click_places")
    LATE = SEGMENT + REACH  # cells of silence that must follow the sound, so that all of it is looked at

    def __init__(self, channels: int, cell_frames: int, cells_per_s: float, step: float) -> None:
        self._cell = cell_frames
        self._per_s = cells_per_s
        self._least = max(GRAIN * step, 1e-6)
        self._recent = Cells(*np.zeros((len(Cells._fields), channels, REACH)))
        self._first = -REACH  # the cell that the first of these is
        self._segment = 0  # the cell that the next segment starts with
        self._doubtful: set[tuple[int, int]] = set()  # segment, channel
        self._window = np.hanning((SEGMENT + 2 * REACH) * cell_frames + 2)[1:-1].copy()
        self._lowest, self._quietest = self._least, 0.0  # limits by the peak so far
        self._places = np.empty(0, np.int64)  # where the kernel writes
        self._found: set[tuple[int, int, float, float]] = set()  # cell, channel, height, power of the sound around

    def add(self, cells: Cells, samples: NDArray[np.float64], first: int, peak: float) -> None:
        """Take the next cells; they start at frame `first` of `samples`, shape (channels, n).

        `peak` is the largest sample so far: what is too small or too quiet beside it is so beside the file's.
        """
        self._lowest, self._quietest = self._limits(peak)
        recent = Cells(*(np.concatenate(pair, axis=1) for pair in zip(self._recent, cells, strict=True)))
        begun = self._first + recent.sums.shape[1] - cells.sums.shape[1]  # the first of the new cells
        total = self._first + recent.sums.shape[1]
        start = max(self._first + REACH, begun - REACH)
        if total - start > REACH:
            for channel in range(len(samples)):
                near = slice(start - REACH - self._first, None)
                sharpness = recent.sharpness[channel, near]
                self._doubtful |= {
                    ((start + cell - REACH) // SEGMENT, channel)
                    for cell in self._outstanding(sharpness, DOUBTFUL, IMPULSE)
                }
                self._keep(recent, channel, start, sharpness, STANDS_OUT, IMPULSE)
                self._keep(recent, channel, start, recent.steps[channel, near], STEPS_OUT)
        count = (total - self._segment - REACH) // SEGMENT
        if count > 0:
            self._look_closer(recent, count, samples, first + (self._segment - begun) * self._cell)
            self._segment += count * SEGMENT
        kept = min(recent.sums.shape[1], SEGMENT + 3 * REACH)
        self._recent = Cells(*(figures[:, -kept:] for figures in recent))
        self._first = total - kept

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
        recent: Cells,
        channel: int,
        start: int,
        sizes: NDArray[np.float64],
        times: float,
        scale: float = 1.0,
    ) -> None:
        """Keep what stands out, of all cells but the first and the last REACH; the first of the others is `start`.

        A size is so many times the height of the click that it stands for.
        """
        for cell in self._outstanding(sizes, times, scale):
            place = start - self._first + cell - REACH
            quieter, louder = sorted(kernel.means_beside(recent.squares[channel], place, LEVEL_CELLS, CORE))
            lower, higher = sorted(kernel.means_beside(recent.edges[channel], place, LEVEL_CELLS, CORE))
            goes_on = louder <= quieter * GOES_ON or higher <= lower * GOES_ON
            if goes_on and quieter >= self._quietest and len(self._found) < MAX_KEPT:
                self._found.add((start + cell - REACH, channel, float(sizes[cell]) / scale, quieter))

    def _outstanding(self, sizes: NDArray[np.float64], times: float, scale: float) -> list[int]:
        """Return the places of what is so many times as large as all that lies around it."""
        if len(self._places) < len(sizes):
            self._places = np.empty(len(sizes), np.int64)
        places = self._places[: len(sizes)]
        found = kernel.outstanding(sizes, REACH, CORE, times, self._lowest * scale, places)
        outstanding: list[int] = places[:found].tolist()
        return outstanding

    def _look_closer(self, recent: Cells, count: int, samples: NDArray[np.float64], at: int) -> None:
        """Look at the next segments where they are steady, or may hide a click; the first starts at frame `at`."""
        place = self._segment - self._first
        shape = (len(samples), count, SEGMENT)
        inner = slice(place, place + count * SEGMENT)
        steady = np.empty((len(samples), count), np.bool_)
        most = STEADY**2 / self._cell
        for channel, flags in enumerate(steady):
            sharpness, edges = recent.sharpness[channel, inner], recent.edges[channel, inner]
            kernel.steady_segments(sharpness, edges, SEGMENT, CLICKED, self._least, most, flags)
        wanted, begun = steady.copy(), self._segment // SEGMENT
        for segment, channel in [one for one in self._doubtful if one[0] < begun + count]:
            self._doubtful.remove((segment, channel))
            wanted[channel, segment - begun] = True
        if not wanted.any():
            return
        wanted &= _loudest_nearby(recent.squares[:, inner].reshape(shape)) >= self._quietest
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
            for place, row in zip(kept[:found].tolist(), heights, strict=False):
                if row[REACH:-REACH].max() >= ABOVE_MEAN * row.mean():
                    number = int(numbers[place])
                    times = STANDS_OUT if steady[channel, number] else FORETOLD_OUT
                    self._keep(recent, channel, self._segment + number * SEGMENT, row, times)


def _loudest_nearby(squares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each segment and of those beside it, (channels, segments); inf where one is not known."""
    loudest = np.full((squares.shape[0], squares.shape[1] + 2), np.inf)
    loudest[:, 1:-1] = squares.max(axis=2)
    nearby: NDArray[np.float64] = np.maximum(np.maximum(loudest[:, :-2], loudest[:, 2:]), loudest[:, 1:-1])
    return nearby
