"""A line on the terminal that says how far the work is; nothing where there is no terminal."""

import shutil
import sys
import time
from typing import Self

from audio_checks.cli.terminal import DIM, Ink, in_colour
from audio_checks.report.findings import printable

EVERY_S = 0.05  # more often than the eye can follow costs more than it shows
CELLS, FEWEST_CELLS = 24, 8
SHORTEST_NAME = 8
CLEAR = "\r\x1b[K"


class Progress:
    """A count of the files done, out of a number.

    The line is redrawn at most every 50 ms, and gone when the work is done or interrupted.
    """

    def __init__(self, total: int, *, shown: bool) -> None:
        self._total = total
        self._done = 0
        self._stream = sys.stderr
        self._shown = shown and total > 1 and self._stream.isatty()  # never in a log
        self._ink = Ink(in_colour(self._stream))
        self._began_s = time.monotonic()
        self._drawn_s = 0.0
        self._line = False

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._line:
            self._stream.write(CLEAR)
            self._stream.flush()

    def step(self, path: str) -> None:
        """Count one file."""
        self._done += 1
        now_s = time.monotonic()
        if self._shown and now_s - self._drawn_s >= EVERY_S:
            self._drawn_s = now_s
            self._draw(path, now_s - self._began_s)

    def _draw(self, path: str, passed_s: float) -> None:
        """Draw the fitting part of bar, count, time left and name; a line that breaks could not be taken back."""
        counted = f"{self._done:>{len(str(self._total))}}/{self._total}"
        left_s = passed_s / self._done * (self._total - self._done)
        left = f"  {_time(left_s)} left" if passed_s > 1 else ""
        room = shutil.get_terminal_size().columns - 1 - len(counted) - len(left)
        cells = min(CELLS, room - 1) if room > FEWEST_CELLS else 0
        bar = f"{self._bar(cells)} " if cells else ""
        name = printable(path)
        room -= len(bar) + 2
        if len(name) > room:
            name = f"...{name[len(name) - room + 3 :]}" if room >= SHORTEST_NAME else ""
        self._stream.write(f"{CLEAR}{bar}{counted}{left}{self._ink(f'  {name}', DIM) if name else ''}")
        self._stream.flush()
        self._line = True

    def _bar(self, cells: int) -> str:
        full, empty = ("█", "░") if _can_draw(self._stream.encoding) else ("#", ".")
        done = cells * self._done // self._total
        return full * done + empty * (cells - done)


def _can_draw(encoding: str | None) -> bool:
    try:
        "█░".encode(encoding or "ascii")
    except (UnicodeEncodeError, LookupError):
        return False
    return True


def _time(left_s: float) -> str:
    minutes, seconds = divmod(round(left_s), 60)
    return f"{minutes} min {seconds:02} s" if minutes else f"{seconds} s"
