"""A pool of large buffers, reused from file to file: allocating and clearing them each time is slow."""

from __future__ import annotations

import threading

import numpy as np
from numpy.typing import NDArray

LARGEST_BYTES = 32 << 20  # larger arrays go back to the system


class _Pool(threading.local):
    """The free buffers of this thread, by name."""

    def __init__(self) -> None:
        self.arrays: dict[str, NDArray[np.uint8]] = {}


_POOL = _Pool()


def acquire(name: str, size_bytes: int) -> NDArray[np.uint8]:
    """Return an uninitialised array of so many bytes, the released one of that name if it is large enough.

    Parameters
    ----------
    name : str
        What it is for. One buffer of a name is free at a time.
    size_bytes : int
        0 or more.
    """
    kept = _POOL.arrays.pop(name, None)
    return (np.empty(size_bytes, np.uint8) if kept is None or len(kept) < size_bytes else kept)[:size_bytes]


def release(name: str, array: NDArray[np.uint8]) -> None:
    """Return an array to the pool. The caller must not use it any more."""
    whole = array.base
    if isinstance(whole, np.ndarray) and whole.nbytes <= LARGEST_BYTES:
        _POOL.arrays[name] = whole
