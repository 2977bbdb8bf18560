"""Loops inside a file: each turns without a seam at the new rate, and keeps its place in the file.

The loop's frames are made as if it repeated without end, in as many whole frames as are nearest to its
period; what leads to it and what comes after are made from the file as it plays once.
"""

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from audio_checks.render.resample import frames_after, loop_blocks, position_after

HELD_SAMPLES = 1 << 21  # of all channels: a loop of so few is held in memory, since a short one turns often

Block = NDArray[np.float64]
Blocks = Callable[[], Iterable[Block]]


@dataclass(frozen=True)
class FittedLoop:
    """One loop at the new rate.

    Attributes
    ----------
    start, end : int
        First and last frame in the master.
    first, last : int
        The same in the game file.
    fit_frames : float
        By how many new frames it was lengthened (+) or shortened (−).
    late : int
        By how much its first new frame stands after its first frame in the master, in parts of
        1 / new rate of the master's frames.
    """

    start: int
    end: int
    first: int
    last: int
    fit_frames: float
    late: int

    @property
    def frames(self) -> int:
        """Length at the new rate."""
        return self.last + 1 - self.first


def fitted_loop(start: int, end: int, frames_out: int, sample_rate_hz: int, to_hz: int) -> FittedLoop:
    """Return the position of a loop in a file of so many new frames: half a frame off its period at most."""
    period = end + 1 - start
    frames = min(frames_after(period, sample_rate_hz, to_hz, loop=True), frames_out)
    first = min(position_after(start, sample_rate_hz, to_hz), frames_out - frames)
    return FittedLoop(
        start=start,
        end=end,
        first=first,
        last=first + frames - 1,
        fit_frames=(frames * sample_rate_hz - period * to_hz) / sample_rate_hz,
        late=first * sample_rate_hz - start * to_hz,
    )


def part(blocks: Blocks, start: int, frames: int, channels: int) -> Blocks:
    """Return the stream of `frames` frames from `start` on; one short enough is read once, and held."""

    def cut() -> Iterator[Block]:
        at, end = 0, start + frames
        for block in blocks():
            first, last = max(start - at, 0), min(end - at, len(block))
            if first < last:
                yield block[first:last]
            at += len(block)
            if at >= end:
                return

    if frames * channels > HELD_SAMPLES:
        return cut
    held = list(cut())
    return lambda: held


def with_turns(
    once: Iterable[Block],
    blocks: Blocks,
    loops: Iterable[FittedLoop],
    *,
    channels: int,
    sample_rate_hz: int,
    to_hz: int,
    shelf: float,
) -> Iterator[Block]:
    """Yield a file as it plays `once`, with the frames of its loops as they turn.

    `blocks` is the master; loops that begin before another has ended stay as they play once.
    """
    turns = []
    end = 0
    for loop in sorted(loops, key=lambda loop: loop.first):
        if loop.first >= end:
            turn = loop_blocks(
                part(blocks, loop.start, loop.end + 1 - loop.start, channels),
                frames=loop.end + 1 - loop.start,
                channels=channels,
                sample_rate_hz=sample_rate_hz,
                to_hz=to_hz,
                frames_out=loop.frames,
                late=loop.late,
                shelf=shelf,
            )
            turns.append((loop.first, loop.last + 1, _Frames(turn)))
            end = loop.last + 1
    at = 0
    for block in once:
        yield _turned(block, at, turns)
        at += len(block)


def _turned(block: Block, at: int, turns: Iterable[tuple[int, int, "_Frames"]]) -> Block:
    """Return a block that begins at some frame, with the frames of loops in it recalculated."""
    made = block
    for first, last, frames in turns:
        start, stop = max(first, at), min(last, at + len(block))
        if start < stop:
            made = block.copy() if made is block else made
            made[start - at : stop - at] = frames.take(stop - start)
    return made


class _Frames:
    """Gives a stream in pieces of any length."""

    def __init__(self, stream: Iterator[Block]) -> None:
        self._stream = stream
        self._held = next(stream)

    def take(self, count: int) -> Block:
        parts, missing = [], count
        while missing > len(self._held):
            parts.append(self._held)
            missing -= len(self._held)
            self._held = next(self._stream)
        parts.append(self._held[:missing])
        self._held = self._held[missing:]
        return np.concatenate(parts)
