"""Faults: clicks, holes, repeats, flat tops, hum and noise, all found on one way through the samples."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.cells import HISTORY, cell_frames, cells_of
from audio_checks.measure.clicks import Clicks
from audio_checks.measure.dropouts import Dropouts
from audio_checks.measure.flat_tops import FlatTops
from audio_checks.measure.hum import Hum
from audio_checks.measure.maxima import maxima_of
from audio_checks.measure.noise_floor import NoiseFloor
from audio_checks.measure.repeats import HISTORY_S, Repeats

STRETCH_FRAMES = 1 << 17  # samples that are looked at together
MOST_SAMPLES = 1 << 21  # of all channels, so that a header of many channels cannot ask for much memory


DETECTORS: dict[str, tuple[str, ...]] = {
    "clicks": Clicks.FIGURES,
    "dropouts": Dropouts.FIGURES,
    "repeats": Repeats.FIGURES,
    "flat_tops": FlatTops.FIGURES,
    "hum": Hum.FIGURES,
    "noise_floor": NoiseFloor.FIGURES,
}
"""What can be looked for, and the figures that each detector gives."""

CELLS_SUFFICE = frozenset({"dropouts", "hum", "noise_floor"})  # the others look back at samples


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
    """

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        step: float = 0.0,
        detectors: Iterable[str] = tuple(DETECTORS),
    ) -> None:
        wanted = frozenset(detectors)
        self._cell = cell_frames(sample_rate_hz)
        cells_per_s = sample_rate_hz / self._cell
        most = MOST_SAMPLES // channels
        history_s = 0.0 if wanted <= CELLS_SUFFICE else HISTORY_S
        self._history = max(HISTORY, min(math.ceil(history_s * sample_rate_hz), most // 2))
        stretch = math.ceil(min(STRETCH_FRAMES, most // 2, frames) / self._cell)
        self._silence = Clicks.LATE * self._cell  # that follows the sound
        self._stretch = max(stretch * self._cell, self._silence)
        self._samples = np.zeros((channels, self._history + self._stretch + self._cell))
        self._lent: NDArray[np.float64] | None = None
        self._end = self._history  # of what is known of the samples
        self._frame = -self._history  # where in the signal the first of them lies
        self._peak = 0.0
        self._clicks = Clicks(channels, self._cell, cells_per_s, step) if "clicks" in wanted else None
        self._dropouts = Dropouts(channels, cells_per_s, step) if "dropouts" in wanted else None
        self._repeats = Repeats(sample_rate_hz, step) if "repeats" in wanted else None
        self._flat_tops = FlatTops(sample_rate_hz, channels, step) if "flat_tops" in wanted else None
        self._hum = Hum(channels, cells_per_s, frames // self._cell, self._cell) if "hum" in wanted else None
        self._noise = NoiseFloor(channels, self._cell) if "noise_floor" in wanted else None

    def lend(self, left: int, most: int) -> NDArray[np.float64]:
        """Return room for the next samples, shape (n, channels).

        Whoever fills it and gives the same array to `add` saves a copy. It is used again for later samples.

        Parameters
        ----------
        left : int
            How many samples are to come.
        most : int
            How many are wanted together at most; a stretch is cut into equal parts.
        """
        space = self._history + self._stretch - self._end
        parts = -(-space // most)
        self._lent = self._samples[:, self._end : self._end + min(left, -(-space // parts))].T
        return self._lent

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if block is self._lent:
            self._take(len(block))
            return
        rows = block.T
        at, count = 0, len(block)
        while at < count:
            taken = min(count - at, self._history + self._stretch - self._end)
            self._samples[:, self._end : self._end + taken] = rows[:, at : at + taken]
            at += taken
            self._take(taken)

    def _take(self, count: int) -> None:
        self._lent = None
        self._end += count
        if self._end == self._history + self._stretch:
            self._look()

    def result(self) -> dict[str, Any]:
        """Return the figures of the detectors that were asked for, by name."""
        padding = self._cell - (self._end - self._history) % self._cell  # at least a frame of silence ends the sound
        self._samples[:, self._end : self._end + padding] = 0.0
        self._end += padding
        self._look()
        figures: dict[str, Any] = {}
        if self._clicks:
            self._samples[:, self._history : self._history + self._silence] = 0.0
            silent = self._samples[:, : self._history + self._silence]
            self._clicks.add(cells_of(silent, self._history, self._cell), silent, self._history, self._peak)
            figures |= self._clicks.result(self._peak)
        if self._dropouts:
            figures |= self._dropouts.result(self._peak, self._cell)
        for detector in (self._repeats, self._flat_tops, self._hum, self._noise):
            if detector:
                figures |= detector.result()
        return figures

    def _look(self) -> None:
        """Let every detector look at what is new, and keep as much of it as the next stretch needs."""
        samples = self._samples[:, : self._end]
        maxima = maxima_of(samples)
        self._peak = max(self._peak, float(maxima.max()))
        if self._clicks or self._dropouts or self._hum or self._noise:
            cells = cells_of(samples, self._history, self._cell)
            if self._clicks:
                self._clicks.add(cells, samples, self._history, self._peak)
            for by_cells in (self._dropouts, self._hum, self._noise):
                if by_cells:
                    by_cells.add(cells)
        if self._repeats:
            self._repeats.add(samples, int(maxima.max(axis=1).argmax()), self._history, self._frame)
        if self._flat_tops:
            self._flat_tops.add(samples, maxima, self._history, self._frame)
        new = self._end - self._history
        kept = samples[:, new:]
        self._samples[:, : self._history] = kept if new >= self._history else kept.copy()
        self._end = self._history
        self._frame += new
