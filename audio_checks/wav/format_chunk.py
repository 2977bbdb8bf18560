"""Reads the `fmt ` chunk, which says how samples are stored, and refuses what contradicts itself (R4, R5).

Source: Microsoft's WAVEFORMATEXTENSIBLE.
"""

from __future__ import annotations

import struct
from typing import NamedTuple

from audio_checks.errors import Unreadable
from audio_checks.system.plural import counted, verb
from audio_checks.wav.files import shrunk
from audio_checks.wav.header_warnings import EXPORT_AGAIN, of_format
from audio_checks.wav.layout import AMBISONIC_TAIL, EXTENSIBLE, FLOAT, GUID_TAIL, PCM, Chunk, StructureWarning
from audio_checks.wav.other_containers import CODECS, EXPORT_WAV

MAX_CHANNELS = 1_024  # also libsndfile's


class Format(NamedTuple):
    """The storage of samples; `bits` are the valid ones of `container_bits`."""

    tag: int
    extensible: bool
    channels: int
    sample_rate_hz: int
    container_bits: int
    bits: int
    mask: int | None
    ambisonic: bool


def read_format(chunk: Chunk, content: bytes) -> tuple[Format, list[StructureWarning]]:
    """Read the `fmt ` chunk (R4, R5).

    Parameters
    ----------
    chunk : Chunk
        Where it is, and its size.
    content : bytes
        Its first 40 bytes, or all of a shorter one.

    Returns
    -------
    (Format, list of StructureWarning)

    Raises
    ------
    Unreadable
        R4 for figures that contradict each other or are out of range; R5 for a codec.
    """
    warnings: list[StructureWarning] = []
    if chunk.size < 16:
        raise _inconsistent(f'the "fmt " chunk has {chunk.size} bytes; 16 or more are wanted', "fmt-size")
    if len(content) < min(chunk.size, 40):
        raise shrunk()
    tag, channels, rate, byte_rate, block_align, container_bits = struct.unpack("<HHIIHH", content[:16])
    bits, mask, extensible, ambisonic = container_bits, None, tag == EXTENSIBLE, False
    if extensible:
        if len(content) < 40 or struct.unpack("<H", content[16:18])[0] < 22:
            raise _inconsistent(
                f'the "fmt " chunk of an extensible header has {chunk.size} bytes; 40 are wanted', "fmt-size"
            )
        bits, mask = struct.unpack("<HI", content[18:24])
        tag, ambisonic = _tag_of(content[24:40])
        if mask.bit_count() > channels:
            speakers, those = counted(mask.bit_count(), "speaker"), counted(channels, "channel")
            words = f"the channel mask names {speakers}, but there {verb(channels, 'is', 'are')} {those}"
            warnings.append(StructureWarning("structure:channel-mask", words, EXPORT_AGAIN))
    if tag not in (PCM, FLOAT):
        name = CODECS.get(tag, f"of an unknown kind (tag {tag:#06x})")
        raise Unreadable(
            f"the sound in this WAV file is {name}; PCM or IEEE float is wanted", "R5", "encoding:codec", EXPORT_WAV
        )
    if not 1 <= channels <= MAX_CHANNELS:
        raise _inconsistent(f"the header says {channels} channels; 1 to {MAX_CHANNELS} are wanted", "channels")
    if not 1_000 <= rate <= 768_000:
        raise _inconsistent(f"the header says a sample rate of {rate} Hz; 1,000 to 768,000 Hz is wanted", "sample-rate")
    if extensible and (container_bits % 8 or not 1 <= bits <= container_bits):
        raise _inconsistent(f"the header says {bits} valid bits in a sample of {container_bits} bits", "bit-depth")
    container_bits = (container_bits + 7) // 8 * 8
    if container_bits not in ((8, 16, 24, 32) if tag == PCM else (32, 64)) or (tag == FLOAT and bits != container_bits):
        kind, expected_bits = ("PCM", "8, 16, 24 or 32") if tag == PCM else ("float", "32 or 64")
        raise _inconsistent(f"the header says {kind} of {bits} bits; {expected_bits} bits are wanted", "bit-depth")
    if block_align != channels * container_bits // 8:
        raise _inconsistent(
            f"the header says {block_align} bytes a frame, but {channels} × {container_bits} bits make"
            f" {channels * container_bits // 8}",
            "block-align",
        )
    if byte_rate != (rate * block_align) & 0xFFFFFFFF:
        raise _inconsistent(
            f"the header says {byte_rate} bytes a second, but {rate} frames of {block_align} bytes make"
            f" {rate * block_align}",
            "byte-rate",
        )
    warnings += of_format(chunk, content)
    return Format(tag, extensible, channels, rate, container_bits, bits, mask, ambisonic), warnings


def _tag_of(guid: bytes) -> tuple[int, bool]:
    """Return the codec tag of a GUID, and whether it means ambisonics."""
    if guid[4:] in (GUID_TAIL, AMBISONIC_TAIL):
        return int(struct.unpack("<I", guid[:4])[0]), guid[4:] == AMBISONIC_TAIL
    raise Unreadable(
        f"the sound in this WAV file is of an unknown kind (GUID {guid.hex()}); PCM or IEEE float is wanted",
        "R5",
        "encoding:codec",
        EXPORT_WAV,
    )


def _inconsistent(message: str, code: str) -> Unreadable:
    return Unreadable(message, "R4", f"structure:{code}", EXPORT_AGAIN)
