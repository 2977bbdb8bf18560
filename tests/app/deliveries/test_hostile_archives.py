"""A ZIP whose directory lies costs little: it is refused, or read within bounds, before anything is allocated."""

import io
import resource
import struct
import zipfile
from collections.abc import Sequence
from pathlib import Path

import pytest

from app.deliveries.errors import ArchiveRefused
from app.deliveries.rules import MAX_ARCHIVE_BYTES
from app.deliveries.uploads import unzip

LOCAL, CENTRAL, END, END64, LOCATOR = "<4s5H3L2H", "<4s6H3L5H2L", "<4s4H2LH", "<4sQ2H2L4Q", "<4sLQL"
GROWTH_MIB = 150


def local_head(name: bytes, size: int) -> bytes:
    return struct.pack(LOCAL, b"PK\x03\x04", 20, 0, 0, 0, 0, 0, size, size, len(name), 0) + name


def central_head(name: bytes, size: int, at: int) -> bytes:
    head = struct.pack(CENTRAL, b"PK\x01\x02", 20, 20, 0, 0, 0, 0, 0, size, size, len(name), 0, 0, 0, 0, 0, at)
    return head + name


def end(entries: int, size: int, at: int) -> bytes:
    """Return the end of a ZIP64 whose directory begins at a byte and has a size, or says so."""
    here = at + size
    return (
        struct.pack(END64, b"PK\x06\x06", 44, 45, 45, 0, 0, entries, entries, size, at)
        + struct.pack(LOCATOR, b"PK\x06\x07", 0, here, 1)
        + struct.pack(END, b"PK\x05\x06", 0, 0, 0xFFFF, 0xFFFF, 0xFFFFFFFF, 0xFFFFFFFF, 0)
    )


def stored(path: Path, sizes: Sequence[int]) -> None:
    """Write a ZIP of files of zeros, which take no room on the disk."""
    directory = b""
    with path.open("wb") as file:
        for number, size in enumerate(sizes):
            name = f"laser_{number:02}.wav".encode()
            directory += central_head(name, size, file.tell())
            file.write(local_head(name, size))
            file.seek(size, io.SEEK_CUR)
        at = file.tell()
        file.write(directory + end(len(sizes), len(directory), at))


def bytes_read() -> int:
    """Return how many bytes this process has read from files so far."""
    return int(Path("/proc/self/io").read_text().split()[1])


def refusal_of(path: Path) -> str:
    """Return why a ZIP is refused; little of it is read, and little memory taken."""
    before_kib, before_bytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, bytes_read()
    with pytest.raises(ArchiveRefused) as refused, unzip.opened(path):
        pass
    assert bytes_read() - before_bytes < 2 * unzip.MAX_READ_BYTES
    assert (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before_kib) / 1024 < GROWTH_MIB
    return str(refused.value)


def test_a_directory_of_five_million_entries_is_not_read(tmp_path: Path):
    entries = 5_000_000
    size = entries * struct.calcsize(CENTRAL)
    path = tmp_path / "many.zip"
    with path.open("wb") as file:
        file.seek(size)
        file.write(end(entries, size, 0))
    assert "directory is larger than that of any delivery" in refusal_of(path)


@pytest.mark.slow
def test_entries_are_counted_whatever_the_end_says(tmp_path: Path):
    count = unzip.MAX_READ_BYTES // struct.calcsize(CENTRAL) - 10
    directory = central_head(b"", 0, 0) * count
    path = tmp_path / "many.zip"
    path.write_bytes(directory + end(5_000_000, len(directory), 0))
    assert f"it has {count} entries" in refusal_of(path)


@pytest.mark.parametrize("size", [1 << 40, (1 << 64) - 1], ids=["a terabyte", "all bits"])
def test_a_directory_larger_than_the_file_is_refused(tmp_path: Path, size: int):
    path = tmp_path / "lies.zip"
    path.write_bytes(central_head(b"laser.wav", 0, 0) + end(1, size, 0))
    assert refusal_of(path).startswith("this is not a ZIP that can be read")


def test_entries_that_overlap_are_refused(tmp_path: Path):
    size = 10_000
    file = local_head(b"laser.wav", size) + bytes(size)
    directory = central_head(b"laser.wav", size, 0) * 100
    path = tmp_path / "overlaps.zip"
    path.write_bytes(file + directory + end(100, len(directory), len(file)))
    assert "overlap" in refusal_of(path)


@pytest.mark.parametrize("reported", [5, 1_900_000_000], ids=["less", "more"])
def test_an_entry_that_is_not_as_long_as_it_says_is_broken(tmp_path: Path, reported: int):
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("laser.wav", bytes(3_000_000))
    content = bytearray(made.getvalue())
    declared_bytes = struct.pack("<L", reported)
    content[22:26] = declared_bytes
    place = content.index(b"PK\x01\x02") + 24
    content[place : place + 4] = declared_bytes
    path = tmp_path / "lies.zip"
    path.write_bytes(content)
    if reported > unzip.RATIO_COUNTS_FROM_BYTES:
        assert "fold" in refusal_of(path)
        return
    with unzip.opened(path) as opened:
        content_of_it = opened.content(opened.entries[0])
        with pytest.raises(unzip.EntryBroken):
            list(content_of_it)


def test_five_gigabytes_of_sounds_pass(tmp_path: Path):
    path = tmp_path / "large.zip"
    stored(path, [1_250_000_000] * 4)
    assert 5_000_000_000 < path.stat().st_size < MAX_ARCHIVE_BYTES
    with unzip.opened(path) as opened:
        assert [entry.left_out for entry in opened.entries] == [None] * 4
        assert len(next(iter(opened.content(opened.entries[-1])))) == unzip.READ_BYTES
