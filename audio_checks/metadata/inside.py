"""Cue points, regions and loops that lie in a stretch of a sound: those of the rest are left out of its chunks."""

from __future__ import annotations

import struct
from collections.abc import Mapping

CUE_BYTES, SAMPLER_BYTES, LOOP_BYTES = 24, 36, 24


def inside_only(name: str, payload: bytes, first: int, end: int, points: Mapping[int, int]) -> bytes:
    """Return a chunk's payload without what lies outside a stretch; empty where nothing is left of it.

    Parameters
    ----------
    name, payload : str, bytes
        Of the chunk; what does not point into the sound stays as it is.
    first, end : int
        From frame `first` up to, and without, frame `end`.
    points : mapping of int to int
        The frame of each cue point by its id.
    """
    if name == "cue ":
        return _cues(payload, first, end)
    if name == "LIST" and payload[:4] == b"adtl":
        return _labels(payload, {point for point, frame in points.items() if first <= frame < end})
    if name == "smpl" and len(payload) >= SAMPLER_BYTES:
        return _loops(payload, first, end)
    return payload


def _cues(payload: bytes, first: int, end: int) -> bytes:
    rows = _rows(payload, 4, _number(payload, 0), CUE_BYTES)
    cues = [cue for cue in rows if first <= _number(cue, 20) < end]
    return struct.pack("<I", len(cues)) + b"".join(cues) if cues else b""


def _labels(payload: bytes, inside: set[int]) -> bytes:
    entries: list[bytes] = []
    at = 4
    while at + 12 <= len(payload):
        size = _number(payload, at + 4)
        if _number(payload, at + 8) in inside:
            entries.append(payload[at : at + 8 + size + size % 2])
        at += 8 + size + size % 2
    return payload[:4] + b"".join(entries) if entries else b""


def _loops(payload: bytes, first: int, end: int) -> bytes:
    rows = _rows(payload, SAMPLER_BYTES, _number(payload, 28), LOOP_BYTES)
    loops = [loop for loop in rows if first <= _number(loop, 8) and _number(loop, 12) < end]
    head = payload[:28] + struct.pack("<I", len(loops)) + payload[32:SAMPLER_BYTES]
    return head + b"".join(loops) + payload[SAMPLER_BYTES + LOOP_BYTES * len(rows) :]


def _rows(payload: bytes, start: int, count: int, size: int) -> list[bytes]:
    stored = min(count, max(len(payload) - start, 0) // size)
    return [payload[at : at + size] for at in range(start, start + size * stored, size)]


def _number(content: bytes, at: int) -> int:
    return int.from_bytes(content[at : at + 4], "little")
