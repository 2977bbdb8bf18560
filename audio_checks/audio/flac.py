"""FLAC masters: a strict look at the header, and the sound unpacked into a WAV that is read like any other.

Decoding is libsndfile's, by soundfile, and its memory is not to be trusted with files from strangers: it
runs in a disposable child (see `sandbox`), which writes the WAV and exits. What a child wrote goes
through the strict reader. Sample for sample nothing changes, so the SHA-256 of a FLAC's samples is that
of the little-endian PCM bytes a WAV of it holds.
Source: RFC 9639; Vorbis comments as in Ogg Vorbis I, chapter 5.
"""

from __future__ import annotations

import hashlib
import io
import os
import tempfile
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cache
from typing import BinaryIO

import numpy as np
from numpy.typing import NDArray

from audio_checks import wav
from audio_checks.audio.sandbox import Sandbox, is_inside
from audio_checks.audio.self_deleting_file import SelfDeletingFile
from audio_checks.errors import Unreadable
from audio_checks.metadata import CHUNKS, MOST_BYTES, MOST_CHUNKS
from audio_checks.metadata.layouts import LAYOUTS
from audio_checks.system.plural import verb

MAGIC = b"fLaC"
BLOCK_NAMES = ("STREAMINFO", "PADDING", "APPLICATION", "SEEKTABLE", "VORBIS_COMMENT", "CUESHEET", "PICTURE")
STREAMINFO, APPLICATION, VORBIS_COMMENT = 0, 2, 4
MOST_BLOCKS = 1_024
MOST_COMMENTS = 1_024
MOST_UNPACKED_BYTES = 2 << 30  # of samples; a few bytes of FLAC can announce hours
DECODE_S = 300.0
BLOCK_FRAMES = 65_536
DEPTHS = (8, 16, 24)  # those libsndfile decodes
# What a number of channels means in FLAC, as the mask of an extensible header; fewer need none.
MASKS = {3: "lcr", 4: "quad", 5: "5.0", 6: "5.1", 8: "7.1"}
MASK_COMMENT = "WAVEFORMATEXTENSIBLE_CHANNEL_MASK"
EXPORT_AGAIN = "export it again from your audio editor as FLAC or WAV"


@dataclass(frozen=True)
class FlacLayout:
    """The facts of a FLAC file's header, once it was found to be valid.

    Attributes
    ----------
    blocks : tuple of str
        The names of its metadata blocks, in their order.
    md5 : bytes
        Of the samples, little-endian and signed; zeros where the encoder left it out.
    comments : dict of str
        Vorbis comments by their names, in capitals; of one name the first.
    riff_chunks : tuple of (id, payload)
        Metadata chunks of the WAV it was packed from, where they were kept.
    channel_mask : int or None
        Speaker positions, for more than two channels.
    """

    sample_rate_hz: int
    channels: int
    bit_depth: int
    frames: int
    md5: bytes
    blocks: tuple[str, ...]
    comments: dict[str, str] = field(default_factory=dict)
    riff_chunks: tuple[tuple[str, bytes], ...] = ()
    channel_mask: int | None = None

    @property
    def unpacked_bytes(self) -> int:
        """Bytes of its samples."""
        return self.frames * self.channels * self.bit_depth // 8

    @property
    def comment_fields(self) -> dict[str, str]:
        """The comments by the names that specs and reports use, as in `Vorbis.TITLE`."""
        return {f"Vorbis.{name}": text for name, text in self.comments.items()}


def read_layout(file: BinaryIO) -> FlacLayout:
    """Read the metadata blocks of a FLAC file; samples are not read.

    Raises
    ------
    Unreadable
        When a block reaches beyond the file, or says what cannot be.
    """
    return _Header(file).layout()


class _Header:
    """One reading of the blocks before the sound."""

    def __init__(self, file: BinaryIO) -> None:
        self.file = file
        self.size = file.seek(0, os.SEEK_END)
        self.at = len(MAGIC)

    def layout(self) -> FlacLayout:
        names: list[str] = []
        comments: dict[str, str] = {}
        chunks: list[tuple[str, bytes]] = []
        info = b""
        last = False
        while not last:
            kind, last, size = self.head()
            if (kind == STREAMINFO) != (not names) or kind == 127 or len(names) == MOST_BLOCKS:
                raise _inconsistent("its metadata blocks are not in valid order: STREAMINFO comes first, and once")
            names.append(BLOCK_NAMES[kind] if kind < len(BLOCK_NAMES) else f"RESERVED_{kind}")
            if kind == STREAMINFO:
                info = self.payload(size, 64)
            elif kind == VORBIS_COMMENT and not comments:
                comments = _comments(self.payload(size, MOST_BYTES))
            elif kind == APPLICATION and len(chunks) < MOST_CHUNKS:
                chunks += _riff_chunk(self.payload(size, MOST_BYTES + 12))
            self.at += size
        if self.at >= self.size:
            raise Unreadable("the file ends before its sound begins", "R1", "structure:truncated", wav.UPLOAD_AGAIN)
        return _from_info(info, tuple(names), comments, tuple(chunks))

    def head(self) -> tuple[int, bool, int]:
        """Return kind, whether it is the last, and size of the next block."""
        self.file.seek(self.at)
        head = self.file.read(4)
        size = int.from_bytes(head[1:], "big")
        if len(head) < 4 or self.at + 4 + size > self.size:
            raise Unreadable(
                "a metadata block of the FLAC file reaches beyond its end",
                "R1",
                "structure:truncated",
                wav.UPLOAD_AGAIN,
            )
        self.at += 4
        return head[0] & 0x7F, bool(head[0] & 0x80), size

    def payload(self, size: int, most: int) -> bytes:
        return self.file.read(min(size, most))


def _from_info(
    info: bytes, names: tuple[str, ...], comments: dict[str, str], chunks: tuple[tuple[str, bytes], ...]
) -> FlacLayout:
    if len(info) != 34:
        raise _inconsistent(f"its STREAMINFO has {len(info)} bytes; 34 are wanted")
    packed = int.from_bytes(info[10:18], "big")
    rate, channels = packed >> 44, (packed >> 41 & 7) + 1
    bits, frames = (packed >> 36 & 31) + 1, packed & (1 << 36) - 1
    if not 1_000 <= rate <= 768_000:
        raise _inconsistent(f"it says a sample rate of {rate} Hz; 1,000 to 768,000 Hz is wanted")
    if bits not in DEPTHS:
        raise _inconsistent(f"it has {bits} bits; {', '.join(map(str, DEPTHS))} are wanted")
    if not frames:
        raise Unreadable(
            "the header leaves open how long the sound is, as a program does that writes to a pipe",
            "R11",
            "structure:stream-header",
            EXPORT_AGAIN,
        )
    layout = FlacLayout(rate, channels, bits, frames, info[18:34], names, comments, chunks, _mask(channels, comments))
    if layout.unpacked_bytes > MOST_UNPACKED_BYTES:
        announced, most = layout.unpacked_bytes >> 20, MOST_UNPACKED_BYTES >> 20
        raise _inconsistent(f"it announces {announced} MiB of samples; at most {most} MiB are read")
    return layout


def _mask(channels: int, comments: dict[str, str]) -> int | None:
    if channels <= 2:
        return None
    with suppress(KeyError, ValueError):
        declared = int(comments[MASK_COMMENT], 16)
        if 0 < declared < 1 << 32 and declared.bit_count() == channels:
            return declared
    return LAYOUTS[MASKS[channels]].masks[0] if channels in MASKS else None


def _comments(payload: bytes) -> dict[str, str]:
    """Return the comments of a VORBIS_COMMENT block that can be read."""
    comments: dict[str, str] = {}
    at = 4 + int.from_bytes(payload[:4], "little")
    count = int.from_bytes(payload[at : at + 4], "little")
    at += 4
    for _ in range(min(count, MOST_COMMENTS)):
        size = int.from_bytes(payload[at : at + 4], "little")
        entry = payload[at + 4 : at + 4 + size]
        if at + 4 > len(payload) or len(entry) < size:
            break
        name, equals, text = entry.decode("utf-8", "replace").partition("=")
        if equals and text and name.isascii() and name.isprintable():
            comments.setdefault(name.upper(), text)
        at += 4 + size
    return comments


def _riff_chunk(payload: bytes) -> list[tuple[str, bytes]]:
    """Return the chunk that an APPLICATION block of the kind "riff" keeps, where it is one that says something."""
    if payload[:4] != b"riff":
        return []
    name, size = payload[4:8].decode("latin-1"), int.from_bytes(payload[8:12], "little")
    chunk = payload[12 : 12 + size]
    return [(name, chunk)] if name in CHUNKS and len(chunk) == size <= MOST_BYTES else []


def _inconsistent(message: str) -> Unreadable:
    return Unreadable(f"the FLAC header is wrong: {message}", "R4", "structure:flac-header", EXPORT_AGAIN)


def opened_as_wav(path: str | os.PathLike[str]) -> io.FileIO:
    """Return a WAV file of the same sound, open for reading; it is deleted when it is closed.

    Raises
    ------
    Unreadable
        When the sound does not decode, not to the announced length, or not to the announced checksum.
    SandboxFailed
        When the child could not do its work, for want of time, memory or disk, or because the decoder broke:
        the tool's fault, as on a server, where the whole check runs in a child.
    """
    descriptor, unpacked = tempfile.mkstemp(prefix="audio-checks-", suffix=".wav")
    os.close(descriptor)
    try:
        if is_inside():
            unpack(os.fspath(path), unpacked)
        else:
            _unpack_in_child(os.fspath(path), unpacked)
        return SelfDeletingFile(unpacked)
    except BaseException:
        with suppress(FileNotFoundError):
            os.unlink(unpacked)
        raise


@cache
def _sandbox() -> Sandbox:
    return Sandbox(
        timeout_s=DECODE_S,
        file_bytes=MOST_UNPACKED_BYTES + (16 << 20),
        preload=("numpy", "soundfile", "audio_checks.audio.flac"),
    )


def _unpack_in_child(path: str, out: str) -> None:
    with _sandbox().child(reads=[path], writes=[out]) as child:
        child.call(unpack, os.path.abspath(path), out)


def unpack(path: str, out: str) -> None:
    """Write the sound of a FLAC file as WAV, with the metadata chunks it has kept. Runs in a sandbox's child.

    Raises
    ------
    Unreadable
        When the sound does not decode, not to the announced length, or not to the announced checksum.
    """
    with wav.open_regular(path) as file:
        layout = read_layout(file)
    with open(out, "wb") as target:
        wav.write_wav(
            target,
            _decoded(path, layout),
            sample_rate_hz=layout.sample_rate_hz,
            bit_depth=layout.bit_depth,
            channels=layout.channels,
            frames=layout.frames,
            channel_mask=layout.channel_mask,
            chunks_after=layout.riff_chunks,
        )


def _decoded(path: str, layout: FlacLayout) -> Iterator[NDArray[np.int64]]:
    """Yield the samples as whole numbers; refuse what is not what the header announced."""
    import soundfile  # slow to import, and only FLAC needs it

    digest, left = hashlib.md5(usedforsecurity=False), layout.frames
    dtype = "int16" if layout.bit_depth <= 16 else "int32"
    spare = np.dtype(dtype).itemsize * 8 - layout.bit_depth
    try:
        with soundfile.SoundFile(path) as sound:
            declared = (sound.samplerate, sound.channels, sound.frames)
            if sound.format != "FLAC" or declared != (layout.sample_rate_hz, layout.channels, layout.frames):
                raise _damaged("its frames and its header do not agree")
            while left:
                block = sound.read(min(BLOCK_FRAMES, left), dtype=dtype, always_2d=True).astype(np.int64) >> spare
                if not len(block):
                    raise _damaged(f"{left} of its {layout.frames} frames {verb(left, 'is', 'are')} missing")
                left -= len(block)
                digest.update(_signed_bytes(block, layout.bit_depth))
                yield block
    except soundfile.SoundFileError:
        # The decoder's own words name its functions, and differ from one version to the next.
        raise _damaged("it does not decode") from None
    if any(layout.md5) and digest.digest() != layout.md5:
        raise _damaged("its samples do not have the checksum that was packed with them")


def _damaged(why: str) -> Unreadable:
    return Unreadable(f"the FLAC file is damaged: {why}", "R1", "structure:flac-damaged", wav.UPLOAD_AGAIN)


def _signed_bytes(block: NDArray[np.int64], bits: int) -> bytes:
    raw = np.ascontiguousarray(block, "<i8").view(np.uint8).reshape(-1, 8)
    return raw[:, : bits // 8].tobytes()
