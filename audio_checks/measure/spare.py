"""Large arrays that one file leaves to the next: the system takes long to find and clear that much memory in a row."""

from __future__ import annotations

import threading

import numpy as np
from numpy.typing import NDArray

LARGEST_BYTES = 32 << 20  # larger arrays go back to the system


class _Kept(threading.local):
    """What this thread keeps, by name."""

    def __init__(self) -> None:
        self.arrays: dict[str, NDArray[np.uint8]] = {}


_KEPT = _Kept()


def taken(name: str, size_bytes: int) -> NDArray[np.uint8]:
    """Return an array of so many bytes with any values, the one that was left under that name if it is large enough.

    Parameters
    ----------
    name : str
        What it is for; whoever takes it leaves nothing to others until it is given back.
    size_bytes : int
        0 or more.
    """
    kept = _KEPT.arrays.pop(name, None)
    return (np.empty(size_bytes, np.uint8) if kept is None or len(kept) < size_bytes else kept)[:size_bytes]


def give_back(name: str, array: NDArray[np.uint8]) -> None:
    """Leave what was taken to the next who takes it; whoever gives it must not use it any more."""
    whole = array.base
    if isinstance(whole, np.ndarray) and whole.nbytes <= LARGEST_BYTES:
        _KEPT.arrays[name] = whole
