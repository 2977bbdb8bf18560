"""A strict reader and writer of WAV files (RIFF and RF64), for files from strangers.

The reader refuses what breaks the rules R1-R7, R11 and R12, each in words; "it plays here" is no
check. What is odd but harmless becomes a warning. Memory stays bounded whatever a header claims.
Sources: EBU Tech 3285 (BWF), EBU Tech 3306 (RF64), Microsoft's WAVEFORMATEXTENSIBLE.
"""

from __future__ import annotations

import os
import secrets
import stat
import struct
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from io import FileIO
from pathlib import Path
from typing import BinaryIO, Literal, Protocol

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.errors import Unreadable
from audio_checks.windows import reachable

BLOCK_FRAMES = 65_536
MAX_BLOCK_BYTES = 4 << 20  # of float64, so that a header of many channels cannot ask for much memory
MAX_CHUNKS = 10_000
MAX_CHANNELS = 1_024  # also libsndfile's
MAX_LOOPS = 1_024
ZEROS = bytes(1 << 16)
STREAM_SIZE = 0xFFFFFFFF  # what a program writes that cannot go back to fill in the size
GUID_TAIL = bytes.fromhex("00001000800000aa00389b71")  # of every GUID that stands for a codec tag
AMBISONIC_TAIL = bytes.fromhex("2107d3118644c8c1ca000000")  # the same of B-format, for PCM and float
PCM, FLOAT, EXTENSIBLE = 1, 3, 0xFFFE

CODECS = {
    0x0002: "Microsoft ADPCM",
    0x0006: "A-law",
    0x0007: "µ-law",
    0x0011: "IMA ADPCM",
    0x0031: "GSM 6.10",
    0x0050: "MPEG audio",
    0x0055: "MP3",
    0x0069: "Xbox ADPCM",
    0x0092: "Dolby AC-3",
    0x00FF: "AAC",
    0x0161: "Windows Media Audio",
    0x0162: "Windows Media Audio Professional",
    0x0163: "Windows Media Audio Lossless",
    0x0270: "ATRAC3",
    0x566F: "Vorbis",
    0x676F: "Vorbis",
    0xF1AC: "FLAC",
}

# Bytes at the start of what is not a WAV file: (offset, bytes, code, name)
OTHER_CONTAINERS = (
    (0, b"version https://git-lfs", "git-lfs-pointer", "a Git LFS pointer, a text that stands for the real file"),
    (0, b"RIFX", "rifx", "RIFX (big-endian RIFF)"),
    (0, b"BW64", "bw64", "BW64"),
    (0, b"riff\x2e\x91\xcf\x11", "w64", "Sony Wave64 (W64)"),
    (0, b"fLaC", "flac", "FLAC"),
    (0, b"OggS", "ogg", "Ogg (Vorbis, Opus or FLAC)"),
    (0, b"FORM", "aiff", "AIFF"),
    (0, b".snd", "au", "AU"),
    (0, b"caff", "caf", "Core Audio (CAF)"),
    (0, b"ID3", "mp3", "MP3 (it starts with an ID3 tag)"),
    (4, b"ftyp", "mp4", "MP4 or M4A"),
    (0, b"\x1aE\xdf\xa3", "matroska", "Matroska or WebM"),
    (0, b"0&\xb2u\x8ef\xcf\x11", "asf", "Windows Media (ASF)"),
    (0, b"wvpk", "wavpack", "WavPack"),
    (0, b"MAC ", "ape", "Monkey's Audio"),
    (0, b"MThd", "midi", "MIDI"),
    (0, b"DSD ", "dsf", "DSD"),
    (0, b"PK\x03\x04", "zip", "a ZIP archive"),
    (0, b"\x1f\x8b", "gzip", "a gzip archive"),
    (0, b"%PDF", "pdf", "a PDF"),
    (0, b"<!DOCTYPE", "html", "a web page"),
    (0, b"<html", "html", "a web page"),
)

EXPORT_WAV = "export it from your audio editor as WAV (PCM); renaming a file does not convert it"
EXPORT_AGAIN = "export it again from your audio editor as WAV"
UPLOAD_AGAIN = "export or copy it again; the file was cut short on its way"


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
    """What the header says, once it was found to be true.

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


def open_regular(path: str | os.PathLike[str]) -> FileIO:
    """Open a regular file for reading; a FIFO, a device or a directory is refused without waiting for it.

    Raises
    ------
    Unreadable
        R11, for anything that is not a regular file which may be read.
    """
    try:
        descriptor = os.open(
            reachable(os.fspath(path)), os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
        )
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise Unreadable(
            f"the file cannot be opened: {reason}",
            "R11",
            "container:cannot-open",
            "check that the file is there and may be read",
        ) from error
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise Unreadable(
                "this is no file but a directory, a pipe or a device; a WAV file is wanted",
                "R11",
                "container:not-a-file",
                "deliver a plain file",
            )
        return os.fdopen(descriptor, "rb", buffering=0)
    except BaseException:
        os.close(descriptor)
        raise


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
        self.warnings: list[StructureWarning] = []

    def layout(self) -> WavLayout:
        start = self.read(0, 40)
        container = self.container(start)
        (riff_size,) = struct.unpack("<I", start[4:8])
        sizes64: tuple[int, int, int] | None = None
        if container == "rf64":
            sizes64 = self.ds64(start)
            if riff_size == STREAM_SIZE:
                riff_size = sizes64[0]
        elif riff_size == STREAM_SIZE:
            raise _stream()
        chunks = self.chunks(8 + riff_size, sizes64[1] if sizes64 else None)
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
        if sizes64 and sizes64[2] not in (0, frames):
            raise Unreadable(
                f"the ds64 chunk counts {sizes64[2]} frames, but the data chunk holds {frames}",
                "R11",
                "structure:ds64",
                EXPORT_AGAIN,
            )
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
        self.file.seek(offset)
        return _read_up_to(self.file, count)

    def warn(self, code: str, message: str, fix: str = EXPORT_AGAIN) -> None:
        self.warnings.append(StructureWarning(f"structure:{code}", message, fix))

    def container(self, start: bytes) -> Literal["wav", "rf64"]:
        """Tell RIFF and RF64 from everything else, which is refused by its name (R11)."""
        if not self.size:
            raise Unreadable("the file is empty: it has 0 bytes", "R11", "container:empty", UPLOAD_AGAIN)
        for offset, magic, code, name in OTHER_CONTAINERS:
            if start[offset : offset + len(magic)] == magic:
                fix = "fetch the real file with `git lfs pull`" if code == "git-lfs-pointer" else EXPORT_WAV
                raise Unreadable(
                    f"the file is {name}, not WAV, whatever its name ends in", "R11", f"container:{code}", fix
                )
        if start[:4] not in (b"RIFF", b"RF64"):
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

    def ds64(self, start: bytes) -> tuple[int, int, int]:
        """Return RIFF size, data size and frames of the ds64 chunk that an RF64 file must begin with."""
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
        return riff_size, data_size, frames

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
                self.warnings.clear()
                chunks, loose_pad = self.walk(self.size, data64)
                self.warn("riff-size", "the RIFF size is 8 bytes too small")
                return chunks
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
        elif excess < 0:
            self.padding(riff_end)
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
            raise _shrunk()
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


def _shrunk() -> Unreadable:
    return Unreadable(
        "the file became shorter while it was read",
        "R1",
        "structure:truncated",
        "wait until it is written, then try again",
    )


def _read_up_to(file: BinaryIO, count: int) -> bytes:
    """Read `count` bytes, or all that are left; a raw file may give them in pieces."""
    content = file.read(count)
    while content is not None and len(content) < count:
        more = file.read(count - len(content))
        if not more:
            break
        content += more
    return content or b""


def frames_at_once(layout: WavLayout, most: int = BLOCK_FRAMES) -> int:
    """Return how many frames are read together, so that memory stays bounded whatever the channels."""
    return max(1, min(most, MAX_BLOCK_BYTES // (8 * layout.channels)))


def read_frames(file: BinaryIO, layout: WavLayout, frames: int) -> bytes:
    """Return the bytes of so many frames from where the file stands.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile.
    """
    wanted = frames * layout.frame_bytes
    raw = _read_up_to(file, wanted)
    if len(raw) < wanted:
        raise _shrunk()
    return raw


def fill(file: FileIO, room: memoryview) -> None:
    """Fill all of `room` from where the file stands.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile.
    """
    filled = 0
    while filled < len(room):
        count = file.readinto(room[filled:])
        if not count:
            raise _shrunk()
        filled += count


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
    """Something that decodes to a place of its own; `measure.faults.Faults` is one."""

    def decode(
        self, raw: bytes | memoryview, container_bits: int, *, floats: bool
    ) -> tuple[NDArray[np.float64], int, int]:
        """Return the block, all PCM samples or-ed together, and the first channel that is not finite or 0."""


def decode(
    raw: bytes | memoryview, layout: WavLayout, decoder: Decoder | None = None
) -> tuple[NDArray[np.float64], int]:
    """Return whole frames as samples, and all PCM samples or-ed together (0 for float).

    The samples have the shape (frames, channels), each channel contiguous, full scale ±1.0. What is or-ed are
    signed integers of the container's width; of 24 bits, the upper three bytes of 32. A `decoder` may put
    the samples where it wants them.

    Raises
    ------
    Unreadable
        R7, for a float sample that is not a finite number.
    """
    used = broken = 0
    if decoder is not None:
        block, used, broken = decoder.decode(raw, layout.container_bits, floats=layout.encoding == "float")
    else:
        block = np.empty((layout.channels, len(raw) // layout.frame_bytes)).T
        if layout.encoding == "pcm":
            used = kernel.decode_pcm(raw, layout.container_bits, block.T)
        else:
            broken = kernel.decode_float(raw, layout.container_bits, block.T)
    if broken:
        raise Unreadable(
            f"channel {broken} holds samples that are not numbers (infinity or NaN)",
            "R7",
            "structure:not-finite",
            "look for a broken plug-in in the session, then export again",
        )
    return block, used


def blocks(file: BinaryIO, layout: WavLayout, block_frames: int = BLOCK_FRAMES) -> Iterator[NDArray[np.float64]]:
    """Yield the samples in blocks of shape (n, channels), full scale ±1.0.

    Raises
    ------
    Unreadable
        R7, for a float sample that is not a finite number; R1, when the file became shorter meanwhile.
    """
    for raw in raw_blocks(file, layout, block_frames):
        yield decode(raw, layout)[0]


def chunk_payload(file: BinaryIO, chunk: Chunk) -> bytes:
    """Return the payload of one chunk, which the caller has found small enough to hold."""
    file.seek(chunk.offset)
    return _read_up_to(file, chunk.size)


def write_wav(
    target: str | os.PathLike[str] | BinaryIO,
    blocks: Iterable[NDArray[np.integer] | NDArray[np.floating]],
    *,
    sample_rate_hz: int,
    bit_depth: int,
    encoding: Literal["pcm", "float"] = "pcm",
    channels: int,
    frames: int,
    channel_mask: int | None = None,
    chunks: Sequence[tuple[str, bytes]] = (),
    chunks_after: Sequence[tuple[str, bytes]] = (),
) -> None:
    """Write a WAV file whose header is right; RF64 where it would pass 4 GiB, extensible where it must be.

    Parameters
    ----------
    target : path or binary file
        A path is written beside its final name, synced and renamed, so it is whole or absent.
    sample_rate_hz, bit_depth, encoding, channels : int, int, str, int
        The format; PCM of 2 to 32 bits, float of 32 or 64.
    blocks : iterable of ndarray, shape (n, channels)
        For PCM integers that are quantised already, within ±2**(bit_depth - 1); for float, floats.
    frames : int
        Of all blocks together.
    channel_mask : int, optional
        Speaker positions; asks for an extensible header.
    chunks, chunks_after : sequence of (id, payload)
        Further chunks before and after `data`.

    Raises
    ------
    ValueError
        When the blocks do not fit what was announced; no file is left behind.
    """
    header, data_size = _header(
        sample_rate_hz, bit_depth, encoding, channels, frames, channel_mask, chunks, chunks_after
    )
    coded = _coded(blocks, bit_depth, encoding, channels, frames)
    tail = b"\0" * (data_size % 2) + b"".join(_chunk(name, payload) for name, payload in chunks_after)
    if not isinstance(target, (str, os.PathLike)):
        _write_all(target, header, coded, tail)
        return
    path = Path(target)
    temporary = path.parent / f".wav-{secrets.token_hex(8)}.part"
    try:
        with open(temporary, "xb") as file:
            _write_all(file, header, coded, tail)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    _sync_directory(path.parent)


def copy_wav(file: BinaryIO, layout: WavLayout, target: str | os.PathLike[str], chunks: Mapping[str, bytes]) -> None:
    """Write a copy of a WAV file, its sound byte for byte, whose chunks say something else.

    Parameters
    ----------
    file, layout : binary file, WavLayout
        What is copied.
    target : path
        Written beside its final name, synced and renamed, so it is whole or absent.
    chunks : mapping of str to bytes
        New payloads by id: of the first chunk of that id, or of a new one. A new one stands before the
        sound, as bext must. Everything else keeps its place. RF64 where it would pass 4 GiB.
    """
    left = dict(chunks)
    before: list[bytes] = []
    after: list[bytes] = []
    for chunk in layout.chunks:
        if chunk.id in ("ds64", "data"):
            continue
        payload = left.pop(chunk.id) if chunk.id in left else chunk_payload(file, chunk)
        (before if chunk.offset < layout.data_offset else after).append(_chunk(chunk.id, payload))
    before += [_chunk(name, payload) for name, payload in left.items()]
    head = _opened(b"".join(before), layout.data_size, layout.frames, sum(map(len, after)))
    path = Path(target)
    temporary = path.parent / f".wav-{secrets.token_hex(8)}.part"
    try:
        with open(temporary, "xb") as copy:
            _write_all(copy, head, raw_blocks(file, layout), b"\0" * (layout.data_size % 2) + b"".join(after))
            copy.flush()
            os.fsync(copy.fileno())
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    _sync_directory(path.parent)


def _sync_directory(directory: Path) -> None:
    if os.name == "posix":
        descriptor = os.open(directory, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)


def _write_all(file: BinaryIO, header: bytes, coded: Iterable[bytes], tail: bytes) -> None:
    file.write(header)
    for block in coded:
        file.write(block)
    file.write(tail)


def _chunk(name: str, payload: bytes) -> bytes:
    identifier = name.encode("latin-1")
    if len(identifier) != 4 or len(payload) > STREAM_SIZE:
        raise ValueError(f"a chunk needs an id of four characters and a payload under 4 GiB: {name!r}")
    return identifier + struct.pack("<I", len(payload)) + payload + b"\0" * (len(payload) % 2)


def _header(
    rate: int,
    bits: int,
    encoding: str,
    channels: int,
    frames: int,
    mask: int | None,
    before: Sequence[tuple[str, bytes]],
    after: Sequence[tuple[str, bytes]],
) -> tuple[bytes, int]:
    """Everything up to the first sample, and the bytes of sound that follow."""
    if bits not in ((32, 64) if encoding == "float" else range(2, 33)):
        raise ValueError(f"no {encoding} of {bits} bits")
    container_bits = (bits + 7) // 8 * 8
    align = channels * container_bits // 8
    data_size = frames * align
    tag = PCM if encoding == "pcm" else FLOAT
    if mask is not None or channels > 2 or bits != container_bits:
        guid = struct.pack("<I", tag) + GUID_TAIL
        extra = struct.pack("<HHI", 22, bits, mask or 0) + guid
        shown = EXTENSIBLE
    else:
        extra, shown = (b"" if tag == PCM else b"\0\0"), tag
    flow = (rate * align) & 0xFFFFFFFF
    fmt = struct.pack("<HHIIHH", shown, channels, rate, flow, align, container_bits) + extra
    head = _chunk("fmt ", fmt)
    if tag == FLOAT:
        head += _chunk("fact", struct.pack("<I", min(frames, STREAM_SIZE)))
    head += b"".join(_chunk(name, payload) for name, payload in before)
    return _opened(head, data_size, frames, sum(len(_chunk(*chunk)) for chunk in after)), data_size


def _opened(head: bytes, data_size: int, frames: int, after_bytes: int) -> bytes:
    """Return everything up to the first sample, given the chunks before `data` and the bytes after it."""
    size = 4 + len(head) + 8 + data_size + data_size % 2 + after_bytes
    if size + 8 <= STREAM_SIZE:
        return b"RIFF" + struct.pack("<I", size) + b"WAVE" + head + b"data" + struct.pack("<I", data_size)
    ds64 = _chunk("ds64", struct.pack("<QQQI", size + 36, data_size, frames, 0))
    open_size = struct.pack("<I", STREAM_SIZE)
    return b"RF64" + open_size + b"WAVE" + ds64 + head + b"data" + open_size


def _coded(
    blocks: Iterable[NDArray[np.integer] | NDArray[np.floating]], bits: int, encoding: str, channels: int, frames: int
) -> Iterator[bytes]:
    """Yield the blocks as bytes of the data chunk; refuse what does not fit."""
    written = 0
    for block in blocks:
        if block.ndim != 2 or block.shape[1] != channels:
            raise ValueError(f"a block of shape {block.shape} does not hold {channels} channels")
        if not np.issubdtype(block.dtype, np.integer if encoding == "pcm" else np.floating):
            raise ValueError(f"{block.dtype} samples cannot be written as {encoding}")
        written += len(block)
        if encoding == "float":
            yield np.ascontiguousarray(block, dtype=f"<f{bits // 8}").tobytes()
            continue
        limit = 1 << (bits - 1)
        if len(block) and not (-limit <= int(block.min()) and int(block.max()) < limit):
            raise ValueError(f"samples beyond the range of {bits} bits")
        container = (bits + 7) // 8
        whole = np.ascontiguousarray(block, dtype=np.int64) << (8 * container - bits)
        if container == 1:
            whole += 128
        yield np.ascontiguousarray(whole, "<i8").view(np.uint8).reshape(-1, 8)[:, :container].tobytes()
    if written != frames:
        raise ValueError(f"{frames} frames were announced, {written} came")
