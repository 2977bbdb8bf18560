"""The ZIP as it is sent: read back by Python's own reader and by unzip, at the sizes where its format changes."""

import hashlib
import io
import itertools
import struct
import tracemalloc
import zipfile
import zlib
from functools import partial
from pathlib import Path
from typing import BinaryIO

import pytest

from app.builds.packs import zip_stream
from app.builds.packs.zip_stream import Entry, EntryDamaged, zip_bytes, zip_length

FOUR_GIB = 1 << 32


def entry(path: str, content: bytes) -> Entry:
    return Entry(path, len(content), hashlib.sha256(content).hexdigest(), partial(io.BytesIO, content))


def packed(entries: list[Entry]) -> bytes:
    whole = b"".join(zip_bytes(entries))
    assert len(whole) == zip_length(entries)
    return whole


def test_it_reads_back_in_order() -> None:
    contents = {"b.wav": b"one", "a.wav": b"", "masters/tür_01.wav": b"\0" * 3_000_000}
    whole = packed([entry(path, content) for path, content in contents.items()])
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == list(contents)
        assert {name: archive.read(name) for name in contents} == contents
        assert {info.compress_type for info in archive.infolist()} == {zipfile.ZIP_STORED}
        assert not any(info.flag_bits & 0x08 for info in archive.infolist())  # sizes stand before the data


def test_it_is_of_one_disk() -> None:
    """Python's reader does not look at the number of the disk; others refuse a disk that they do not have."""
    end = packed([entry("a.wav", b"one")])[-22:]
    assert struct.unpack("<4s4H2LH", end)[:5] == (b"PK\x05\x06", 0, 0, 1, 1)


def test_the_same_files_are_the_same_bytes() -> None:
    entries = [entry("a.wav", b"one"), entry("b.wav", b"two")]
    assert packed(entries) == packed(entries)


def test_an_empty_zip_is_valid() -> None:
    assert zipfile.ZipFile(io.BytesIO(packed([]))).namelist() == []


@pytest.mark.slow
@pytest.mark.parametrize("count", [0xFFFE, 0xFFFF])
def test_many_files(count: int) -> None:
    whole = packed([entry(f"{number}.wav", b"") for number in range(count)])
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        assert len(archive.namelist()) == count
    assert (b"PK\x06\x06" in whole) == (count >= 0xFFFF)


class Zeros(io.RawIOBase):
    """A file of zeros that takes no room."""

    def __init__(self, size: int) -> None:
        self._left = size

    def read(self, size: int = -1) -> bytes:
        given = min(self._left, size)
        self._left -= given
        return b"\0" * given


@pytest.mark.slow
def test_over_four_gib(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # 4 GiB of zeros takes no time to hash twice when the sum is known; its holes take no room on disk.
    monkeypatch.setattr(zip_stream, "_verified_crc", lambda entry: known.get(entry.path) or zlib.crc32(b"end"))
    monkeypatch.setattr(zip_stream, "READ_BYTES", 1 << 24)
    block = b"\0" * (1 << 24)
    crc = 0
    for _ in range(FOUR_GIB // len(block)):
        crc = zlib.crc32(block, crc)
    known = {"large.wav": crc}

    def zeros() -> BinaryIO:
        return Zeros(FOUR_GIB)

    entries = [Entry("large.wav", FOUR_GIB, "", zeros), entry("after.wav", b"end")]
    whole = tmp_path / "large.zip"
    with whole.open("wb") as file:
        for part in zip_bytes(entries):
            if part == block:
                file.seek(len(part), io.SEEK_CUR)
            else:
                file.write(part)
    assert whole.stat().st_size == zip_length(entries)
    with zipfile.ZipFile(whole) as archive:
        large, after = archive.infolist()
        assert (large.file_size, after.header_offset > FOUR_GIB) == (FOUR_GIB, True)
        assert archive.read("after.wav") == b"end"
        with archive.open("large.wav") as file:
            assert file.read(1000) == b"\0" * 1000


@pytest.mark.parametrize("stored", [b"shorter", b"changed!!!", b"much longer than it was"])
def test_a_damaged_file_breaks_the_stream_before_a_byte_of_it(stored: bytes) -> None:
    good = b"0123456789"
    damaged = Entry("b.wav", len(good), hashlib.sha256(good).hexdigest(), partial(io.BytesIO, stored))
    parts: list[bytes] = []
    with pytest.raises(EntryDamaged, match=r"b\.wav"):
        parts.extend(zip_bytes([entry("a.wav", b"one"), damaged, entry("c.wav", b"three")]))
    sent = b"".join(parts)
    assert b"a.wav" in sent
    assert b"b.wav" not in sent
    assert b"PK\x05\x06" not in sent  # no end of a ZIP: nobody can take it for whole


def test_a_file_that_changes_while_it_is_sent_breaks_the_stream() -> None:
    good = b"0123456789"
    readings = itertools.chain([good], itertools.repeat(b"9876543210"))
    changing = Entry("a.wav", len(good), hashlib.sha256(good).hexdigest(), lambda: io.BytesIO(next(readings)))
    with pytest.raises(EntryDamaged, match="changed while"):
        list(zip_bytes([changing]))


@pytest.mark.slow
def test_memory_does_not_grow_with_the_files() -> None:
    size = 64 << 20
    digest = hashlib.sha256(b"\0" * size).hexdigest()
    entries = [Entry(f"{number}.wav", size, digest, lambda: Zeros(size)) for number in range(2)]
    tracemalloc.start()
    try:
        assert sum(len(part) for part in zip_bytes(entries)) == zip_length(entries)
        assert tracemalloc.get_traced_memory()[1] < 8 << 20
    finally:
        tracemalloc.stop()
