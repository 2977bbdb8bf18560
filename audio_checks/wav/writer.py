"""A writer of WAV files whose headers are right, and whole or absent."""

from __future__ import annotations

import os
import secrets
import struct
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import BinaryIO, Literal

import numpy as np
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.wav.decoding import raw_blocks
from audio_checks.wav.files import chunk_payload
from audio_checks.wav.layout import EXTENSIBLE, FLOAT, GUID_TAIL, PCM, STREAM_SIZE, WavLayout, stretch_of


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
    durable: bool = True,
) -> None:
    """Write a WAV file whose header is right; RF64 where it would pass 4 GiB, extensible where it must be.

    Parameters
    ----------
    target : path or binary file
        A path is written next to its final name, synced and renamed, so it is whole or absent.
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
    durable : bool
        A path is on the disk before this returns; without, after a power cut it may be cut short.

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
            if durable:
                file.flush()
                os.fsync(file.fileno())
        os.replace(temporary, path)
    except BaseException:
        temporary.unlink(missing_ok=True)
        raise
    if durable:
        _sync_directory(path.parent)


def copy_wav(file: BinaryIO, layout: WavLayout, target: str | os.PathLike[str], chunks: Mapping[str, bytes]) -> None:
    """Write a copy of a WAV file, its sound byte for byte, whose chunks say something else.

    Parameters
    ----------
    file, layout : binary file, WavLayout
        What is copied.
    target : path
        Written next to its final name, synced and renamed, so it is whole or absent.
    chunks : mapping of str to bytes
        New payloads by id: of the first chunk of that id, or of a new one. A new one is placed before the
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
    _copy_sound(file, layout, target, b"".join(before), b"".join(after))


def copy_stretch(
    file: BinaryIO,
    layout: WavLayout,
    target: str | os.PathLike[str],
    first: int,
    end: int,
    *,
    chunks: Sequence[tuple[str, bytes]] = (),
    chunks_after: Sequence[tuple[str, bytes]] = (),
) -> None:
    """Write a stretch of a WAV file as a file of the same format, its sound byte for byte.

    Parameters
    ----------
    file, layout : binary file, WavLayout
        What is copied.
    target : path
        Written next to its final name, synced and renamed, so it is whole or absent.
    first, end : int
        From frame `first` up to, and without, frame `end`, which lie inside the sound.
    chunks, chunks_after : sequence of (id, payload)
        Further chunks before and after `data`.
    """
    inside = stretch_of(layout, first, end)
    formats = [chunk_payload(file, chunk) for chunk in layout.chunks if chunk.id == "fmt "]
    head = b"".join(_chunk("fmt ", payload) for payload in formats)
    if any(chunk.id == "fact" for chunk in layout.chunks):
        head += _chunk("fact", struct.pack("<I", min(inside.frames, STREAM_SIZE)))
    head += b"".join(_chunk(name, payload) for name, payload in chunks)
    after = b"".join(_chunk(name, payload) for name, payload in chunks_after)
    _copy_sound(file, inside, target, head, after)


def _copy_sound(file: BinaryIO, layout: WavLayout, target: str | os.PathLike[str], before: bytes, after: bytes) -> None:
    head = _opened(before, layout.data_size, layout.frames, len(after))
    path = Path(target)
    temporary = path.parent / f".wav-{secrets.token_hex(8)}.part"
    try:
        with open(temporary, "xb") as copy:
            _write_all(copy, head, raw_blocks(file, layout), b"\0" * (layout.data_size % 2) + after)
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


def _write_all(file: BinaryIO, header: bytes, coded: Iterable[bytes | bytearray], tail: bytes) -> None:
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
) -> Iterator[bytes | bytearray]:
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
        raw = bytearray(block.size * ((bits + 7) // 8))
        if not kernel.encode_pcm(np.ascontiguousarray(block.T, dtype=np.int64), channels, bits, raw):
            raise ValueError(f"samples beyond the range of {bits} bits")
        yield raw
    if written != frames:
        raise ValueError(f"{frames} frames were announced, {written} came")
