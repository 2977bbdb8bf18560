"""`dropout`: the sound has no holes, and no stretch of it plays twice.

Why: a computer that came too late while it recorded or exported leaves a buffer out, holds the last
sample, or plays the buffer before again. It is heard as a stutter.
How to fix: export again with a larger buffer, or offline; a recording needs another take, or the
place painted over. A rhythm of holes that are alike is taken for a gate that is meant.
Source: practice in the field. A hole is a millisecond or more without movement, or in which nothing moves
but a last value that leaks away or a straight line, or one and a half of hiss 25 dB or more under the sound,
with sound up to both its edges; a repeat is a buffer of 64 to 2048 frames that comes again bit by bit, at
once or after up to three others, as a ring of buffers gives it that is not filled in time. A hole that
hisses louder, or that fades of 10 ms lead into and out of, cannot be distinguished from a pause of the sound itself.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Dropouts"
NOT_FIXED = "The missing sound is not in the file: export it again from the session."
FIGURES = ("dropouts", "dropout_places", "repeats", "repeat_places", "sample_peak_dbfs")
PLACES_NAMED = 3
FIX = "export it again with a larger buffer or offline; if the recording has it, record again or repair the place"


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `dropout:hole` at the longest hole, and `dropout:repeat` at the longest repeat."""
    if file.measurements.is_inaudible:
        return
    holes = [(start_s, end_s) for start_s, end_s, _ in file.measurements.dropout_places]
    if holes:
        yield _finding("hole", "hole", file.measurements.dropouts, holes)
    repeats = [(start_s, end_s) for start_s, end_s, _ in file.measurements.repeat_places]
    if repeats:
        yield _finding("repeat", "repeated buffer", file.measurements.repeats, repeats)


def _finding(condition: str, name: str, count: int, spans: list[tuple[float, float]]) -> Finding:
    start_s, end_s = max(spans, key=lambda span: span[1] - span[0])
    named = ", ".join(f"{start_s:.3f} s" for start_s, _ in spans[:PLACES_NAMED])
    more = ", ..." if count > PLACES_NAMED else ""
    plural = "" if count == 1 else "s"
    longest = "" if count == 1 else "the longest "
    return Finding(
        code=f"dropout:{condition}",
        message=f"{count} {name}{plural} in the sound ({named}{more}), {longest}{1000 * (end_s - start_s):.1f} ms long",
        fix=FIX,
        measured=float(count),
        limit=0.0,
        unit=f"{name}s",
        start_s=start_s,
        end_s=end_s,
    )
