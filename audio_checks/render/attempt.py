"""One writing of a game file, measured on its way: what its peaks are, and what rounding added."""

import math
from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.average_spectrum import AverageSpectrum
from audio_checks.measure.levels import Levels
from audio_checks.measure.loudness import Loudness
from audio_checks.measure.true_peak import TruePeak
from audio_checks.render.dither import Dither, Requantisation
from audio_checks.render.recipe import Recipe
from audio_checks.render.rendered import SeamFigures


class Attempt:
    """The result of one attempt to write the file."""

    FIGURES = (*Levels.FIGURES, *TruePeak.FIGURES, *Loudness.FIGURES)

    def __init__(
        self,
        rate: int,
        bit_depth: int,
        dither: Dither,
        channels: int,
        frames: int,
        weights: NDArray[np.float64],
        *,
        bands_of_hz: int | None,
    ) -> None:
        self.bit_depth = bit_depth
        self.dither = dither
        self.noise = Requantisation()
        self.spectrum = (
            None if bands_of_hz is None else AverageSpectrum(rate, channels, frames, bands_of_hz=bands_of_hz)
        )
        self.pcm_sha256: str | None = None  # of what a coded file decodes to
        self.seam: SeamFigures | None = None
        self._lowest = self._highest = 0
        self._is_decoded = False
        self._accumulators = (
            Levels(rate, channels, frames),
            TruePeak(rate, channels, frames),
            Loudness(rate, channels, frames, weights=weights),
        )
        self._figures: dict[str, Any] | None = None

    def watched_steps(self, blocks: Iterator[NDArray[np.int64]]) -> Iterator[NDArray[np.int64]]:
        """Pass whole numbers through, measured before they are held to the range that can be written."""
        full = 1 << (self.bit_depth - 1)
        for block in blocks:
            lowest, highest = int(block.min(initial=0)), int(block.max(initial=0))
            self._lowest, self._highest = min(self._lowest, lowest), max(self._highest, highest)
            self._measure(block / full)
            yield np.clip(block, -full, full - 1) if lowest < -full or highest >= full else block

    def watched_floats(
        self, blocks: Iterator[NDArray[np.float64]], dtype: type[np.float32] | type[np.float64]
    ) -> Iterator[NDArray[np.floating]]:
        """Pass floats through at the width that is written, measured as a reader will find them."""
        for block in blocks:
            written: NDArray[np.floating] = block.astype(dtype)
            kept = written.astype(np.float64)
            self.noise.add(kept - block)
            self._measure(kept)
            yield written

    def watch_decoded(self, blocks: Iterator[NDArray[np.float64]], wanted: Iterator[NDArray[np.float64]]) -> None:
        """Measure the decoded sound of a coded file, and its distance from the encoder's input."""
        self._is_decoded = True
        for block, meant in zip(blocks, wanted, strict=True):
            self.noise.add(block - meant)
            self._measure(block)

    def figures(self) -> dict[str, Any]:
        """Return the levels of what was written, by their names in the report."""
        if self._figures is None:
            self._figures = {}
            for accumulator in self._accumulators:
                self._figures |= accumulator.result()
        return self._figures

    def over_db(self, recipe: Recipe) -> float:
        """Return the excess of the loudest peak in dB; 0 when none is beyond its limit."""
        figures = self.figures()
        over = [0.0]
        for level, limit in (
            (figures["sample_peak_dbfs"], recipe.sample_peak_limit_dbfs),
            (figures["true_peak_dbtp"], recipe.true_peak_limit_dbtp),
        ):
            if limit is not None and level > limit + recipe.tolerance_db:
                over.append(level - limit)
        if self._is_decoded:  # a float decoder goes beyond full scale, and the game's clips there
            over.append(figures["sample_peak_dbfs"])
            return max(over)
        full = 1 << (self.bit_depth - 1)
        clips = max(self._highest / (full - 1), -self._lowest / full)
        if clips > 1:
            over.append(20 * math.log10(clips))
        return max(over)

    def _measure(self, block: NDArray[np.float64]) -> None:
        for accumulator in self._accumulators:
            accumulator.add(block)
        if self.spectrum is not None:
            self.spectrum.add(block)
