"""A ZIP written while it is sent: stored, in the given order, byte-identical again, its length known beforehand.

Python's zipfile, on a stream, cannot write sizes before the data; readers that stream too refuse such files.
"""

import hashlib
import struct
import zlib
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import BinaryIO

from app.core import kill_points

READ_BYTES = 1 << 20
UTF8_NAMES = 0x800
TIME, DATE = 0, (1 << 5) | 1  # 1980-01-01 00:00, the earliest that ZIP knows: the same pack is the same bytes
MADE_ON_UNIX = 3 << 8
REGULAR_FILE = 0o100644 << 16
PLAIN, WITH_ZIP64 = 20, 45
LARGEST_32, LARGEST_16 = 0xFFFFFFFF, 0xFFFF
ZIP64_EXTRA = 0x0001


class EntryDamaged(Exception):
    """A file of the pack is not what the pack was promised to hold."""


@dataclass(frozen=True)
class Entry:
    """One file of the pack: opened when its turn comes, and held against the hash it must have."""

    path: str
    size_bytes: int
    sha256: str
    opened: Callable[[], BinaryIO]

    @property
    def name(self) -> bytes:
        """The path as the ZIP holds it."""
        return self.path.encode()


def zip_length(entries: Sequence[Entry]) -> int:
    """Return how many bytes `zip_bytes` gives."""
    offset = central = 0
    for entry in entries:
        central += 46 + len(entry.name) + len(_central_extra(entry.size_bytes, offset))
        offset += 30 + len(entry.name) + len(_local_extra(entry.size_bytes)) + entry.size_bytes
    return offset + central + len(_end(len(entries), central, offset))


def zip_bytes(entries: Sequence[Entry]) -> Iterator[bytes]:
    """Yield the ZIP; raise EntryDamaged before a byte of a file whose hash is wrong is given out."""
    offset = 0
    directory: list[bytes] = []
    for entry in entries:
        crc = _verified_crc(entry)
        extra = _local_extra(entry.size_bytes)
        directory.append(_central(entry, crc, offset))
        header = struct.pack(
            "<4s5H3L2H",
            b"PK\x03\x04",
            _version(entry.size_bytes),
            UTF8_NAMES,
            0,
            TIME,
            DATE,
            crc,
            min(entry.size_bytes, LARGEST_32),
            min(entry.size_bytes, LARGEST_32),
            len(entry.name),
            len(extra),
        )
        yield header + entry.name + extra
        yield from _content(entry, crc)
        kill_points.point("builds.entry_packed")
        offset += len(header) + len(entry.name) + len(extra) + entry.size_bytes
    central = sum(map(len, directory))
    yield from directory
    yield _end(len(entries), central, offset)


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


def _version(size_bytes: int, offset: int = 0) -> int:
    return WITH_ZIP64 if max(size_bytes, offset) >= LARGEST_32 else PLAIN


def _local_extra(size_bytes: int) -> bytes:
    if size_bytes < LARGEST_32:
        return b""
    return struct.pack("<2H2Q", ZIP64_EXTRA, 16, size_bytes, size_bytes)


def _central_extra(size_bytes: int, offset: int) -> bytes:
    large = [size_bytes, size_bytes] if size_bytes >= LARGEST_32 else []
    large += [offset] if offset >= LARGEST_32 else []
    return struct.pack(f"<2H{len(large)}Q", ZIP64_EXTRA, 8 * len(large), *large) if large else b""


def _central(entry: Entry, crc: int, offset: int) -> bytes:
    extra = _central_extra(entry.size_bytes, offset)
    version = _version(entry.size_bytes, offset)
    header = struct.pack(
        "<4s6H3L5H2L",
        b"PK\x01\x02",
        MADE_ON_UNIX | version,
        version,
        UTF8_NAMES,
        0,
        TIME,
        DATE,
        crc,
        min(entry.size_bytes, LARGEST_32),
        min(entry.size_bytes, LARGEST_32),
        len(entry.name),
        len(extra),
        0,
        0,
        0,
        REGULAR_FILE,
        min(offset, LARGEST_32),
    )
    return header + entry.name + extra


def _end(count: int, central: int, offset: int) -> bytes:
    zip64 = b""
    if count >= LARGEST_16 or central >= LARGEST_32 or offset >= LARGEST_32:
        record = struct.pack(
            "<4sQ2H2L4Q",
            b"PK\x06\x06",
            44,
            MADE_ON_UNIX | WITH_ZIP64,
            WITH_ZIP64,
            0,
            0,
            count,
            count,
            central,
            offset,
        )
        zip64 = record + struct.pack("<4sLQL", b"PK\x06\x07", 0, offset + central, 1)
    counted = min(count, LARGEST_16)
    return zip64 + struct.pack(
        "<4s4H2LH",
        b"PK\x05\x06",
        0,
        0,
        counted,
        counted,
        min(central, LARGEST_32),
        min(offset, LARGEST_32),
        0,
    )
