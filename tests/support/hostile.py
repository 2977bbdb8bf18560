"""What a check can do to itself, run in its sandbox in place of the real one."""

import os
import signal
import tempfile
from pathlib import Path
from typing import Any, NoReturn

import audio_checks
from audio_checks.runner import check_file


def tries(path: os.PathLike[str]) -> Path:
    """Return the file in which the tries at one blob are counted, a byte each."""
    return Path(tempfile.gettempdir()) / f"soundlist-tries-{Path(path).name}"


def _count(path: os.PathLike[str]) -> int:
    with tries(path).open("ab") as file:
        file.write(b"x")
    return tries(path).stat().st_size


def crash(path: os.PathLike[str], *_: Any, **__: Any) -> NoReturn:
    """Die as a decoder with a memory error does."""
    _count(path)
    os.kill(os.getpid(), signal.SIGSEGV)
    raise AssertionError("still alive")


def hang(path: os.PathLike[str], *_: Any, **__: Any) -> NoReturn:
    """Never come back."""
    _count(path)
    while True:
        pass


def eat_memory(path: os.PathLike[str], *_: Any, **__: Any) -> NoReturn:
    """Want more memory than there is."""
    _count(path)
    eaten = []
    while True:
        eaten.append(bytes(64 << 20))


def crash_twice(path: os.PathLike[str], *args: Any, **kwargs: Any) -> audio_checks.FileReport:
    """Work at the third try."""
    if _count(path) < 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return check_file(path, *args, **kwargs)
