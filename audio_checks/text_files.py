"""Text files that people write: specs, sound lists, baselines. Like sounds, they come from trees of strangers."""

import os
import stat
from pathlib import Path

from audio_checks.errors import SpecError
from audio_checks.windows import reachable

MOST_BYTES = 32 << 20


def read_text(path: Path, *, fix: str = "", most_bytes: int = MOST_BYTES) -> str:
    """Return the text of a UTF-8 file, without a byte order mark.

    Raises
    ------
    SpecError
        The file cannot be read, is no regular file, is larger than it may be, or is no UTF-8; `fix` then says how to
        make it so. What the file holds is not repeated.
    """
    try:
        content = _content(path, most_bytes)
    except (OSError, ValueError) as error:
        raise SpecError(f"cannot be read: {getattr(error, 'strerror', None) or error}", where=str(path)) from None
    try:
        return content.decode("utf-8-sig").replace("\r\n", "\n").replace("\r", "\n")
    except UnicodeDecodeError:
        raise SpecError("; ".join(["is not UTF-8 text", *([fix] if fix else [])]), where=str(path)) from None


def _content(path: Path, most_bytes: int) -> bytes:
    """Return a file's bytes without waiting for a FIFO or reading a device for ever."""
    flags = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)
    with os.fdopen(os.open(reachable(os.fspath(path)), flags), "rb") as file:
        if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
            raise SpecError("is no regular file but a pipe or a device", where=str(path))
        content = file.read(most_bytes + 1)
    if len(content) > most_bytes:
        raise SpecError(f"is larger than {most_bytes >> 20} MiB", where=str(path))
    return content
