"""`sample-peak`: no sample lies above the peak limit of the spec.

Why: a file at full scale leaves the game's mixer no room, and any later gain, fade or conversion
clips it. It is often the sign of a limiter driven too hard.
How to fix: lower the level by the amount named, in the session rather than in the finished file.
Source: the delivery spec, `[limits] sample_peak_dbfs`; ±1.0 is 0 dBFS.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown, lowering_advice
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Sample peak"
LIMITS = {"sample_peak_dbfs": (-200.0, 60.0), "tolerance_db": (0.0, 12.0, "Tolerance on levels")}
FIGURES = ("sample_peak_dbfs", "sample_peak_s", "clipped_spans")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits sample peaks."""
    return spec.limits.sample_peak_dbfs is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `sample-peak:over` when the loudest sample of any channel exceeds the limit."""
    limit = spec.limits.sample_peak_dbfs
    peak = file.measurements.sample_peak_dbfs
    if limit is not None and peak > limit + spec.limits.tolerance_db:
        at_s = file.measurements.sample_peak_s
        yield Finding(
            code="sample-peak:over",
            message=f"sample peak {peak:z.2f} dBFS, limit {level_shown(limit)} dBFS",
            fix=lowering_advice(peak - limit, is_cut_off=file.measurements.is_cut_off),
            measured=peak,
            limit=limit,
            unit="dBFS",
            start_s=at_s,
            end_s=at_s,
        )
