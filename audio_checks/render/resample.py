"""Sample rates downwards: FFT overlap-save in float64, linear phase, no delay, exact lengths.

A block of the master is transformed, weighted by the low-pass, cut at the new Nyquist frequency and
transformed back at the new length: filtering and changing the rate are one step. Blocks overlap by
the reach of the filter, so their edges never show. The transforms are our own (kernel/fourier.c), so
that a render is the same to the last bit on every machine.
"""

import math
from collections import deque
from collections.abc import Callable, Iterable, Iterator

import numpy as np
from numpy.typing import NDArray

from audio_checks.errors import RenderRefused
from audio_checks.kernel import convert, fourier, restore_silence
from audio_checks.render.resample_plan import WINDOWS, Plan, plan_for
from audio_checks.render.twiddles import cos_sin_pi, twiddle_factors

SERIES_END = 1e-17

Blocks = Callable[[], Iterable[NDArray[np.float64]]]


def frames_after(frames: int, sample_rate_hz: int, to_hz: int, *, loop: bool = False) -> int:
    """Return the length at the new rate: rounded up, or for a loop to the nearest whole frame (half rounds up).

    A one-shot keeps every moment of its master; a loop must keep its period, so it is at most half a
    frame off (see `loop_fit_frames`). Nothing with frames in it becomes empty.
    """
    if loop and frames:
        return max(1, (2 * frames * to_hz + sample_rate_hz) // (2 * sample_rate_hz))
    return -(-frames * to_hz // sample_rate_hz)


def position_after(position: int, sample_rate_hz: int, to_hz: int) -> int:
    """Return the position of a master's frame at the new rate; half a frame rounds up."""
    return (2 * position * to_hz + sample_rate_hz) // (2 * sample_rate_hz)


def loop_fit_frames(frames: int, sample_rate_hz: int, to_hz: int) -> float:
    """Return the new frames by which a loop was lengthened (+) or shortened (−) to become whole."""
    whole = frames_after(frames, sample_rate_hz, to_hz, loop=True)
    return (whole * sample_rate_hz - frames * to_hz) / sample_rate_hz


def ensure_downwards(sample_rate_hz: int, to_hz: int) -> None:
    """Raise RenderRefused when the new rate is above the master's."""
    if to_hz > sample_rate_hz:
        raise RenderRefused(
            f"the target asks for {to_hz} Hz, and the master has only {sample_rate_hz} Hz: what a higher rate "
            "would hold was never recorded, so it is not made up",
            code="render:upwards",
            fix=f"deliver a master at {to_hz} Hz or more, or give the project a target at {sample_rate_hz} Hz or less",
        )


def resample(
    samples: NDArray[np.float64], sample_rate_hz: int, to_hz: int, *, loop: bool = False
) -> NDArray[np.float64]:
    """Return `samples` at a lower rate.

    Parameters
    ----------
    samples : ndarray, shape (frames, channels)
        Full scale plays no part: nothing clips.
    sample_rate_hz, to_hz : int
        Frames per second before and after.
    loop : bool
        Filter around the seam, as if the samples repeated without end.

    Returns
    -------
    ndarray, shape (frames_after(...), channels)
        Frame m is at the instant m / to_hz of the master. Where the master is digital silence as
        far as the filter reaches, zeros are exact.

    Raises
    ------
    RenderRefused
        `render:upwards`.
    """
    frames, channels = samples.shape
    parts = resample_blocks(
        lambda: [samples], frames=frames, channels=channels, sample_rate_hz=sample_rate_hz, to_hz=to_hz, loop=loop
    )
    return np.concatenate([np.empty((0, channels)), *parts])


def resample_blocks(
    blocks: Blocks,
    *,
    frames: int,
    channels: int,
    sample_rate_hz: int,
    to_hz: int,
    loop: bool = False,
    shelf: float = 1.0,
) -> Iterator[NDArray[np.float64]]:
    """Yield a stream at a lower rate, block by block; memory does not grow with its length.

    `blocks` starts the stream from its beginning each time it is called: a loop is read again for
    what comes before its first frame and after its last. `shelf` is the gain of the top octave of what
    is left: the filter that cuts the highs lifts those below them, in phase and without delay.
    """
    ensure_downwards(sample_rate_hz, to_hz)
    if not frames:
        return
    if to_hz == sample_rate_hz:
        yield from blocks()
        return
    if loop:
        frames_out = frames_after(frames, sample_rate_hz, to_hz, loop=True)
        yield from loop_blocks(
            blocks,
            frames=frames,
            channels=channels,
            sample_rate_hz=sample_rate_hz,
            to_hz=to_hz,
            frames_out=frames_out,
            shelf=shelf,
        )
        return
    plan = plan_for(sample_rate_hz, to_hz, frames * channels, shelf)
    frames_out = frames_after(frames, sample_rate_hz, to_hz)
    reader = _Reader(iter(blocks()), channels, start=0)
    if plan.up * sample_rate_hz == plan.down * to_hz:
        yield from _on_grid(plan, reader, frames_out, max(1, WINDOWS // channels))
    else:
        yield from _drifting(plan, _Stretch(plan, sample_rate_hz, to_hz), reader, frames_out)


def loop_blocks(
    blocks: Blocks,
    *,
    frames: int,
    channels: int,
    sample_rate_hz: int,
    to_hz: int,
    frames_out: int,
    late: int = 0,
    shelf: float = 1.0,
) -> Iterator[NDArray[np.float64]]:
    """Yield one turn of a loop at a lower rate: filtered as if it repeated without end, fitted to `frames_out` frames.

    `late` is by how much of a frame of the master, in parts of 1 / `to_hz`, the first new frame comes after
    (or, negative, before) the loop's first frame: a loop inside a file keeps its place against what leads to it.
    """
    plan = plan_for(sample_rate_hz, to_hz, frames * channels, shelf)
    lead = _frames_before(blocks, frames, plan.edge_in + -(-sample_rate_hz // to_hz) + 1)
    reader = _Reader(_cycle(lead, blocks), channels, start=-len(lead))
    stretch = _Stretch(plan, frames * to_hz, frames_out * to_hz, late * frames_out)
    yield from _drifting(plan, stretch, reader, frames_out)


def _on_grid(plan: Plan, reader: "_Reader", frames_out: int, at_once: int) -> Iterator[NDArray[np.float64]]:
    """Yield the new frames where blocks of both rates begin together."""
    turns_in, turns_out = twiddle_factors(plan.block_in), twiddle_factors(plan.block_out)
    positions = np.arange(at_once * plan.hop_out, dtype=np.int64) * plan.down
    heard_from = positions // plan.up + (plan.edge_in - plan.reach)
    heard_until = -(-positions // plan.up) + (plan.edge_in + plan.reach)
    for first in range(0, frames_out, plan.hop_out * at_once):
        block_frames = min(plan.hop_out * at_once, frames_out - first)
        blocks = -(-block_frames // plan.hop_out)
        stream = reader.take(first // plan.up * plan.down - plan.edge_in, (blocks - 1) * plan.hop_in + plan.block_in)
        converted = np.empty((len(stream), blocks * plan.hop_out))
        convert(stream, converted, plan.response, turns_in, turns_out, plan.hop_in, plan.hop_out, plan.edge_out)
        frames = converted.shape[1]
        restore_silence(stream, converted, heard_from[:frames], heard_until[:frames])
        yield converted[:, :block_frames].T


def _drifting(plan: Plan, stretch: "_Stretch", reader: "_Reader", frames_out: int) -> Iterator[NDArray[np.float64]]:
    """Yield the new frames where they drift against the grid: of a loop, and of rates with no small ratio."""
    for first in range(0, frames_out, plan.hop_out):
        start, late = stretch.start_of(first)
        window = reader.take(start - plan.edge_in, plan.block_in)
        count = min(plan.hop_out, frames_out - first)
        yield _moved_block(plan, window, count, late, stretch.drift)


class _Stretch:
    """Positions of new frames in the master: `step_out` for `step_in` of its own, all later by `late` / `step_out`."""

    def __init__(self, plan: Plan, step_in: int, step_out: int, late: int = 0) -> None:
        self._step_in, self._step_out, self._late = step_in, step_out, late
        # Frames of the master by which each new frame comes later than on the grid of the plan.
        self.drift = (step_in * plan.up - plan.down * step_out) / (step_out * plan.up)

    def start_of(self, frame_out: int) -> tuple[int, float]:
        """Return the frame of the master at or just before a new frame, and by how much it is before."""
        whole, part = divmod(frame_out * self._step_in + self._late, self._step_out)
        return whole, part / self._step_out


class _Reader:
    """Gives windows of a stream that move forwards; beyond both ends is silence."""

    def __init__(self, source: Iterator[NDArray[np.float64]], channels: int, start: int) -> None:
        self._source = source
        self._channels = channels
        self._held: deque[NDArray[np.float64]] = deque()
        self._start = start  # of what is held
        self._end = start

    def take(self, start: int, count: int) -> NDArray[np.float64]:
        """Return `count` frames from `start` on, shape (channels, count), each channel contiguous."""
        while self._held and self._start + len(self._held[0]) <= start:
            self._start += len(self._held.popleft())
        while self._end < start + count and (block := next(self._source, None)) is not None:
            self._held.append(block)
            self._end += len(block)
        window = np.zeros((self._channels, count))
        at = self._start
        for block in self._held:
            first, last = max(start, at), min(start + count, at + len(block))
            if first < last:
                window[:, first - start : last - start] = block[first - at : last - at].T
            at += len(block)
        return window


def _frames_before(blocks: Blocks, frames: int, count: int) -> NDArray[np.float64]:
    """Return the `count` frames that sound before the first frame of a loop."""
    stream = iter(blocks())
    tail = next(stream)  # a stream with frames has a block
    for block in stream:
        tail = np.concatenate([tail, block])[-count:]
    tail = tail[-min(count, frames) :]
    return tail[np.arange(-count, 0) % len(tail)]


def _cycle(lead: NDArray[np.float64], blocks: Blocks) -> Iterator[NDArray[np.float64]]:
    yield lead
    while True:
        yield from blocks()


def _moved_block(plan: Plan, window: NDArray[np.float64], count: int, late: float, drift: float) -> NDArray[np.float64]:
    """Return `count` new frames: the block moved as a whole to its middle, each frame by its own rest from there."""
    bins = len(plan.response)
    real, imaginary = window.copy(), np.zeros_like(window)
    fourier(real, imaginary, twiddle_factors(plan.block_in))
    real, imaginary = real[:, :bins] * plan.response, imaginary[:, :bins] * plan.response
    offsets = (np.arange(count, dtype=np.float64) - (count - 1) / 2) * (drift * plan.up / plan.down)
    middle = late + drift * (count - 1) / 2
    span = slice(plan.edge_out, plan.edge_out + count)
    if middle:
        cosine, sine = cos_sin_pi(np.arange(bins, dtype=np.float64) * (2.0 * middle / plan.block_in))
        real, imaginary = real * cosine - imaginary * sine, real * sine + imaginary * cosine
    converted = _backwards(plan, real, imaginary)[:, span]
    if drift:
        converted = converted + _moved(plan, real, imaginary, offsets, span)
    centre = plan.edge_in + late + np.arange(count) * (plan.down / plan.up + drift)
    before, after = np.floor(centre).astype(np.int64), np.ceil(centre).astype(np.int64)
    restore_silence(window, converted, before - plan.reach, after + plan.reach)
    return converted.T


def _backwards(plan: Plan, real: NDArray[np.float64], imaginary: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the real signal of half a spectrum, shape (channels, block_out)."""
    size, bins = plan.block_out, real.shape[1]
    # Real and imaginary parts in each other's place make a transform forwards one backwards.
    whole_real, whole_imaginary = np.zeros((len(real), size)), np.zeros((len(real), size))
    whole_imaginary[:, :bins], whole_real[:, :bins] = real, imaginary
    mirror = slice(size - 1, size // 2, -1)
    count = size - 1 - size // 2
    whole_imaginary[:, mirror], whole_real[:, mirror] = real[:, 1 : count + 1], -imaginary[:, 1 : count + 1]
    fourier(whole_real, whole_imaginary, twiddle_factors(size))
    return whole_imaginary


def _moved(
    plan: Plan,
    real: NDArray[np.float64],
    imaginary: NDArray[np.float64],
    offsets: NDArray[np.float64],
    span: slice,
) -> NDArray[np.float64]:
    """Return the addition from a shift of each new frame by its own small offset, by Taylor's series."""
    turn = 2 * math.pi / plan.block_out * np.arange(real.shape[1])  # at most π per new frame
    bound = math.pi * float(np.abs(offsets).max(initial=0.0))
    added = np.zeros((len(real), len(offsets)))
    weight, size, order = np.ones_like(offsets), 1.0, 1
    while size > SERIES_END and bound:
        real, imaginary = -imaginary * turn, real * turn
        weight = weight * offsets / order
        size *= bound / order
        added += weight * _backwards(plan, real, imaginary)[:, span]
        order += 1
    return added
