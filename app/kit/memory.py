"""Gives memory back to the system: what glibc keeps free, and what only the garbage collector can free."""

import contextlib
import ctypes
import gc
import threading
from collections.abc import Callable

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD, M_ARENA_MAX = -1, -3, -8  # of mallopt(3)
LARGE_BYTES = 128 << 10  # a block of this size or more is mapped by itself, and unmapped once it is free
KEPT_BYTES = 1 << 20  # at the top of a heap
HEAPS = 2
COLLECT_EVERY_S = 10.0
NOT_GLIBC = (OSError, AttributeError, TypeError)


def return_free_memory() -> None:
    """Set up the allocator of this process and of those that it forks; elsewhere than on glibc nothing happens.

    By default glibc raises both limits to the largest block that was freed, up to 32 and 64 MiB, and gives threads
    eight heaps a core: a few large requests at once would keep hundreds of MiB for good.
    """
    with contextlib.suppress(*NOT_GLIBC):
        mallopt = ctypes.CDLL(None).mallopt
        mallopt(M_MMAP_THRESHOLD, LARGE_BYTES)
        mallopt(M_TRIM_THRESHOLD, KEPT_BYTES)
        mallopt(M_ARENA_MAX, HEAPS)


def collect_garbage(until: threading.Event) -> None:
    """Collect garbage every few seconds, in a thread of its own, until the event is set.

    A collection by itself waits for a number of new objects. A few refused requests of 8 MiB, held by the tracebacks
    of their errors, are few objects: they kept 90 MiB in a process that had nothing to do. What is then free between
    blocks in use is returned page by page; without asking, glibc returns only what is free at the top of a heap.
    """
    trim: Callable[[int], object] = id
    with contextlib.suppress(*NOT_GLIBC):
        trim = ctypes.CDLL(None).malloc_trim

    def collect() -> None:
        while not until.wait(COLLECT_EVERY_S):
            gc.collect()
            trim(0)

    threading.Thread(target=collect, name="garbage", daemon=True).start()
