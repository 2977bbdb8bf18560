"""`cut-start`: the sound does not start in the middle of its wave.

Why: where the first samples stand far from zero, the loudspeaker has to jump there, and a click is
heard before the sound. Most often the selection was drawn too late. Loops rightly start in mid-wave,
so they are left alone: a cue that the list calls a loop, and a file with loop points, unless the list
says that its cue is none.
How to fix: start the selection earlier, at a zero crossing, or fade in over a millisecond.
Source: practice in the field. The first sample reaches a fifth of the largest one in the 10 ms after
it, lies less than 36 dB under the file's peak and at -60 dBFS or more, and the wave, followed on, does
not pass through zero there. Digital silence around the sound does not hide its edge, nor does a converter of sample
rates that rings before it, nor a gentle equaliser, nor a fade-in of 0.1 ms or so.
What it does not find: a cut with so short a fade into what dies away or grows within 40 ms, for a
percussive sound's own attack is the same wave; nor one where the wave passes through zero by itself.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Abrupt start"
NOT_FIXED = "What stood before the cut is not in the file: choose an earlier start in the session."
FIGURES = ("start_edge",)
AROUND_S = 0.01


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Not for a loop."""
    return not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `cut-start:mid-wave` when the sound starts far from zero."""
    edge = file.measurements.start_edge
    if edge is None or not edge.cut or loops_by_itself(file.layout.loops, cue):
        return
    yield Finding(
        code="cut-start:mid-wave",
        message=f"starts off a zero crossing ({edge.level_dbfs:.1f} dBFS) and may click",
        fix="start the selection earlier, at a zero crossing, or fade in over a millisecond",
        measured=edge.level_dbfs,
        unit="dBFS",
        start_s=edge.at_s,
        end_s=min(file.facts.duration_s, edge.at_s + AROUND_S),
    )
