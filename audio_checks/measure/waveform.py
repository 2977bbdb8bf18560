"""The shape of a sound for drawing: lowest, highest and RMS value of each of its points."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel import by_channel, shape_points

SMALL_POINTS = 240  # a row of a list
MOST_STEPS = 2**31 - 1
LARGE_POINTS = 4096  # a review room across a wide screen


@dataclass(frozen=True)
class WaveShape:
    """Points from the first frame to the last; all channels in one lane, full scale ±1.0."""

    frames: int
    sample_rate_hz: int
    lowest: NDArray[np.float64]
    highest: NDArray[np.float64]
    rms: NDArray[np.float64]

    @property
    def points(self) -> int:
        """Number of points."""
        return len(self.rms)

    def in_steps(self, full_scale: int) -> dict[str, Any]:
        """Return the shape as whole numbers of 32 bits, ±`full_scale` standing for ±1.0."""
        lines = {"min": self.lowest, "max": self.highest, "rms": self.rms}
        whole = {
            name: np.rint(np.clip(line * full_scale, -MOST_STEPS, MOST_STEPS)).astype(int)
            for name, line in lines.items()
        }
        return {"points": self.points, **{name: line.tolist() for name, line in whole.items()}}

    def to_dict(self, decimals: int = 4) -> dict[str, Any]:
        """Return the shape as plain numbers; four decimals are 80 dB below full scale, less than a pixel."""
        return {
            "frames": self.frames,
            "sample_rate_hz": self.sample_rate_hz,
            "min": _plain(self.lowest, decimals),
            "max": _plain(self.highest, decimals),
            "rms": _plain(self.rms, decimals),
        }


class Waveform:
    """Accumulates the shape of a sound, block by block.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole sound.
    points : int
        Points wanted. A sound of fewer frames gets one point a frame.
    """

    def __init__(self, sample_rate_hz: int, channels: int, frames: int, points: int = SMALL_POINTS) -> None:
        self._sample_rate_hz = sample_rate_hz
        self._channels = channels
        self._frames = frames
        count = min(points, frames)
        self._edges = np.arange(count + 1, dtype=np.int64) * frames // max(count, 1)
        self._lowest = np.full(count, np.inf)
        self._highest = np.full(count, -np.inf)
        self._squares = np.zeros(count)
        self._at = 0

    def add(self, block: NDArray[np.float64]) -> None:
        """Take in the next frames, shape (frames, channels)."""
        if not len(block):
            return
        first = int(np.searchsorted(self._edges, self._at, side="right")) - 1
        last = int(np.searchsorted(self._edges, self._at + len(block), side="left"))
        starts = np.maximum(self._edges[first:last] - self._at, 0)
        span = slice(first, last)
        shape_points(by_channel(block), starts, self._lowest[span], self._highest[span], self._squares[span])
        self._at += len(block)

    def result(self) -> WaveShape:
        """Return the shape; no points for no frames."""
        weights = np.diff(self._edges) * self._channels
        return WaveShape(
            frames=self._frames,
            sample_rate_hz=self._sample_rate_hz,
            lowest=self._lowest,
            highest=self._highest,
            rms=np.sqrt(self._squares / weights),
        )


def _plain(values: NDArray[np.float64], decimals: int) -> list[float]:
    plain: list[float] = (np.round(values, decimals) + 0.0).tolist()
    return plain
