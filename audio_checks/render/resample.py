"""Sample rates downwards: FFT overlap-save in float64, linear phase, no delay, exact lengths.

A block of the master is transformed, weighted by the low-pass, cut at the new Nyquist frequency and
transformed back at the new length: filtering and changing the rate are one step. Blocks overlap by
the reach of the filter, so their edges never show.
"""

import math
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.errors import RenderRefused

PASSBAND = 0.95  # of the new Nyquist frequency; the stop band begins at the new Nyquist frequency itself
ATTENUATION_DB = 200.0
MIN_BLOCK_FRAMES = 16_384
BLOCK_FILTERS = 12  # a block is this many filters long, so a twelfth of the work is overlap
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
    """Return where a frame of the master lies at the new rate; half a frame rounds up."""
    return (2 * position * to_hz + sample_rate_hz) // (2 * sample_rate_hz)


def loop_fit_frames(frames: int, sample_rate_hz: int, to_hz: int) -> float:
    """Return by how many new frames a loop was lengthened (+) or shortened (−) to become whole."""
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
        Filter around the seam, as if the samples repeated for ever.

    Returns
    -------
    ndarray, shape (frames_after(...), channels)
        Frame m stands at the instant m / to_hz of the master. Where the master is digital silence as
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
    blocks: Blocks, *, frames: int, channels: int, sample_rate_hz: int, to_hz: int, loop: bool = False
) -> Iterator[NDArray[np.float64]]:
    """Yield a stream at a lower rate, block by block; memory does not grow with its length.

    `blocks` starts the stream from its beginning each time it is called: a loop is read again for
    what comes before its first frame and after its last.
    """
    ensure_downwards(sample_rate_hz, to_hz)
    if not frames:
        return
    if to_hz == sample_rate_hz:
        yield from blocks()
        return
    plan = _plan(sample_rate_hz, to_hz, frames)
    stretch = _Stretch(plan, frames, frames_after(frames, sample_rate_hz, to_hz, loop=loop), loop=loop)
    if loop:
        lead = _frames_before(blocks, frames, plan.edge_in)
        reader = _Reader(_for_ever(lead, blocks), channels, start=-len(lead))
    else:
        reader = _Reader(iter(blocks()), channels, start=0)
    for first in range(0, stretch.frames_out, plan.hop_out):
        start, late = stretch.start_of(first)
        window = reader.take(start - plan.edge_in, plan.block_in)
        count = min(plan.hop_out, stretch.frames_out - first)
        yield _convert(plan, window, count, late, stretch.drift)


@dataclass(frozen=True)
class _Plan:
    """One pair of rates: the filter and how blocks are laid."""

    up: int
    down: int
    reach: int  # frames of the master that the filter sees on each side
    block_in: int
    edge_in: int
    edge_out: int
    hop_out: int
    response: NDArray[np.float64]  # of the zero-phase low-pass, at the bins of a new block

    @property
    def block_out(self) -> int:
        return self.block_in // self.down * self.up


@lru_cache(maxsize=16)
def _lowpass(sample_rate_hz: int, to_hz: int) -> NDArray[np.float64]:
    """Return a Kaiser-windowed sinc from PASSBAND to all of the new Nyquist frequency, odd in length."""
    new_nyquist = to_hz / sample_rate_hz / 2  # cycles per frame of the master
    width = (1 - PASSBAND) * new_nyquist
    cutoff = (1 + PASSBAND) / 2 * new_nyquist
    half = math.ceil((ATTENUATION_DB - 7.95) / (14.36 * width) / 2)  # Kaiser's estimate of the order
    beta = 0.1102 * (ATTENUATION_DB - 8.7)
    steps = np.arange(-half, half + 1)
    taps: NDArray[np.float64] = 2 * cutoff * np.sinc(2 * cutoff * steps) * np.kaiser(2 * half + 1, beta)
    taps /= taps.sum()
    return taps


def _plan(sample_rate_hz: int, to_hz: int, frames: int) -> _Plan:
    half = len(_lowpass(sample_rate_hz, to_hz)) // 2
    wanted = max(MIN_BLOCK_FRAMES, BLOCK_FILTERS * 2 * half)
    return _laid_plan(sample_rate_hz, to_hz, min(wanted, 1 << (frames - 1).bit_length()))


@lru_cache(maxsize=32)
def _laid_plan(sample_rate_hz: int, to_hz: int, hop_wanted: int) -> _Plan:
    common = math.gcd(sample_rate_hz, to_hz)
    up, down = to_hz // common, sample_rate_hz // common
    taps = _lowpass(sample_rate_hz, to_hz)
    half = len(taps) // 2
    slack = 2 + 2 * math.ceil(down / up)  # a loop's frames lie up to a frame off the grid of their block
    edge_units = math.ceil((half + slack) / down)
    units = _smooth(math.ceil(hop_wanted / down) + 2 * edge_units)
    block_in, block_out = units * down, units * up
    centred = np.zeros(block_in)
    centred[: half + 1] = taps[half:]
    centred[-half:] = taps[:half]
    response = np.fft.rfft(centred).real[: block_out // 2 + 1] * (up / down)
    if block_out % 2 == 0:
        response[-1] = 0.0
    return _Plan(
        up=up,
        down=down,
        reach=half,
        block_in=block_in,
        edge_in=edge_units * down,
        edge_out=edge_units * up,
        hop_out=(units - 2 * edge_units) * up,
        response=response,
    )


def _smooth(least: int) -> int:
    """Return the first number from `least` on whose only prime factors are 2, 3 and 5, for quick transforms."""
    number = least
    while True:
        rest = number
        for prime in (2, 3, 5):
            while rest % prime == 0:
                rest //= prime
        if rest == 1:
            return number
        number += 1


class _Stretch:
    """Where the new frames lie in the master; a loop is stretched evenly to its whole number of frames."""

    def __init__(self, plan: _Plan, frames: int, frames_out: int, *, loop: bool) -> None:
        self.frames_out = frames_out
        self._step_in, self._step_out = (frames, frames_out) if loop else (plan.down, plan.up)
        # Frames of the master by which each new frame comes later than on the plain grid of the rates.
        self.drift = (self._step_in * plan.up - plan.down * self._step_out) / (self._step_out * plan.up)

    def start_of(self, frame_out: int) -> tuple[int, float]:
        """Return the frame of the master at or just before a new frame, and by how much it is before."""
        whole, part = divmod(frame_out * self._step_in, self._step_out)
        return whole, part / self._step_out


class _Reader:
    """Gives windows of a stream that move forwards; beyond both ends lies silence."""

    def __init__(self, source: Iterator[NDArray[np.float64]], channels: int, start: int) -> None:
        self._source = source
        self._held = np.empty((0, channels))
        self._start = start

    def take(self, start: int, count: int) -> NDArray[np.float64]:
        """Return `count` frames from `start` on, shape (count, channels)."""
        before = max(0, self._start - start)
        skip = max(0, start - self._start)
        parts, have = [self._held], len(self._held)
        while have < skip + count - before:
            block = next(self._source, None)
            if block is None:
                break
            parts.append(block)
            have += len(block)
        held = np.concatenate(parts)[skip:]
        self._held = held
        self._start += skip
        window = np.zeros((count, held.shape[1]))
        found = held[: count - before]
        window[before : before + len(found)] = found
        return window


def _frames_before(blocks: Blocks, frames: int, count: int) -> NDArray[np.float64]:
    """Return the `count` frames that sound before the first frame of a loop."""
    tail = None
    for block in blocks():
        tail = block if tail is None else np.concatenate([tail, block])[-count:]
    assert tail is not None  # noqa: S101 - a stream with frames has a block
    tail = tail[-min(count, frames) :]
    return tail[np.arange(-count, 0) % len(tail)]


def _for_ever(lead: NDArray[np.float64], blocks: Blocks) -> Iterator[NDArray[np.float64]]:
    yield lead
    while True:
        yield from blocks()


def _convert(plan: _Plan, window: NDArray[np.float64], count: int, late: float, drift: float) -> NDArray[np.float64]:
    planar = np.ascontiguousarray(window.T)
    spectrum = np.fft.rfft(planar)[:, : len(plan.response)] * plan.response
    offsets = (np.arange(count, dtype=np.float64) - (count - 1) / 2) * (drift * plan.up / plan.down)
    middle = late + drift * (count - 1) / 2
    span = slice(plan.edge_out, plan.edge_out + count)
    if middle:
        spectrum *= np.exp(2j * np.pi / plan.block_in * middle * np.arange(len(plan.response)))
    converted = np.fft.irfft(spectrum, plan.block_out)[:, span]
    if drift:
        converted += _moved(plan, spectrum, offsets, span)
    _silence_where_silent(plan, planar, converted, late, drift)
    return converted.T


def _moved(
    plan: _Plan, spectrum: NDArray[np.complex128], offsets: NDArray[np.float64], span: slice
) -> NDArray[np.float64]:
    """Return what a shift of each new frame by its own small offset adds: Taylor's series, derivatives by the FFT."""
    turn = 2j * np.pi / plan.block_out * np.arange(spectrum.shape[1])  # at most iπ per new frame
    bound = math.pi * float(np.abs(offsets).max(initial=0.0))
    added = np.zeros((len(spectrum), len(offsets)))
    weight, size, order = np.ones_like(offsets), 1.0, 1
    while size > SERIES_END and bound:
        spectrum = spectrum * turn
        weight = weight * offsets / order
        size *= bound / order
        added += weight * np.fft.irfft(spectrum, plan.block_out)[:, span]
        order += 1
    return added


def _silence_where_silent(
    plan: _Plan, planar: NDArray[np.float64], converted: NDArray[np.float64], late: float, drift: float
) -> None:
    sounding = planar != 0.0
    if sounding.shape[1] - np.count_nonzero(sounding, axis=1).min() < plan.reach:
        return
    index = np.arange(converted.shape[1])
    centre = plan.edge_in + late + index * (plan.down / plan.up + drift)
    low = np.floor(centre).astype(np.int64) - plan.reach
    high = np.ceil(centre).astype(np.int64) + plan.reach + 1
    for channel, heard in enumerate(sounding):
        counts = np.concatenate([[0], np.cumsum(heard)])
        converted[channel, counts[high] == counts[low]] = 0.0
