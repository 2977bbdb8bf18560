"""The mark of a placeholder: how it is written, and where it is found."""

from __future__ import annotations

import re
import struct
from collections.abc import Mapping

MARK = "SOUNDLIST:PLACEHOLDER"
MARKED_FIELDS = ("INFO.ICMT", "bext.Description", "Vorbis.COMMENT", "Vorbis.DESCRIPTION")
STATE_FIELD = "iXML.ASWG.state"
BEXT_BYTES = 602
_MARKED = re.compile(MARK + r"(?: ([^\x00-\x1f\x7f]{1,64}))?")


def cue_marked(fields: Mapping[str, str]) -> str | None:
    """Return the number of the cue that a placeholder is for.

    Parameters
    ----------
    fields : mapping of str
        What a file says of itself, by name; see `Metadata`.

    Returns
    -------
    str or None
        "" when the mark names no cue; None for a real sound.
    """
    for name in MARKED_FIELDS:
        if match := _MARKED.match(fields.get(name, "")):
            return (match[1] or "").strip()
    return "" if fields.get(STATE_FIELD, "").lower() == "placeholder" else None


def comment_chunk(number: str) -> tuple[str, bytes]:
    """Return the LIST/INFO chunk that marks a placeholder for a cue."""
    text = _text(number) + b"\0"
    entry = b"ICMT" + struct.pack("<I", len(text)) + text + b"\0" * (len(text) % 2)
    return "LIST", b"INFO" + entry


def marked_comment(number: str) -> tuple[str, str]:
    """Return the Vorbis comment that marks a placeholder for a cue, its name and its text."""
    return "COMMENT", _text(number).decode()


def broadcast_chunk(number: str) -> tuple[str, bytes]:
    """Return the bext chunk that marks a placeholder for a cue."""
    return "bext", _text(number)[:256].ljust(BEXT_BYTES, b"\0")


def _text(number: str) -> bytes:
    cue = "".join(character for character in number if character.isprintable())[:64].strip()
    return f"{MARK} {cue}".strip().encode()
