"""The throw-away child: it limits itself, runs a request, and answers."""

from __future__ import annotations

import contextlib
import os
import pickle
import sys
import tempfile
import traceback

with contextlib.suppress(ImportError):  # where there is no fork there are no limits either
    import resource

from audio_checks.audio.sandbox.confinement import confine, library_places
from audio_checks.audio.sandbox.messages import (
    DETAIL_CHARACTERS,
    FAILED,
    LENGTH,
    NO_MEMORY,
    RAISED,
    RETURNED,
    Access,
    Limits,
)
from audio_checks.audio.sandbox.plain import encode
from audio_checks.errors import AudioChecksError

libraries: list[str] = []  # what the server has found for all its children
_inside = False
_confined = False


def is_inside() -> bool:
    """Return whether this process is a disposable child itself, so that no other is needed, nor allowed."""
    return _inside


def enter_sandbox() -> None:
    """Have this process know that it is a throw-away child."""
    global _inside  # noqa: PLW0603 - of this process, which ends with its one call
    _inside = True


def serve_once() -> None:
    """Answer the request on standard input, and leave."""
    enter_sandbox()
    output = os.dup(1)
    os.dup2(2, 1)
    kind, body = answer(sys.stdin.buffer.read())
    with os.fdopen(output, "wb") as stream:
        stream.write(LENGTH.pack(kind, len(body)) + body)


def answer(request: bytes) -> tuple[bytes, bytes]:
    """Run a request; return the kind of its answer, and the answer as `plain` writes it."""
    limits: Limits | None = None
    try:
        limits, access, function, args, kwargs = pickle.loads(request)  # noqa: S301 - it comes from the caller
        if os.name == "posix":
            _limit(limits)
        _confine(access)
        kind, value = RETURNED, function(*args, **kwargs)
    except AudioChecksError as error:
        kind, value = RAISED, error.with_traceback(None)
    except MemoryError:
        return NO_MEMORY, b""
    except BaseException:
        return FAILED, traceback.format_exc()[-DETAIL_CHARACTERS:].encode("utf-8", "replace")
    try:
        body = encode(value)
    except MemoryError:
        return NO_MEMORY, b""
    except Exception:
        return FAILED, traceback.format_exc()[-DETAIL_CHARACTERS:].encode("utf-8", "replace")
    if limits is not None and len(body) > limits.result_bytes:
        return FAILED, f"the result has {len(body)} bytes; {limits.result_bytes} are allowed".encode()
    return kind, body


def _confine(access: Access) -> None:
    """Give up all that no call of this child needs, before its first one."""
    global _confined  # noqa: PLW0603 - of this process, for good
    if not _confined:
        tempfile.tempdir = access.scratch
        confine(access.reads, (access.scratch, *access.writes), libraries or library_places())
        _confined = True


def _limit(limits: Limits) -> None:
    """Take from this process what it does not need."""
    for kind, most in (
        (resource.RLIMIT_AS, limits.memory_bytes),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_NOFILE, limits.open_files),
        (resource.RLIMIT_FSIZE, limits.file_bytes),
        (resource.RLIMIT_NPROC, 0),
    ):
        with contextlib.suppress(ValueError, OSError):
            resource.setrlimit(kind, (most, most))
    with contextlib.suppress(ValueError, OSError):
        # For this call only, without the time of earlier ones. The hard limit would hold for all of them together.
        used = resource.getrusage(resource.RUSAGE_SELF)
        _, hard = resource.getrlimit(resource.RLIMIT_CPU)
        resource.setrlimit(resource.RLIMIT_CPU, (int(used.ru_utime + used.ru_stime) + limits.cpu_s, hard))
