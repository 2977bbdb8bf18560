"""Has glibc give free memory back to the system."""

import contextlib
import ctypes

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD, M_ARENA_MAX = -1, -3, -8  # of mallopt(3)
LARGE_BYTES = 128 << 10  # a block of this size or more is mapped by itself, and unmapped once it is free
KEPT_BYTES = 1 << 20  # at the top of a heap
HEAPS = 2


def return_free_memory() -> None:
    """Set up the allocator of this process and of those that it forks; elsewhere than on glibc nothing happens.

    By default glibc raises both limits to the largest block that was freed, up to 32 and 64 MiB, and gives threads
    eight heaps a core: a few large requests at once would keep hundreds of MiB for good.
    """
    with contextlib.suppress(OSError, AttributeError, TypeError):
        mallopt = ctypes.CDLL(None).mallopt
        mallopt(M_MMAP_THRESHOLD, LARGE_BYTES)
        mallopt(M_TRIM_THRESHOLD, KEPT_BYTES)
        mallopt(M_ARENA_MAX, HEAPS)
