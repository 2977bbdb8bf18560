"""`head-silence`: the sound starts when it is asked to.

Why: silence before the sound is heard as lag: the shot comes after the trigger. Loops rightly
start in mid-wave, so they are left alone: a cue that the list calls a loop, and a file with loop
points, unless the list says that its cue is none.
How to fix: trim the head to the first audible sample, with a fade of a few samples.
Source: the delivery spec, `[limits] head_silence_ms` and `edge_silence_below_dbfs`; silence is
what lies below that level, or 60 dB under the file's peak, whichever is lower.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Leading silence"
LIMITS = {"head_silence_ms": (0.0, 3_600_000.0), "edge_silence_below_dbfs": (-200.0, 60.0, "Trim threshold")}
FIGURES = ("sample_peak_dbfs", "head_silence_ms")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits it, and not for a loop."""
    return spec.limits.head_silence_ms is not None and not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `head-silence:over` when the silence before the sound is longer than the limit."""
    limit = spec.limits.head_silence_ms
    if limit is None or loops_by_itself(file.layout.loops, cue) or file.measurements.sample_peak_dbfs == float("-inf"):
        return
    head_ms, _ = file.measurements.edges(spec.limits.edge_silence_below_dbfs)
    if head_ms > limit:
        yield Finding(
            code="head-silence:over",
            message=f"{head_ms:.1f} ms of silence before the sound, limit {limit:g} ms",
            fix=f"trim {head_ms - limit:.1f} ms or more from the start",
            measured=head_ms,
            limit=limit,
            unit="ms",
            start_s=0.0,
            end_s=head_ms / 1000,
        )
