"""The filter for one pair of rates, and how the blocks of a stream are laid for it."""

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from audio_checks.kernel import fourier
from audio_checks.render.twiddles import kaiser_sinc, twiddle_factors

PASSBAND = 0.95  # of the new Nyquist frequency; the stop band begins at the new Nyquist frequency itself
ATTENUATION_DB = 200.0
SHELF_MIDDLE, SHELF_WIDTH = 0.5, 0.4  # of the new Nyquist frequency: the top octave, risen to by three quarters
SHELF_DB = 140.0  # how well the filter below the shelf stops, so that the pass band keeps its ripple
BLOCK_FILTERS = 6  # a block is this many filters long, so a sixth of the work is overlap
WINDOWS = 8  # are transformed at once, of all channels together
GRID_END = 2_000


@dataclass(frozen=True)
class Plan:
    """One pair of rates: the filter and how blocks are laid."""

    up: int
    down: int
    reach: int  # frames of the master that the filter sees on each side
    block_in: int
    edge_in: int
    edge_out: int
    hop_in: int
    hop_out: int
    response: NDArray[np.float64]  # of the zero-phase low-pass, at the bins of a new block

    @property
    def block_out(self) -> int:
        """Return a block's number of new frames."""
        return self.block_in // self.down * self.up


@lru_cache(maxsize=16)
def _lowpass(sample_rate_hz: int, to_hz: int, shelf: float = 1.0) -> NDArray[np.float64]:
    """Return a Kaiser-windowed sinc from PASSBAND to all of the new Nyquist frequency, odd in length.

    With a shelf, what passes a second, gentle low-pass is taken away from the lifted whole in part.
    """
    new_nyquist = to_hz / sample_rate_hz / 2  # cycles per frame of the master
    width = (1 - PASSBAND) * new_nyquist
    cutoff = (1 + PASSBAND) / 2 * new_nyquist
    taps = _kaiser(width, cutoff, ATTENUATION_DB)
    if shelf == 1.0:
        return taps
    gentle = _kaiser(SHELF_WIDTH * new_nyquist, SHELF_MIDDLE * new_nyquist, SHELF_DB)
    lifted = shelf * taps
    beside = (len(taps) - len(gentle)) // 2
    lifted[beside : beside + len(gentle)] -= (shelf - 1.0) * gentle
    return lifted


def _kaiser(width: float, cutoff: float, attenuation_db: float) -> NDArray[np.float64]:
    half = math.ceil((attenuation_db - 7.95) / (14.36 * width) / 2)  # Kaiser's estimate of the order
    return kaiser_sinc(half, cutoff, 0.1102 * (attenuation_db - 8.7))


def plan_for(sample_rate_hz: int, to_hz: int, samples: int, shelf: float = 1.0) -> Plan:
    """Return the plan of blocks; a short sound gets short ones, so that it fills the windows of one transform."""
    taps = len(_lowpass(sample_rate_hz, to_hz))
    fitting = 1 << (max(samples // WINDOWS, 2 * taps) - 1).bit_length()
    return _laid_plan(sample_rate_hz, to_hz, min(BLOCK_FILTERS * taps, fitting), shelf)


@lru_cache(maxsize=32)
def _laid_plan(sample_rate_hz: int, to_hz: int, hop_wanted: int, shelf: float) -> Plan:
    up, down = _grid(sample_rate_hz, to_hz)
    taps = _lowpass(sample_rate_hz, to_hz, shelf)
    half = len(taps) // 2
    drift = abs(sample_rate_hz * up - down * to_hz) / (to_hz * up)  # frames of the master, for each new one
    slack = 2 + 2 * math.ceil(down / up) + math.ceil(2 * drift * hop_wanted)  # a loop drifts by up to one as well
    edge_units = math.ceil((half + slack) / down)
    units = _smooth(math.ceil(hop_wanted / down) + 2 * edge_units)
    block_in, block_out = units * down, units * up
    centred, imaginary = np.zeros((1, block_in)), np.zeros((1, block_in))
    centred[0, : half + 1] = taps[half:]
    centred[0, -half:] = taps[:half]
    fourier(centred, imaginary, twiddle_factors(block_in))
    response = centred[0, : block_out // 2 + 1] / block_in
    if block_out % 2 == 0:
        response[-1] = 0.0
    return Plan(
        up=up,
        down=down,
        reach=half,
        block_in=block_in,
        edge_in=edge_units * down,
        edge_out=edge_units * up,
        hop_in=(units - 2 * edge_units) * down,
        hop_out=(units - 2 * edge_units) * up,
        response=response,
    )


def _grid(sample_rate_hz: int, to_hz: int) -> tuple[int, int]:
    """Return the numbers of new and of master frames that match: the ratio itself where its factors are small.

    Else the nearest such ratio: the rest is made up by moving each frame.
    """
    common = math.gcd(sample_rate_hz, to_hz)
    up, down = to_hz // common, sample_rate_hz // common
    if _is_small(up) and _is_small(down):
        return up, down
    pairs = ((new, round(new * sample_rate_hz / to_hz)) for new in range(1, GRID_END) if _is_small(new))
    fitting = [(new, old) for new, old in pairs if old >= new and _is_small(old)]
    return min(fitting, key=lambda pair: abs(pair[0] * sample_rate_hz - pair[1] * to_hz) / pair[0])


def _is_small(number: int) -> bool:
    """Return whether 2, 3, 5 and 7 are the only prime factors."""
    for prime in (2, 3, 5, 7):
        while number % prime == 0:
            number //= prime
    return number == 1


def _smooth(least: int) -> int:
    """Return the first number from `least` on that is a power of two, or three times one, for quick transforms."""
    power = 1 << (least - 1).bit_length()
    return power // 4 * 3 if power // 4 * 3 >= least else power
