"""Faults: clicks, holes, repeats, flat tops, hum and noise, all found on one way through the samples."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.cells import HISTORY, cell_frames, cells_of
from audio_checks.measure.clicks import Clicks
from audio_checks.measure.dropouts import Dropouts
from audio_checks.measure.flat_tops import FlatTops
from audio_checks.measure.hum import Hum
from audio_checks.measure.noise_floor import NoiseFloor
from audio_checks.measure.repeats import HISTORY_S, Repeats

STRETCH_FRAMES = 1 << 17  # samples that are looked at together
MOST_SAMPLES = 1 << 21  # of all channels, so that a header of many channels cannot ask for much memory


class Faults:
    """Hands stretches of samples, with what came before them, to every detector of faults.

    Stretches have their places in the file, whatever the blocks: so figures do not depend on these.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    """

    FIGURES = (
        *Clicks.FIGURES,
        *Dropouts.FIGURES,
        *Repeats.FIGURES,
        *FlatTops.FIGURES,
        *Hum.FIGURES,
        *NoiseFloor.FIGURES,
    )

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, *, step: float = 0.0) -> None:
        self._cell = cell_frames(sample_rate_hz)
        cells_per_s = sample_rate_hz / self._cell
        most = MOST_SAMPLES // channels
        self._history = max(HISTORY, min(math.ceil(HISTORY_S * sample_rate_hz), most // 2))
        stretch = math.ceil(min(STRETCH_FRAMES, most // 2, frames) / self._cell)
        self._silence = Clicks.LATE * self._cell  # that follows the sound
        self._stretch = max(stretch * self._cell, self._silence)
        self._samples = np.zeros((channels, self._history + self._stretch + self._cell))
        self._end = self._history  # of what is known of the samples
        self._frame = -self._history  # where in the signal the first of them lies
        self._peak = 0.0
        self._clicks = Clicks(channels, self._cell, cells_per_s, step)
        self._dropouts = Dropouts(channels, cells_per_s, step)
        self._repeats = Repeats(sample_rate_hz, step)
        self._flat_tops = FlatTops(sample_rate_hz, channels, step)
        self._hum = Hum(channels, cells_per_s, frames // self._cell, self._cell)
        self._noise = NoiseFloor(channels, self._cell)

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        rows = block.T
        at, count = 0, len(block)
        while at < count:
            taken = min(count - at, self._history + self._stretch - self._end)
            self._samples[:, self._end : self._end + taken] = rows[:, at : at + taken]
            self._end += taken
            at += taken
            if self._end == self._history + self._stretch:
                self._look()

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        padding = self._cell - (self._end - self._history) % self._cell  # at least a frame of silence ends the sound
        self._samples[:, self._end : self._end + padding] = 0.0
        self._end += padding
        self._look()
        self._samples[:, self._history : self._history + self._silence] = 0.0
        silent = self._samples[:, : self._history + self._silence]
        self._clicks.add(cells_of(silent, self._history, self._cell), silent, self._history)
        return {
            **self._clicks.result(self._peak),
            **self._dropouts.result(self._peak, self._cell),
            **self._repeats.result(),
            **self._flat_tops.result(),
            **self._hum.result(),
            **self._noise.result(),
        }

    def _look(self) -> None:
        """Let every detector look at what is new, and keep as much of it as the next stretch needs."""
        samples = self._samples[:, : self._end]
        self._peak = max(self._peak, kernel.highest(samples[:, self._history :]))
        cells = cells_of(samples, self._history, self._cell)
        self._clicks.add(cells, samples, self._history)
        for detector in (self._dropouts, self._hum, self._noise):
            detector.add(cells)
        self._repeats.add(samples, self._history, self._frame)
        self._flat_tops.add(samples, self._history, self._frame)
        new = self._end - self._history
        self._samples[:, : self._history] = self._samples[:, new : self._end].copy()
        self._end = self._history
        self._frame += new
