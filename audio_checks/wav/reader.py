"""A strict reader of headers, RIFF and RF64: it refuses what breaks the rules R1-R6, R11 and R12, each in words.

"It plays here" is not a check. What is odd but harmless becomes a warning. Memory stays bounded whatever a header says.
Sources: EBU Tech 3285 (BWF), EBU Tech 3306 (RF64), Microsoft's WAVEFORMATEXTENSIBLE.
"""

from __future__ import annotations

import os
import struct
from typing import BinaryIO, Literal

from audio_checks.errors import Unreadable
from audio_checks.system.plural import verb
from audio_checks.wav import header_warnings
from audio_checks.wav.files import read_up_to
from audio_checks.wav.format_chunk import read_format
from audio_checks.wav.header_warnings import EXPORT_AGAIN, Sizes64
from audio_checks.wav.layout import (
    PCM,
    STREAM_SIZE,
    Chunk,
    StructureWarning,
    WavLayout,
)
from audio_checks.wav.loops import MOST_BYTES, Loops, read_loops
from audio_checks.wav.other_containers import EXPORT_WAV, OTHER_CONTAINERS

MAX_CHUNKS = 10_000
ZEROS = bytes(1 << 16)
HEAD_BYTES = 44  # the shortest header there is, read at once

UPLOAD_AGAIN = "export or copy it again; the file was cut short on its way"


def read_layout(file: BinaryIO) -> WavLayout:
    """Read the headers of a WAV file and judge its structure; samples are not read.

    Parameters
    ----------
    file : binary file
        Seekable. Its position afterwards is undefined.

    Returns
    -------
    WavLayout

    Raises
    ------
    Unreadable
        When rule R1-R6, R11 or R12 is broken.
    """
    return _Reading(file).layout()


def _show(identifier: bytes) -> str:
    """Return a chunk's id for a sentence: printable, whatever its bytes."""
    return "".join(chr(byte) if 0x20 <= byte < 0x7F else "?" for byte in identifier)


def _is_printable(identifier: bytes) -> bool:
    return all(0x20 <= byte < 0x7F for byte in identifier)


class _Reading:
    """One reading of one header."""

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self.size = file.seek(0, os.SEEK_END)
        file.seek(0)
        self.head = read_up_to(file, HEAD_BYTES)
        self.warnings: list[StructureWarning] = []

    def layout(self) -> WavLayout:
        start = self.read(0, 40)
        container = self.container(start)
        (riff_size,) = struct.unpack("<I", start[4:8])
        sizes64: Sizes64 | None = None
        declared_riff_size = riff_size
        if container == "rf64":
            sizes64 = self.ds64(start)
            if riff_size == STREAM_SIZE:
                riff_size = sizes64.riff_size
        elif riff_size == STREAM_SIZE:
            raise _stream()
        chunks = self.chunks(8 + riff_size, sizes64.data_size if sizes64 else None)
        header, data = self.pair(chunks)
        stored, odd = read_format(header, self.read(header.offset, min(header.size, 40)))
        self.warnings += odd
        tag, extensible, channels, rate, container_bits, bits, mask, ambisonic = stored
        frame_bytes = channels * container_bits // 8
        frames, rest = divmod(data.size, frame_bytes)
        if rest:
            raise Unreadable(
                f"the data chunk holds {data.size} bytes, which is not a whole number of frames"
                f" of {frame_bytes} bytes: {rest} are left over",
                "R1",
                "structure:partial-frame",
                EXPORT_AGAIN,
            )
        if not frames:
            raise Unreadable(
                "the file holds no sound: its data chunk is empty", "R6", "structure:no-frames", EXPORT_AGAIN
            )
        counted, ds64_counts = header_warnings.frame_count_warnings(self.read, chunks, frames, sizes64)
        if sizes64 and ds64_counts and sizes64.frames not in (0, frames):
            raise Unreadable(
                f"the ds64 chunk counts {sizes64.frames} frames, but the data chunk holds {frames}",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        self.warnings += counted
        if sizes64:
            declared_data_size = int.from_bytes(self.read(data.offset - 4, 4), "little")
            self.warnings += header_warnings.of_sizes(declared_riff_size, declared_data_size, sizes64)
        self.warnings += header_warnings.of_padding(self.read, chunks, self.size)
        loops = self.loops(chunks, frames)
        self.warnings += loops.warnings
        return WavLayout(
            container=container,
            encoding="pcm" if tag == PCM else "float",
            codec_tag=tag,
            extensible=extensible,
            sample_rate_hz=rate,
            bit_depth=bits,
            container_bits=container_bits,
            channels=channels,
            channel_mask=mask,
            frames=frames,
            data_offset=data.offset,
            data_size=data.size,
            chunks=tuple(chunks),
            warnings=tuple(self.warnings),
            loops=loops.inside,
            loops_outside=loops.outside,
            file_size=self.size,
            ambisonic=ambisonic,
        )

    def read(self, offset: int, count: int) -> bytes:
        if offset + count <= len(self.head):
            return self.head[offset : offset + count]
        self.file.seek(offset)
        return read_up_to(self.file, count)

    def warn(self, code: str, message: str, fix: str = EXPORT_AGAIN) -> None:
        self.warnings.append(StructureWarning(f"structure:{code}", message, fix))

    def container(self, start: bytes) -> Literal["wav", "rf64"]:
        """Accept RIFF and RF64; refuse everything else by its name (R11)."""
        if not self.size:
            raise Unreadable("the file is empty: it has 0 bytes", "R11", "container:empty", UPLOAD_AGAIN)
        if start[:4] not in (b"RIFF", b"RF64"):
            for offset, magic, code, name in OTHER_CONTAINERS:
                if start[offset : offset + len(magic)] == magic:
                    fix = "fetch the real file with `git lfs pull`" if code == "git-lfs-pointer" else EXPORT_WAV
                    raise Unreadable(
                        f"the file is {name}, not WAV, whatever its name ends in", "R11", f"container:{code}", fix
                    )
            if len(start) > 1 and start[0] == 0xFF and start[1] & 0xE0 == 0xE0 and start[1] & 0x06:
                raise Unreadable(
                    "the file is MP3, not WAV, whatever its name ends in", "R11", "container:mp3", EXPORT_WAV
                )
            if not any(start):
                raise Unreadable(
                    "the file starts with zeros where a WAV file starts with RIFF",
                    "R11",
                    "container:zeros",
                    UPLOAD_AGAIN,
                )
            raise Unreadable(
                f'the file starts with "{_show(start[:4])}"; a WAV file starts with RIFF or RF64',
                "R11",
                "container:unknown",
                EXPORT_WAV,
            )
        if len(start) < 12:
            raise Unreadable(
                f"the file ends after {self.size} bytes, in the middle of its header",
                "R1",
                "structure:truncated",
                UPLOAD_AGAIN,
            )
        if start[8:12] != b"WAVE":
            form = _show(start[8:12])
            raise Unreadable(
                f'the file is RIFF, but of the kind "{form}"; "WAVE" is wanted', "R11", "container:not-wave", EXPORT_WAV
            )
        return "wav" if start[:4] == b"RIFF" else "rf64"

    def ds64(self, start: bytes) -> Sizes64:
        """Return the content of the ds64 chunk that an RF64 file must begin with."""
        if start[12:16] != b"ds64":
            raise Unreadable(
                "the file is RF64 but does not begin with a ds64 chunk, which carries its sizes",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        declared = int.from_bytes(start[16:20], "little")
        content = self.read(20, 28)
        if declared < 28 or len(content) < 28:
            raise Unreadable(
                f"the ds64 chunk has {declared} bytes; 28 or more are wanted", "R11", "structure:ds64", EXPORT_AGAIN
            )
        riff_size, data_size, frames, entries = struct.unpack("<QQQI", content)
        if 28 + 12 * entries > declared:
            raise Unreadable(
                f"the ds64 chunk announces {entries} table entries, more than its {declared} bytes can hold",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        return Sizes64(riff_size, data_size, frames, entries, declared)

    def chunks(self, riff_end: int, data64: int | None) -> list[Chunk]:
        """Walk the chunks, and see that RIFF size and file agree (R1, R2, R12)."""
        excess = riff_end - self.size
        if riff_end < 12:
            raise Unreadable(
                "the RIFF size was left at zero, as a recorder does that could not finish",
                "R2",
                "structure:riff-size",
                EXPORT_AGAIN,
            )
        if excess > 0:
            chunks, loose_pad = self.walk(self.size, data64)
            if excess == 8:
                self.warn("riff-size", "the RIFF size is 8 bytes too large: it counts its own header")
            elif not (excess == 1 and loose_pad):
                raise Unreadable(
                    f"the RIFF header says that the file has {riff_end} bytes, but it has {self.size}",
                    "R2",
                    "structure:riff-size",
                    UPLOAD_AGAIN,
                )
            return chunks
        try:
            chunks, loose_pad = self.walk(riff_end, data64)
        except Unreadable as refusal:
            if excess == -8:
                return self.walk_all(data64)
            if excess < 0 and refusal.code == "structure:truncated":
                raise Unreadable(
                    f"the RIFF header says that the file has {riff_end} bytes, but it has {self.size},"
                    " and its chunks reach beyond what the header says",
                    "R2",
                    "structure:riff-size",
                    EXPORT_AGAIN,
                ) from None
            raise
        if excess == -1 and loose_pad:
            self.warn("riff-size", "the RIFF size does not count the pad byte at the end")
        elif excess == -8 and self.sound(self.read(riff_end, 8), riff_end, self.size, data64):
            return self.walk_all(data64)  # what is left out is the head of an empty chunk
        elif excess < 0:
            self.padding(riff_end)
        return chunks

    def walk_all(self, data64: int | None) -> list[Chunk]:
        """List the chunks of a file whose RIFF size leaves out the last 8 bytes."""
        self.warnings.clear()
        chunks, _ = self.walk(self.size, data64)
        self.warn("riff-size", "the RIFF size is 8 bytes too small")
        return chunks

    def padding(self, riff_end: int) -> None:
        """Allow nothing but zeros after the RIFF (R12)."""
        self.file.seek(riff_end)
        while block := self.file.read(len(ZEROS)):
            if block != ZEROS[: len(block)]:
                raise Unreadable(
                    f"{self.size - riff_end} bytes that are not part of the WAV file follow its end",
                    "R12",
                    "structure:trailing-bytes",
                    EXPORT_AGAIN,
                )
        self.warn("padding", f"{self.size - riff_end} bytes of zero padding follow the end of the WAV file")

    def walk(self, end: int, data64: int | None) -> tuple[list[Chunk], bool]:
        """List the chunks up to `end`, and whether the last one's pad byte is outside."""
        chunks: list[Chunk] = []
        position = 12
        while position < end:
            head = self.read(position, 8)[: end - position]
            if chunks and chunks[-1].size % 2 and not self.sound(head, position, end, data64):
                unpadded = self.read(position - 1, 8)
                if self.sound(unpadded, position - 1, end, data64) and unpadded[0]:
                    self.warn("pad-byte", f'the pad byte after the chunk "{chunks[-1].id}" of odd length is missing')
                    position, head = position - 1, unpadded
            if len(head) < 8 or not _is_printable(head[:4]):
                self.stray(position, end)
                break
            size = self.declared_size(head, data64)
            if position + 8 + size > end:
                raise self.overrun(head[:4], size, position + 8, end)
            if len(chunks) == MAX_CHUNKS:
                raise Unreadable(
                    f"the file has more than {MAX_CHUNKS} chunks; a WAV file has a handful",
                    "R1",
                    "structure:too-many-chunks",
                    EXPORT_AGAIN,
                )
            chunks.append(Chunk(head[:4].decode("latin-1"), position + 8, size))
            position += 8 + size + size % 2
        loose_pad = position == end + 1
        if loose_pad and end == self.size:
            self.warn("pad-byte", f'the pad byte after the last chunk "{chunks[-1].id}" is missing')
        return chunks, loose_pad

    def sound(self, head: bytes, position: int, end: int, data64: int | None) -> bool:
        """Whether these bytes can be the head of a chunk inside the file."""
        return (
            len(head) == 8
            and _is_printable(head[:4])
            and not (head[:4] != b"data" and head[4:] == b"\xff\xff\xff\xff")
            and position + 8 + self.declared_size(head, data64) <= end
        )

    def declared_size(self, head: bytes, data64: int | None) -> int:
        (size,) = struct.unpack("<I", head[4:8])
        if size == STREAM_SIZE and head[:4] == b"data":
            if data64 is None:
                raise _stream()
            return data64
        return int(size)

    def stray(self, position: int, end: int) -> None:
        """Allow zeros where a chunk was expected; refuse anything else (R1)."""
        left = end - position
        self.file.seek(position)
        remaining = left
        while remaining:
            block = self.file.read(min(remaining, len(ZEROS)))
            if not block or block != ZEROS[: len(block)]:
                raise Unreadable(
                    f"what stands at position {position} (bytes to the end: {left}) is not a chunk:"
                    " a name of four letters was wanted there",
                    "R1",
                    "structure:no-chunk",
                    EXPORT_AGAIN,
                )
            remaining -= len(block)
        self.warn(
            "padding",
            f"the last {left} {verb(left, 'byte', 'bytes')} of the WAV file {verb(left, 'is', 'are')} zero padding",
        )

    def overrun(self, identifier: bytes, size: int, offset: int, end: int) -> Unreadable:
        missing = size - (end - offset)
        if identifier == b"data":
            return Unreadable(
                f"the data chunk says that it has {size} bytes of sound, but {missing} of them are missing",
                "R1",
                "structure:truncated",
                UPLOAD_AGAIN,
            )
        return Unreadable(
            f'the chunk "{_show(identifier)}" says that it has {size} bytes,'
            f" which is {missing} more than the file has left",
            "R1",
            "structure:truncated",
            UPLOAD_AGAIN,
        )

    def pair(self, chunks: list[Chunk]) -> tuple[Chunk, Chunk]:
        """Return the one `fmt ` and the one `data` chunk, in this order (R3)."""
        formats = [chunk for chunk in chunks if chunk.id == "fmt "]
        datas = [chunk for chunk in chunks if chunk.id == "data"]
        for matching_chunks, name, role in (
            (formats, "fmt ", "describes the sample format"),
            (datas, "data", "holds the sound"),
        ):
            if len(matching_chunks) != 1:
                count = "no" if not matching_chunks else str(len(matching_chunks))
                raise Unreadable(
                    f'the file has {count} "{name}" chunk{"s" if len(matching_chunks) > 1 else ""}, which {role};'
                    " exactly one is wanted",
                    "R3",
                    f"structure:{'no' if not matching_chunks else 'several'}-{name.strip()}",
                    EXPORT_AGAIN,
                )
        if formats[0].offset > datas[0].offset:
            raise Unreadable(
                'the "fmt " chunk comes after the "data" chunk; it must come before',
                "R3",
                "structure:fmt-after-data",
                EXPORT_AGAIN,
            )
        return formats[0], datas[0]

    def loops(self, chunks: list[Chunk], frames: int) -> Loops:
        sampler = next((chunk for chunk in chunks if chunk.id == "smpl"), None)
        if sampler is None:
            return Loops((), (), ())
        return read_loops(self.read(sampler.offset, min(sampler.size, MOST_BYTES)), sampler.size, frames)


def _stream() -> Unreadable:
    return Unreadable(
        "the header leaves its sizes open, as a program does that writes to a pipe; the true sizes are wanted",
        "R11",
        "structure:stream-header",
        EXPORT_AGAIN,
    )
