"""`tail-silence`: the file ends when the sound does.

Why: silence after the sound costs memory on every platform and holds a voice of the game's mixer
that another sound could have had. Loops rightly end in mid-wave, so they are left alone:
a cue that the list calls a loop, and a file with loop points, unless the list says that its cue is none.
How to fix: trim the tail to where the sound has faded out.
Source: the delivery spec, `[limits] tail_silence_ms` and `edge_silence_below_dbfs`; silence is
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
LABEL = "Trailing silence"
LIMITS = {"tail_silence_ms": (0.0, 3_600_000.0)}
FIGURES = ("sample_peak_dbfs", "tail_silence_ms")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Only where the spec limits it, and not for a loop."""
    return spec.limits.tail_silence_ms is not None and not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `tail-silence:over` when the silence after the sound is longer than the limit."""
    limit = spec.limits.tail_silence_ms
    if limit is None or loops_by_itself(file.layout.loops, cue) or file.measurements.sample_peak_dbfs == float("-inf"):
        return
    _, tail_ms = file.measurements.edges(spec.limits.edge_silence_below_dbfs)
    if tail_ms > limit:
        length_s = file.facts.duration_s
        yield Finding(
            code="tail-silence:over",
            message=f"{tail_ms:.1f} ms of silence after the sound, limit {limit:g} ms",
            fix=f"trim {tail_ms - limit:.1f} ms or more from the end",
            measured=tail_ms,
            limit=limit,
            unit="ms",
            start_s=length_s - tail_ms / 1000,
            end_s=length_s,
        )
