"""The DC offset that a fix takes out: one constant for each channel, where the whole sound stands on it."""

from dataclasses import dataclass
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.fixing.samples import stretch

EDGE_MS = 10.0  # over which the constant rises and falls where the sound begins or ends at zero
STRETCH_S = (0.05, 0.4)  # of the means that are compared: 2 periods of 40 Hz at least, 8 periods of 20 Hz
STRETCHES = 4  # a short sound is parted into so many
CLICKS_ABOVE = 2.0**-15  # a step of one 16-bit value

UNEVEN = (
    "The offset is not the same throughout the sound, and taking one constant out would put an offset where there "
    "is none: use a high-pass at 10 to 20 Hz in the session."
)
LOOPED = (
    "The sound begins or ends at zero and has loop points: taking the offset out would put a step where the loop "
    "joins. Use a high-pass at 10 to 20 Hz in the session, then set the points again."
)


@dataclass(frozen=True)
class Offset:
    """The amount taken out of each channel between two frames.

    Attributes
    ----------
    first, end : int
        The stretch of the master, from frame `first` up to, and without, frame `end`.
    values : ndarray, shape (channels,)
        The constant for each channel, full scale ±1.0.
    head, tail : int
        Frames over which the constant rises from zero at the start and falls to zero at the end; 0
        where the sound stands on the offset at its very edge.
    """

    first: int
    end: int
    values: NDArray[np.float64]
    head: int
    tail: int

    @property
    def is_exact(self) -> bool:
        """Whether every sample is moved by the same whole number of steps, so that nothing is rounded."""
        return not self.head and not self.tail

    def at(self, places: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return the amounts taken out at these frames of the master, shape (frames, channels)."""
        share = rise(places - self.first, self.head) * rise(self.end - 1 - places, self.tail)
        return np.asarray(share * self.values)


def rise(places: NDArray[np.int64], frames: int) -> NDArray[np.float64]:
    """Return the weights of a raised cosine from nothing to the whole over so many frames, shape (n, 1)."""
    if not frames:
        return np.ones((len(places), 1))
    shares = np.clip((places + 0.5) / frames, 0.0, 1.0)
    return np.asarray(0.5 - 0.5 * np.cos(np.pi * shares))[:, np.newaxis]


def offset_of(file: BinaryIO, layout: wav.WavLayout, first: int, end: int) -> Offset:
    """Return the offset of a stretch, so that its mean is zero without it.

    A constant for the whole stretch is a whole number of steps of the master's depth. Where that would
    move the first or last frame away from zero, the constant rises and falls over 10 ms.
    """
    frames = end - first
    total = np.zeros(layout.channels)
    for block in stretch(file, layout, first, end):
        total += block.sum(axis=0)
    mean = total / max(1, frames)
    most = min(round(EDGE_MS * layout.sample_rate_hz / 1000), frames // 8)
    head = most if _leaves_zero(file, layout, first, mean) else 0
    tail = most if _leaves_zero(file, layout, end - 1, mean) else 0
    if head or tail:  # a raised cosine over n frames holds n / 2 of the constant
        return Offset(first, end, total / (frames - (head + tail) / 2), head, tail)
    if layout.encoding == "pcm":
        step = 2.0 ** (1 - layout.bit_depth)
        mean = np.round(mean / step) * step
    return Offset(first, end, mean, 0, 0)


def why_not(file: BinaryIO, layout: wav.WavLayout, limit_percent: float) -> str | None:
    """Return the obstacle to safe removal of a sound's offset, in a sentence; None without one.

    No stretch of the sound may end up further from zero than it is, or than the limit.
    """
    offset = offset_of(file, layout, 0, layout.frames)
    if layout.loops and not offset.is_exact:
        return LOOPED
    means = _means(file, layout)
    most = np.maximum(np.abs(means), limit_percent / 100)
    return UNEVEN if bool((np.abs(means - offset.values) > most).any()) else None


def _leaves_zero(file: BinaryIO, layout: wav.WavLayout, frame: int, mean: NDArray[np.float64]) -> bool:
    return any(
        bool((np.abs(block - mean) > np.maximum(np.abs(block), CLICKS_ABOVE)).any())
        for block in stretch(file, layout, frame, frame + 1)
    )


def _means(file: BinaryIO, layout: wav.WavLayout) -> NDArray[np.float64]:
    """Return the mean of each stretch, shape (stretches, channels), weighted by a Hann window and half overlapped.

    The window keeps a low tone, of which a stretch holds no whole number of periods, out of the mean.
    """
    shortest, longest = STRETCH_S
    length_s = min(max(layout.duration_s / STRETCHES, shortest), longest)
    hop = max(1, round(length_s * layout.sample_rate_hz / 2))
    hops = layout.frames // hop
    if hops < 2:
        return np.zeros((0, layout.channels))
    rising, falling = np.zeros((2, hops, layout.channels))
    start = 0
    for block in stretch(file, layout, 0, hops * hop):
        places = np.arange(start, start + len(block))
        share = np.sin(np.pi / 2 * ((places % hop) + 0.5) / hop)[:, np.newaxis] ** 2
        for sums, weighted in ((rising, block * share), (falling, block * (1 - share))):
            np.add.at(sums, places // hop, weighted)
        start += len(block)
    return np.asarray((rising[:-1] + falling[1:]) / hop)
