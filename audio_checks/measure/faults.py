"""Faults: clicks, holes, repeats, flat tops, hum and noise, all found on one way through the samples."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure import buffer_pool
from audio_checks.measure.cells import HISTORY, LEAST_CELL, CellStream, cell_frames
from audio_checks.measure.clicks import Clicks
from audio_checks.measure.dropouts import Dropouts
from audio_checks.measure.flat_tops import FlatTops
from audio_checks.measure.hum import Hum
from audio_checks.measure.maxima import ROW_FRAMES, maxima_of
from audio_checks.measure.noise_floor import NoiseFloor
from audio_checks.measure.repeats import HISTORY_S, Repeats
from audio_checks.measure.survey import Room, Survey

Answer = TypeVar("Answer")
STRETCH_FRAMES = 1 << 20  # samples that are looked at together
MOST_SAMPLES = 1 << 22  # of all channels, so that a header of many channels cannot ask for much memory
UNIT_FRAMES = 1 << 11  # what the kernel adds up together: of pieces of whole units all sums are the same
PIECE_SAMPLES = 1 << 18  # of all channels, that are read, hashed and decoded together: their bytes stay in a near cache


DETECTORS: dict[str, tuple[str, ...]] = {
    "clicks": Clicks.FIGURES,
    "dropouts": Dropouts.FIGURES,
    "repeats": Repeats.FIGURES,
    "flat_tops": FlatTops.FIGURES,
    "hum": Hum.FIGURES,
    "noise_floor": NoiseFloor.FIGURES,
}
"""What can be looked for, and the figures that each detector gives."""

CELLS_KEPT = max(Clicks.BACK, Dropouts.BACK, NoiseFloor.BACK)
CELLS_SUFFICE = frozenset({"dropouts", "hum", "noise_floor"})  # the others look back at samples
SUMS_SUFFICE = frozenset({"hum", "noise_floor"})  # of cells, with the squares


class Faults:
    """Hands stretches of samples, with what came before them, to every detector of faults.

    Stretches have their places in the file, whatever the blocks: so figures do not depend on these.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    detectors : iterable of str
        Which of DETECTORS to ask; all without.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        step: float = 0.0,
        detectors: Iterable[str] = tuple(DETECTORS),
        survey: Survey | None = None,
    ) -> None:
        detector_set = frozenset(detectors)
        self._cell = cell_frames(sample_rate_hz)
        self._sums_suffice = detector_set <= SUMS_SUFFICE and self._cell >= LEAST_CELL
        cells_per_s = sample_rate_hz / self._cell
        most = MOST_SAMPLES // channels
        history_s = 0.0 if detector_set <= CELLS_SUFFICE else HISTORY_S
        self._history = _whole(max(HISTORY, min(math.ceil(history_s * sample_rate_hz), most // 2)), ROW_FRAMES)
        self._silence = Clicks.LATE * self._cell  # that follows the sound
        wanted_frames = max(min(STRETCH_FRAMES, most // 2, frames), self._silence)
        self._stretch = _whole(wanted_frames, math.lcm(self._cell, ROW_FRAMES))
        shape = channels, self._history + self._stretch + self._cell
        self._room = buffer_pool.acquire("samples", math.prod(shape) * np.dtype(np.float64).itemsize)
        self._samples = self._room.view(np.float64).reshape(shape)
        self._samples[:, : self._history] = 0.0  # what comes is written before it is read
        self._maxima = np.empty((channels, -(-self._samples.shape[1] // ROW_FRAMES)))
        self._maxima[:, : self._history // ROW_FRAMES] = 0.0
        self._survey = survey or Survey()
        self._decoded: NDArray[np.float64] | None = None  # a block in its final place
        self._hum = Hum(channels, cells_per_s, frames // self._cell, self._cell) if "hum" in detector_set else None
        kept_sums = self._hum.back if self._hum else 0
        self._cells = CellStream(channels, self._cell, CELLS_KEPT, kept_sums, self._stretch // self._cell)
        self._known: tuple[NDArray[np.float64], int] | None = None  # what was measured while it was decoded, its cells
        self._end = self._history  # of what is known of the samples
        self._frame = -self._history  # the position in the signal of the first of them
        self._peak = 0.0
        self._clicks = Clicks(self._cell, cells_per_s, step) if "clicks" in detector_set else None
        self._dropouts = Dropouts(channels, cells_per_s, step) if "dropouts" in detector_set else None
        self._repeats = Repeats(sample_rate_hz, step) if "repeats" in detector_set else None
        self._flat_tops = FlatTops(sample_rate_hz, channels, step) if "flat_tops" in detector_set else None
        self._noise = NoiseFloor(channels, self._cell) if "noise_floor" in detector_set else None
        self.errors: dict[str, Exception] = {}  # of detectors that failed: the others go on

    def room(self) -> int:
        """Return the number of samples that fit until the next look."""
        return self._history + self._stretch - self._end

    def piece_frames(self) -> int:
        """Return the best number of frames to decode together: whole rows and cells that lie in a near cache."""
        unit = math.lcm(self._cell, UNIT_FRAMES)
        return min(max(PIECE_SAMPLES // len(self._samples) // unit, 1) * unit, self._stretch)

    def decode(
        self, pieces: Iterable[bytes | memoryview], frames: int, container_bits: int, *, floats: bool
    ) -> tuple[NDArray[np.float64], int, int]:
        """Decode the next samples, in pieces of `piece_frames`, to where `add` wants them; see `Survey.decode`.

        Passing this array to `add` saves a copy and a pass over the samples. It holds others later.
        """
        first = self._end
        self._samples[:, first + frames : first + frames + self._cell] = 0.0
        count = frames // self._cell + (frames < self._stretch)  # a sound that ends is followed by silence
        rows = -(-frames // ROW_FRAMES)
        if first == self._history:
            before = first // ROW_FRAMES
            cells, maxima = self._cells.room(count), self._maxima[:, before : before + rows]
            if self._sums_suffice:
                cells = cells[: 2 * len(maxima)]
        else:
            cells, maxima = None, np.empty((len(self._samples), rows))
        room = Room(self._samples, first, maxima, cells, self._cell)
        block, used, broken = self._survey.decode(pieces, frames, container_bits, floats, room)
        self._known = None if cells is None else (block, count)
        self._decoded = block
        return block, used, broken

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if block is self._decoded:
            self._take(len(block))
            return
        rows = block.T
        at, count = 0, len(block)
        while at < count:
            taken = min(count - at, self._history + self._stretch - self._end)
            self._samples[:, self._end : self._end + taken] = rows[:, at : at + taken]
            at += taken
            self._known = None
            self._take(taken)

    def _take(self, count: int) -> None:
        self._decoded = None
        self._end += count
        if self._end == self._history + self._stretch:
            self._move_on(self._look())

    def result(self) -> dict[str, Any]:
        """Return the figures of the detectors that were asked for, by name."""
        padding = self._cell - (self._end - self._history) % self._cell  # at least a frame of silence ends the sound
        self._samples[:, self._end : self._end + padding] = 0.0
        self._end += padding
        cells = self._look()
        figures: dict[str, Any] = {}
        if self._clicks:
            self._move_on(cells)
            self._samples[:, self._history : self._history + self._silence] = 0.0
            silent = self._samples[:, : self._history + self._silence]
            count = self._cells.measure(silent, self._history)
            newest = self._cells.newest(count)
            self._ask("clicks", self._clicks.add, newest, count, silent, self._history, self._peak)
            figures |= self._ask("clicks", self._clicks.result, self._peak) or {}
        if self._dropouts:
            figures |= self._ask("dropouts", self._dropouts.result, self._peak, self._cell) or {}
        others = {"repeats": self._repeats, "flat_tops": self._flat_tops, "hum": self._hum, "noise_floor": self._noise}
        for name, detector in others.items():
            if detector:
                figures |= self._ask(name, detector.result) or {}
        buffer_pool.release("samples", self._room)
        self._samples = self._samples[:, :0]  # others write there now
        self._cells.end()
        return figures

    def _ask(self, detector: str, call: Callable[..., Answer], *given: object) -> Answer | None:
        """Call a detector and return its answer; one that has failed is not called again."""
        if detector in self.errors:
            return None
        try:
            return call(*given)
        except MemoryError:  # the machine's trouble, not the detector's
            raise
        except Exception as error:
            self.errors[detector] = error
            return None

    def _measure(self, samples: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64], int]:
        """Return the maxima of all samples, the peaks of channels, and how many cells are new where one wants them."""
        before, rows = self._history // ROW_FRAMES, -(-self._end // ROW_FRAMES)
        if self._known is None:
            maxima = maxima_of(samples[:, self._history :])
            peaks = maxima.max(axis=1)
        else:
            maxima, peaks = self._survey.maxima(self._known[0]), self._survey.peaks(self._known[0])
        if not self._known:  # else they were written there
            self._maxima[:, before : before + maxima.shape[1]] = maxima
        self._maxima[:, before + maxima.shape[1] : rows] = 0.0
        peaks = np.maximum(peaks, self._maxima[:, :before].max(axis=1, initial=0.0))
        count = self._known[1] if self._known else 0
        if not self._known and (self._clicks or self._dropouts or self._hum or self._noise):
            count = self._cells.measure(samples, self._history)
        self._known = None
        return self._maxima[:, :rows], peaks, count

    def _look(self) -> int:
        """Let every detector look at what is new, and return how many cells of it there are."""
        samples = self._samples[:, : self._end]
        maxima, peaks, count = self._measure(samples)
        self._peak = max(self._peak, float(peaks.max()))
        if count:
            cells = self._cells.newest(count)
            if self._clicks:
                self._ask("clicks", self._clicks.add, cells, count, samples, self._history, self._peak)
            if self._dropouts:
                self._ask("dropouts", self._dropouts.add, cells, count)
            if self._noise:
                self._ask("noise_floor", self._noise.add, cells, count)
            if self._hum:
                self._ask("hum", self._hum.add, self._cells.newest_sums(count), count)
        if self._repeats:
            self._ask("repeats", self._repeats.add, samples, int(peaks.argmax()), self._history, self._frame)
        if self._flat_tops:
            self._ask("flat_tops", self._flat_tops.add, samples, maxima, peaks, self._history, self._frame)
        return count

    def _move_on(self, cells: int) -> None:
        """Keep as much of what is new, so many cells with it, as those need that look at the next stretch."""
        self._cells.keep(cells)
        new = self._end - self._history
        for whole, some in ((self._samples, self._history), (self._maxima, self._history // ROW_FRAMES)):
            kept = whole[:, new * some // self._history :][:, :some]
            whole[:, :some] = kept if new >= self._history else kept.copy()
        self._end = self._history
        self._frame += new


def _whole(count: int, unit: int) -> int:
    """Return the next multiple of a unit."""
    return -(-count // unit) * unit
