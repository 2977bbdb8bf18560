"""Chunks beside the sound, made from their standards: bext, iXML, LIST, cue and inst."""

from __future__ import annotations

import struct
from collections.abc import Mapping

from tests.support.waves import chunk


def bext_payload(
    *,
    description: str = "",
    originator: str = "",
    reference: str = "",
    date: str = "2026-11-21",
    time: str = "14:05:00",
    time_reference: int = 0,
    version: int = 2,
    umid: bytes = b"",
    levels: tuple[int, int, int, int, int] = (0x7FFF,) * 5,
    history: str = "",
) -> bytes:
    """The payload of a bext chunk; what is not given is empty."""
    texts = ((description, 256), (originator, 32), (reference, 32), (date, 10), (time, 8))
    fixed = b"".join(text.encode().ljust(width, b"\0") for text, width in texts)
    return (
        fixed
        + struct.pack("<QH", time_reference, version)
        + umid.ljust(64, b"\0")
        + struct.pack("<5h", *levels)
        + bytes(180)
        + history.encode()
    )


def bext(**reported: object) -> bytes:
    """A whole bext chunk."""
    return chunk(b"bext", bext_payload(**reported))


def ixml(body: str, *, encoding: str = "UTF-8") -> bytes:
    """A whole iXML chunk with `body` inside its root."""
    document = f'<?xml version="1.0" encoding="{encoding}"?>\n<BWFXML><IXML_VERSION>2.10</IXML_VERSION>{body}</BWFXML>'
    return chunk(b"iXML", document.encode(encoding))


def info(**texts: str) -> bytes:
    """A whole LIST/INFO chunk."""
    entries = (chunk(name.encode(), text.encode() + b"\0") for name, text in texts.items())
    return chunk(b"LIST", b"INFO" + b"".join(entries))


def labels(names: Mapping[int, str], *, kind: bytes = b"labl") -> bytes:
    """A whole LIST/adtl chunk that names cue points."""
    entries = (chunk(kind, struct.pack("<I", point) + name.encode() + b"\0") for point, name in names.items())
    return chunk(b"LIST", b"adtl" + b"".join(entries))


def cue(points: Mapping[int, int]) -> bytes:
    """A whole `cue ` chunk: the frame of each point."""
    body = b"".join(struct.pack("<2I4s3I", number, frame, b"data", 0, 0, frame) for number, frame in points.items())
    return chunk(b"cue ", struct.pack("<I", len(points)) + body)


def inst(
    note: int = 60,
    tune: int = 0,
    gain: int = 0,
    notes: tuple[int, int] = (0, 127),
    velocities: tuple[int, int] = (1, 127),
) -> bytes:
    """A whole `inst` chunk."""
    return chunk(b"inst", struct.pack("<BbbBBBB", note, tune, gain, *notes, *velocities))
