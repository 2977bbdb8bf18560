"""A strict reader of headers, RIFF and RF64: it refuses what breaks the rules R1-R6, R11 and R12, each in words.

"It plays here" is no check. What is odd but harmless becomes a warning. Memory stays bounded whatever a header claims.
Sources: EBU Tech 3285 (BWF), EBU Tech 3306 (RF64), Microsoft's WAVEFORMATEXTENSIBLE.
"""

from __future__ import annotations

import os
import struct
from typing import BinaryIO, Literal

from audio_checks.errors import Unreadable
from audio_checks.wav import oddities
from audio_checks.wav.files import read_up_to, shrunk
from audio_checks.wav.layout import (
    AMBISONIC_TAIL,
    EXTENSIBLE,
    FLOAT,
    GUID_TAIL,
    PCM,
    STREAM_SIZE,
    Chunk,
    SampleLoop,
    StructureWarning,
    WavLayout,
)
from audio_checks.wav.oddities import Sizes64
from audio_checks.wav.other_containers import CODECS, OTHER_CONTAINERS

MAX_CHUNKS = 10_000
MAX_CHANNELS = 1_024  # also libsndfile's
MAX_LOOPS = 1_024
ZEROS = bytes(1 << 16)
HEAD_BYTES = 44  # the shortest header there is, read at once

EXPORT_WAV = "export it from your audio editor as WAV (PCM); renaming a file does not convert it"
EXPORT_AGAIN = "export it again from your audio editor as WAV"
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


def _lawful(identifier: bytes) -> bool:
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
        told_riff_size = riff_size
        if container == "rf64":
            sizes64 = self.ds64(start)
            if riff_size == STREAM_SIZE:
                riff_size = sizes64.riff_size
        elif riff_size == STREAM_SIZE:
            raise _stream()
        chunks = self.chunks(8 + riff_size, sizes64.data_size if sizes64 else None)
        header, data = self.pair(chunks)
        tag, extensible, channels, rate, container_bits, bits, mask, ambisonic = self.format(header)
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
        counted, ds64_counts = oddities.of_counts(self.read, chunks, frames, sizes64)
        if sizes64 and ds64_counts and sizes64.frames not in (0, frames):
            raise Unreadable(
                f"the ds64 chunk counts {sizes64.frames} frames, but the data chunk holds {frames}",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        self.warnings += counted
        if sizes64:
            told_data_size = int.from_bytes(self.read(data.offset - 4, 4), "little")
            self.warnings += oddities.of_sizes(told_riff_size, told_data_size, sizes64)
        self.warnings += oddities.of_padding(self.read, chunks, self.size)
        loops, outside = self.loops(chunks, frames)
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
            loops=loops,
            loops_outside=outside,
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
        """Tell RIFF and RF64 from everything else, which is refused by its name (R11)."""
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
        """Return what the ds64 chunk says that an RF64 file must begin with."""
        if start[12:16] != b"ds64":
            raise Unreadable(
                "the file is RF64 but does not begin with a ds64 chunk, which carries its sizes",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        told = int.from_bytes(start[16:20], "little")
        content = self.read(20, 28)
        if told < 28 or len(content) < 28:
            raise Unreadable(
                f"the ds64 chunk has {told} bytes; 28 or more are wanted", "R11", "structure:ds64", EXPORT_AGAIN
            )
        riff_size, data_size, frames, entries = struct.unpack("<QQQI", content)
        if 28 + 12 * entries > told:
            raise Unreadable(
                f"the ds64 chunk announces {entries} table entries, more than its {told} bytes can hold",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
        return Sizes64(riff_size, data_size, frames, entries, told)

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
        """List the chunks up to `end`, and tell whether the last one's pad byte is outside."""
        chunks: list[Chunk] = []
        position = 12
        while position < end:
            head = self.read(position, 8)[: end - position]
            if chunks and chunks[-1].size % 2 and not self.sound(head, position, end, data64):
                unpadded = self.read(position - 1, 8)
                if self.sound(unpadded, position - 1, end, data64) and unpadded[0]:
                    self.warn("pad-byte", f'the pad byte after the chunk "{chunks[-1].id}" of odd length is missing')
                    position, head = position - 1, unpadded
            if len(head) < 8 or not _lawful(head[:4]):
                self.stray(position, end)
                break
            size = self.told_size(head, data64)
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
        """Whether these bytes can be the head of a chunk that lies inside the file."""
        return (
            len(head) == 8
            and _lawful(head[:4])
            and not (head[:4] != b"data" and head[4:] == b"\xff\xff\xff\xff")
            and position + 8 + self.told_size(head, data64) <= end
        )

    def told_size(self, head: bytes, data64: int | None) -> int:
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
                    f"what stands at position {position} (bytes to the end: {left}) is no chunk:"
                    " a name of four letters was wanted there",
                    "R1",
                    "structure:no-chunk",
                    EXPORT_AGAIN,
                )
            remaining -= len(block)
        self.warn("padding", f"the last {left} bytes of the WAV file are zero padding")

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
        for found, name, role in ((formats, "fmt ", "tells the sample format"), (datas, "data", "holds the sound")):
            if len(found) != 1:
                count = "no" if not found else str(len(found))
                raise Unreadable(
                    f'the file has {count} "{name}" chunk{"s" if len(found) > 1 else ""}, which {role};'
                    " exactly one is wanted",
                    "R3",
                    f"structure:{'no' if not found else 'several'}-{name.strip()}",
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

    def format(self, chunk: Chunk) -> tuple[int, bool, int, int, int, int, int | None, bool]:
        """Read the `fmt ` chunk (R4, R5)."""
        if chunk.size < 16:
            raise _inconsistent(f'the "fmt " chunk has {chunk.size} bytes; 16 or more are wanted', "fmt-size")
        content = self.read(chunk.offset, min(chunk.size, 40))
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
            tag, ambisonic = self.tag_of(content[24:40])
            if mask.bit_count() > channels:
                self.warn(
                    "channel-mask",
                    f"the channel mask names {mask.bit_count()} speakers, but there are {channels} channels",
                )
        if tag not in (PCM, FLOAT):
            name = CODECS.get(tag, f"of an unknown kind (tag {tag:#06x})")
            raise Unreadable(
                f"the sound in this WAV file is {name}; PCM or IEEE float is wanted", "R5", "encoding:codec", EXPORT_WAV
            )
        if not 1 <= channels <= MAX_CHANNELS:
            raise _inconsistent(f"the header says {channels} channels; 1 to {MAX_CHANNELS} are wanted", "channels")
        if not 1_000 <= rate <= 768_000:
            raise _inconsistent(
                f"the header says a sample rate of {rate} Hz; 1,000 to 768,000 Hz is wanted", "sample-rate"
            )
        if extensible and (container_bits % 8 or not 1 <= bits <= container_bits):
            raise _inconsistent(f"the header says {bits} valid bits in a sample of {container_bits} bits", "bit-depth")
        container_bits = (container_bits + 7) // 8 * 8
        if container_bits not in ((8, 16, 24, 32) if tag == PCM else (32, 64)) or (
            tag == FLOAT and bits != container_bits
        ):
            kind, wanted = ("PCM", "8, 16, 24 or 32") if tag == PCM else ("float", "32 or 64")
            raise _inconsistent(f"the header says {kind} of {bits} bits; {wanted} bits are wanted", "bit-depth")
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
        self.warnings += oddities.of_format(chunk, content)
        return tag, extensible, channels, rate, container_bits, bits, mask, ambisonic

    def tag_of(self, guid: bytes) -> tuple[int, bool]:
        """Return the codec tag that a GUID stands for, and whether it says ambisonics."""
        if guid[4:] in (GUID_TAIL, AMBISONIC_TAIL):
            return int(struct.unpack("<I", guid[:4])[0]), guid[4:] == AMBISONIC_TAIL
        raise Unreadable(
            f"the sound in this WAV file is of an unknown kind (GUID {guid.hex()}); PCM or IEEE float is wanted",
            "R5",
            "encoding:codec",
            EXPORT_WAV,
        )

    def loops(self, chunks: list[Chunk], frames: int) -> tuple[tuple[SampleLoop, ...], tuple[SampleLoop, ...]]:
        """Read the loops of the `smpl` chunk, inside the file and outside; a damaged one is a warning, no refusal."""
        samplers = [chunk for chunk in chunks if chunk.id == "smpl"]
        if not samplers:
            return (), ()
        content = self.read(samplers[0].offset, min(samplers[0].size, 36 + 24 * MAX_LOOPS))
        if len(content) < 36:
            self.warn("smpl", f'the "smpl" chunk has {samplers[0].size} bytes; 36 or more are wanted')
            return (), ()
        (count,) = struct.unpack("<I", content[28:32])
        inside: list[SampleLoop] = []
        outside: list[SampleLoop] = []
        for number in range(min(count, (len(content) - 36) // 24)):
            kind, start, end = struct.unpack("<III", content[36 + 24 * number + 4 :][:12])
            if start > end:
                self.warn("smpl", f"loop {number + 1} runs backwards, from frame {start} to {end}")
                continue
            kinds: tuple[Literal["forward", "alternating", "backward"], ...] = ("forward", "alternating", "backward")
            loop = SampleLoop(start, end, kinds[kind] if kind < 3 else "other")
            (inside if end < frames else outside).append(loop)
        if count > (len(content) - 36) // 24:
            self.warn("smpl", f'the "smpl" chunk announces {count} loops, more than it holds')
        return tuple(inside), tuple(outside)


def _stream() -> Unreadable:
    return Unreadable(
        "the header leaves its sizes open, as a program does that writes to a pipe; the true sizes are wanted",
        "R11",
        "structure:stream-header",
        EXPORT_AGAIN,
    )


def _inconsistent(message: str, code: str) -> Unreadable:
    return Unreadable(message, "R4", f"structure:{code}", EXPORT_AGAIN)
