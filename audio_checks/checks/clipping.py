"""`clipping`: no crests are cut off.

Why: crests pressed flat against one level mean that something clipped: at full scale, or under it
when the level was lowered afterwards, or softly in a saturator. In guns and explosions they can be
style, so this warns, and is for an ear to judge.
How to fix: listen at the marked places. If it is a fault, lower the gain before the stage that
clips, and export again; lowering the file's level leaves the clipping in.
Source: practice in the field. At full scale three samples in a row count. Under it, three crests at
the file's own ceiling, each with three samples or more on one level and a corner at both ends. Soft
tops count where most of the highest crests, and eight or more, are half as round as a wave's.
Where a low cut made the tops lean, a volume was ridden or a converter of sample rates left ripples,
four crests count that are straight between two corners, and a fifth of all that lie as high near by.
What it does not find: crests cut off before other filters than these, or for less than some five
samples before a change of the sample rate: their corners are rounded, as those of any drive are.
Square waves and waves of steps are flat by nature, and left alone.
"""

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile
    from audio_checks.measure.flat_tops import FlatTop

SEVERITY = "warning"
LABEL = "Clipping"
IN_CATEGORIES = True
NOT_FIXED = (
    "What was cut off at the top is gone, and a lower level does not bring it back: lower the level before the "
    "limiter or converter, and export again."
)
FIGURES = ("clipped_runs", "clipped_spans", "soft_tops", "soft_spans", "sample_peak_dbfs")
PLACES_NAMED = 3


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `clipping:flat-tops` for crests that are cut off, else `clipping:soft-tops` for flattened ones."""
    if file.measurements.is_inaudible:
        return
    figures = file.measurements
    if figures.clipped_runs:
        yield _finding("flat-tops", "clipped run", figures.clipped_runs, figures.clipped_spans)
    elif figures.soft_tops:
        yield _finding("soft-tops", "soft-clipped peak", figures.soft_tops, figures.soft_spans)


def _finding(condition: str, unit: str, count: int, spans: "Sequence[FlatTop]") -> Finding:
    level = max(span.level_dbfs for span in spans)
    places = ", ".join(f"{span.start_s:.3f} s" for span in spans[:PLACES_NAMED])
    more = ", ..." if count > PLACES_NAMED else ""
    plural = "" if count == 1 else "s"
    return Finding(
        code=f"clipping:{condition}",
        message=f"{count} {unit}{plural} at {level:.1f} dBFS ({places}{more})",
        fix="listen there: if it is not meant, lower the gain before the stage that clips and export again",
        measured=float(count),
        limit=0.0,
        unit=f"{unit}s",
        start_s=spans[0].start_s,
        end_s=spans[0].end_s,
    )
