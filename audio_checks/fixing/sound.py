"""The sound of a fixed copy: what stays of the master's, moved in level and faded where a cut would click."""

import math
from collections.abc import Iterable, Iterator
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.fixing.offset import CLICKS_ABOVE, Offset, rise
from audio_checks.fixing.plan import Plan
from audio_checks.fixing.samples import stretch

FADE_MS = 5.0


def fades_of(file: BinaryIO, layout: wav.WavLayout, plan: Plan, offset: Offset | None) -> tuple[int, int]:
    """Return the numbers of frames faded at start and end: none where the cut would not be heard."""
    most = round(FADE_MS * layout.sample_rate_hz / 1000)
    last = layout.frames - plan.cut_tail - 1
    head = min(most, plan.silent_head) if plan.cut_head and _clicks(file, layout, plan.cut_head, offset) else 0
    tail = min(most, plan.silent_tail) if plan.cut_tail and _clicks(file, layout, last, offset) else 0
    return head, tail


def _clicks(file: BinaryIO, layout: wav.WavLayout, frame: int, offset: Offset | None) -> bool:
    return any(
        bool(np.abs(_centred(block, np.array([frame]), offset)).max() > CLICKS_ABOVE)
        for block in stretch(file, layout, frame, frame + 1)
    )


def _centred(block: NDArray[np.float64], places: NDArray[np.int64], offset: Offset | None) -> NDArray[np.float64]:
    return block if offset is None else block - offset.at(places)


def fixed_sound(
    file: BinaryIO, layout: wav.WavLayout, plan: Plan, fades: tuple[int, int], offset: Offset | None
) -> Iterator[NDArray[np.float64]]:
    """Yield the kept part of the sound, without its offset, moved in level, with its fades."""
    first, end = plan.cut_head, layout.frames - plan.cut_tail
    factor = 10 ** (plan.gain_db / 20)
    start = first
    for block in stretch(file, layout, first, end):
        places = np.arange(start, start + len(block))
        # Where nothing is done the weights are 1.0, so that samples stay exact.
        weights = factor * rise(places - first, fades[0]) * rise(end - 1 - places, fades[1])
        yield _centred(block, places, offset) * weights
        start += len(block)


class Extremes:
    """Holds whole numbers to what a depth can store, and remembers how far they reached."""

    def __init__(self, bit_depth: int) -> None:
        self._full = 1 << (bit_depth - 1)
        self._lowest = self._highest = 0

    def held(self, blocks: Iterable[NDArray[np.int64]]) -> Iterator[NDArray[np.int64]]:
        """Yield the blocks, each value within what can be stored."""
        for block in blocks:
            self._lowest = min(self._lowest, int(block.min(initial=0)))
            self._highest = max(self._highest, int(block.max(initial=0)))
            yield np.clip(block, -self._full, self._full - 1)

    def over_db(self) -> float:
        """Return the excess of the largest in dB; 0 where none did."""
        most = max(self._highest / (self._full - 1), -self._lowest / self._full)
        return 20 * math.log10(most) if most > 1 else 0.0
