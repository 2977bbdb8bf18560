"""Signals and WAV files for tests, made from scratch so that nothing under test makes its own evidence."""

from __future__ import annotations

import struct
from collections.abc import Iterable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

PCM_GUID = bytes.fromhex("0100000000001000800000aa00389b71")
FLOAT_GUID = bytes.fromhex("0300000000001000800000aa00389b71")
Samples = NDArray[np.float64]


def sine(
    *,
    hz: float,
    dbfs: float = -6.0,
    seconds: float = 1.0,
    rate: int = 48_000,
    channels: int = 1,
    phase: float = 0.0,
) -> Samples:
    """A steady tone whose crest is at `dbfs`, shape (frames, channels), the same in every channel."""
    times = np.arange(round(seconds * rate)) / rate
    tone = 10 ** (dbfs / 20) * np.sin(2 * np.pi * hz * times + phase)
    return np.repeat(tone[:, np.newaxis], channels, axis=1)


def noise(
    *, dbfs: float = -20.0, seconds: float = 1.0, rate: int = 48_000, channels: int = 1, seed: int = 1
) -> Samples:
    """White Gaussian noise with an RMS of `dbfs`, independent in every channel."""
    draws = np.random.default_rng(seed).standard_normal((round(seconds * rate), channels))
    return draws * 10 ** (dbfs / 20)


def silence(*, seconds: float = 1.0, rate: int = 48_000, channels: int = 1) -> Samples:
    """Digital silence."""
    return np.zeros((round(seconds * rate), channels))


def click(
    *, at_s: float = 0.5, dbfs: float = -6.0, seconds: float = 1.0, rate: int = 48_000, channels: int = 1
) -> Samples:
    """One sample at `dbfs` in silence."""
    samples = silence(seconds=seconds, rate=rate, channels=channels)
    samples[round(at_s * rate)] = 10 ** (dbfs / 20)
    return samples


def swelling(samples: Samples, frames: int = 480) -> Samples:
    """The sound with a straight rise and fall, so that nothing of it stands out where it begins and ends."""
    rise = np.minimum(1.0, (np.arange(len(samples)) + 1) / frames)
    return samples * (rise * rise[::-1])[:, np.newaxis]


def join(*parts: Samples) -> Samples:
    """The parts one after the other."""
    return np.concatenate(parts)


def pcm_bytes(samples: Samples, bits: int = 24) -> bytes:
    """Interleaved little-endian PCM, rounded without dither and held within the range of `bits`."""
    scale = 2 ** (bits - 1)
    whole = np.clip(np.rint(np.asarray(samples) * scale), -scale, scale - 1).astype("<i4")
    if bits == 8:
        return (whole + 128).astype(np.uint8).tobytes()
    if bits == 16:
        return whole.astype("<i2").tobytes()
    if bits == 24:
        return np.ascontiguousarray(whole).view(np.uint8).reshape(-1, 4)[:, :3].tobytes()
    return whole.tobytes()


def float_bytes(samples: Samples, bits: int = 32) -> bytes:
    """Interleaved little-endian IEEE float."""
    return np.asarray(samples).astype(f"<f{bits // 8}").tobytes()


def chunk(name: bytes, payload: bytes, *, size: int | None = None, pad: bool = True) -> bytes:
    """One RIFF chunk; `size` lies about its length, `pad=False` leaves out the pad byte."""
    reported = len(payload) if size is None else size
    return name + struct.pack("<I", reported) + payload + (b"\0" if pad and len(payload) % 2 else b"")


def fmt(
    *,
    tag: int = 1,
    channels: int = 1,
    rate: int = 48_000,
    bits: int = 16,
    byte_rate: int | None = None,
    block_align: int | None = None,
    extra: bytes = b"",
) -> bytes:
    """The payload of a `fmt ` chunk; what is not given is right."""
    align = channels * ((bits + 7) // 8) if block_align is None else block_align
    flow = rate * align if byte_rate is None else byte_rate
    return struct.pack("<HHIIHH", tag, channels, rate, flow & 0xFFFFFFFF, align, bits) + extra


def extensible(
    *,
    channels: int = 1,
    rate: int = 48_000,
    container_bits: int = 32,
    valid_bits: int = 24,
    mask: int = 0,
    guid: bytes = PCM_GUID,
) -> bytes:
    """The payload of an extensible `fmt ` chunk."""
    extra = struct.pack("<HHI", 22, valid_bits, mask) + guid
    return fmt(tag=0xFFFE, channels=channels, rate=rate, bits=container_bits, extra=extra)


def riff(*chunks: bytes, size: int | None = None, magic: bytes = b"RIFF", form: bytes = b"WAVE") -> bytes:
    """A RIFF file of chunks made by `chunk`; `size` lies about its length."""
    body = form + b"".join(chunks)
    return magic + struct.pack("<I", len(body) if size is None else size) + body


def wav_bytes(
    samples: Samples,
    *,
    rate: int = 48_000,
    bits: int = 24,
    encoding: str = "pcm",
    before: Iterable[bytes] = (),
    after: Iterable[bytes] = (),
) -> bytes:
    """A plain, right WAV file; `before` and `after` are whole chunks around `data`."""
    samples = np.asarray(samples, dtype=np.float64)
    if samples.ndim == 1:
        samples = samples[:, np.newaxis]
    payload = pcm_bytes(samples, bits) if encoding == "pcm" else float_bytes(samples, bits)
    header = fmt(tag=1 if encoding == "pcm" else 3, channels=samples.shape[1], rate=rate, bits=bits)
    return riff(chunk(b"fmt ", header), *before, chunk(b"data", payload), *after)


def write_wav(
    path: Path,
    samples: Samples,
    *,
    rate: int = 48_000,
    bits: int = 24,
    encoding: str = "pcm",
    before: Iterable[bytes] = (),
    after: Iterable[bytes] = (),
) -> Path:
    """Write `wav_bytes` to `path`, and return the path."""
    path.write_bytes(wav_bytes(samples, rate=rate, bits=bits, encoding=encoding, before=before, after=after))
    return path


def smpl(loops: Iterable[tuple[int, int]], *, rate: int = 48_000) -> bytes:
    """A whole `smpl` chunk with forward loops from start to end, the end included."""
    loops = list(loops)
    head = struct.pack("<9I", 0, 0, round(1e9 / rate), 60, 0, 0, 0, len(loops), 0)
    body = b"".join(struct.pack("<6I", number, 0, start, end, 0, 0) for number, (start, end) in enumerate(loops))
    return chunk(b"smpl", head + body)


def placeholder_mark(number: str) -> bytes:
    """A LIST/INFO chunk that marks a placeholder for the cue `number`."""
    text = f"SOUNDLIST:PLACEHOLDER {number}".encode() + b"\0"
    return chunk(b"LIST", b"INFO" + chunk(b"ICMT", text))


def write_large(path: Path, data_bytes: int) -> Path:
    """Write an RF64 file of 48 kHz/24 bit stereo that takes no room on the disk: silence, but for its first second."""
    data_bytes -= data_bytes % 6
    sound = pcm_bytes(noise(channels=2))
    ds64 = struct.pack("<QQQI", data_bytes + 72, data_bytes, 0, 0)
    chunks = chunk(b"ds64", ds64) + chunk(b"fmt ", fmt(channels=2, bits=24)) + b"data" + b"\xff" * 4
    with open(path, "wb") as file:
        file.write(b"RF64" + b"\xff" * 4 + b"WAVE" + chunks + sound)
        file.truncate(12 + len(chunks) + data_bytes)
    return path
