"""`placeholder`: the file is the real sound, not a stand-in for it.

Why: stand-ins (a spoken word, a beep) let the team hear what is missing. One that nobody replaced
ships with the game.
How to fix: deliver the sound for the cue that the mark names; the mark goes with the stand-in.
Source: stand-ins are marked by `SOUNDLIST:PLACEHOLDER` and the cue's number in the comment
(LIST/INFO ICMT) or in the description of a broadcast wave (bext).
"""

import re
from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from audio_checks import wav
from audio_checks.findings import Finding
from audio_checks.spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio import AudioFile

FIGURES = ()
MARK = re.compile(rb"SOUNDLIST:PLACEHOLDER(?: ([^\x00-\x1f\x7f]{1,64}))?")
DESCRIPTION_BYTES = 256  # of bext
MOST_BYTES = 1 << 20  # of a LIST chunk: comments stand near its start


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `placeholder:marked` for a file that carries the mark; an error among renders."""
    number = cue_marked(file)
    if number is not None:
        yield Finding(
            code="placeholder:marked",
            message=f"this is a stand-in{f' for cue {number}' if number else ''}, not the sound itself",
            fix="deliver the real sound in its place",
            severity="error" if spec.target is not None else None,
        )


def cue_marked(file: "AudioFile") -> str | None:
    """Return the number of the cue that a stand-in is for ("" when it names none); None for a real sound."""
    marked = [chunk for chunk in file.layout.chunks if chunk.id in ("LIST", "bext")]
    if not marked:
        return None
    with wav.open_regular(file.path) as stream:
        for chunk in marked:
            most = DESCRIPTION_BYTES if chunk.id == "bext" else MOST_BYTES
            payload = wav.chunk_payload(stream, replace(chunk, size=min(chunk.size, most)))
            text = payload if chunk.id == "bext" else _comment(payload)
            if found := MARK.match(text.lstrip()):
                return (found[1] or b"").decode("utf-8", "replace").strip()
    return None


def _comment(payload: bytes) -> bytes:
    """Return the ICMT text of a LIST/INFO chunk; empty where there is none."""
    if payload[:4] != b"INFO":
        return b""
    at = 4
    while at + 8 <= len(payload):
        size = int.from_bytes(payload[at + 4 : at + 8], "little")
        if payload[at : at + 4] == b"ICMT":
            return payload[at + 8 : at + 8 + size]
        at += 8 + size + size % 2
    return b""
