"""The chunks of a master, carried into a copy whose sound begins later or ends earlier.

What points into the sound is moved with it: cue points, regions, loops, and the time of day at
which the sound began. What was measured of the old samples is taken back: a reader of the copy
must not trust it. Everything else is carried as it is, byte for byte.
Sources: RIFF cue, smpl and adtl (Microsoft, Multimedia Programming Interface 1.0); EBU Tech 3285
v2 (bext); iXML 3.01.
"""

import re
import struct
from collections.abc import Callable
from dataclasses import dataclass
from typing import BinaryIO

from audio_checks import wav
from audio_checks.errors import MendRefused

OF_THE_SOUND = frozenset({"fmt ", "data", "fact", "ds64"})  # written anew
STALE = frozenset({"PEAK", "levl"})  # peaks of the old samples, which programs draw or trust
MOST_BYTES = 64 << 20  # of all chunks together, which are held in memory
TIME_REFERENCE = 338  # in bext: frames since midnight, 64 bits
BEXT_VERSION, BEXT_LOUDNESS = 346, 412
UNSET = struct.pack("<5h", *[0x7FFF] * 5)  # of the loudness fields of bext version 2


@dataclass(frozen=True)
class Move:
    """What becomes of the sound.

    Attributes
    ----------
    cut, frames : int
        Frames cut from its start, and frames that stay.
    changed : bool
        Whether samples have other values than before.
    new_depth : int or None
        The depth it is written at; None where that stays.
    """

    cut: int
    frames: int
    changed: bool
    new_depth: int | None

    def position(self, frame: int) -> int:
        """Return where a frame of the master lies in the copy; what was cut away lies at the nearer end."""
        return min(max(frame - self.cut, 0), self.frames - 1)

    def length(self, frame: int, length: int) -> int:
        """Return how much of a region of the master is left in the copy."""
        first = min(max(frame - self.cut, 0), self.frames)
        end = min(max(frame + length - self.cut, 0), self.frames)
        return end - first


Chunk = tuple[str, bytes]


def carried(file: BinaryIO, layout: wav.WavLayout, move: Move) -> tuple[list[Chunk], list[Chunk]]:
    """Return the chunks for a copy, those that stood before the sound and those after it.

    Raises
    ------
    MendRefused
        `mend:large-chunks`: they are more than can be held.
    """
    kept = [chunk for chunk in layout.chunks if chunk.id not in OF_THE_SOUND]
    total = sum(chunk.size for chunk in kept)
    if total > MOST_BYTES:
        raise MendRefused(
            f"the file carries {total >> 20} MiB beside its sound; a mend carries {MOST_BYTES >> 20} MiB at most",
            code="mend:large-chunks",
            fix="mend it in the session, or leave out what the file need not carry",
        )
    points: dict[int, int] = {}
    before: list[Chunk] = []
    after: list[Chunk] = []
    payloads = [(chunk, wav.chunk_payload(file, chunk)) for chunk in kept]
    for chunk, payload in payloads:
        if chunk.id == "cue ":
            points |= _points(payload)
    for chunk, payload in payloads:
        if chunk.id in STALE and move.changed:
            continue
        moved = _moved(chunk.id, payload, move, points)
        (before if chunk.offset < layout.data_offset else after).append((chunk.id, moved))
    return before, after


def _moved(name: str, payload: bytes, move: Move, points: dict[int, int]) -> bytes:
    movers: dict[str, Callable[[bytearray], None]] = {
        "cue ": lambda content: _move_cues(content, move),
        "smpl": lambda content: _move_loops(content, move),
        "bext": lambda content: _move_bext(content, move),
        "LIST": lambda content: _move_regions(content, move, points),
    }
    if name == "iXML":
        return _moved_ixml(payload, move)
    if name not in movers:
        return payload
    content = bytearray(payload)
    movers[name](content)
    return bytes(content)


def _points(payload: bytes) -> dict[int, int]:
    """Return the frame of each cue point by its id."""
    return {
        struct.unpack_from("<I", payload, at)[0]: struct.unpack_from("<I", payload, at + 20)[0]
        for at in _cue_offsets(payload)
    }


def _cue_offsets(payload: bytes | bytearray) -> range:
    told = int.from_bytes(payload[:4], "little")
    return range(4, 4 + 24 * min(told, (len(payload) - 4) // 24), 24) if len(payload) >= 4 else range(0)


def _move_cues(content: bytearray, move: Move) -> None:
    for at in _cue_offsets(content):
        for field in (at + 4, at + 20):  # order of play, and frame: the same number where nothing is compressed
            _put(content, field, move.position(_get(content, field)))


def _move_loops(content: bytearray, move: Move) -> None:
    if len(content) < 36:
        return
    for at in range(36, 36 + 24 * min(_get(content, 28), (len(content) - 36) // 24), 24):
        _put(content, at + 8, move.position(_get(content, at + 8)))
        _put(content, at + 12, move.position(_get(content, at + 12)))


def _move_bext(content: bytearray, move: Move) -> None:
    if len(content) >= TIME_REFERENCE + 8:
        (began,) = struct.unpack_from("<Q", content, TIME_REFERENCE)
        struct.pack_into("<Q", content, TIME_REFERENCE, (began + move.cut) % (1 << 64))
    loudness_end = BEXT_LOUDNESS + len(UNSET)
    if move.changed and len(content) >= loudness_end and struct.unpack_from("<H", content, BEXT_VERSION)[0] >= 2:
        content[BEXT_LOUDNESS:loudness_end] = UNSET


def _move_regions(content: bytearray, move: Move, points: dict[int, int]) -> None:
    if content[:4] != b"adtl":
        return
    at = 4
    while at + 8 <= len(content):
        size = _get(content, at + 4)
        if content[at : at + 4] == b"ltxt" and size >= 8 and at + 16 <= len(content):
            first = points.get(_get(content, at + 8), 0)
            _put(content, at + 12, move.length(first, _get(content, at + 12)))
        at += 8 + size + size % 2


def _moved_ixml(payload: bytes, move: Move) -> bytes:
    """Move the two stamps that tell when the sound began, and tell the new depth; leave every other byte alone."""
    if move.cut:
        for low, high in (
            (b"TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO", b"TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI"),
            (b"BWF_TIME_REFERENCE_LOW", b"BWF_TIME_REFERENCE_HIGH"),
        ):
            began = _ixml_number(payload, low)
            if began is None:
                continue
            began += ((_ixml_number(payload, high) or 0) << 32) + move.cut
            payload = _with_ixml_number(payload, low, began & 0xFFFFFFFF)
            payload = _with_ixml_number(payload, high, began >> 32 & 0xFFFFFFFF)
    return payload if move.new_depth is None else _with_ixml_number(payload, b"AUDIO_BIT_DEPTH", move.new_depth)


def _ixml_number(payload: bytes, tag: bytes) -> int | None:
    found = re.search(rb"<%b>\s*([0-9]{1,20})\s*</%b>" % (tag, tag), payload)
    return int(found[1]) if found else None


def _with_ixml_number(payload: bytes, tag: bytes, number: int) -> bytes:
    return re.sub(rb"(<%b>)\s*[0-9]{1,20}\s*(</%b>)" % (tag, tag), rb"\g<1>%d\g<2>" % number, payload)


def _get(content: bytes | bytearray, at: int) -> int:
    return int(struct.unpack_from("<I", content, at)[0])


def _put(content: bytearray, at: int, value: int) -> None:
    struct.pack_into("<I", content, at, value)
