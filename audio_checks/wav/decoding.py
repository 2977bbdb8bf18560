"""From the bytes of the data chunk to samples, in blocks."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import BinaryIO, Protocol

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.errors import Unreadable
from audio_checks.wav.files import read_frames
from audio_checks.wav.layout import WavLayout

BLOCK_FRAMES = 65_536
TOO_LARGE_DBFS = 385  # 2^64 times full scale: the sixth powers of more do not add up to numbers
MAX_BLOCK_BYTES = 4 << 20  # of float64, so that a header of many channels cannot ask for much memory


def frames_at_once(layout: WavLayout, most: int = BLOCK_FRAMES) -> int:
    """Return the number of frames to read together, so that memory stays bounded whatever the channels."""
    return max(1, min(most, MAX_BLOCK_BYTES // (8 * layout.channels)))


def raw_blocks(file: BinaryIO, layout: WavLayout, block_frames: int = BLOCK_FRAMES) -> Iterator[bytes]:
    """Yield the bytes of the data chunk in whole frames, in order.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile.
    """
    file.seek(layout.data_offset)
    left, most = layout.frames, frames_at_once(layout, block_frames)
    while left:
        frames = min(left, most)
        yield read_frames(file, layout, frames)
        left -= frames


class Decoder(Protocol):
    """A decoder with its own buffer; `measure.faults.Faults` is one."""

    def decode(
        self, pieces: Iterable[bytes | memoryview], frames: int, container_bits: int, *, floats: bool
    ) -> tuple[NDArray[np.float64], int, int]:
        """Return the block, all PCM samples or-ed together, the first channel not finite, or too large (< 0), or 0."""


def decode_to(
    decoder: Decoder, pieces: Iterable[bytes | memoryview], frames: int, layout: WavLayout
) -> tuple[NDArray[np.float64], int]:
    """Decode whole frames that come in pieces with `decode`; return its result, with its errors."""
    block, used, broken = decoder.decode(pieces, frames, layout.container_bits, floats=layout.encoding == "float")
    _ensure_levels(broken)
    return block, used


def decode(raw: bytes | memoryview, layout: WavLayout) -> tuple[NDArray[np.float64], int]:
    """Return whole frames as samples, and all PCM samples or-ed together (0 for float).

    The samples have the shape (frames, channels), each channel contiguous, full scale ±1.0. What is or-ed are
    signed integers of the container's width; of 24 bits, the upper three bytes of 32.

    Raises
    ------
    Unreadable
        R7, for a float sample that is not a finite number or over TOO_LARGE_DBFS.
    """
    block = np.empty((layout.channels, len(raw) // layout.frame_bytes)).T
    if layout.encoding == "pcm":
        return block, kernel.decode_pcm(raw, layout.container_bits, block.T)
    _ensure_levels(kernel.decode_float(raw, layout.container_bits, block.T))
    return block, 0


def _ensure_levels(broken: int) -> None:
    """Raise Unreadable where a channel, from 1 on, holds samples that are not finite, or less than 0: too large."""
    fix = "look for a broken plug-in in the session, then export again"
    if broken > 0:
        words = f"channel {broken} holds samples that are not numbers (infinity or NaN)"
        raise Unreadable(words, "R7", "structure:not-finite", fix)
    if broken < 0:
        words = f"channel {-broken} holds samples over {TOO_LARGE_DBFS} dBFS, which no sound has"
        raise Unreadable(words, "R7", "structure:too-large", fix)


def blocks(file: BinaryIO, layout: WavLayout, block_frames: int = BLOCK_FRAMES) -> Iterator[NDArray[np.float64]]:
    """Yield the samples in blocks of shape (n, channels), full scale ±1.0.

    Raises
    ------
    Unreadable
        R7, for a float sample that is not a finite number or over TOO_LARGE_DBFS; R1, when the file became shorter
        meanwhile.
    """
    for raw in raw_blocks(file, layout, block_frames):
        yield decode(raw, layout)[0]
