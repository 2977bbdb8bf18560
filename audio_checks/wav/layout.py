"""The content of a WAV file's header, and the names that its readers and writers share."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

STREAM_SIZE = 0xFFFFFFFF  # written by programs that cannot go back to fill in the size
GUID_TAIL = bytes.fromhex("00001000800000aa00389b71")  # of every GUID that encodes a codec tag
AMBISONIC_TAIL = bytes.fromhex("2107d3118644c8c1ca000000")  # the same of B-format, for PCM and float
PCM, FLOAT, EXTENSIBLE = 1, 3, 0xFFFE


@dataclass(frozen=True)
class Chunk:
    """One chunk of the file.

    Attributes
    ----------
    id : str
        Four characters (latin-1).
    offset, size : int
        Where the payload starts, and its bytes.
    """

    id: str
    offset: int
    size: int


@dataclass(frozen=True)
class StructureWarning:
    """Something odd that does no harm: a stable code, and a sentence."""

    code: str
    message: str
    fix: str


@dataclass(frozen=True)
class SampleLoop:
    """A loop of the `smpl` chunk: first and last frame (the last one is played), and its kind."""

    start: int
    end: int
    kind: Literal["forward", "alternating", "backward", "other"] = "forward"


@dataclass(frozen=True)
class WavLayout:
    """The content of the header, once it was found to be true.

    Attributes
    ----------
    codec_tag : int
        1 for PCM, 3 for float; an extensible header is resolved to the tag in its GUID.
    extensible : bool
        Whether the header was an extensible one.
    bit_depth, container_bits : int
        Bits that count, and bits that each sample takes in the file.
    channel_mask : int or None
        Speaker positions of an extensible header; None without one.
    frames : int
        Per channel.
    ambisonic : bool
        Whether the header says that the channels are ambisonic B-format.
    """

    container: Literal["wav", "rf64"]
    encoding: Literal["pcm", "float"]
    codec_tag: int
    extensible: bool
    sample_rate_hz: int
    bit_depth: int
    container_bits: int
    channels: int
    channel_mask: int | None
    frames: int
    data_offset: int
    data_size: int
    chunks: tuple[Chunk, ...]
    warnings: tuple[StructureWarning, ...]
    loops: tuple[SampleLoop, ...]
    file_size: int
    loops_outside: tuple[SampleLoop, ...] = ()
    ambisonic: bool = False

    @property
    def frame_bytes(self) -> int:
        """Bytes of one frame."""
        return self.channels * self.container_bits // 8

    @property
    def duration_s(self) -> float:
        """Length in seconds."""
        return self.frames / self.sample_rate_hz


def stretch_of(layout: WavLayout, first: int, end: int) -> WavLayout:
    """Return the layout of a file whose sound is one stretch of it, from `first` up to, and without, `end`."""
    return replace(
        layout,
        data_offset=layout.data_offset + first * layout.frame_bytes,
        data_size=(end - first) * layout.frame_bytes,
        frames=end - first,
    )
