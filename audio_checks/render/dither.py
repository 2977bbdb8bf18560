"""From float to whole numbers: rounding with dither of our own, the same bytes each time.

Noise of a triangular distribution (TPDF), two steps wide at its foot, is added before rounding.
The error is then white, and its mean and power do not depend on the sound: half a step RMS, which
is −96.33 dBFS at 16 bit and −48.16 dBFS at 8 bit. Digital silence stays silent, and channels that
are equal stay equal: where they are, they get the same noise.
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
from audio_checks.kernel import by_channel, rounded_steps, shaped_steps, silent_runs
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
        self.add_energy(float(np.square(error).sum()), error.size)

    def add_energy(self, energy: float, samples: int) -> None:
        """Take the sum of their squares, and how many they are."""
        self._energy += energy
        self._samples += samples

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
        Not clipped: the caller refuses or lowers what exceeds full scale.
    """
    scale = float(1 << (bit_depth - 1))
    noise = Requantisation() if noise is None else noise
    if dither == "none":
        for block in blocks:
            yield _rounded(by_channel(block), scale, None, None, noise)
        return
    words = np.random.Philox(key=int.from_bytes(seed[:16], "little"))
    rounded = _Shaper(channels).rounded if dither == "shaped" else _rounded
    for rows, silent in _with_silence(blocks, channels):
        yield rounded(rows, scale, _shared(words.random_raw(rows.size), rows), silent, noise)


def _shared(words: NDArray[np.uint64], rows: NDArray[np.float64]) -> NDArray[np.uint64]:
    """Return the noise of frames and channels, the same for channels that are equal in a frame.

    So a sound that is mono in two channels stays mono, and its channels do not differ by dither alone.
    """
    by_frame = words.reshape(rows.shape[1], rows.shape[0])
    for channel in range(1, len(rows)):
        for earlier in range(channel):
            equal = rows[channel] == rows[earlier]
            by_frame[equal, channel] = by_frame[equal, earlier]
    return words


def _rounded(
    rows: NDArray[np.float64],
    scale: float,
    words: NDArray[np.uint64] | None,
    silent: NDArray[np.uint8] | None,
    noise: Requantisation,
) -> NDArray[np.int64]:
    """Round channels to steps, with the noise in words of two even random numbers each, frame after frame."""
    steps = np.empty(rows.shape, dtype=np.int64)
    noise.add_energy(rounded_steps(rows, scale, words, silent, steps) / scale**2, steps.size)
    return steps.T


class _Shaper:
    """Rounds sample after sample, subtracting weighted earlier errors, so that the noise moves up out of hearing."""

    def __init__(self, channels: int) -> None:
        self._errors = np.zeros((channels, len(SHAPE)))

    def rounded(
        self,
        rows: NDArray[np.float64],
        scale: float,
        words: NDArray[np.uint64],
        silent: NDArray[np.uint8],
        noise: Requantisation,
    ) -> NDArray[np.int64]:
        scaled = rows * scale
        steps = scaled.copy()
        triangular = ((words >> 32).astype(np.float64) - (words & 0xFFFFFFFF)) * 2.0**-32
        shaped_steps(steps, np.ascontiguousarray(triangular.reshape(scaled.T.shape).T), silent, WEIGHTS, self._errors)
        noise.add((steps - scaled) / scale)
        return steps.T.astype(np.int64)


def _with_silence(
    blocks: Iterable[NDArray[np.float64]], channels: int
) -> Iterator[tuple[NDArray[np.float64], NDArray[np.uint8]]]:
    """Yield each block by channel, held back a little, with marks of the samples that are digital silence."""
    margin = SILENCE_FRAMES - 1
    edge = np.zeros((channels, margin))
    held, began = edge, False
    for block in blocks:
        began = began or len(block) > 0
        held = np.concatenate([held, block.T], axis=1)
        if held.shape[1] > 2 * margin:
            yield held[:, margin:-margin], _silence(held)
            held = held[:, -2 * margin :]
    if began:
        held = np.concatenate([held, edge], axis=1)
        yield held[:, margin:-margin], _silence(held)


def _silence(held: NDArray[np.float64]) -> NDArray[np.uint8]:
    """Return, for each sample between the two margins, whether it is in a whole run of silence."""
    margin = SILENCE_FRAMES - 1
    marks = np.empty((len(held), held.shape[1] - 2 * margin), dtype=np.uint8)
    silent_runs(held, margin, SILENCE_FRAMES, marks)
    return marks
