"""How many lines of Python something takes: unlike seconds, the same on a busy machine."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any


class TooManySteps(AssertionError):
    """More lines were executed than were expected."""


class Steps:
    """A count of executed lines."""

    taken = 0


@contextmanager
def at_most(most: int) -> Iterator[Steps]:
    """Count the lines that this thread executes, and raise TooManySteps at the first one too many."""
    steps = Steps()

    def trace(_frame: FrameType, event: str, _argument: Any) -> Any:
        if event == "line":
            steps.taken += 1
            if steps.taken > most:
                raise TooManySteps(f"more than {most:,} lines of Python were executed")
        return trace

    before = sys.gettrace()
    sys.settrace(trace)
    try:
        yield steps
    finally:
        sys.settrace(before)
