"""The commands' output: plain lines, a line of progress on a terminal, and nothing that could control one."""

import sys
import unicodedata

UNSEEN = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}  # control, format, surrogate, private, unassigned, separators


def counted(count: int, singular: str, many: str | None = None) -> str:
    """Return a number with its noun: 0 files, 1 file, 2 files."""
    return f"{count:,} {singular if count == 1 else many or f'{singular}s'}"


def shown(text: str) -> str:
    """Return a text of the server or of a file name with what could control a terminal as escapes."""
    return "".join(
        sign.encode("unicode_escape").decode() if unicodedata.category(sign) in UNSEEN else sign for sign in text
    )


def say(text: str = "") -> None:
    """Print a line."""
    sys.stdout.write(text + "\n")


def warn(text: str) -> None:
    """Print a line on standard error."""
    sys.stderr.write(text + "\n")


def megabytes(count: int) -> str:
    """Return a number of bytes as people read it."""
    return f"{count / 1e6:.1f} MB"


class Progress:
    """A line of progress, on a terminal only."""

    def __init__(self, files: int, size_bytes: int) -> None:
        self._files, self._size_bytes = files, size_bytes
        self._done = self._bytes = 0
        self._is_shown = sys.stderr.isatty() and files > 0

    def add_bytes(self, count: int) -> None:
        """Count bytes that arrived."""
        self._bytes += count
        self._draw()

    def add_file(self) -> None:
        """Count a file that is in its place."""
        self._done += 1
        self._draw()

    def end(self) -> None:
        """Remove the line."""
        if self._is_shown:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    def _draw(self) -> None:
        if self._is_shown:
            size = f"{megabytes(self._bytes)} of {megabytes(self._size_bytes)}"
            sys.stderr.write(f"\r\x1b[K{self._done} of {counted(self._files, 'file')}, {size}")
            sys.stderr.flush()
