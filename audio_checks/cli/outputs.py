"""Destinations of a report: formats, each to a file or to stdout."""

import sys
from collections.abc import Callable, Sequence
from pathlib import Path

from audio_checks.cli import reporters
from audio_checks.cli.arguments import UsageError
from audio_checks.cli.terminal import in_colour


class Outputs:
    """The formats that were asked for, and the place of each."""

    def __init__(self, asked: list[str] | None, formats: Sequence[str]) -> None:
        self._places: list[tuple[str, str]] = []
        for output in asked or ["text"]:
            name, _, path = output.partition(":")
            path = "" if path == "-" else path
            if name not in formats:
                raise UsageError(f'no format "{name}"; formats: {", ".join(formats)}')
            self._places.append((name, path))
        alone = [path for name, path in self._places if path or not reporters.goes_beside(name)]
        if len(set(alone)) < len(alone) or len(set(self._places)) < len(self._places):
            raise UsageError("two formats go to the same place; name a file for one, as in --format json:report.json")

    def write(self, written: Callable[[str, bool], str]) -> None:
        """Write every format; `written` makes the text of one, coloured or not."""
        for name, path in self._places:
            if path:
                try:
                    Path(path).write_text(
                        written(name, False), encoding="utf-8", errors="backslashreplace", newline="\n"
                    )
                except OSError as error:
                    raise UsageError(f"{path}: cannot be written: {error.strerror}") from None
            else:
                sys.stdout.write(written(name, in_colour(sys.stdout)))
