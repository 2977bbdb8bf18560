"""`structure`: the file is whole, and says of itself what it holds.

Why: players are lenient in different ways. A file whose header and content disagree plays in one
tool, is cut short in another and crashes a third; in a game it is the last tool that counts.
How to fix: export the file again from the session, or copy it again if a transfer was cut off.
Source: RIFF and RF64 (EBU Tech 3306), WAVE and WAVEFORMATEXTENSIBLE; rules R1 to R7, R11 and R12.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "File structure"
FIGURES = ()


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield faults that the reader tolerated; one that it cannot makes a file unreadable, and no check is called."""
    for warning in file.warnings:
        yield Finding(code=warning.code, message=warning.message, fix=warning.fix, severity="warning")
    used, stated = file.facts.effective_bits, file.facts.bit_depth
    if used is not None and used > stated:
        yield Finding(
            code="structure:valid-bits",
            message=f"the samples make use of {used} bits, but the header says that {stated} count",
            fix="export it again from your audio editor as WAV; a reader that believes the header cuts the rest off",
            severity="warning",
            measured=float(used),
            limit=float(stated),
            unit="bit",
        )
