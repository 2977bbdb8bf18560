"""The progress of a long command: a line for each step, and one now and then while a step goes on."""

import threading
import time
from collections.abc import Callable
from typing import Self

QUIET_S = 5.0


class Progress:
    """Reports steps, and that the current one still goes on."""

    def __init__(self, report: Callable[[str], None], *, quiet_s: float = QUIET_S) -> None:
        self._report = report
        self._quiet_s = quiet_s
        self._step = ""
        self._since = time.monotonic()
        self._changed = threading.Event()
        self._is_over = False
        self._reporter = threading.Thread(target=self._report_long_steps, name="progress", daemon=True)

    def __enter__(self) -> Self:
        self._reporter.start()
        return self

    def __exit__(self, *_error: object) -> None:
        self.end()

    def begin(self, step: str) -> None:
        """Report the step that begins now: "Preparing the database"."""
        self._report(f"  {step} …")
        self._step, self._since = step, time.monotonic()
        self._changed.set()

    def end(self) -> None:
        """Report no further step."""
        self._is_over = True
        self._changed.set()
        self._reporter.join()

    def _report_long_steps(self) -> None:
        while not self._is_over:
            if self._changed.wait(self._quiet_s):
                self._changed.clear()
            elif self._step:
                self._report(f"  {self._step} … {time.monotonic() - self._since:.0f} s so far")
