"""`clipping`: the waveform has no runs of flat tops.

Why: a run of samples pressed against one level usually means that something clipped before the
file was made. Lowering the level afterwards leaves the flat tops in. In guns and explosions they
can be style, so this warns, and is for an ear to judge.
How to fix: listen at the marked places. If it is a fault, lower the gain before the stage that
clips, and export again.
Source: practice in the field; levels after gain cannot be told from the peak alone.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.findings import Finding
from audio_checks.spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio import AudioFile

FIGURES = ("clipped_runs", "clipped_spans")
PLACES_NAMED = 3


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:  # noqa: ARG001
    """Yield one `clipping:flat-tops` for the file, at its first run, when there is any."""
    runs = file.measurements.clipped_runs
    if not runs:
        return
    spans = sorted(file.measurements.clipped_spans)
    places = ", ".join(f"{start_s:.3f} s" for start_s, _, _ in spans[:PLACES_NAMED])
    more = ", ..." if runs > PLACES_NAMED else ""
    start_s, end_s, _ = spans[0]
    yield Finding(
        code="clipping:flat-tops",
        message=f"{runs} {'run' if runs == 1 else 'runs'} of flat tops ({places}{more})",
        fix="listen there: if it is not meant, lower the gain before the stage that clips and export again",
        measured=float(runs),
        limit=0.0,
        unit="runs",
        start_s=start_s,
        end_s=end_s,
    )
