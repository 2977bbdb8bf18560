"""Reads the loops of a `smpl` chunk; a damaged chunk is a warning, never a refusal."""

from __future__ import annotations

import struct
from typing import Literal, NamedTuple

from audio_checks.system.plural import counted
from audio_checks.wav.header_warnings import EXPORT_AGAIN
from audio_checks.wav.layout import SampleLoop, StructureWarning

HEADER_BYTES, LOOP_BYTES, MAX_LOOPS = 36, 24, 1_024
MOST_BYTES = HEADER_BYTES + LOOP_BYTES * MAX_LOOPS
KINDS: tuple[Literal["forward", "alternating", "backward"], ...] = ("forward", "alternating", "backward")


class Loops(NamedTuple):
    """The loops inside the sound, those that reach outside, and what is odd about the chunk."""

    inside: tuple[SampleLoop, ...]
    outside: tuple[SampleLoop, ...]
    warnings: tuple[StructureWarning, ...]


def read_loops(content: bytes, size: int, frames: int) -> Loops:
    """Return the loops of a `smpl` chunk.

    Parameters
    ----------
    content : bytes
        The first `MOST_BYTES` of the chunk, or all of a shorter one.
    size : int
        The size of the chunk, in bytes.
    frames : int
        Of the sound.
    """
    if len(content) < HEADER_BYTES:
        return Loops((), (), (_warning(f'the "smpl" chunk has {size} bytes; {HEADER_BYTES} or more are wanted'),))
    (count,) = struct.unpack("<I", content[28:32])
    held = (len(content) - HEADER_BYTES) // LOOP_BYTES
    inside: list[SampleLoop] = []
    outside: list[SampleLoop] = []
    warnings: list[StructureWarning] = []
    for number in range(min(count, held)):
        kind, start, end = struct.unpack("<III", content[HEADER_BYTES + LOOP_BYTES * number + 4 :][:12])
        if start > end:
            warnings.append(_warning(f"loop {number + 1} runs backwards, from frame {start} to {end}"))
            continue
        loop = SampleLoop(start, end, KINDS[kind] if kind < len(KINDS) else "other")
        (inside if end < frames else outside).append(loop)
    if count > held:
        warnings.append(_warning(f'the "smpl" chunk announces {counted(count, "loop")}, more than it holds'))
    return Loops(tuple(inside), tuple(outside), tuple(warnings))


def _warning(message: str) -> StructureWarning:
    return StructureWarning("structure:smpl", message, EXPORT_AGAIN)
