"""FLAC files: packed by libFLAC, their headers rewritten from the format's own definition."""

from __future__ import annotations

import io
import struct
from collections.abc import Iterable, Mapping

import numpy as np
import soundfile

from tests.support import chunks
from tests.support.mutants import damaged
from tests.support.waves import Samples, noise, smpl

SUBTYPES = {8: "PCM_S8", 16: "PCM_16", 24: "PCM_24"}


def flac_bytes(samples: Samples, *, rate: int = 48_000, bits: int = 24, blocks: Iterable[bytes] = ()) -> bytes:
    """A right FLAC file of samples that are whole steps of its depth, with further metadata blocks."""
    samples = np.asarray(samples, dtype=np.float64)
    if samples.ndim == 1:
        samples = samples[:, np.newaxis]
    scale = 2 ** (bits - 1)
    whole = np.clip(np.rint(samples * scale), -scale, scale - 1).astype(np.int64) << (32 - bits)
    file = io.BytesIO()
    soundfile.write(file, whole.astype(np.int32), rate, format="FLAC", subtype=SUBTYPES[bits])
    content = file.getvalue()
    return with_blocks(content, blocks) if blocks else content


def block(kind: int, payload: bytes, *, last: bool = False) -> bytes:
    """One metadata block."""
    return bytes([kind | (0x80 if last else 0)]) + len(payload).to_bytes(3, "big") + payload


def comments(texts: Mapping[str, str]) -> bytes:
    """A VORBIS_COMMENT block."""
    entries = [f"{name}={text}".encode() for name, text in texts.items()]
    body = struct.pack("<I", 4) + b"test" + struct.pack("<I", len(entries))
    return block(4, body + b"".join(struct.pack("<I", len(entry)) + entry for entry in entries))


def riff(chunk: bytes) -> bytes:
    """An APPLICATION block that keeps a chunk of the WAV a file was packed from."""
    return block(2, b"riff" + chunk)


def split(content: bytes) -> tuple[bytes, bytes]:
    """The 34 bytes of STREAMINFO, and the frames."""
    at = 4
    while True:
        head = content[at]
        size = int.from_bytes(content[at + 1 : at + 4], "big")
        at += 4 + size
        if head & 0x80:
            return content[8:42], content[at:]


def with_blocks(content: bytes, blocks: Iterable[bytes]) -> bytes:
    """A FLAC file whose blocks after STREAMINFO are these, and an empty PADDING."""
    info, frames = split(content)
    return b"fLaC" + block(0, info) + b"".join(blocks) + block(1, b"", last=True) + frames


def with_info(
    content: bytes,
    *,
    rate: int | None = None,
    bits: int | None = None,
    frames: int | None = None,
    md5: bytes | None = None,
) -> bytes:
    """A FLAC file whose STREAMINFO says something else."""
    info, sound = split(content)
    packed = int.from_bytes(info[10:18], "big")
    fields = [packed >> 44, packed >> 41 & 7, packed >> 36 & 31, packed & (1 << 36) - 1]
    for place, reported in ((0, rate), (2, None if bits is None else bits - 1), (3, frames)):
        if reported is not None:
            fields[place] = reported
    packed = fields[0] << 44 | fields[1] << 41 | fields[2] << 36 | fields[3]
    info = info[:10] + packed.to_bytes(8, "big") + (info[18:] if md5 is None else md5)
    return b"fLaC" + block(0, info, last=True) + sound


def flac_mutant(rng: np.random.Generator) -> bytes:
    """A FLAC file with metadata in it, with one to three damages."""
    return damaged(rng, SEEDS[rng.integers(len(SEEDS))])


SEEDS = [
    flac_bytes(
        noise(seconds=0.01, channels=2),
        blocks=[comments({"TITLE": "Laser"}), riff(chunks.bext(originator="Mara Lind")), riff(smpl([(3, 99)]))],
    ),
    flac_bytes(noise(seconds=0.01), bits=16),
    flac_bytes(noise(seconds=0.005, channels=6), bits=8),
]
