"""Regular files of strangers, and bytes of them that come whole or not at all."""

from __future__ import annotations

import os
import stat
from io import FileIO
from typing import BinaryIO

from audio_checks.errors import Unreadable
from audio_checks.system.windows import reachable
from audio_checks.wav.layout import Chunk, WavLayout


def open_regular(path: str | os.PathLike[str]) -> FileIO:
    """Open a regular file for reading; a FIFO, a device or a directory is refused without waiting for it.

    Raises
    ------
    Unreadable
        R11, for anything that is not a regular file which may be read.
    """
    try:
        descriptor = os.open(
            reachable(os.fspath(path)), os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
        )
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise Unreadable(
            f"the file cannot be opened: {reason}",
            "R11",
            "container:cannot-open",
            "check that the file is there and may be read",
        ) from error
    try:
        if not stat.S_ISREG(os.fstat(descriptor).st_mode):
            raise Unreadable(
                "this is not a file but a directory, a pipe or a device; a WAV file is wanted",
                "R11",
                "container:not-a-file",
                "deliver a plain file",
            )
        return os.fdopen(descriptor, "rb", buffering=0)
    except BaseException:
        os.close(descriptor)
        raise


def shrunk() -> Unreadable:
    """Return the refusal of a file that became shorter while it was read (R1)."""
    return Unreadable(
        "the file became shorter while it was read",
        "R1",
        "structure:truncated",
        "wait until it is written, then try again",
    )


def read_up_to(file: BinaryIO, count: int) -> bytes:
    """Read `count` bytes, or all that are left; a raw file may give them in pieces."""
    content = file.read(count)
    while content is not None and len(content) < count:
        more = file.read(count - len(content))
        if not more:
            break
        content += more
    return content or b""


def read_frames(file: BinaryIO, layout: WavLayout, frames: int) -> bytes:
    """Return the bytes of so many frames from where the file stands.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile.
    """
    wanted_bytes = frames * layout.frame_bytes
    raw = read_up_to(file, wanted_bytes)
    if len(raw) < wanted_bytes:
        raise shrunk()
    return raw


def fill(file: FileIO, room: memoryview) -> None:
    """Fill all of `room` from where the file stands.

    Raises
    ------
    Unreadable
        R1, when the file became shorter meanwhile.
    """
    filled = 0
    while filled < len(room):
        count = file.readinto(room[filled:])
        if not count:
            raise shrunk()
        filled += count


def chunk_payload(file: BinaryIO, chunk: Chunk) -> bytes:
    """Return the payload of one chunk, which the caller has found small enough to hold."""
    file.seek(chunk.offset)
    return read_up_to(file, chunk.size)
