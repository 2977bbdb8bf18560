"""Sines and cosines, and the filter made of them, the same to the last bit on every machine.

The C library's own may differ between machines in their last bit, and a render must not. So here
everything is sums, products and quotients, which IEEE 754 rounds alike everywhere.
"""

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]

_SINE = [(-1.0) ** k / math.factorial(2 * k + 1) for k in range(10)]  # enough for an eighth of a turn
_COSINE = [(-1.0) ** k / math.factorial(2 * k) for k in range(11)]
_DOUBLINGS_A_DB = 0.16609640474436813  # log2(10) / 20
_LN_2 = 0.6931471805599453
_EXPONENTIAL_TERMS = 20  # for powers up to a half of ln 2 the last are below 1e-27
_BESSEL_TERMS = 80  # for arguments up to 25 the last are below 1e-17 of the sum


@lru_cache(maxsize=32)
def twiddle_factors(count: int) -> Floats:
    """Return exp(−2πi·j / count) for j = 0..count−1, shape (count, 2): real and imaginary parts."""
    eighths = np.arange(count, dtype=np.int64) * 8
    octant, rest = eighths // count, eighths % count
    cosine, sine = _in_octant(octant, rest / count)
    return np.stack([cosine, -sine], axis=1)


def cos_sin_pi(halves: Floats) -> tuple[Floats, Floats]:
    """Return the cosine and the sine of π times each value."""
    quarters = np.fmod(halves, 2.0) * 4.0
    quarters = np.where(quarters < 0.0, quarters + 8.0, quarters)
    octant = np.floor(quarters)
    return _in_octant(octant.astype(np.int64), quarters - octant)


def _in_octant(octant: NDArray[np.int64], part: Floats) -> tuple[Floats, Floats]:
    """Return cosine and sine of (octant + part) eighths of a turn."""
    mirrored = octant % 2 == 1
    angle = np.where(mirrored, 1.0 - part, part) * (math.pi / 4)
    square = angle * angle
    near, far = _polynomial(_COSINE, square), angle * _polynomial(_SINE, square)
    quarter = (octant + 1) // 2 % 4  # the nearest quarter turn
    far = np.where(mirrored, -far, far)
    cosine = np.choose(quarter, [near, -far, -near, far])
    sine = np.choose(quarter, [far, near, -far, -near])
    return cosine, sine


def gain_of(level_db: float) -> float:
    """Return the amplitude ratio of a level in dB, 10 ** (level_db / 20), within 2e-16 of it."""
    doublings = level_db * _DOUBLINGS_A_DB
    whole = math.floor(doublings + 0.5)
    rest = (doublings - whole) * _LN_2
    total = 1.0
    for k in range(_EXPONENTIAL_TERMS, 0, -1):
        total = 1.0 + total * rest / k
    return math.ldexp(total, whole)


def _polynomial(weights: list[float], values: Floats) -> Floats:
    total = np.full_like(values, weights[-1])
    for weight in weights[-2::-1]:
        total = total * values + weight
    return total


def kaiser_sinc(half: int, cutoff: float, beta: float) -> Floats:
    """Return a low-pass of 2·half + 1 taps: a sinc of `cutoff` cycles a frame under a Kaiser window, sum 1."""
    steps = np.arange(1, half + 1, dtype=np.float64)
    sinc = cos_sin_pi(2.0 * cutoff * steps)[1] / (math.pi * steps)
    window = _bessel(beta * np.sqrt(1.0 - (steps / half) ** 2)) / _bessel(np.array([beta]))
    side = sinc * window
    middle = 2.0 * cutoff
    taps = np.concatenate([side[::-1], [middle], side])
    return np.asarray(taps / math.fsum(taps), dtype=np.float64)


def _bessel(values: Floats) -> Floats:
    """Return the modified Bessel function of order zero, by its power series."""
    quarter = values * values / 4.0
    term = np.ones_like(values)
    total = np.ones_like(values)
    for k in range(1, _BESSEL_TERMS):
        term = term * quarter / (k * k)
        total = total + term
    return total
