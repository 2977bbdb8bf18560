"""From float to whole numbers: rounding with dither of our own, the same bytes each time.

Noise of a triangular distribution (TPDF), two steps wide at its foot, is added before rounding.
The error is then white, and its mean and power do not depend on the sound: half a step RMS, which
is −96.33 dBFS at 16 bit and −48.16 dBFS at 8 bit. Digital silence stays silent.
Sources: S. P. Lipshitz, R. A. Wannamaker, J. Vanderkooy, "Quantization and Dither: A Theoretical
Survey", JAES 40 (1992); the five weights of `shaped` from the same authors' "Minimally Audible
Noise Shaping", JAES 39 (1991), made for 44.1 kHz.
"""

import math
from collections.abc import Iterable, Iterator
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks.errors import RenderRefused
from audio_checks.kernel import shaped_steps
from audio_checks.measure.decibels import power_decibels

Dither = Literal["tpdf", "shaped", "none"]

SILENCE_FRAMES = 64  # so many zeros in a row, or a file's edge, make digital silence; fewer are zero crossings
SHAPED_FROM_HZ = 44_100
DITHERED_TO_BITS = 16  # at 24 bit the noise of any converter covers the error of rounding
SHAPE = (2.033, -2.165, 1.959, -1.590, 0.6149)
WEIGHTS = np.array(SHAPE)


def ensure_shapeable(dither: Dither, sample_rate_hz: int) -> None:
    """Raise RenderRefused for shaped dither at a rate with no room above hearing to move the noise to."""
    if dither == "shaped" and sample_rate_hz < SHAPED_FROM_HZ:
        raise RenderRefused(
            f"shaped dither at {sample_rate_hz} Hz would move the noise to where it is heard",
            code="render:shaped-too-low",
            fix=f'use dither = "tpdf" for targets below {SHAPED_FROM_HZ} Hz',
        )


class Requantisation:
    """Sums up the difference between what was wanted and what is written."""

    def __init__(self) -> None:
        self._energy = 0.0
        self._samples = 0

    def add(self, error: NDArray[np.float64]) -> None:
        """Take differences, full scale ±1.0."""
        self._energy += float(np.square(error).sum())
        self._samples += error.size

    def level_dbfs(self) -> float:
        """Return their RMS; −inf where every sample is exact, and for none."""
        return power_decibels(self._energy / self._samples) if self._samples else -math.inf


def quantised(
    blocks: Iterable[NDArray[np.float64]],
    *,
    bit_depth: int,
    channels: int,
    dither: Dither,
    seed: bytes,
    noise: Requantisation | None = None,
) -> Iterator[NDArray[np.int64]]:
    """Yield blocks of floats (full scale ±1.0) as whole numbers of `bit_depth` bits.

    Parameters
    ----------
    blocks : iterable of ndarray, shape (frames, channels)
        The stream, in order.
    bit_depth : int
        8 to 32; 1.0 becomes 2 ** (bit_depth - 1).
    channels : int
        Of every block.
    dither : {"tpdf", "shaped", "none"}
        Noise added before rounding.
    seed : bytes
        Digest of the master: the same master gives the same noise, however its blocks are cut.
    noise : Requantisation, optional
        Is given what rounding and dither add.

    Yields
    ------
    ndarray of int64
        Not clipped: what lies beyond full scale is for the caller to refuse or to lower.
    """
    scale = float(1 << (bit_depth - 1))
    if dither == "none":
        for block in blocks:
            wanted = block * scale
            whole = _rounded(wanted)
            if noise is not None:
                noise.add((whole - wanted) / scale)
            yield whole
        return
    triangular = _TriangularNoise(seed, channels)
    shaper = _Shaper(channels) if dither == "shaped" else None
    for block, silent in _with_silence(blocks, channels):
        wanted, added = block * scale, triangular.draw(len(block))
        whole = shaper.rounded(wanted, added, silent) if shaper else _rounded(wanted + added)
        whole[silent] = 0
        if noise is not None:
            noise.add((whole - wanted) / scale)
        yield whole


def _rounded(values: NDArray[np.float64]) -> NDArray[np.int64]:
    return np.floor(values + 0.5).astype(np.int64)


class _TriangularNoise:
    """Differences of two even random numbers, in steps: between −1 and 1, most often near 0."""

    def __init__(self, seed: bytes, channels: int) -> None:
        self._words = np.random.Philox(key=int.from_bytes(seed[:16], "little"))
        self._channels = channels

    def draw(self, frames: int) -> NDArray[np.float64]:
        words = self._words.random_raw(frames * self._channels).astype("<u8", copy=False).view("<u4")
        noise = words[1::2].astype(np.float64)
        noise -= words[::2]  # in place: copies of whole blocks cost more than the sums
        noise *= 2.0**-32
        return noise.reshape(frames, self._channels)


class _Shaper:
    """Rounds sample after sample, subtracting weighted earlier errors, so that the noise moves up out of hearing."""

    def __init__(self, channels: int) -> None:
        self._errors = np.zeros((channels, len(SHAPE)))

    def rounded(
        self, wanted: NDArray[np.float64], noise: NDArray[np.float64], silent: NDArray[np.bool_]
    ) -> NDArray[np.int64]:
        steps = np.array(wanted.T, order="C")
        quiet = np.ascontiguousarray(silent.T).view(np.uint8)
        shaped_steps(steps, np.ascontiguousarray(noise.T), quiet, WEIGHTS, self._errors)
        return steps.T.astype(np.int64)


def _with_silence(
    blocks: Iterable[NDArray[np.float64]], channels: int
) -> Iterator[tuple[NDArray[np.float64], NDArray[np.bool_]]]:
    """Yield each block, held back a little, with a mask of the samples that are digital silence."""
    margin = SILENCE_FRAMES - 1
    edge = np.zeros((margin, channels))
    held, began = edge, False
    for block in blocks:
        began = began or len(block) > 0
        held = np.concatenate([held, block])
        if len(held) > 2 * margin:
            yield held[margin:-margin], _in_silence(held)
            held = held[-2 * margin :]
    if began:
        held = np.concatenate([held, edge])
        yield held[margin:-margin], _in_silence(held)


def _in_silence(held: NDArray[np.float64]) -> NDArray[np.bool_]:
    """Tell of each sample between the two margins whether a whole run of silence around it is zeros."""
    is_zero = held == 0.0
    if not any(_has_run(np.flatnonzero(channel)) for channel in is_zero.T):  # most of a sound
        return np.zeros((len(held) - 2 * (SILENCE_FRAMES - 1), held.shape[1]), dtype=bool)
    zeros = np.concatenate([np.zeros((1, held.shape[1]), dtype=np.int64), np.cumsum(is_zero, axis=0)])
    runs = zeros[SILENCE_FRAMES:] - zeros[:-SILENCE_FRAMES] == SILENCE_FRAMES
    starts = np.concatenate([np.zeros((1, held.shape[1]), dtype=np.int64), np.cumsum(runs, axis=0)])
    inside: NDArray[np.bool_] = starts[SILENCE_FRAMES:] > starts[:-SILENCE_FRAMES]
    return inside


def _has_run(zeros: NDArray[np.intp]) -> bool:
    """Whether some of these places, in rising order, make a whole run of silence."""
    last = SILENCE_FRAMES - 1
    return bool((zeros[last:] - zeros[:-last] == last).any())
