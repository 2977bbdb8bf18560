"""The `LIST` chunks: INFO (what the sound is) and adtl (what its cue points are called).

Source: Multimedia Programming Interface and Data Specifications 1.0, chapters 2 and 3.
"""

from __future__ import annotations

import struct
from collections.abc import Iterator

from audio_checks.metadata.text import text_of

MOST_ENTRIES = 4_096


def read_info(payload: bytes) -> dict[str, str]:
    """Return the texts of a LIST/INFO chunk by their ids, as in `ICMT`; empty for another kind of list.

    Raises
    ------
    ValueError
        An entry reaches beyond the chunk, or there are too many.
    """
    if payload[:4] != b"INFO":
        return {}
    texts = {name.decode("latin-1"): text_of(entry) for name, entry in _entries(payload)}
    return {name: text for name, text in texts.items() if text}


def read_labels(payload: bytes) -> dict[int, str]:
    """Return the labels of a LIST/adtl chunk by the cue point they are for; empty for another kind of list.

    A note is used where a cue point has no label.

    Raises
    ------
    ValueError
        An entry reaches beyond the chunk, or there are too many.
    """
    labels: dict[int, str] = {}
    notes: dict[int, str] = {}
    if payload[:4] != b"adtl":
        return {}
    for name, entry in _entries(payload):
        if name in (b"labl", b"note") and len(entry) >= 4:
            (point,) = struct.unpack_from("<I", entry)
            (labels if name == b"labl" else notes).setdefault(point, text_of(entry[4:]))
    return notes | labels


def read_lengths(payload: bytes) -> dict[int, int]:
    """Return the lengths in frames of the regions of a LIST/adtl chunk by their cue points; empty for another list.

    Raises
    ------
    ValueError
        An entry reaches beyond the chunk, or there are too many.
    """
    if payload[:4] != b"adtl":
        return {}
    regions = (struct.unpack_from("<2I", entry) for name, entry in _entries(payload) if _is_region(name, entry))
    return {point: frames for point, frames in regions if frames}


def _is_region(name: bytes, entry: bytes) -> bool:
    return name == b"ltxt" and len(entry) >= 8


def _entries(payload: bytes) -> Iterator[tuple[bytes, bytes]]:
    kind = payload[:4].decode("latin-1")
    at, count = 4, 0
    while at + 8 <= len(payload) and any(payload[at : at + 4]):  # zeros pad some lists
        name, size = payload[at : at + 4], int.from_bytes(payload[at + 4 : at + 8], "little")
        if not all(0x20 <= byte < 0x7F for byte in name) or at + 8 + size > len(payload):
            raise ValueError(f'an entry of the "LIST" chunk of the kind {kind} reaches beyond the chunk')
        count += 1
        if count > MOST_ENTRIES:
            raise ValueError(f'the "LIST" chunk of the kind {kind} has more than {MOST_ENTRIES} entries')
        yield name, payload[at + 8 : at + 8 + size]
        at += 8 + size + size % 2
