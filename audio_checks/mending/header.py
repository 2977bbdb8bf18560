"""Headers that tell wrong sizes of a sound that is whole.

Recorders that lost power, programs that wrote to a pipe, and tools that append or pad leave sizes
behind that readers take differently. Where every sample is there, the sizes follow from the file
itself. What is cut short stays refused: sound that is missing is not made up.
Sources: RIFF and RF64 (EBU Tech 3306), rules R2, R4, R11 and R12.
"""

import os
import shutil
import struct
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

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


def with_right_sizes(path: str | os.PathLike[str], copy: Path) -> tuple[str, ...]:
    """Write a copy whose header tells what is there; return what was put right, in words.

    Parameters
    ----------
    path, copy : path
        The file, which is only read, and the copy; no copy is left behind when this fails.

    Returns
    -------
    tuple of str
        Empty for a header that was right, byte for byte.

    Raises
    ------
    Unreadable
        What the strict reader says of the copy: no size puts this file right.
    """
    with wav.open_regular(path) as file:
        found = _Sizes(file)
    shutil.copyfile(path, copy)
    try:
        words = found.write(copy)
        with wav.open_regular(copy) as file:
            wav.read_layout(file)
    except BaseException:
        copy.unlink(missing_ok=True)
        raise
    return words


@dataclass(frozen=True)
class _Patch:
    offset: int
    content: bytes
    words: str


class _Sizes:
    """What the sizes in a header should be, going by the chunks that are there."""

    def __init__(self, file: BinaryIO) -> None:
        self._file = file
        self._size = file.seek(0, os.SEEK_END)
        self._patches: list[_Patch] = []
        self._frame_bytes = 0
        self._end = self._size
        head = self._read(0, 12)
        if head[:4] == b"RIFF" and head[8:] == b"WAVE":
            told = int.from_bytes(head[4:8], "little")
            self._end = self._walk(told)
            self._correct_riff_size(told)

    def write(self, copy: Path) -> tuple[str, ...]:
        words = [patch.words for patch in self._patches]
        with copy.open("r+b") as file:
            for patch in self._patches:
                file.seek(patch.offset)
                file.write(patch.content)
            if self._end < self._size:
                words.append(f"{self._size - self._end} bytes after the sound's file cut off")
                file.truncate(self._end)
            elif self._end > self._size:
                words.append("the missing pad byte added")
                file.truncate(self._end)
            file.flush()
            os.fsync(file.fileno())
        return tuple(words)

    def _read(self, offset: int, count: int) -> bytes:
        self._file.seek(offset)
        return self._file.read(count) or b""

    def _walk(self, told: int) -> int:
        """Return where the last chunk ends, pad byte included."""
        position, seen_data = 12, False
        # A told end is believed only where a chunk ends there; some writers leave the last pad byte uncounted.
        while position + 8 <= self._size and not (seen_data and position - told - 8 in (0, 1)):
            head = self._read(position, 8)
            name, size = head[:4], int.from_bytes(head[4:], "little")
            if not (name.isascii() and name.decode("ascii").isprintable()):
                break
            if name == b"data" and not seen_data:
                size, seen_data = self._data_size(position, size, told), True
            if position + 8 + size > self._size:
                break
            if name == b"fmt ":
                self._correct_format(position + 8, size)
            position += 8 + size + size % 2
        return position

    def _data_size(self, position: int, told: int, riff_told: int) -> int:
        """Return the bytes of sound: as told, or all that follow where the size was left open."""
        following = self._size - position - 8
        left_open = told == wav.STREAM_SIZE or (told == 0 and riff_told in (0, 36, wav.STREAM_SIZE))
        if not (left_open and self._frame_bytes and following >= self._frame_bytes):
            return told
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

    def _correct_riff_size(self, told: int) -> None:
        if told + 8 != self._end and self._end <= MOST_BYTES:
            true = self._end - 8
            self._patches.append(_Patch(4, struct.pack("<I", true), f"RIFF size set to {true} bytes"))
