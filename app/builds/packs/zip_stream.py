"""A ZIP written while it is sent: stored, in the given order, byte-identical again, its length known beforehand.

Readers that stream too want each size before its data: it is, with the checksum, in front of every file.
"""

import hashlib
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import TYPE_CHECKING, BinaryIO

from app.core import kill_points

if TYPE_CHECKING:
    from stream_zip import MemberFile

READ_BYTES = 1 << 20
WRITTEN_AT = datetime(1980, 1, 1)  # noqa: DTZ001  the earliest that ZIP knows, which has no zones: the same pack is the same bytes
REGULAR_FILE = 0o100644
LARGEST_32, LARGEST_16 = 0xFFFFFFFF, 0xFFFF  # these values say that a number is elsewhere, as ZIP64
HEADERS_BYTES, END_BYTES = 30 + 46, 22
ZIP64_HEADERS_BYTES, ZIP64_END_BYTES = 20 + 28, 56 + 20


class EntryDamaged(Exception):
    """A file of the pack is not what the pack was promised to hold."""


@dataclass(frozen=True)
class Entry:
    """One file of the pack: opened when its turn comes, and held against the hash it must have."""

    path: str
    size_bytes: int
    sha256: str
    opened: Callable[[], BinaryIO]


def zip_length(entries: Sequence[Entry]) -> int:
    """Return the length of the ZIP in bytes."""
    headers_bytes, end_bytes = HEADERS_BYTES, END_BYTES
    if _needs_zip64(entries):
        headers_bytes, end_bytes = headers_bytes + ZIP64_HEADERS_BYTES, end_bytes + ZIP64_END_BYTES
    return end_bytes + sum(headers_bytes + 2 * len(entry.path.encode()) + entry.size_bytes for entry in entries)


def zip_bytes(entries: Sequence[Entry]) -> Iterator[bytes]:
    """Yield the ZIP; raise EntryDamaged before a byte of a file whose hash is wrong is given out."""
    from stream_zip import stream_zip  # brings ciphers, which are heavy: loaded where a ZIP is sent

    yield from stream_zip(_members(entries), chunk_size=READ_BYTES, extended_timestamps=False)


def _members(entries: Sequence[Entry]) -> Iterator["MemberFile"]:
    from stream_zip import NO_COMPRESSION_32, NO_COMPRESSION_64

    method = NO_COMPRESSION_64 if _needs_zip64(entries) else NO_COMPRESSION_32
    for entry in entries:
        crc = _verified_crc(entry)
        yield entry.path, WRITTEN_AT, REGULAR_FILE, method(entry.size_bytes, crc), _content(entry, crc)
        kill_points.point("builds.entry_packed")


def _needs_zip64(entries: Sequence[Entry]) -> bool:
    length = sum(HEADERS_BYTES + 2 * len(entry.path.encode()) + entry.size_bytes for entry in entries)
    return len(entries) >= LARGEST_16 or length >= LARGEST_32


def _verified_crc(entry: Entry) -> int:
    digest, crc, length = hashlib.sha256(), 0, 0
    with entry.opened() as file:
        while block := file.read(READ_BYTES):
            digest.update(block)
            crc = zlib.crc32(block, crc)
            length += len(block)
    if length != entry.size_bytes or digest.hexdigest() != entry.sha256:
        raise EntryDamaged(f"{entry.path} is not what was stored: {length} bytes, {entry.size_bytes} expected")
    return crc


def _content(entry: Entry, crc: int) -> Iterator[bytes]:
    sent_crc, length = 0, 0
    with entry.opened() as file:
        while block := file.read(READ_BYTES):
            sent_crc = zlib.crc32(block, sent_crc)
            length += len(block)
            if length > entry.size_bytes:
                break
            yield block
    if length != entry.size_bytes or sent_crc != crc:
        raise EntryDamaged(f"{entry.path} changed while it was sent")
