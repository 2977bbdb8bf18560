"""What a check can do to itself, run in its sandbox in place of the real one."""

import os
import signal
from typing import Any, NoReturn


def crash(*_: Any, **__: Any) -> NoReturn:
    """Die as a decoder with a memory error does."""
    os.kill(os.getpid(), signal.SIGSEGV)
    raise AssertionError("still alive")


def hang(*_: Any, **__: Any) -> NoReturn:
    """Never come back."""
    while True:
        pass


def eat_memory(*_: Any, **__: Any) -> NoReturn:
    """Want more memory than there is."""
    eaten = []
    while True:
        eaten.append(bytes(64 << 20))
