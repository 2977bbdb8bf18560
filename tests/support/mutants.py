"""WAV files of every kind, and damaged copies of them."""

from __future__ import annotations

import struct

import numpy as np

from tests.support.chunks import bext, cue, info, inst, ixml, labels
from tests.support.waves import chunk, extensible, fmt, noise, pcm_bytes, riff, sine, smpl, wav_bytes

SOUND = pcm_bytes(sine(hz=440, seconds=0.01), 16)  # 480 frames, 960 bytes
FMT = chunk(b"fmt ", fmt())
DATA = chunk(b"data", SOUND)
GOOD = riff(FMT, DATA)


def ds64(riff_size: int, data_size: int, frames: int, entries: int = 0) -> bytes:
    """A whole `ds64` chunk without its table."""
    return chunk(b"ds64", struct.pack("<QQQI", riff_size, data_size, frames, entries))


def rf64(data_size: int = 960, frames: int = 480, riff_size: int | None = None, entries: int = 0) -> bytes:
    """An RF64 file of SOUND; what is given lies."""
    size = 4 + 36 + len(FMT) + len(DATA) if riff_size is None else riff_size
    data = b"data\xff\xff\xff\xff" + SOUND
    return riff(ds64(size, data_size, frames, entries), FMT, data, magic=b"RF64", size=0xFFFFFFFF)


SEEDS = [
    GOOD,
    wav_bytes(noise(seconds=0.005, channels=2), bits=24, before=[chunk(b"bext", bytes(99))], after=[smpl([(3, 99)])]),
    wav_bytes(noise(seconds=0.005), bits=32, encoding="float", after=[chunk(b"LIST", b"INFO" + chunk(b"ICMT", b"x"))]),
    riff(chunk(b"fmt ", extensible(channels=2)), chunk(b"data", pcm_bytes(noise(seconds=0.005, channels=2), 32))),
    rf64(),
    wav_bytes(noise(seconds=0.005), bits=8),
    wav_bytes(
        noise(seconds=0.005),
        bits=16,
        before=[
            bext(originator="Mara Lind"),
            ixml("<PROJECT>Shield Wing</PROJECT><ASWG><catId>GUNAuto</catId></ASWG>"),
            info(ICMT="layered"),
            labels({1: "hit"}),
            cue({1: 48}),
            inst(),
        ],
    ),
]
EXTREMES = [0, 1, 7, 8, 0x7F, 0x80, 0xFF, 0x7FFF, 0x8000, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFE, 0xFFFFFFFF]


def mutant(rng: np.random.Generator) -> bytes:
    """A seed with one to three damages, most of them near its start."""
    return damaged(rng, SEEDS[rng.integers(len(SEEDS))])


def damaged(rng: np.random.Generator, whole: bytes) -> bytes:
    """A copy with one to three damages, most of them near its start."""
    content = bytearray(whole)
    for _ in range(rng.integers(1, 4)):
        near = int(rng.integers(min(120, len(content)) if rng.random() < 0.8 else len(content)))
        match rng.integers(6):
            case 0:
                content[near] = rng.integers(256)
            case 1:
                extreme = EXTREMES[rng.integers(len(EXTREMES))]
                width = int(rng.choice([1, 2, 4]))
                content[near : near + width] = (extreme & (1 << 8 * width) - 1).to_bytes(width, "little")
            case 2:
                del content[near : near + int(rng.integers(1, 64))]
            case 3:
                content[near:near] = rng.bytes(int(rng.integers(1, 32)))
            case 4:
                content[near:near] = content[12 : 12 + int(rng.integers(8, 60))]
            case _:
                del content[max(near, 1) :]
        if not content:
            content = bytearray(b"R")
    return bytes(content)
