"""Header fields that the reader does not use: harmless inconsistencies are warned about.

Sources: EBU Tech 3306 (the 64-bit count of `ds64` replaces that of `fact` where this says 0xFFFFFFFF, and
nowhere else; its 64-bit sizes replace 32-bit ones that say so), WAVEFORMATEX (`cbSize`, whole bytes a
sample), WAVEFORMATEXTENSIBLE (18 speakers; the bits above are reserved, but for the highest, "all speakers").
"""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from audio_checks.wav.layout import EXTENSIBLE, STREAM_SIZE, Chunk, StructureWarning

Read = Callable[[int, int], bytes]
PLAIN_FMT_BYTES = 16
RESERVED_SPEAKERS = 0x7FFC0000
EXPORT_AGAIN = "export it again from your audio editor as WAV"


class Sizes64(NamedTuple):
    """The content of the `ds64` chunk of an RF64 file."""

    riff_size: int
    data_size: int
    frames: int
    entries: int
    chunk_size: int


def _warning(code: str, message: str) -> StructureWarning:
    return StructureWarning(f"structure:{code}", message, EXPORT_AGAIN)


def frame_count_warnings(
    read: Read, chunks: Sequence[Chunk], frames: int, sizes64: Sizes64 | None
) -> tuple[list[StructureWarning], bool]:
    """Return warnings about the counts of frames in `fact` and `ds64`, and whether `ds64` is what counts them.

    Parameters
    ----------
    read : callable
        Takes an offset and a number of bytes; returns those bytes of the file.
    chunks : sequence of Chunk
        Of the whole file, in their order.
    frames : int
        As the data chunk holds them.
    sizes64 : Sizes64 or None
        None in a file that is not RF64.
    """
    declared: int | None = None  # by the fact chunk
    warnings: list[StructureWarning] = []
    facts = [chunk for chunk in chunks if chunk.id == "fact"]
    if len(facts) > 1:
        warnings.append(_warning("fact", f'the file has {len(facts)} "fact" chunks; at most one is wanted'))
    if facts:
        content = read(facts[0].offset, min(facts[0].size, 4))
        if len(content) < 4:
            warnings.append(_warning("fact", f'the "fact" chunk has {facts[0].size} bytes; 4 or more are wanted'))
        else:
            declared = int(struct.unpack("<I", content)[0])
    if unused := [chunk for chunk in chunks if chunk.id == "ds64"][1 if sizes64 else 0 :]:
        where = "a second" if sizes64 else "a"
        warnings.append(_warning("ds64-size", f"the file has {where} ds64 chunk ({unused[0].size} bytes), not used"))
    defers = sizes64 is not None and declared == STREAM_SIZE
    if declared is not None and not defers and declared != frames:
        warnings.append(
            _warning("fact", f'the "fact" chunk counts {declared} frames, but the data chunk holds {frames}')
        )
    if sizes64 is not None and sizes64.frames != frames and (sizes64.frames or declared is not None):
        words = f"the ds64 chunk counts {sizes64.frames} frames, but the data chunk holds {frames}"
        warnings.append(_warning("ds64-count", words))
    return warnings, defers


def of_sizes(riff_size: int, declared_data_size: int, sizes64: Sizes64) -> Iterator[StructureWarning]:
    """Yield warnings about 64-bit sizes that differ from 32-bit ones which count, and about bytes that say nothing."""
    for name, size, size64 in (
        ("RIFF header", riff_size, sizes64.riff_size),
        ("data chunk", declared_data_size, sizes64.data_size),
    ):
        if size not in (STREAM_SIZE, size64):
            yield _warning("ds64-size", f"the {name} says {size} bytes, but the ds64 chunk says {size64}")
    spare = sizes64.chunk_size - 28 - 12 * sizes64.entries
    if spare:
        yield _warning("ds64-size", f"the ds64 chunk has {spare} bytes after its table")


def of_format(chunk: Chunk, content: bytes) -> Iterator[StructureWarning]:
    """Yield warnings about a `fmt ` chunk that was read: its extension, its sample size and its speakers.

    Parameters
    ----------
    chunk : Chunk
        Its position.
    content : bytes
        The first 40 bytes of it, or all.
    """
    tag, _, _, _, _, bits = struct.unpack("<HHIIHH", content[:PLAIN_FMT_BYTES])
    held = max(chunk.size - PLAIN_FMT_BYTES - 2, 0)
    declared = struct.unpack("<H", content[16:18])[0] if chunk.size >= PLAIN_FMT_BYTES + 2 else 0
    if declared != held or chunk.size == PLAIN_FMT_BYTES + 1:
        words = f'the "fmt " chunk announces an extension of {declared} bytes, but it has {chunk.size} bytes in all'
        yield _warning("fmt-extension", words)
    if tag != EXTENSIBLE and bits % 8:
        yield _warning(
            "sample-bytes",
            f"the header says {bits} bits a sample, which are not whole bytes; {-(-bits // 8) * 8} are read",
        )
    if tag == EXTENSIBLE:
        mask = struct.unpack("<I", content[20:24])[0]
        if mask & RESERVED_SPEAKERS:
            yield _warning("channel-mask", f"the channel mask {mask:#010x} names speakers that there are none of")


def of_padding(read: Read, chunks: Sequence[Chunk], file_size: int) -> Iterator[StructureWarning]:
    """Yield a warning for each pad byte that is not zero."""
    for chunk, after in zip(chunks, [*chunks[1:], None], strict=True):
        end = chunk.offset + chunk.size
        there = end < file_size if after is None else after.offset - 8 > end
        if chunk.size % 2 and there and read(end, 1) != b"\0":
            yield _warning("pad-value", f'the pad byte after the chunk "{chunk.id}" of odd length is not zero')
