"""`metadata`: the file says of itself what the project asks for.

Why: who made a sound, from what, and under which rights is known on the day it is delivered. Ten
thousand files later it is known only where it was written into them.
How to fix: fill the fields in the editor's metadata window, then export again. Names are those of
the standards: bext.Originator, iXML.PROJECT, iXML.ASWG.catId, INFO.ICOP.
Source: the delivery spec, `[metadata] required`; EBU Tech 3285 (bext), iXML, ASWG-G006 (Sony's
fields in iXML), LIST/INFO; comments of FLAC files are Vorbis.TITLE and so on.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.system.plural import verb

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Metadata"
NOT_FIXED = "Only its designer knows what the field should say: fill it in the editor."
FIGURES = ()


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec requires fields."""
    return bool(spec.required_metadata)


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `metadata:missing` for required fields that hold nothing, `metadata:damaged` for an unreadable chunk."""
    metadata = file.metadata
    for sentence in metadata.damaged:
        yield Finding(
            code="metadata:damaged",
            message=sentence,
            fix="write the metadata again from your editor; what is in this chunk is lost to every reader",
        )
    missing = [name for name in spec.required_metadata if name not in metadata.fields]
    if missing:
        holds = verb(len(missing), "holds", "hold")
        summary = f"{len(missing)} of {len(spec.required_metadata)} required fields {holds} nothing"
        yield Finding(
            code="metadata:missing",
            message=f"{summary}: {', '.join(missing)}",
            fix=f"fill {'it' if len(missing) == 1 else 'them'} in the editor's metadata window, and export again",
            measured=float(len(missing)),
            limit=0.0,
            unit="fields",
        )
