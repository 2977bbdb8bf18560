"""Text files that are whole or absent: written beside their place, synced, and moved there."""

import os
import secrets
from pathlib import Path


def write_whole(path: str | Path, text: str) -> None:
    """Write a text file in one step: whoever reads it meets the old text or the new, never half of one.

    Raises
    ------
    OSError
        The folder cannot be written to; what stood there before stands there still.
    """
    path = Path(path)
    beside = path.with_name(f".{path.name[:100]}.{secrets.token_hex(4)}")
    try:
        with beside.open("x", encoding="utf-8", newline="\n") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        beside.replace(path)
    except BaseException:
        beside.unlink(missing_ok=True)
        raise
