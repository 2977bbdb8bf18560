"""`encoding`: the samples are stored the way the project accepts.

Why: integer and floating-point samples need different handling in a game's build, and a float
file can hold levels above full scale that the next tool clips.
How to fix: export with integer (PCM) samples, or with float ones where the spec asks for them.
Source: the delivery spec, `[accept] encodings`, or the target's encoding.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
FIGURES = ()
WORDS = {"pcm": "integer (PCM)", "float": "float"}


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Only where the spec lists encodings."""
    return spec.accept.encodings is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `encoding:not-accepted` for samples of another encoding than the spec lists."""
    wanted = spec.accept.encodings or ()
    found = file.facts.encoding
    if found not in wanted:
        yield Finding(
            code="encoding:not-accepted",
            message=f"{WORDS[found]} samples, accepted {' or '.join(WORDS[one] for one in wanted)}",
            fix=f"export with {WORDS[wanted[0]]} samples",
        )
