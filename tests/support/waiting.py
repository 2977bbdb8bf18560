"""Waiting for an event, with a limit."""

import time
from collections.abc import Callable


def until(condition: Callable[[], object], within_s: float = 300.0) -> None:
    """Return once a condition holds; fail where it does not come about."""
    deadline = time.monotonic() + within_s
    while not condition():
        assert time.monotonic() < deadline, f"it did not come about within {within_s:.0f} s"
        time.sleep(0.02)
