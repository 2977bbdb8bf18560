"""Messages on stderr, and the choice of colour for a stream."""

import os
import shutil
import sys
from contextvars import ContextVar
from typing import IO

from audio_checks.report.findings import printable

RED, GREEN, YELLOW, MAGENTA, CYAN = "31", "32", "33", "35", "36"
BOLD, DIM = "1", "2"
NARROWEST, WIDEST = 40, 120


class Ink:
    """Colours text, or leaves it plain."""

    def __init__(self, colour: bool) -> None:
        self._colour = colour

    def __call__(self, text: str, *codes: str) -> str:
        """Return the text between the codes that colour it and the one that ends them."""
        return f"\x1b[{';'.join(codes)}m{text}\x1b[0m" if self._colour and codes and text else text


_quiet: ContextVar[bool] = ContextVar("quiet", default=False)


def set_quiet(quiet: bool) -> None:
    """Print notes or leave them out, from now on."""
    _quiet.set(quiet)


def note(message: str) -> None:
    """Print a fact worth knowing and no fault, as `say` does; nothing when the run is quiet."""
    if not _quiet.get():
        say(message)


def say(message: str) -> None:
    """Print a message for people on stderr, each of its lines under the tool's name."""
    for line in message.split("\n"):
        print(f"audio-checks: {printable(line)}", file=sys.stderr)


def in_colour(stream: IO[str]) -> bool:
    """Return whether colours are shown: on a terminal, unless NO_COLOR is set; anywhere, if FORCE_COLOR is."""
    if os.environ.get("NO_COLOR"):
        return False
    if os.environ.get("FORCE_COLOR"):
        return True
    return stream.isatty() and os.environ.get("TERM") != "dumb"


def width() -> int:
    """Return the columns that text is wrapped to: those of the terminal, within reason."""
    return max(NARROWEST, min(WIDEST, shutil.get_terminal_size().columns))
