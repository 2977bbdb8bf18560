"""The seam of a loop: what the ear meets between its last frame and its first."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.measure.decibels import decibels

NEARBY_S = 0.01
INAUDIBLE = 1e-4  # -80 dBFS: nearby changes count as no smaller,
SHARE = 2e-3  # nor as smaller than this share of the largest sample nearby


class Seam:
    """Compares step and change of slope at the seams of loops with those in the 10 ms around each.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    loops : sequence of (int, int, bool), optional
        First and last frame of each loop, and whether it is played back and forth; none is the whole signal.
    """

    FIGURES = ("seam_step_db", "seam_slope_db", "loop_seams")

    def __init__(
        self, sample_rate_hz: int, channels: int, frames: int, *, loops: Sequence[tuple[int, int, bool]] = ()
    ) -> None:
        around = max(1, round(NEARBY_S * sample_rate_hz))
        self._has_loops = bool(loops)
        self._ends = [_Ends(*loop, around, channels) for loop in loops or ((0, frames - 1, False),)]
        self._seen = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        for ends in self._ends:
            ends.add(block, self._seen)
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return, in dB over the largest nearby, the step and the change of slope; the worst channel counts.

        Above 0 dB the seam moves faster than the sound around it. -inf where it does not move at all.
        `seam_step_db` and `seam_slope_db` are those of the first loop, or of the whole signal;
        `loop_seams` has both for each loop, and is empty without loops.
        """
        seams = tuple(ends.seam() for ends in self._ends)
        return {
            "seam_step_db": seams[0][0],
            "seam_slope_db": seams[0][1],
            "loop_seams": seams if self._has_loops else (),
        }


class _Ends:
    """The samples at both ends of one loop."""

    def __init__(self, start: int, last: int, turns: bool, around: int, channels: int) -> None:
        width = min(around, last + 1 - start)
        self._turns = turns
        self._spans = ((last + 1 - width, last + 1), (start, start + width))  # before the seam, after it
        self._sides = np.zeros((2, width, channels))

    def add(self, block: NDArray[np.float64], seen: int) -> None:
        for side, (start, end) in zip(self._sides, self._spans, strict=True):
            first, last = max(start, seen), min(end, seen + len(block))
            if first < last:
                side[first - start : last - start] = block[first - seen : last - seen]

    def seam(self) -> tuple[float, float]:
        """Return the step and the change of slope, in dB over the largest nearby."""
        before, after = self._sides
        if not self._turns:
            return _seam(np.concatenate([before, after]), len(before) - 1)
        # Back from the last frame, and forward again from the first: each is played once at its turn.
        bends = [
            _seam(np.concatenate([side, side[-2::-1]]), len(side) - 1, bends=1)[1] for side in (before, after[::-1])
        ]
        return decibels(0.0), max(bends)


def _seam(around: NDArray[np.float64], last: int, *, bends: int = 2) -> tuple[float, float]:
    """Return step and change of slope after a frame, over the largest elsewhere.

    `bends` is how many changes of slope are the seam's: those before and after its step, or the one of a turn.
    """
    across = np.ascontiguousarray(around.T)  # channel by channel
    steps = across[:, 1:] - across[:, :-1]
    slopes = steps[:, 1:] - steps[:, :-1]
    least = np.maximum(INAUDIBLE, SHARE * np.abs(across).max(axis=1))
    return _excess(steps, last, 1, least), _excess(slopes, last - 1, bends, least)


def _excess(changes: NDArray[np.float64], first: int, count: int, least: NDArray[np.float64]) -> float:
    """Return the largest change at the seam over the largest elsewhere, in dB."""
    sizes = np.abs(changes)
    at_seam = sizes[:, max(first, 0) : first + count].copy()
    if not at_seam.size:
        return decibels(0.0)
    sizes[:, max(first, 0) : first + count] = 0.0
    elsewhere = np.maximum(sizes.max(axis=1, initial=0.0), least)
    return decibels(float((at_seam.max(axis=1) / elsewhere).max()))
