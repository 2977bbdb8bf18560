"""The C library of this process, opened once."""

import ctypes
import functools


@functools.cache
def c_library() -> ctypes.CDLL:
    """Return it; each of its functions is looked up once, and so by the server for all its children."""
    library = ctypes.CDLL(None, use_errno=True)
    for name in ("prctl", "syscall", "capget", "capset"):
        getattr(library, name, None)
    return library
