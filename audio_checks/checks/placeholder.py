"""`placeholder`: the file is the real sound, not a placeholder for it.

Why: placeholders (a spoken word, a beep) let the team hear what is missing. One that was not replaced
ships with the game.
How to fix: deliver the sound for the cue that the mark names; the mark goes with the placeholder.
Source: placeholders are marked by `SOUNDLIST:PLACEHOLDER` and the cue's number in the comment
(LIST/INFO ICMT, or COMMENT of a FLAC file) or in the description of a broadcast wave (bext); other
tools say `placeholder` as the state in iXML (ASWG-G006).
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.metadata.mark import cue_marked
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"  # an error when renders are judged
LABEL = "Placeholder"
IN_CATEGORIES = True
NOT_FIXED = "A placeholder is replaced by the sound itself."
FIGURES = ()


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `placeholder:marked` for a file that carries the mark; an error among renders."""
    number = cue_marked(file.metadata.fields)
    if number is not None:
        yield Finding(
            code="placeholder:marked",
            message=f"this is a placeholder{f' for cue {number}' if number else ''}, not the final sound",
            fix="deliver the final sound",
            severity="error" if spec.target is not None else None,
        )
