"""Reads a delivered ZIP without trusting it: bounded before anything is unpacked, and never by a name inside it."""

import io
import os
import stat
import struct
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import audio_checks
from app.deliveries.errors import ArchiveRefused
from app.deliveries.rules import MAX_FILE_BYTES, base_name

MAX_ENTRIES = 5_000
MAX_TOTAL_BYTES = 16 << 30
MAX_RATIO = 200  # digital silence packs 1000 : 1, so the ratio counts for archives that grow large only
RATIO_COUNTS_FROM_BYTES = 512 << 20
MAX_READ_BYTES = 8 << 20  # the directory is read at once: 5,000 entries with long names fit
READ_BYTES = 1 << 20
METHODS = frozenset({zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED})
ENCRYPTED, UTF8_NAME = 0x1, 0x800
UNICODE_PATH = 0x7075
UNIX = 3
ARCHIVES = (".zip", ".7z", ".rar", ".tar", ".gz", ".tgz", ".bz2", ".xz")
SOUNDS = (".wav", ".wave", ".bwf", ".rf64", ".bw64", ".w64", ".flac", ".aif", ".aiff", ".aifc", ".au", ".snd", ".caf",
          ".mp3", ".mp2", ".m4a", ".aac", ".wma", ".ogg", ".oga", ".opus")  # fmt: skip
IGNORED_ENTRIES = ("__MACOSX/", "._", ".DS_Store", "Thumbs.db", "desktop.ini")
Broken = (zipfile.BadZipFile, zlib.error, EOFError, OSError, RuntimeError, NotImplementedError, ValueError)


class EntryBroken(Exception):
    """One file of the ZIP cannot be unpacked; the message says why."""


@dataclass(frozen=True)
class Entry:
    """One file in a ZIP; `left_out` says why it is none of ours."""

    place: int
    path: str
    left_out: str | None


class OpenArchive:
    """A ZIP that was found harmless, and its files."""

    def __init__(self, archive: zipfile.ZipFile) -> None:
        self._archive = archive
        paths = paths_of(archive.infolist())
        self.entries = [
            Entry(index, path, _why_left_out(info, path))
            for index, (info, path) in enumerate(zip(archive.infolist(), paths, strict=True))
            if not info.is_dir()
        ]

    def content(self, entry: Entry) -> Iterator[bytes]:
        """Yield the bytes of one file; raise EntryBroken where they are not what the ZIP says."""
        info = self._archive.infolist()[entry.place]
        try:
            with self._archive.open(info) as file:
                while piece := file.read(READ_BYTES):
                    yield piece
        except Broken as error:
            raise EntryBroken(f"it cannot be unpacked ({error}); pack it again") from None


@contextmanager
def opened(path: Path) -> Iterator[OpenArchive]:
    """Open a ZIP; raise ArchiveRefused where it is none, is damaged, or would unpack to too much."""
    with path.open("rb", buffering=0) as file:
        try:
            archive = zipfile.ZipFile(_Bounded(file))
        except Broken as error:
            raise ArchiveRefused(f"this is not a ZIP that can be read ({error}); pack the files again") from None
        with archive:
            _ensure_harmless(archive.infolist(), path.stat().st_size)
            yield OpenArchive(archive)


class _Bounded(io.BufferedReader):
    """A file that refuses to be read in huge pieces, as a lying directory would have it."""

    def __init__(self, file: io.FileIO) -> None:
        super().__init__(file)
        self._size_bytes = os.fstat(file.fileno()).st_size

    def read(self, size: int | None = -1, /) -> bytes:
        wanted = self._size_bytes - self.tell() if size is None or size < 0 else size
        if wanted > MAX_READ_BYTES:
            raise ValueError("its directory is larger than that of any delivery")
        return super().read(size)


def _ensure_harmless(entries: list[zipfile.ZipInfo], archive_bytes: int) -> None:
    if len(entries) > MAX_ENTRIES:
        raise ArchiveRefused(f"it has {len(entries)} entries; {MAX_ENTRIES} are taken at once. Send several ZIPs")
    total = sum(info.file_size for info in entries)
    if total > MAX_TOTAL_BYTES:
        raise ArchiveRefused(
            f"it would unpack to {total} bytes; {MAX_TOTAL_BYTES} are taken at once. Send several ZIPs"
        )
    if sum(info.compress_size for info in entries) > archive_bytes:
        raise ArchiveRefused("its entries overlap, as no honest ZIP's do; nothing was unpacked")
    if total > RATIO_COUNTS_FROM_BYTES and total > MAX_RATIO * archive_bytes:
        raise ArchiveRefused(f"it would grow {total // archive_bytes}-fold; nothing was unpacked. Send the files alone")


def paths_of(entries: list[zipfile.ZipInfo]) -> list[str]:
    """Return the paths of all entries: as they say themselves, or in the code page that fits them all together."""
    raw = {index: name for index, info in enumerate(entries) if (name := _undeclared_name(info)) is not None}
    encoding = None
    if raw:  # many packers write UTF-8 and do not say so
        joined = audio_checks.decode_text(b"\n".join(raw.values()), guessed=audio_checks.GUESSED_FOR_ZIP)
        encoding = audio_checks.CODE_PAGES[joined.encoding]
    return [
        _unicode_path(info) or (raw[index].decode(encoding, "replace") if encoding and index in raw else info.filename)
        for index, info in enumerate(entries)
    ]


def _undeclared_name(info: zipfile.ZipInfo) -> bytes | None:
    """Return the bytes of a name whose encoding the entry does not say; None where it does, or is plain ASCII."""
    if info.flag_bits & UTF8_NAME or info.filename.isascii() or _unicode_path(info):
        return None
    try:
        return info.filename.encode("cp437")
    except UnicodeError:
        return None


def _unicode_path(info: zipfile.ZipInfo) -> str | None:
    """Return the path in the Unicode path field of an entry, None where it has none or one of another name.

    APPNOTE 6.3.10, 4.6.9: version 1, the CRC-32 of the plain name, then the path in UTF-8.
    """
    extra, offset = info.extra, 0
    while offset + 4 <= len(extra):
        kind, length = struct.unpack_from("<HH", extra, offset)
        body = extra[offset + 4 : offset + 4 + length]
        offset += 4 + length
        if kind != UNICODE_PATH or len(body) < 6 or body[0] != 1:
            continue
        try:
            plain = info.orig_filename.encode("utf-8" if info.flag_bits & UTF8_NAME else "cp437")
            if zlib.crc32(plain) == int.from_bytes(body[1:5], "little"):
                return body[5:].decode()
        except UnicodeError:
            continue
    return None


def _why_left_out(info: zipfile.ZipInfo, path: str) -> str | None:
    name = base_name(path)
    if any(path.startswith(litter) or name.startswith(litter) for litter in IGNORED_ENTRIES):
        return "not a sound: written by the system that packed it"
    if info.create_system == UNIX and stat.S_ISLNK(info.external_attr >> 16):
        return "a link to another file; pack the file itself"
    if info.flag_bits & ENCRYPTED:
        return "it is locked with a password; pack it without"
    if name.lower().endswith(ARCHIVES):
        return "an archive inside the ZIP is not opened; send it by itself"
    if not name.lower().endswith(SOUNDS):
        return "not a sound file by its name"
    if info.compress_type not in METHODS:
        return "packed by a method that is not read here; pack it as an ordinary ZIP"
    if info.file_size > MAX_FILE_BYTES:
        return f"{info.file_size} bytes; one file may have {MAX_FILE_BYTES}"
    return None
