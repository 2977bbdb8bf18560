"""Atomic writes of text files: to a scratch file, synced, then renamed."""

import os
import secrets
from pathlib import Path


def write_atomically(path: str | Path, text: str) -> None:
    """Write a text file atomically: a reader gets the old text or the new, never a part.

    Raises
    ------
    OSError
        The folder cannot be written to; the old file is unchanged.
    """
    path = Path(path)
    scratch = path.with_name(f".{path.name[:100]}.{secrets.token_hex(4)}")
    try:
        with scratch.open("x", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        scratch.replace(path)
    except BaseException:
        scratch.unlink(missing_ok=True)
        raise
