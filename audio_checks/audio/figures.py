"""Families of figures, and one pass of their accumulators over the samples of a file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from functools import partial
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.measure.codec_frames import CodecFrames
from audio_checks.measure.cuts import Cuts
from audio_checks.measure.decay import Decay
from audio_checks.measure.edges import Edges
from audio_checks.measure.faults import DETECTORS, Faults
from audio_checks.measure.levels import Levels
from audio_checks.measure.likeness import Likeness
from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.pauses import Pauses
from audio_checks.measure.phase import Phase
from audio_checks.measure.seam import Seam
from audio_checks.measure.spectrum import Spectrum
from audio_checks.measure.steps import Steps
from audio_checks.measure.survey import Survey
from audio_checks.measure.true_peak import TruePeak


class Accumulator(Protocol):
    """Something that measures while a file streams by."""

    def add(self, block: NDArray[np.float64], /) -> None:
        """Take the next samples, shape (n, channels); the array holds others when `add` is called again."""

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""


def _size(layout: wav.WavLayout) -> tuple[int, int, int]:
    return layout.sample_rate_hz, layout.channels, layout.frames


def _step(layout: wav.WavLayout) -> float:
    return 2.0 ** (1 - layout.bit_depth) if layout.encoding == "pcm" else 0.0


def _loudness(layout: wav.WavLayout) -> Accumulator:
    return Loudness(*_size(layout), weights=channel_weights(layout.channels, layout.channel_mask))


def _seam(layout: wav.WavLayout) -> Accumulator:
    return Seam(*_size(layout), loops=[(loop.start, loop.end, loop.kind == "alternating") for loop in layout.loops])


FIGURES: dict[str, tuple[str, ...]] = {
    "levels": Levels.FIGURES,
    "true_peak": TruePeak.FIGURES,
    "loudness": Loudness.FIGURES,
    "edges": Edges.FIGURES,
    "cuts": Cuts.FIGURES,
    **DETECTORS,
    "pauses": Pauses.FIGURES,
    "phase": Phase.FIGURES,
    "steps": Steps.FIGURES,
    "likeness": Likeness.FIGURES,
    "spectrum": Spectrum.FIGURES,
    "decay": Decay.FIGURES,
    "seam": Seam.FIGURES,
    "codec_frames": CodecFrames.FIGURES,
}
"""Families of figures; each family has one accumulator, but all that look for faults share one."""

MAKERS: dict[str, Callable[[wav.WavLayout, Survey], Accumulator]] = {
    "levels": lambda layout, survey: Levels(*_size(layout), survey=survey),
    "true_peak": lambda layout, survey: TruePeak(*_size(layout), survey=survey),
    "loudness": lambda layout, _: _loudness(layout),
    "edges": lambda layout, survey: Edges(*_size(layout), survey=survey),
    "cuts": lambda layout, survey: Cuts(*_size(layout), step=_step(layout), survey=survey),
    "pauses": lambda layout, survey: Pauses(*_size(layout), survey=survey),
    "phase": lambda layout, survey: Phase(*_size(layout), survey=survey),
    "steps": lambda layout, _: Steps(*_size(layout), step=_step(layout)),
    "likeness": lambda layout, _: Likeness(*_size(layout)),
    "spectrum": lambda layout, _: Spectrum(*_size(layout), step=_step(layout)),
    "decay": lambda layout, _: Decay(*_size(layout)),
    "seam": lambda layout, _: _seam(layout),
    "codec_frames": lambda layout, _: CodecFrames(*_size(layout), step=_step(layout)),
}
"""How each family's accumulator is made for a file; what a block's survey finds serves all of them."""

PART_FRAMES = 1 << 17
IN_PARTS = frozenset({"codec_frames", "decay", "likeness", "spectrum"})
"""Families that transform what they are given: that takes many times its memory, so they are given parts of a block."""


class InParts:
    """Hands blocks on in parts of PART_FRAMES."""

    def __init__(self, accumulator: Accumulator) -> None:
        self._accumulator = accumulator

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        for start in range(0, len(block), PART_FRAMES):
            self._accumulator.add(block[start : start + PART_FRAMES])

    def result(self) -> dict[str, Any]:
        """Return the figures, by name."""
        return self._accumulator.result()


FAMILIES = {figure: family for family, figures in FIGURES.items() for figure in figures}


def _makers(
    layout: wav.WavLayout, families: Iterable[str]
) -> Iterator[tuple[tuple[str, ...], Callable[[], Accumulator]]]:
    """Yield the maker of each accumulator, with the families that it measures."""
    survey = Survey()
    ordered_families = sorted(families)
    for family in ordered_families:
        if family in MAKERS:
            yield (family,), partial(_made, family, layout, survey)
    if detectors := tuple(family for family in ordered_families if family in DETECTORS):
        yield (
            detectors,
            partial(Faults, *_size(layout), step=_step(layout), detectors=detectors, survey=survey),
        )


def _made(family: str, layout: wav.WavLayout, survey: Survey) -> Accumulator:
    accumulator = MAKERS[family](layout, survey)
    return InParts(accumulator) if family in IN_PARTS else accumulator


class Pass:
    """One pass over a file's samples. An accumulator that raises loses its figures; the others go on.

    Parameters
    ----------
    layout : WavLayout
    families : iterable of str
        Which families of FIGURES to measure.
    """

    def __init__(self, layout: wav.WavLayout, families: Iterable[str]) -> None:
        self._errors: dict[str, Exception] = {}  # by family
        self._running: list[tuple[tuple[str, ...], Accumulator]] = []
        for measured, make in _makers(layout, families):
            with self._contained(measured):
                self._running.append((measured, make()))

    @property
    def decoder(self) -> Faults | None:
        """The accumulator that blocks are best decoded into, if there is one."""
        return next((accumulator for _, accumulator in self._running if isinstance(accumulator, Faults)), None)

    def add(self, block: NDArray[np.float64]) -> None:
        """Hand the next samples, shape (n, channels), to every accumulator that has not failed."""
        for measured, accumulator in self._running:
            with self._contained(measured):
                accumulator.add(block)
        if self._errors:
            self._running = [running for running in self._running if self._errors.keys().isdisjoint(running[0])]

    def result(self) -> tuple[dict[str, Any], dict[str, Exception]]:
        """Return the figures, None for those that could not be measured, and the error of each of the latter."""
        figures: dict[str, Any] = {}
        for measured, accumulator in self._running:
            with self._contained(measured):
                figures |= accumulator.result()
            if isinstance(accumulator, Faults):
                self._errors |= accumulator.errors
        errors = {figure: error for family, error in self._errors.items() for figure in FIGURES[family]}
        return figures | dict.fromkeys(errors), errors

    @contextmanager
    def _contained(self, families: tuple[str, ...]) -> Iterator[None]:
        try:
            yield
        except MemoryError:  # the machine's trouble, not the figure's
            raise
        except Exception as error:
            self._errors |= dict.fromkeys(families, error)
