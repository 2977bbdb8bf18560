"""The chunks of a master, carried into a copy: trimmed, at another rate or depth, or of other channels.

What points into the sound is moved with it: cue points, regions, loops, sync points, and the time
of day at which the sound began. What was measured of the old samples is taken back: a reader of
the copy must not trust it. Everything else is carried as it is, byte for byte.
Sources: RIFF cue, smpl and adtl (Microsoft, Multimedia Programming Interface 1.0); acid (Sonic
Foundry, as other programs read it); EBU Tech 3285 v2 (bext); iXML 3.01; ASWG-G006.
"""

import re
import struct
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import BinaryIO

from audio_checks import wav
from audio_checks.metadata.inside import inside_only

REWRITTEN = frozenset({"fmt ", "data", "fact", "ds64"})  # written by the copy itself
STALE = frozenset({"PEAK", "levl"})  # peaks of the old samples, which programs draw or trust
MOST_BYTES = 64 << 20  # of all chunks together, which are held in memory
TIME_REFERENCE = 338  # in bext: frames since midnight, 64 bits
BEXT_VERSION, BEXT_LOUDNESS, BEXT_HISTORY = 346, 412, 602
UNSET = struct.pack("<5h", *[0x7FFF] * 5)  # of the loudness fields of bext version 2
ACID_TEMPO = 20

# Two halves of a 64-bit number of frames: since midnight, and from the start of the sound.
SINCE_MIDNIGHT = (
    (b"TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_LO", b"TIMESTAMP_SAMPLES_SINCE_MIDNIGHT_HI"),
    (b"BWF_TIME_REFERENCE_LOW", b"BWF_TIME_REFERENCE_HIGH"),
)
SYNC_POINT = (b"SYNC_POINT_LOW", b"SYNC_POINT_HIGH")
RATES = (b"FILE_SAMPLE_RATE", b"TIMESTAMP_SAMPLE_RATE")
MEASURED = (
    *(b"BWF_LOUDNESS_VALUE", b"BWF_LOUDNESS_RANGE", b"BWF_MAX_TRUE_PEAK_LEVEL"),
    *(b"BWF_MAX_MOMENTARY_LOUDNESS", b"BWF_MAX_SHORT_TERM_LOUDNESS"),
    *(b"rmsPower", b"loudness", b"loudnessRange", b"maxPeak", b"specDensity", b"zeroCrossRate", b"papr"),
)

Chunk = tuple[str, bytes]
Points = tuple[int, int]


@dataclass(frozen=True)
class Move:
    """The changes to the sound.

    Attributes
    ----------
    cut, frames : int
        Frames of the master cut from its start, and frames of the copy.
    changed : bool
        Whether samples have other values than before.
    new_depth : int or None
        The depth it is written at; None where that stays.
    sample_rate_hz, to_hz : int
        Rate of the master and of the copy; equal where it stays.
    new_channels : bool
        Whether channels were mixed.
    loops : mapping of (int, int) to (int, int)
        First and last frame of each loop, as they were and as they are, for loops fitted to whole frames.
    stretch : float
        How many times longer the sound became by that, 1 for all but fitted loops.
    history : str
        A line for the coding history of a broadcast wave.
    only_inside : bool
        Whether points, regions and loops outside the copy are left out; else they move to its nearer end. Only for
        copies at the master's rate.
    """

    cut: int
    frames: int
    changed: bool
    new_depth: int | None
    sample_rate_hz: int = 1
    to_hz: int = 1
    new_channels: bool = False
    loops: Mapping[Points, Points] = field(default_factory=dict)
    stretch: float = 1.0
    history: str = ""
    only_inside: bool = False

    @property
    def new_rate(self) -> bool:
        """Whether the copy has another rate."""
        return self.sample_rate_hz != self.to_hz

    def at_new_rate(self, frames: int) -> int:
        """Return a count of the master's frames in frames of the copy; half a frame rounds up."""
        return (2 * frames * self.to_hz + self.sample_rate_hz) // (2 * self.sample_rate_hz)

    def position(self, frame: int) -> int:
        """Return the position of a master's frame in the copy; removed frames map to the nearer end."""
        return min(self.at_new_rate(max(frame - self.cut, 0)), self.frames - 1)

    def length(self, frame: int, length: int) -> int:
        """Return the length left in the copy of a region of the master."""
        first, end = self.at_new_rate(max(frame - self.cut, 0)), self.at_new_rate(max(frame + length - self.cut, 0))
        return min(end, self.frames) - min(first, self.frames)

    def loop(self, start: int, end: int) -> Points:
        """Return first and last frame of a loop in the copy."""
        return self.loops.get((start, end), (self.position(start), self.position(end)))


def bytes_outside_data(layout: wav.WavLayout) -> int:
    """Return the number of bytes in a file besides its sound; above `MOST_BYTES` they are not carried."""
    return sum(chunk.size for chunk in layout.chunks if chunk.id not in REWRITTEN)


def carried(
    file: BinaryIO, layout: wav.WavLayout, move: Move, *, keep: Callable[[str, bytes], bool] | None = None
) -> tuple[list[Chunk], list[Chunk]]:
    """Return the chunks for a copy, those that stood before the sound and those after it.

    Parameters
    ----------
    file, layout : binary file, WavLayout
        The master. The caller has seen that `bytes_outside_data` it are no more than `MOST_BYTES`.
    move : Move
        What happens to its sound.
    keep : function of id and payload, optional
        Whether a chunk goes along; without it all do.
    """
    kept = [chunk for chunk in layout.chunks if chunk.id not in REWRITTEN]
    payloads = [(chunk, wav.chunk_payload(file, chunk)) for chunk in kept]
    points: dict[int, int] = {}
    before: list[Chunk] = []
    after: list[Chunk] = []
    for chunk, payload in payloads:
        if chunk.id == "cue ":
            points |= _points(payload)
    for chunk, whole in payloads:
        if (chunk.id in STALE and move.changed) or (keep is not None and not keep(chunk.id, whole)):
            continue
        payload = whole
        if move.only_inside:
            payload = inside_only(chunk.id, whole, move.cut, move.cut + move.frames, points)
        if whole and not payload:
            continue
        moved = _moved(chunk.id, payload, move, points)
        (before if chunk.offset < layout.data_offset else after).append((chunk.id, moved))
    return before, after


def sampler(rate_hz: int, loops: Sequence[tuple[int, int, int]], old: bytes = b"") -> bytes:
    """Return the payload of a `smpl` chunk with loops, each a kind, a first and a last frame.

    The other content of an old chunk stays.
    """
    head = old[:36] if len(old) >= 36 else struct.pack("<9I", 0, 0, 0, 60, 0, 0, 0, 0, 0)
    more = old[36 + 24 * min(_get(old, 28), (len(old) - 36) // 24) :] if len(old) >= 36 else b""
    head = head[:8] + struct.pack("<I", _period_ns(rate_hz)) + head[12:28] + struct.pack("<I", len(loops)) + head[32:]
    return head + b"".join(struct.pack("<6I", number, *loop, 0, 0) for number, loop in enumerate(loops)) + more


def _period_ns(rate_hz: int) -> int:
    return round(1e9 / rate_hz)


def _moved(name: str, payload: bytes, move: Move, points: dict[int, int]) -> bytes:
    movers: dict[str, Callable[[bytearray], None]] = {
        "cue ": lambda content: _move_cues(content, move),
        "smpl": lambda content: _move_loops(content, move),
        "bext": lambda content: _move_bext(content, move),
        "LIST": lambda content: _move_regions(content, move, points),
        "acid": lambda content: _move_tempo(content, move),
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
    stored = int.from_bytes(payload[:4], "little")
    return range(4, 4 + 24 * min(stored, (len(payload) - 4) // 24), 24) if len(payload) >= 4 else range(0)


def _move_cues(content: bytearray, move: Move) -> None:
    for at in _cue_offsets(content):
        for offset in (at + 4, at + 20):  # order of play, and frame: the same number where nothing is compressed
            _put(content, offset, move.position(_get(content, offset)))


def _move_loops(content: bytearray, move: Move) -> None:
    if len(content) < 36:
        return
    if move.new_rate:
        _put(content, 8, _period_ns(move.to_hz))
    for at in range(36, 36 + 24 * min(_get(content, 28), (len(content) - 36) // 24), 24):
        start, end = move.loop(_get(content, at + 8), _get(content, at + 12))
        _put(content, at + 8, start)
        _put(content, at + 12, end)


def _move_bext(content: bytearray, move: Move) -> None:
    if len(content) >= TIME_REFERENCE + 8:
        (began,) = struct.unpack_from("<Q", content, TIME_REFERENCE)
        struct.pack_into("<Q", content, TIME_REFERENCE, move.at_new_rate(began + move.cut) % (1 << 64))
    loudness_end = BEXT_LOUDNESS + len(UNSET)
    if move.changed and len(content) >= loudness_end and struct.unpack_from("<H", content, BEXT_VERSION)[0] >= 2:
        content[BEXT_LOUDNESS:loudness_end] = UNSET
    if move.history and len(content) >= BEXT_HISTORY:
        stored = bytes(content[BEXT_HISTORY:]).rstrip(b"\0")
        between = b"\r\n" if stored and not stored.endswith(b"\n") else b""
        content[BEXT_HISTORY:] = stored + between + move.history.encode("ascii") + b"\r\n"


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


def _move_tempo(content: bytearray, move: Move) -> None:
    if move.stretch != 1.0 and len(content) >= ACID_TEMPO + 4:
        (tempo,) = struct.unpack_from("<f", content, ACID_TEMPO)
        struct.pack_into("<f", content, ACID_TEMPO, tempo / move.stretch)


def _moved_ixml(payload: bytes, move: Move) -> bytes:
    """Move places and times, update rate and depth, drop measured values; keep the rest."""
    if move.cut or move.new_rate:
        for low, high in SINCE_MIDNIGHT:
            payload = _with_moved_frames(payload, low, high, lambda began: move.at_new_rate(began + move.cut))
        payload = _with_moved_frames(payload, *SYNC_POINT, move.position)
    if move.new_rate:
        for tag in RATES:
            payload = _with_ixml_number(payload, tag, move.to_hz)
    if move.changed:
        payload = re.sub(rb"<(%b)>[^<]*</\1>" % b"|".join(MEASURED), b"", payload)
    if move.new_channels:  # which track was which recorder's input is true no more
        before, _, rest = payload.partition(b"<TRACK_LIST>")
        _, closed, after = rest.partition(b"</TRACK_LIST>")
        payload = before + after if closed else payload
    return payload if move.new_depth is None else _with_ixml_number(payload, b"AUDIO_BIT_DEPTH", move.new_depth)


def _with_moved_frames(payload: bytes, low: bytes, high: bytes, moved: Callable[[int], int]) -> bytes:
    """Return the document with each pair of 32-bit halves rewritten, in order."""
    lows, highs = _ixml_numbers(payload, low), _ixml_numbers(payload, high)
    if not lows:
        return payload
    highs += [0] * (len(lows) - len(highs))
    whole = [moved(low_word + (other << 32)) for low_word, other in zip(lows, highs, strict=False)]
    payload = _with_ixml_numbers(payload, low, [number & 0xFFFFFFFF for number in whole])
    return _with_ixml_numbers(payload, high, [number >> 32 & 0xFFFFFFFF for number in whole])


def _ixml_numbers(payload: bytes, tag: bytes) -> list[int]:
    return [int(match[1]) for match in re.finditer(rb"<%b>\s*([0-9]{1,20})\s*</%b>" % (tag, tag), payload)]


def _with_ixml_numbers(payload: bytes, tag: bytes, numbers: list[int]) -> bytes:
    left = iter(numbers)
    element = rb"(<%b>)\s*([0-9]{1,20})\s*(</%b>)" % (tag, tag)
    return re.sub(element, lambda match: b"%b%d%b" % (match[1], next(left, int(match[2])), match[3]), payload)


def _with_ixml_number(payload: bytes, tag: bytes, number: int) -> bytes:
    return re.sub(rb"(<%b>)\s*[0-9]{1,20}\s*(</%b>)" % (tag, tag), rb"\g<1>%d\g<2>" % number, payload)


def _get(content: bytes | bytearray, at: int) -> int:
    return int(struct.unpack_from("<I", content, at)[0])


def _put(content: bytearray, at: int, value: int) -> None:
    struct.pack_into("<I", content, at, value)
