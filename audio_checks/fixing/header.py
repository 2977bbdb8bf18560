"""Corrects headers with wrong sizes where the sound itself is complete.

Recorders that lost power, programs that wrote to a pipe, and tools that append or pad leave sizes
behind that readers take differently. Where every sample is there, the sizes follow from the file
itself. What is cut short stays refused: sound that is missing is not made up.
Sources: RIFF and RF64 (EBU Tech 3306), rules R2, R4, R11 and R12.
"""

import os
import struct
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import BinaryIO, NamedTuple

from audio_checks import wav

SIZES = frozenset(
    {
        "structure:riff-size",
        "structure:stream-header",
        "structure:no-frames",
        "structure:trailing-bytes",
        "structure:no-chunk",
        "structure:byte-rate",
        "structure:pad-byte",
        "structure:padding",
    }
)
"""Codes of findings that a right header can answer."""
MOST_BYTES = 0xFFFFFFFF + 8  # of a file without ds64
PIECE_BYTES = 1 << 20


class Corrected(NamedTuple):
    """Corrections of a header, in words, and the number of bytes left out after the sound's file.

    No words for a header that was right: its copy is the same byte for byte.
    """

    words: tuple[str, ...]
    cut_bytes: int


def with_right_sizes(path: str | os.PathLike[str], copy: Path) -> Corrected:
    """Write a copy with a correct header; return what was corrected, in words.

    Parameters
    ----------
    path, copy : path
        The file, which is only read, and the copy; no copy is left behind when this fails.

    Returns
    -------
    Corrected

    Raises
    ------
    Unreadable
        What the strict reader says of the copy: no size puts this file right.
    """
    try:
        with wav.open_regular(path) as file:
            corrected = _Sizes(file).write(copy)
        with wav.open_regular(copy) as file:
            wav.read_layout(file)
    except BaseException:
        copy.unlink(missing_ok=True)
        raise
    return corrected


@dataclass(frozen=True)
class _Patch:
    offset: int
    content: bytes
    words: str


class _Sizes:
    """The right sizes in a header, going by the chunks that are there."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._size = file.seek(0, os.SEEK_END)
        self._patches: list[_Patch] = []
        self._pads: list[int] = []  # where a pad byte is missing between two chunks
        self._frame_bytes = 0
        self._end = self._size
        head = self._read(0, 12)
        if head[:4] == b"RIFF" and head[8:] == b"WAVE":
            declared = int.from_bytes(head[4:8], "little")
            self._end = self._walk(declared)
            self._correct_riff_size(declared)

    def write(self, copy: Path) -> Corrected:
        words = [patch.words for patch in self._patches]
        kept = min(self._end, self._size)
        with copy.open("wb") as file:
            for start, stop in pairwise((0, *self._pads, kept)):
                self._copy(file, start, stop)
                if stop < kept or self._end > self._size:
                    file.write(b"\0")
            for patch in self._patches:
                file.seek(patch.offset + sum(pad <= patch.offset for pad in self._pads))
                file.write(patch.content)
            file.flush()
            os.fsync(file.fileno())
        missing = len(self._pads) + (self._end > self._size)
        if missing:
            words.append("the missing pad byte added" if missing == 1 else f"{missing} missing pad bytes added")
        if self._size > kept:
            words.append(f"{self._size - kept} bytes after the sound's file cut off")
        return Corrected(tuple(words), self._size - kept)

    def _copy(self, target: BinaryIO, start: int, stop: int) -> None:
        self._file.seek(start)
        while start < stop:
            piece = self._file.read(min(PIECE_BYTES, stop - start))
            if not piece:
                raise OSError("the file became shorter while it was copied")
            target.write(piece)
            start += len(piece)

    def _read(self, offset: int, count: int) -> bytes:
        self._file.seek(offset)
        return self._file.read(count) or b""

    def _walk(self, declared: int) -> int:
        """Return the end of the last chunk, pad byte included."""
        position, seen_data, odd = 12, False, False
        # The declared end is believed only where a chunk ends there; some writers leave the last pad byte uncounted.
        while position + 8 <= self._size and not (seen_data and position - declared - 8 in (0, 1)):
            head = self._read(position, 8)
            name, size = head[:4], int.from_bytes(head[4:], "little")
            if odd and not self._is_head(position) and self._is_head(position - 1):
                position -= 1
                self._pads.append(position)
                head = self._read(position, 8)
                name, size = head[:4], int.from_bytes(head[4:], "little")
            if not _is_printable(name):
                break
            if name == b"data" and not seen_data:
                size, seen_data = self._data_size(position, size, declared), True
            if position + 8 + size > self._size:
                break
            if name == b"fmt ":
                self._correct_format(position + 8, size)
            odd = size % 2 == 1
            position += 8 + size + odd
        return position

    def _is_head(self, position: int) -> bool:
        """Return whether a chunk may begin here: its name is printable, and it ends in the file or is the sound."""
        head = self._read(position, 8)
        name, size = head[:4], int.from_bytes(head[4:], "little")
        return len(head) == 8 and _is_printable(name) and (name == b"data" or position + 8 + size <= self._size)

    def _data_size(self, position: int, declared: int, riff_declared: int) -> int:
        """Return the bytes of sound: as declared, or all that follow where the size was left open."""
        following = self._size - position - 8
        left_open = declared == wav.STREAM_SIZE or (declared == 0 and riff_declared in (0, 36, wav.STREAM_SIZE))
        if not (left_open and self._frame_bytes and following >= self._frame_bytes):
            return declared
        size = following // self._frame_bytes * self._frame_bytes
        if size < wav.STREAM_SIZE:
            self._patches.append(_Patch(position + 4, struct.pack("<I", size), f"data size set to {size} bytes"))
        return size

    def _correct_format(self, offset: int, size: int) -> None:
        if size < 16:
            return
        _, _, rate, byte_rate, self._frame_bytes, _ = struct.unpack("<HHIIHH", self._read(offset, 16))
        true = (rate * self._frame_bytes) & 0xFFFFFFFF
        if byte_rate != true:
            self._patches.append(
                _Patch(offset + 8, struct.pack("<I", true), f"byte rate set to {true}, as rate and frame size make")
            )

    def _correct_riff_size(self, declared: int) -> None:
        end = self._end + len(self._pads)
        if declared + 8 != end <= MOST_BYTES:
            true = end - 8
            self._patches.append(_Patch(4, struct.pack("<I", true), f"RIFF size set to {true} bytes"))


def _is_printable(name: bytes) -> bool:
    return name.isascii() and name.decode("ascii").isprintable()
