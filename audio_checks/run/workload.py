"""The number of processes that some files are worth."""

import os
from collections.abc import Sequence

CORES = os.cpu_count() or 1
MUCH_BYTES = 64 << 20  # starting processes costs a fifth of a second, which less work does not earn back
MANY_FILES = 200


def size_of(path: str) -> int:
    """Return the size of a file, in bytes; 0 for anything that is none."""
    try:
        return os.stat(path).st_size
    except (OSError, ValueError):
        return 0


def process_count(paths: Sequence[str]) -> int:
    """Return the number of processes that some files are worth: one a core when they are many or large, else one."""
    if len(paths) < 2:
        return 1
    size = sum(os.path.getsize(path) for path in paths if os.path.isfile(path))
    return CORES if len(paths) >= MANY_FILES or size >= MUCH_BYTES else 1
