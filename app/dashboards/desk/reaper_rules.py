"""A project for REAPER as text: a region for each file that is owed, rendered under the region's name; no session.

Regions lie one after the other. What came back has its change requests as markers at their times.
"""

import base64
from collections.abc import Iterator, Sequence
from typing import NamedTuple

GAP_S = 2.0
UNKNOWN_LENGTH_S = 2.0
SHOWN_CHARS = 200
MOST_LINES = 40
REGION = 1  # a flag of a marker: it and the next of its number are a region's two ends
ALL_REGIONS = 3  # what is rendered
QUOTES = "\"'`"


class OwedFile(NamedTuple):
    """One file that a designer owes.

    Attributes
    ----------
    stem : str
        Its name without the ending: the region's name.
    length_s : float or None
        As the list or the former version has it; None where neither says.
    notes : tuple of (float, str)
        Times from its beginning, and what is to change there.
    """

    stem: str
    length_s: float | None
    notes: tuple[tuple[float, str], ...] = ()


class RenderFormat(NamedTuple):
    """The delivery spec's format of masters."""

    sample_rate_hz: int
    bit_depth: int


def reaper_project(title: str, about: Sequence[str], files: Sequence[OwedFile], render_format: RenderFormat) -> str:
    """Return the text of a project, in the order of the files."""
    lines = [
        '<REAPER_PROJECT 0.1 "6.0" 0',
        "  <NOTES 0 2",
        *(f"    |{_one_line(line)}" for line in [title, *about][:MOST_LINES]),
        "  >",
        f"  SAMPLERATE {render_format.sample_rate_hz} 1 0",
        "  TEMPO 120 4 4",
        '  RENDER_FILE "Renders"',
        '  RENDER_PATTERN "$region"',
        f"  RENDER_FMT 0 2 {render_format.sample_rate_hz}",
        "  RENDER_1X 0",
        f"  RENDER_RANGE {ALL_REGIONS} 0 0 18 1000",
        "  RENDER_STEMS 0",
        "  RENDER_DITHER 0",
        "  <RENDER_CFG",
        f"    {_wave_format(render_format.bit_depth)}",
        "  >",
        *(f"  {line}" for line in _markers(files)),
        "  <TRACK",
        '    NAME "Sounds"',
        "  >",
        ">",
    ]
    return "\n".join(lines) + "\n"


def _markers(files: Sequence[OwedFile]) -> Iterator[str]:
    at_s, notes = 0.0, 0
    for number, file in enumerate(files, start=1):
        length_s = file.length_s or UNKNOWN_LENGTH_S
        yield f"MARKER {number} {at_s:.6f} {_quoted(file.stem)} {REGION}"
        yield f'MARKER {number} {at_s + length_s:.6f} "" {REGION}'
        for note_s, text in file.notes:
            notes += 1
            yield f"MARKER {notes} {at_s + min(max(note_s, 0.0), length_s):.6f} {_quoted(text)} 0"
        at_s += length_s + GAP_S


def _wave_format(bit_depth: int) -> str:
    """Return the settings of a WAV render: the codec's name backwards, its depth, and no options."""
    return base64.b64encode(b"evaw" + bytes([bit_depth, 0, 0])).decode()


def _one_line(text: str) -> str:
    kept = "".join(character if character.isprintable() else " " for character in text)
    return " ".join(kept.split())[:SHOWN_CHARS]


def _quoted(text: str) -> str:
    """Return a text between quotation marks that it does not hold; one with all three loses the last kind."""
    line = _one_line(text)
    mark = next((mark for mark in QUOTES if mark not in line), "`")
    return f"{mark}{line.replace('`', chr(39)) if mark == '`' else line}{mark}"
