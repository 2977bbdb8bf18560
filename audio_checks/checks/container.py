"""`container`: the file is of a kind the project accepts.

Why: a game's build takes one or two kinds of file, and what is inside decides, not the ending of
the name. An MP3 renamed to .wav is still an MP3.
How to fix: export as WAV from the session; do not rename or convert a compressed file.
Source: the delivery spec, `[accept] containers`.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Container"
IN_CATEGORIES = True
FIGURES = ()


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec lists containers."""
    return spec.accept.containers is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `container:not-accepted` for a readable container that the spec does not list."""
    accepted = spec.accept.containers or ()
    container = file.facts.container
    if container not in accepted:
        yield Finding(
            code="container:not-accepted",
            message=f"container {container.upper()}, accepted {', '.join(accepted).upper()}",
            fix=f"export the sound as {accepted[0].upper()}",
        )
