"""Cut edges: sounds that start or end in the middle of their wave."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure import abrupt
from audio_checks.measure.decibels import decibels
from audio_checks.measure.survey import Survey

SILENT = 5e-5  # -86 dBFS: the parts before and after the sound are no louder
GRAIN = 2.0  # steps of the bit depth that still are silence
KEPT_S = 0.1  # of the sound at either end, for how filters ring there and how the sound goes on; NEAR_S of an end
FOLLOWED_S = 10.0  # by more than this, so that no more is kept block by block
EDGE_SHARE = 0.2  # of the largest sample nearby, which an edge in mid-wave reaches and a fade does not
BELOW_PEAK = 10 ** (-36 / 20)  # an edge that quiet, under the file's peak, does not matter
AUDIBLE = 1e-3  # -60 dBFS: nor does one that no one hears, as where a quiet sound fades out
RING_S = 0.005  # the longest that a converter of sample rates rings before an edge,
RING_SHARE = 0.1  # as high as this share of the edge at most, and
RING_HZ = 0.25  # at this share of the rate or more: what fades in is slower
STEP, GAP = 2, 4  # samples in which such an edge rises, and those before its top that no longer ring
SHARP_HZ = 48_000  # at higher rates edges are no sharper than at this one


class Edge(NamedTuple):
    """The start or end of a sound: its place, level and channel (1 is the first), and whether it is cut."""

    at_s: float
    level_dbfs: float
    channel: int
    cut: bool


class Cuts:
    """A memory of a sound's start and end; digital silence around it does not belong to it.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    step : float
        The smallest step of the file's bit depth; 0 for float.
    survey : Survey, optional
        Shared with others that look at the same blocks.
    """

    FIGURES = ("start_edge", "end_edge")

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        step: float = 0.0,
        survey: Survey | None = None,
    ) -> None:
        self._rate = sample_rate_hz
        self._survey = survey or Survey()
        self._step = step
        self._silent = max(SILENT, GRAIN * step)
        self._frames = frames
        self._near, self._length = (max(1, round(kept_s * sample_rate_hz)) for kept_s in (abrupt.NEAR_S, KEPT_S))
        self._head = np.empty((channels, 0))
        self._head_at = -1  # the frame that the sound starts with
        self._tail = np.empty((channels, 0))  # what the sound ends with, as far as is known
        self._after: list[NDArray[np.float64]] = []  # silence that came after it
        self._seen = 0
        self._tail_end = 0
        self._peak = 0.0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        if not len(block):
            return
        planar = kernel.by_channel(block)
        self._peak = max(self._peak, self._survey.highest(block))
        first, last = kernel.loud_frames(planar, self._survey.maxima(block), self._silent)
        if self._head_at < 0:
            if first >= 0:
                self._head_at = self._seen + first
                self._head = planar[:, first : first + self._length].copy()
        elif self._head.shape[1] < self._length:
            self._head = np.concatenate((self._head, planar[:, : self._length - self._head.shape[1]]), axis=1)
        if last >= 0:
            followed_s = (self._frames - self._seen - len(block)) / self._rate
            start = last + 1 - (self._near if followed_s > FOLLOWED_S else self._length)
            if start >= 0:
                self._tail = planar[:, start : last + 1].copy()
            else:
                pieces = (self._tail, *self._after, planar[:, : last + 1])
                self._tail = np.concatenate(pieces, axis=1)[:, -self._length :]
            self._tail_end = self._seen + last + 1
            self._after = []
        if last + 1 < len(block) and sum(piece.shape[1] for piece in self._after) < self._length:
            self._after.append(planar[:, last + 1 : last + 1 + self._length].copy())
        self._seen += len(block)

    def result(self) -> dict[str, Any]:
        """Return `start_edge` and `end_edge`, each an Edge; None for silence."""
        if self._head_at < 0:
            return {"start_edge": None, "end_edge": None}
        return {
            "start_edge": self._judge(self._head, self._head_at, 1),
            "end_edge": self._judge(self._tail[:, ::-1], self._tail_end, -1),
        }

    def _judge(self, kept: NDArray[np.float64], at: int, way: int) -> Edge:
        """Return the most conspicuous channel's edge; what is `kept` runs from the edge into the sound, that `way`."""
        samples = kept[:, : self._near]
        sizes = np.abs(samples)
        channel = int(sizes[:, 0].argmax())
        edge, nearby = float(sizes[channel, 0]), float(sizes[channel].max())
        least = max(BELOW_PEAK * self._peak, AUDIBLE)
        if _jumps(samples[channel], EDGE_SHARE * nearby) and edge >= least:
            return Edge(at / self._rate, decibels(edge), channel + 1, True)
        rung = [(_after_ringing(row, self._rate), 0, number) for number, row in enumerate(samples, 1)]
        ramps = [
            (*abrupt.edge(row, self._rate, self._step, least, start=way > 0), number)
            for number, row in enumerate(kept, 1)
        ]
        height, frames, number = max(rung + ramps)
        if height > 0 and height >= least:
            return Edge((at + way * frames) / self._rate, decibels(height), number, True)
        return Edge(at / self._rate, decibels(edge), channel + 1, False)


def _jumps(samples: NDArray[np.float64], least: float) -> bool:
    """Return whether a wave, followed back beyond its edge by a line or by a parabola, is far from zero."""
    first, second, third = (*samples[:3].tolist(), 0.0, 0.0)[:3]
    return bool(abs(first) >= least and max(abs(2 * first - second), abs(3 * first - 3 * second + third)) >= least)


def _after_ringing(samples: NDArray[np.float64], rate_hz: int) -> float:
    """Return the height of the edge a wave jumps to after it rang, as a steep filter rings before a step; else 0."""
    sizes = np.abs(samples)
    spread = max(1.0, rate_hz / SHARP_HZ)
    begins = int((sizes >= EDGE_SHARE * sizes.max()).argmax())
    top = begins + int(sizes[begins : begins + round(STEP * spread) + 1].argmax())
    ring = samples[: max(0, top - round(GAP * spread))]
    if begins > RING_S * rate_hz or not 0 < np.abs(ring).max(initial=0.0) <= RING_SHARE * sizes[top]:
        return 0.0
    rise = top - int(np.flatnonzero(sizes[:top] <= RING_SHARE * sizes[top])[-1])
    if not _jumps(samples[top::rise], EDGE_SHARE * float(sizes.max())):
        return 0.0
    whole = ring / np.abs(ring).max()  # squares of very small numbers are 0
    turning = float(np.square(np.diff(whole)).sum() / np.square(whole).sum())  # 4 sin²(pi hz / rate) of a tone
    fast = 2 * math.sin(math.pi * RING_HZ / spread)
    return float(sizes[top]) if turning >= fast**2 else 0.0
