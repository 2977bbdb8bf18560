"""Clicks: moments far sharper than everything around them, in a sound that goes on."""

from __future__ import annotations

from functools import lru_cache
from itertools import groupby
from operator import itemgetter
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import Cells
from audio_checks.measure.click_rules import ALONE, BURST, CORE, IN_BURSTS, IN_GLIDES, Candidate, Rule, strongest
from audio_checks.measure.decibels import decibels
from audio_checks.measure.heard_clicks import AFTER_CELLS, heard_over_db
from audio_checks.measure.maxima import ROW_FRAMES, maxima_of
from audio_checks.measure.onsets import Heights, Surroundings, is_isolated, surroundings

STANDS_OUT = 3.5  # times sharper than the sharpest moment of the 20 ms before and the 20 ms after,
STEPS_OUT = 3.0  # or with so many times the largest step: in hiss a step shows better that way;
BENDS_OUT = 5.0  # or so many times as bent below 1 kHz: a dull click in a bright sound shows there alone
CANDIDATE = (
    1.2  # times as sharp, or a step so many times as large, is worth a closer look by the rules of click_rules.py
)
BENDS_DOUBTFUL = 2.0  # times as bent is worth it, too
DULL_FRAMES = 6  # of a cell that are left without the highs
REACH = 40  # cells on either side that are compared: 20 ms
BURST_STANDS_OUT = 4.0  # times as sharp as all beyond, within the reach: worth a closer look, against the sound beyond
BURST_GOES_ON = 2.8  # the power of sixth differences may fall or rise by 4.5 dB there: strokes and crackle leave a tail
CONTEXT = 24  # cells of the sound before a click, and of that after it, from which it is predicted: 12 ms
LEVEL_CELLS = 20  # 10 ms on either side, by which a sound is said to go on
GOES_ON = 30.0  # power, or that of sixth differences, may fall or rise by 15 dB; more is a sound that starts or stops
BELOW_PEAK = 6.3e-3  # 44 dB under the file's peak: smaller clicks count for nothing
AUDIBLE = 1e-3  # -60 dBFS: no one hears smaller ones
SOUND_BELOW_PEAK = 1e-5  # in power, 50 dB: what counts as a sound
HEARD_DB = 18.0  # over what masks it, of the 20 that are promised: what stands out less is part of the sound
IMPULSE = 20.0  # the sharpness of a single sample at full scale
GRAIN = 8.0  # steps of the bit depth: smaller clicks are rounding
STEADY = 2.7  # peak over RMS of the sixth differences; below that tones hide small clicks in them
SEGMENT = 2 * ROW_FRAMES  # cells of steady sound that are looked at together
GLIDES = 0.12  # of the largest steps of cells, how much they change from one to the next: a tone that glides; noise 0.2
GLIDED = 16  # cells of such a tone, and as many on either side, in which it glides little
GLIDE_DOUBTFUL = 1.3  # times as hard to predict as those beside it is worth a closer look there
CLICKED = 4  # of them, the sharpest ones, do not say how steady the rest is: the click itself must not
ORDER = 20  # samples that predict the next one
ABOVE_MEAN = 3.0  # times the mean height: what stands out of a steady sound reaches that, and most segments are over
MAX_KEPT = 1_000
MAX_CANDIDATES = 8_000  # of a stretch


class Click(NamedTuple):
    """One click: when, in which channel (1 is the first), and the single sample that would be as sharp."""

    at_s: float
    channel: int
    level_dbfs: float


class Clicks:
    """Finds clicks in cells; in steady sounds and at candidates, in the error of linear prediction.

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
        self._candidates: list[Candidate] = []
        self._lowest, self._quietest = self._least, 0.0  # limits by the peak so far
        self._out = np.empty((MAX_CANDIDATES, 5))  # where the kernel writes
        self._places, self._powers = np.empty(MAX_CANDIDATES, np.int64), np.empty(MAX_CANDIDATES)  # the same
        self._new: set[tuple[int, int, float, float]] = set()  # cell, channel, height, power of the sound around
        self._found: dict[tuple[int, int, float, float], Surroundings] = {}
        self._heard: dict[tuple[int, int], float] = {}  # dB over what masks a click, by cell and channel
        self._unheard: set[tuple[int, int]] = set()  # until enough is known of what follows them
        self._heights = Heights()

    def add(self, cells: Cells, new: int, samples: NDArray[np.float64], first: int, peak: float) -> None:
        """Take the next cells, the last `new` of these; they start at frame `first` of `samples`, shape (channels, n).

        At least BACK others come before them, zeros before the first.
        `peak` is the largest sample so far: what is too small or too quiet beside it is so beside the file's.
        """
        self._lowest, self._quietest = self._limits(peak)
        begun, total = self._seen, self._seen + new
        before = total - cells.sums.shape[1]  # the cell that the first of all is
        start = max(0, begun - REACH) - REACH
        if total - start > 2 * REACH:
            for channel in range(len(samples)):
                self._scan(cells, before, channel, start)
        count = (total - self._segment - REACH) // SEGMENT
        if count > 0:
            at = first + (self._segment - begun) * self._cell
            self._check_steady(cells, before, count, samples, at)
            self._segment += count * SEGMENT
        self._check_candidates(cells, before, total, samples, first - begun * self._cell)
        self._heights.add(cells.sharpness[:, cells.sharpness.shape[1] - new :])
        if self._new:
            kept = sorted(self._new - self._found.keys())
            self._found.update(
                zip(kept, surroundings(cells, [key[:2] for key in kept], before, self._cell), strict=True)
            )
            self._unheard |= {key[:2] for key in kept} - self._heard.keys()
            self._new.clear()
        self._listen(total - AFTER_CELLS, samples, first - begun * self._cell)
        self._seen = total

    def result(self, peak: float) -> dict[str, Any]:
        """Return `clicks`, how many there are, and `click_places`; `peak` is the file's largest sample."""
        least, sound = self._limits(peak)
        clicks: list[Click] = []
        last: dict[int, int] = {}
        for key in sorted(self._found):
            cell, channel, height, power = key
            if height < least or power < sound or self._heard[cell, channel] < HEARD_DB:
                continue
            if not is_isolated(self._found[key], self._heights, channel):
                continue
            if cell - last.get(channel, -9) > CORE:
                clicks.append(Click(cell / self._per_s, channel + 1, decibels(height)))
            last[channel] = cell
        return {"clicks": len(clicks), "click_places": tuple(clicks)}

    def _limits(self, peak: float) -> tuple[float, float]:
        """Return the height that a click must have in a file of that peak, and the power that the sound around must."""
        return max(self._least, peak * BELOW_PEAK, AUDIBLE), peak**2 * SOUND_BELOW_PEAK * self._cell

    def _outstanding(
        self,
        cells: Cells,
        channel: int,
        heights: NDArray[np.float64],
        starts: NDArray[np.int64],
        times: float,
        least: float,
        *,
        reach: int = REACH,
        above_mean: float = 0.0,
    ) -> list[list[float]]:
        """Return cells `times` as high as those around them, in each row of heights, but for `reach` at both ends.

        Rows start at the places `starts` of `cells`. What is no higher than `least` counts for nothing.
        Each is given as its row, its cell, its height, the power of the sound around, and how many times as high
        it is.
        """
        outstanding_count = kernel.outstanding_amid(
            heights,
            starts,
            times,
            reach,
            CORE,
            least,
            above_mean,
            cells.squares[channel],
            cells.edges[channel],
            LEVEL_CELLS,
            self._quietest,
            GOES_ON,
            self._out,
        )
        outstanding: list[list[float]] = self._out[:outstanding_count].tolist()
        return outstanding

    def _listen(self, last: int, samples: NDArray[np.float64], origin: int) -> None:
        """Measure how far the clicks up to a cell are heard; cell 0 starts at frame `origin`."""
        for channel in {channel for cell, channel in self._unheard if cell <= last}:
            places = [cell for cell, other in self._unheard if other == channel and cell <= last]
            frames = origin + np.array(places, np.int64) * self._cell
            over_db = heard_over_db(samples[channel], frames, self._cell, round(self._cell * self._per_s))
            self._heard.update(zip(((cell, channel) for cell in places), over_db.tolist(), strict=True))
        self._unheard -= self._heard.keys()

    def _keep(self, cell: int, channel: int, height: float, power: float) -> None:
        if len(self._found) + len(self._new) < MAX_KEPT:
            self._new.add((cell, channel, height, power))

    def _scan(self, cells: Cells, before: int, channel: int, start: int) -> None:
        """Keep the outliers of the cells from one on, and mark possible ones.

        `before` is the cell that the first of `cells` is.
        """
        first = start - before
        sharpness, steps = cells.sharpness[channel], cells.steps[channel]
        bends = np.empty(len(sharpness) - first)
        kernel.bends(cells.sums[channel, first - 2 :], bends)  # a cell late: the last one bends with what follows it
        for heights, begin, scale, times, doubtful in (
            (sharpness[first:], first, IMPULSE, STANDS_OUT, CANDIDATE),
            (steps[first:], first, 1.0, STEPS_OUT, CANDIDATE),
            (bends, first - 1, 1.0, BENDS_OUT, BENDS_DOUBTFUL),
        ):
            rows, starts = heights[np.newaxis], np.array([begin])
            outstanding = self._outstanding(cells, channel, rows, starts, doubtful, self._lowest * scale)
            for _, at, height, power, stands in outstanding:
                cell_index = begin + int(at)
                if stands < times:
                    self._candidates.append(Candidate(channel, ALONE, before + cell_index, stands, power))
                elif heights is not bends:
                    self._keep(before + cell_index, channel, height / scale, power)
                else:
                    self._keep(before + cell_index, channel, _sharpest(sharpness, cell_index), power)
        self._find_bursts(cells, before, channel, first)

    def _find_bursts(self, cells: Cells, before: int, channel: int, first: int) -> None:
        """Mark the outliers from all but a few cells beside them, where the sound beyond those goes on."""
        burst_count = kernel.bursts(
            cells.sharpness[channel, first:],
            cells.squares[channel, first:],
            cells.edges[channel, first:],
            BURST,
            REACH,
            LEVEL_CELLS,
            BURST_STANDS_OUT,
            self._lowest * IMPULSE,
            self._quietest,
            GOES_ON,
            BURST_GOES_ON,
            self._places,
            self._powers,
        )
        for cell_index, power in zip(
            self._places[:burst_count].tolist(), self._powers[:burst_count].tolist(), strict=True
        ):
            self._candidates.append(Candidate(channel, IN_BURSTS, before + first + cell_index, 1.0, power))

    def _check_candidates(
        self, cells: Cells, before: int, total: int, samples: NDArray[np.float64], origin: int
    ) -> None:
        """Keep the candidates that can be predicted neither way, once all that they are compared with is known.

        Cell 0 starts at frame `origin`, `before` is the cell that the first of `cells` is, `total` the next to come.
        """
        dull = max(1, round(self._cell / DULL_FRAMES))  # frames that are taken as one
        decided_cells = total - BURST - 1 - -(-self._around(dull) // self._cell)
        ready = strongest([candidate for candidate in self._candidates if candidate.cell < decided_cells])
        self._candidates = [candidate for candidate in self._candidates if candidate.cell >= decided_cells]
        for (channel, rules), alike in groupby(ready, key=itemgetter(0, 1)):
            doubts, sharpness = list(alike), cells.sharpness[channel]
            for rule in rules:
                asked = [doubt for doubt in doubts if doubt.stands >= rule.stands]
                frames = origin + np.array([candidate.cell for candidate in asked], np.int64) * self._cell
                for index in self._clicks_by(rule, samples[channel], frames, dull) if asked else ():
                    cell, power = asked[index].cell, asked[index].power
                    self._keep(cell, channel, _sharpest(sharpness, cell - before), power)

    def _clicks_by(self, rule: Rule, samples: NDArray[np.float64], frames: NDArray[np.int64], dull: int) -> list[int]:
        """Return the clicks by a rule among cells that start at some frames; `dull` frames are one by such."""
        thin = dull if rule.without_highs else 1
        size = round(self._cell / thin)
        starts = frames - rule.before * self._cell
        late = np.flatnonzero(starts >= self._around(thin))  # of many channels less is kept
        kept = np.empty(len(late), np.int64)
        click_count = kernel.unforeseen_both_ways(
            samples,
            thin,
            starts[late],
            _window(CONTEXT * size),
            _window((rule.cells + 2 * REACH) * size),
            ORDER,
            size,
            rule.cells,
            rule.harder_than_beside,
            rule.harder_than_around,
            kept,
        )
        places: list[int] = late[kept[:click_count]].tolist()
        return places

    def _around(self, thin: int) -> int:
        """Return the count of frames looked at before a place, and as many after it, where so many are taken as one."""
        return (REACH * round(self._cell / thin) + ORDER) * thin

    def _check_steady(self, cells: Cells, before: int, count: int, samples: NDArray[np.float64], at: int) -> None:
        """Look at what cannot be predicted of the next segments, where they are steady or of a tone that glides.

        The first starts at frame `at`; `before` is the cell that the first of `cells` is.
        """
        index = self._segment - before
        inner = slice(index, index + count * SEGMENT)
        steady, gliding = np.empty((2, len(samples), count), np.bool_)
        most = STEADY**2 / self._cell
        for channel in range(len(samples)):
            sharpness, edges = cells.sharpness[channel, inner], cells.edges[channel, inner]
            kernel.steady_segments(sharpness, edges, SEGMENT, CLICKED, self._least, most, steady[channel])
            kernel.gliding_segments(cells.steps[channel, inner], SEGMENT, GLIDES, gliding[channel])
        gliding &= ~steady
        if not (steady.any() or gliding.any()):
            return
        loud = _loudest_nearby(cells.squares[:, inner]) >= self._quietest
        origin = at - self._segment * self._cell
        for channel in range(len(samples)):
            starts = self._segment + np.flatnonzero(steady[channel] & loud[channel]) * SEGMENT
            self._predict(cells, before, channel, starts, samples[channel], origin)
            starts = self._segment + np.flatnonzero(gliding[channel] & loud[channel]) * SEGMENT
            self._predict_gliding(cells, before, channel, starts, samples[channel], origin)

    def _predict(
        self,
        cells: Cells,
        before: int,
        channel: int,
        starts: NDArray[np.int64],
        samples: NDArray[np.float64],
        origin: int,
    ) -> None:
        """Keep the outliers of the unpredictable part of a channel's segments from each of `starts` on.

        Cell 0 starts at frame `origin`.
        """
        heights, starts = self._unforeseen(samples, starts, origin, SEGMENT, REACH, STANDS_OUT, self._lowest)
        outstanding = self._outstanding(
            cells, channel, heights, starts - before, STANDS_OUT, self._lowest, above_mean=ABOVE_MEAN
        )
        for row, at, height, power, _ in outstanding:
            self._keep(int(starts[int(row)]) + int(at), channel, height, power)

    def _predict_gliding(
        self,
        cells: Cells,
        before: int,
        channel: int,
        starts: NDArray[np.int64],
        samples: NDArray[np.float64],
        origin: int,
    ) -> None:
        """Mark possible outliers of the unpredictable part of a channel's segments, little by little."""
        parts = (starts[:, np.newaxis] + np.arange(0, SEGMENT, GLIDED)).ravel()
        heights, parts = self._unforeseen(samples, parts, origin, GLIDED, GLIDED, GLIDE_DOUBTFUL, self._least)
        outstanding = self._outstanding(
            cells, channel, heights, parts - before, GLIDE_DOUBTFUL, self._least, reach=GLIDED
        )
        for row, at, _, power, stands in outstanding:
            self._candidates.append(Candidate(channel, IN_GLIDES, int(parts[int(row)]) + int(at), stands, power))

    def _unforeseen(
        self,
        samples: NDArray[np.float64],
        starts: NDArray[np.int64],
        origin: int,
        count: int,
        reach: int,
        times: float,
        least: float,
    ) -> tuple[NDArray[np.float64], NDArray[np.int64]]:
        """Return the unpredictable part of `count` cells and `reach` on either side, and the first cell of each row.

        The cells start at `starts`; only rows are returned in which something may stand out.
        """
        starts = starts - reach
        frames = origin + starts * self._cell
        starts, frames = starts[frames >= ORDER], frames[frames >= ORDER]  # of many channels less is kept
        heights = np.empty((len(starts), count + 2 * reach))
        kept = np.empty(len(starts), np.int64)
        window = _window((count + 2 * reach) * self._cell)
        kept_count = kernel.unforeseen(
            samples, frames, window, ORDER, self._cell, reach, CORE, times, least, heights, kept
        )
        return heights[:kept_count], starts[kept[:kept_count]]


def _sharpest(sharpness: NDArray[np.float64], cell: int) -> float:
    """Return the single sample that is as sharp as a cell and those that a click there may spill into."""
    return float(sharpness[cell - CORE : cell + CORE + 1].max()) / IMPULSE


@lru_cache(maxsize=8)
def _window(frames: int) -> NDArray[np.float64]:
    """Return a Hann window whose ends lie just outside."""
    return np.hanning(frames + 2)[1:-1].copy()


def _loudest_nearby(squares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the largest of each segment and of those beside it, (channels, segments); inf where one is not known."""
    rows = maxima_of(squares)  # two of them are a segment
    loudest = np.full((len(rows), rows.shape[1] // 2 + 2), np.inf)
    np.maximum(rows[:, ::2], rows[:, 1::2], out=loudest[:, 1:-1])
    nearby: NDArray[np.float64] = np.maximum(np.maximum(loudest[:, :-2], loudest[:, 2:]), loudest[:, 1:-1])
    return nearby
