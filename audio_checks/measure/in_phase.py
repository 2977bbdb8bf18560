"""Lines at multiples of the mains that keep their phase between loud strokes, where no spectrum shows them."""

from __future__ import annotations

from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

LONGEST_S = 4.0  # of a sound; hum does not end there
WINDOW_S = 0.1  # long enough to part the multiples, short enough to fit between strokes
TURNS = 256  # steps of phase from one window to the next that are tried, three for each of the most windows
PROMINENT = 16.0  # power of what adds up in phase, in times of what the noise next to the line adds up to
HALF = 2.0  # amplitude in the same times that each half of the sound must show by itself: hum does not come or go
CLEAR = 0.1  # share of the windows in which the noise lies under the line,
CONSTANT = 0.9  # and the share of these in which the line is there, as strong and in phase,
STRAYS, VARIES = 9.0, 0.25  # within so many times the noise's power and the line's
FLOOR = 0.02  # of the median noise: a window does not count for more than what is as quiet as that
FAINTEST = 1e-5  # in power, 50 dB under the strongest line: what is fainter may be the window's own


class Lines(NamedTuple):
    """Multiples of a frequency that are there, rising, and their power together: 0.5 for a sine at full scale."""

    multiples: tuple[int, ...]
    power: float


def lines_in_phase(samples: NDArray[np.float64], rate_hz: float, mains_hz: float, multiples: int, off: float) -> Lines:
    """Find the multiples of a frequency that go through a sound in one phase.

    The sound is cut into windows, and each multiple's amplitude in them is added up with its phase, those where little
    lies beside the line counting for more: by the power halfway to the neighbouring multiples. A line that goes on
    adds up; what strikes, sweeps or comes and goes does not.

    Parameters
    ----------
    samples : ndarray, shape (frames,)
        One channel, full scale ±1.0; no more than LONGEST_S of it is looked at.
    rate_hz : float
        Twice the highest multiple and more.
    mains_hz : float
        The frequency that all are multiples of.
    multiples : int
        How many are looked for, from the frequency itself on.
    off : float
        Share by which the frequency may be off; the multiples that are found are in tune with each other.

    Returns
    -------
    Lines
        None, of power 0, for silence and where no line keeps its phase.

    Raises
    ------
    ValueError
        For less than one window of sound.

    Notes
    -----
    A matched filter in noise that comes and goes: Kay, Fundamentals of Statistical Signal Processing: Detection Theory
    (1998), section 4.4. The noise is known from a few places only, so that some line shows in one of 36 sounds of
    2 s of white noise; of 400 none showed two that are in tune.
    """
    length = round(WINDOW_S * rate_hz)
    hop = length // 2
    count = (min(len(samples), round(LONGEST_S * rate_hz)) - length) // hop + 1
    orders = np.arange(1, multiples + 1)
    windows = np.lib.stride_tricks.sliding_window_view(samples, length)[: count * hop : hop]
    amplitudes, noise = _amplitudes(windows, rate_hz, mains_hz, orders)
    starts_s = np.arange(count)[:, np.newaxis] * (hop / rate_hz)
    amplitudes *= np.exp(-2j * np.pi * starts_s * (mains_hz * orders))  # what is left turns by how far the line is off
    weights = 1 / noise
    whole = weights.sum(axis=0)
    added = np.fft.fft(amplitudes * weights, TURNS, axis=0) / whole  # by steps of phase a window
    step_hz = rate_hz / hop / TURNS
    offs_hz = np.arange(-off * mains_hz, off * mains_hz, step_hz / multiples)
    at_offs = added[np.round(offs_hz[:, np.newaxis] * orders / step_hz).astype(int), orders - 1]
    powers = np.square(np.abs(at_offs))
    prominent = powers * whole >= PROMINENT
    best = np.lexsort(((powers * prominent).sum(axis=1), prominent.sum(axis=1)))[-1]
    turned = amplitudes * np.exp(-2j * np.pi * starts_s * (offs_hz[best] * orders))
    there = prominent[best] & _go_on(turned, noise)
    squares = np.square(np.abs((turned * weights).sum(axis=0) / whole)) * there
    there &= squares >= FAINTEST * squares.max()
    return Lines(tuple(orders[there].tolist()), float(squares[there].sum()) / 2)


def _amplitudes(
    windows: NDArray[np.float64], rate_hz: float, mains_hz: float, orders: NDArray[np.int64]
) -> tuple[NDArray[np.complex128], NDArray[np.float64]]:
    """Return each multiple's amplitude in each window, and the power of the noise next to it."""
    amplitudes = (windows.copy() @ _waves(windows.shape[1], rate_hz, mains_hz, len(orders))).view(np.complex128)
    beside = np.square(np.abs(amplitudes[:, len(orders) :]))
    padded = np.pad(beside, ((0, 0), (1, 1)), mode="reflect")
    noise = (padded[:, :-3] + padded[:, 1:-2] + padded[:, 2:-1] + padded[:, 3:]) / 4  # two on either side
    return amplitudes[:, : len(orders)], np.maximum(noise, FLOOR * np.median(noise, axis=0)) + 1e-14


@lru_cache(maxsize=4)
def _waves(length: int, rate_hz: float, mains_hz: float, multiples: int) -> NDArray[np.float64]:
    """Return weights for a window's amplitude at each multiple, and halfway between them: cosine and sine by turns."""
    hann = np.hanning(length + 1)[:-1] * (2 / (length / 2))
    times_s = np.arange(length) / rate_hz
    orders = np.concatenate((np.arange(1, multiples + 1), np.arange(multiples + 1) + 0.5))
    return (np.exp(-2j * np.pi * mains_hz * np.outer(times_s, orders)) * hann[:, np.newaxis]).view(np.float64)


def _go_on(turned: NDArray[np.complex128], noise: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Return, for each line, whether it goes through the whole sound, as strong in every window that could show it."""
    weights = 1 / noise
    line = (turned * weights).sum(axis=0) / weights.sum(axis=0)
    size = np.abs(line)
    clear = noise < np.square(size)
    near = np.square(np.abs(turned - line)) <= STRAYS * noise + VARIES * np.square(size)
    constant = (near & clear).sum(axis=0) >= CONSTANT * clear.sum(axis=0)
    steady: NDArray[np.bool_] = constant & (clear.sum(axis=0) >= CLEAR * len(turned))
    middle = len(turned) // 2
    for half in (slice(None, middle), slice(middle, None)):
        along = (turned[half] * weights[half] * np.conj(line)).real.sum(axis=0)
        steady &= along >= HALF * np.sqrt(weights[half].sum(axis=0)) * size
    return steady
