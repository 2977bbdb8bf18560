"""Loudness as ITU-R BS.1770 and EBU R 128 define it, at any sample rate.

Sources: ITU-R BS.1770-5, Annex 1; EBU Tech 3341 (momentary and short-term); EBU Tech 3342 (range).
The K-weighting is designed for each rate from the analogue prototypes that the tabulated filters
approximate (De Man, "Evaluation of implementations of the EBU R128 loudness measurement", 2018); its
gain is that of the table at every rate.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.decibels import power_decibels
from audio_checks.measure.means import mean_of

OFFSET_LUFS = -0.691  # of K-weighted power, so that a 997 Hz sine reads its RMS level
HOPS_PER_S = 100
MOMENTARY_HOPS, SHORT_TERM_HOPS = 40, 300
GATE_HOPS = 10  # gating blocks and the values of the loudness range start every 100 ms
MOST_BLOCKS = 4_000_000  # 4.6 days; of what lasts longer, every second or third gating block counts
HOPS_AT_ONCE = 6_000
ABSOLUTE_GATE_LUFS, RELATIVE_GATE_LU, RANGE_GATE_LU = -70.0, -10.0, -20.0
GATE_POWER = 10 ** ((ABSOLUTE_GATE_LUFS - OFFSET_LUFS) / 10)
TABULATED_SCALE = 1.0049948987146884  # the highpass of the table is that much louder than its prototype
REAR_WEIGHT = 10**0.15  # +1.5 dB


@lru_cache(maxsize=64)
def channel_weights(channels: int, mask: int | None = None) -> NDArray[np.float64]:
    """Return the weight of each channel: 1 in front, 1.41 at the sides, 0 for the LFE.

    Parameters
    ----------
    channels : int
        How many there are.
    mask : int, optional
        Speaker positions as in WAVEFORMATEXTENSIBLE; without it, 4 channels are L R Ls Rs, 5 are
        L R C Ls Rs and 6 are L R C LFE Ls Rs.
    """
    if mask is None or mask.bit_count() < channels:
        mask = {4: 0x33, 5: 0x37, 6: 0x3F}.get(channels, 0)
    positions = [1 << bit for bit in range(32) if mask >> bit & 1][:channels]
    sides = 0x600 if mask & 0x600 else 0x30  # with side speakers present, those at the back are behind the listener
    weights = np.ones(channels)
    for channel, position in enumerate(positions):
        if position == 0x8:
            weights[channel] = 0.0
        elif position & sides:
            weights[channel] = REAR_WEIGHT
    weights.flags.writeable = False
    return weights


def k_weighting(sample_rate_hz: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return the biquads of the K-weighting at a sample rate: numerators and denominators, shape (2, 3)."""
    highest = 0.45 * sample_rate_hz  # below 3.7 kHz the shelf is above the band
    k = math.tan(math.pi * min(1681.974450955533, highest) / sample_rate_hz)
    q, gain = 0.7071752369554196, 10 ** (3.999843853973347 / 20)
    middle = gain**0.4996667741545416
    scale = 1 + k / q + k * k
    shelf = (
        [(gain + middle * k / q + k * k) / scale, 2 * (k * k - gain) / scale, (gain - middle * k / q + k * k) / scale],
        [1.0, 2 * (k * k - 1) / scale, (1 - k / q + k * k) / scale],
    )
    k, q = math.tan(math.pi * 38.13547087602444 / sample_rate_hz), 0.5003270373238773
    scale = 1 + k / q + k * k
    gain = TABULATED_SCALE / scale  # the tabulated numerator is 1, -2, 1, which gains 0.04 dB at 48 kHz, and less above
    highpass = ([gain, -2 * gain, gain], [1.0, 2 * (k * k - 1) / scale, (1 - k / q + k * k) / scale])
    return np.array([shelf[0], highpass[0]]), np.array([shelf[1], highpass[1]])


@lru_cache(maxsize=16)
def _recursion(sample_rate_hz: int) -> NDArray[np.float64]:
    """Return the kernel's coefficients: b0, b1, b2, a1, a2 of the shelf, a1, a2 of the highpass (b is 1, -2, 1)."""
    numerators, denominators = k_weighting(sample_rate_hz)
    return np.concatenate((numerators[0] * numerators[1, 0], denominators[0, 1:], denominators[1, 1:]))


class Loudness:
    """Measures loudness of blocks, with a hop of 10 ms.

    Parameters
    ----------
    sample_rate_hz, channels, frames : int
        Of the whole signal.
    weights : ndarray, optional
        How much each channel counts; see `channel_weights`.
    """

    FIGURES = (
        "integrated_lufs",
        "max_momentary_lufs",
        "max_short_term_lufs",
        "loudness_range_lu",
        "short_loudness_lufs",
    )

    def __init__(
        self,
        sample_rate_hz: int,
        channels: int,
        frames: int,
        *,
        weights: NDArray[np.float64] | None = None,
    ) -> None:
        self._rate = sample_rate_hz
        even = channels + channels % 2  # the kernel filters two channels at once
        self._weights = np.zeros(even)
        self._weights[:channels] = channel_weights(channels) if weights is None else weights
        self._memory, self._open = np.zeros(6 * even), np.zeros(even)
        self._seen = 0
        self._whole = 0  # hops that are whole
        self._pending: list[NDArray[np.float64]] = []  # energy of whole hops that wait to be looked at
        self._kept = np.zeros(SHORT_TERM_HOPS)  # energy of the hops before them: windows reach back
        self._loudest = dict.fromkeys((MOMENTARY_HOPS, SHORT_TERM_HOPS), 0.0)
        self._loud: dict[int, list[NDArray[np.float64]]] = {MOMENTARY_HOPS: [], SHORT_TERM_HOPS: []}
        self._gate_hops = GATE_HOPS * (1 + frames * HOPS_PER_S // (sample_rate_hz * GATE_HOPS * MOST_BLOCKS))

    def add(self, block: NDArray[np.float64]) -> None:
        """Take the next samples, shape (n, channels)."""
        energies = np.empty(len(block) * HOPS_PER_S // self._rate + 2)
        ended = kernel.hop_energies(
            kernel.by_channel(block),
            _recursion(self._rate),
            self._weights,
            self._memory,
            self._open,
            energies,
            self._rate,
            self._seen,
            self._whole,
        )
        self._pending.append(energies[:ended])
        self._whole += ended
        self._seen += len(block)
        if self._whole % HOPS_AT_ONCE < ended:
            self._look(ends=False)

    def result(self) -> dict[str, Any]:
        """Return the figures, by name; -inf for silence."""
        self._pending.append(np.array([self._open @ self._weights]))
        self._look(ends=True)
        loudest = {count: _lufs(power) for count, power in self._loudest.items()}
        gating, ranging = (np.concatenate([np.empty(0), *self._loud[count]]) for count in self._loudest)
        return {
            "integrated_lufs": integrated_lufs(gating),
            "max_momentary_lufs": loudest[MOMENTARY_HOPS],
            "max_short_term_lufs": loudest[SHORT_TERM_HOPS],
            "loudness_range_lu": loudness_range_lu(ranging),
            "short_loudness_lufs": loudest[MOMENTARY_HOPS],
        }

    def _look(self, *, ends: bool) -> None:
        """Measure all windows that end in the pending hops; where the sound ends, the last hop is open, not gated."""
        hops = np.concatenate((self._kept, *self._pending))
        new = len(hops) - len(self._kept)
        first = self._whole + ends - len(hops)  # negative at first: there is silence before the signal
        powers = np.empty(new)  # of the windows that end with each new hop
        for count, loud in self._loud.items():
            loudest = kernel.window_loudness(hops, first, count, self._rate, powers)
            self._loudest[count] = max(self._loudest[count], loudest)
            start = first + len(hops) - count + 1 - new  # of the first window
            skipped = -start % self._gate_hops if start >= 0 else -start
            gated = powers[skipped : new - ends : self._gate_hops]
            loud.append(gated[gated >= GATE_POWER])
        self._kept = hops[-SHORT_TERM_HOPS:]
        self._pending = []


def _lufs(power: float) -> float:
    return OFFSET_LUFS + power_decibels(power)


def integrated_lufs(powers: NDArray[np.float64]) -> float:
    """Return the gated loudness of 400 ms blocks that overlap by 300 ms, in LUFS.

    Parameters
    ----------
    powers : ndarray
        K-weighted mean power of each block.

    Returns
    -------
    float
        -inf when no block passes the gate of -70 LUFS.
    """
    loud = powers[powers > GATE_POWER]
    if not len(loud):
        return -math.inf
    gate = mean_of(loud) * 10 ** (RELATIVE_GATE_LU / 10)
    return _lufs(mean_of(loud[loud > gate]))


def loudness_range_lu(powers: NDArray[np.float64]) -> float | None:
    """Return the spread of short-term loudness, from its 10th percentile to its 95th, in LU.

    Parameters
    ----------
    powers : ndarray
        K-weighted mean power of each 3 s block.

    Returns
    -------
    float or None
        None when no block reaches -70 LUFS.
    """
    loud = powers[powers >= GATE_POWER]
    if not len(loud):
        return None
    gate = mean_of(loud) * 10 ** (RANGE_GATE_LU / 10)
    levels = 10 * np.log10(np.sort(loud[loud >= gate]))
    low, high = (levels[round((len(levels) - 1) * share)] for share in (0.10, 0.95))
    return float(high - low)
