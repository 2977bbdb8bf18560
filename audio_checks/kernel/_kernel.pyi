"""The compiled functions. Blocks are float64 of shape (channels, frames), each channel contiguous."""

from typing import overload

import numpy as np
from numpy.typing import NDArray

_Floats = NDArray[np.float64]
_Bytes = bytes | memoryview

def bends(sums: _Floats, out: _Floats, /) -> None: ...
def bursts(
    heights: _Floats,
    squares: _Floats,
    edges: _Floats,
    within: int,
    reach: int,
    level: int,
    times: float,
    least: float,
    quietest: float,
    louder: float,
    sharper: float,
    places: NDArray[np.int64],
    powers: _Floats,
    /,
) -> int: ...
def cells(block: _Floats, first: int, size: int, out: _Floats, /) -> None: ...
def convert(
    stream: _Floats,
    out: _Floats,
    response: _Floats,
    turns_in: _Floats,
    turns_out: _Floats,
    hop_in: int,
    hop_out: int,
    edge_out: int,
    /,
) -> None: ...
def crests(samples: _Floats, maxima: _Floats, first: int, shape: _Floats, out: _Floats, /) -> int: ...
def decay_rows(
    signal: _Floats,
    window: _Floats,
    hop: int,
    turns: _Floats,
    octaves: NDArray[np.int64],
    fine: NDArray[np.int64],
    held: _Floats,
    begins: bool,
    out: _Floats,
    /,
) -> None: ...
def decode_pcm(raw: _Bytes, container_bits: int, block: _Floats, /) -> int: ...
def decode_float(raw: _Bytes, container_bits: int, block: _Floats, /) -> int: ...
def encode_pcm(steps: NDArray[np.int64], channels: int, bits: int, out: bytearray, /) -> bool: ...
def extremes(samples: _Floats, maxima: _Floats, row: int, known: _Floats, /) -> None: ...
def fourier(real: _Floats, imaginary: _Floats, turns: _Floats, /) -> None: ...
def gliding_segments(steps: _Floats, size: int, most: float, flags: NDArray[np.bool_], /) -> None: ...
def group_sums(values: _Floats, size: int, sums: _Floats, /) -> None: ...
@overload
def hash_add(stream: bytearray, data: _Bytes, /) -> None: ...
@overload
def hash_add(stream: bytearray, other: bytearray, data: _Bytes, /) -> None: ...
def hash_begin() -> bytearray: ...
def hash_end(stream: bytearray, /) -> bytes: ...
def hashes_two() -> bool: ...
def highest(block: _Floats, /) -> float: ...
def hop_energies(
    block: _Floats,
    coefficients: _Floats,
    weights: _Floats,
    memory: _Floats,
    open_energies: _Floats,
    hops: _Floats,
    rate: int,
    seen: int,
    hop: int,
    /,
) -> int: ...
def restore_silence(stream: _Floats, out: _Floats, first: NDArray[np.int64], last: NDArray[np.int64], /) -> None: ...
def loud_frames(block: _Floats, maxima: _Floats, level: float, /) -> tuple[int, int]: ...
def low_runs(
    figures: _Floats,
    low: float,
    beside: float,
    shortest: int,
    longest: int,
    starts_after: int,
    ends_after: int,
    ends_by: int,
    out: NDArray[np.int64],
    /,
) -> int: ...
def lulls(
    squares: _Floats,
    deep: float,
    level: float,
    longest: int,
    starts_after: int,
    ends_after: int,
    ends_by: int,
    out: NDArray[np.int64],
    /,
) -> int: ...
def made_from() -> str: ...
def maxima(block: _Floats, rows: _Floats, /) -> None: ...
def outstanding_amid(
    heights: _Floats,
    firsts: NDArray[np.int64],
    times: float,
    reach: int,
    core: int,
    least: float,
    above_mean: float,
    squares: _Floats,
    edges: _Floats,
    level: int,
    quietest: float,
    goes_on: float,
    out: _Floats,
    /,
) -> int: ...
def pitch_rows(
    signal: _Floats,
    window: _Floats,
    first: int,
    hop: int,
    turns: _Floats,
    below: NDArray[np.int64],
    shares: _Floats,
    spans: NDArray[np.int64],
    out: _Floats,
    /,
) -> None: ...
def power_sums(
    signal: _Floats, window: _Floats, first: int, hop: int, count: int, turns: _Floats, sums: _Floats, /
) -> None: ...
def powers(
    signal: _Floats, window: _Floats, first: int, hop: int, turns: _Floats, out: _Floats, by_bin: bool, /
) -> None: ...
def products(block: _Floats, sums: _Floats, /) -> None: ...
def records(
    block: _Floats,
    loudest: float,
    ceiling: float,
    grain: float,
    backward: bool,
    levels: _Floats,
    places: NDArray[np.int64],
    /,
) -> int: ...
def recurrences(
    samples: _Floats,
    first: int,
    spread: float,
    shortest: int,
    longest: int,
    times: float,
    ring: int,
    out: NDArray[np.int64],
    /,
) -> int: ...
def rounded_steps(
    samples: _Floats,
    scale: float,
    noise: NDArray[np.uint64] | None,
    silent: NDArray[np.uint8] | None,
    out: NDArray[np.int64],
    /,
) -> float: ...
def shape_points(
    block: _Floats, starts: NDArray[np.int64], lowest: _Floats, highest: _Floats, squares: _Floats, /
) -> None: ...
def shaped_steps(
    wanted: _Floats, noise: _Floats, silent: NDArray[np.uint8], weights: _Floats, errors: _Floats, /
) -> None: ...
def silent_lines(
    spectrum: NDArray[np.float32],
    bands: NDArray[np.float32],
    firsts: NDArray[np.int32],
    taps: NDArray[np.float32],
    turns: NDArray[np.float32],
    first: int,
    frame: int,
    frames: int,
    silent: float,
    rounding: float,
    audible: float,
    out: NDArray[np.int64],
    /,
) -> int: ...
def silent_runs(samples: _Floats, margin: int, run: int, out: NDArray[np.uint8], /) -> None: ...
def steady_segments(
    sharpness: _Floats, powers: _Floats, size: int, without: int, least: float, most: float, flags: NDArray[np.bool_], /
) -> None: ...
def stereo_products(block: _Floats, at: int, hop: int, hops: _Floats, /) -> None: ...
def straight_tops(
    samples: _Floats,
    maxima: _Floats,
    first: int,
    shape: _Floats,
    patience: int,
    counts: _Floats,
    out: _Floats,
    /,
) -> int: ...
def sums(block: _Floats, figures: _Floats, /) -> None: ...
def survey(
    raw: _Bytes,
    container_bits: int,
    floats: bool,
    samples: _Floats,
    first: int,
    maxima: _Floats,
    figures: _Floats,
    cells: _Floats | None,
    cell: int,
    hops: _Floats | None,
    hop: int,
    at: int,
    /,
) -> tuple[int, int]: ...
def true_peak(
    block: _Floats,
    maxima: _Floats,
    history: _Floats,
    near_taps: _Floats,
    middle_taps: _Floats,
    half_taps: _Floats,
    bounds: _Floats,
    best: float,
    place: int,
    seen: int,
    /,
) -> tuple[float, int]: ...
def unforeseen(
    samples: _Floats,
    starts: NDArray[np.int64],
    window: _Floats,
    order: int,
    size: int,
    reach: int,
    core: int,
    times: float,
    least: float,
    heights: _Floats,
    kept: NDArray[np.int64],
    /,
) -> int: ...
def unforeseen_both_ways(
    samples: _Floats,
    thin: int,
    places: NDArray[np.int64],
    beside: _Floats,
    around: _Floats,
    order: int,
    size: int,
    place: int,
    times_beside: float,
    times_around: float,
    kept: NDArray[np.int64],
    /,
) -> int: ...
def window_loudness(hops: _Floats, first: int, length: int, rate: int, powers: _Floats, /) -> float: ...
