"""`cut-tail`: the sound does not end in the middle of its wave.

Why: where the last samples stand far from zero, the sound stops with a click, and its tail is
missing. Most often the selection was too short, or a limit of length cut it. Loops rightly end in
mid-wave, so they are left alone: a cue that the list calls a loop, and a file with loop points, unless
the list says that its cue is none.
How to fix: export up to the end of the tail, or fade out over its last part.
Source: practice in the field. The last sample reaches a fifth of the largest one in the 10 ms before
it, lies less than 36 dB under the file's peak and at -60 dBFS or more, and the wave, followed on, does
not pass through zero there. Digital silence around the sound does not hide its edge, nor does a converter of sample
rates that rings after it, nor a low cut's smooth answer, nor a fade-out of 0.1 ms or so.
What it does not find: a cut where the wave passes through zero by itself, and one whose answer in a
low cut is nearly as high as the sound before.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Abrupt end"
NOT_FIXED = "What stood after the cut is not in the file: let the sound ring out in the session."
FIGURES = ("end_edge",)
AROUND_S = 0.01


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Not for a loop."""
    return not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `cut-tail:mid-wave` when the sound ends far from zero."""
    edge = file.measurements.end_edge
    if edge is None or not edge.cut or loops_by_itself(file.layout.loops, cue):
        return
    yield Finding(
        code="cut-tail:mid-wave",
        message=f"ends off a zero crossing ({edge.level_dbfs:.1f} dBFS) and may click",
        fix="export up to the end of the tail, or fade out",
        measured=edge.level_dbfs,
        unit="dBFS",
        start_s=max(0.0, edge.at_s - AROUND_S),
        end_s=edge.at_s,
    )
