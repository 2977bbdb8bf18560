"""`true-peak`: the waveform stays under the true-peak limit of the spec.

Why: a converter rebuilds the curve that runs between the samples. A file whose samples all lie
below 0 dBFS can exceed full scale there, and clip in the player's device or in a lossy encoder.
How to fix: lower the level, or use a true-peak limiter at the ceiling that the spec names.
Source: ITU-R BS.1770, Annex 2.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown, lowering_advice
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "True peak"
LIMITS = {"true_peak_dbtp": (-200.0, 60.0)}
FIGURES = ("true_peak_dbtp", "true_peak_s", "sample_peak_dbfs", "clipped_spans")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits true peaks."""
    return spec.limits.true_peak_dbtp is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `true-peak:over` when the curve of the loudest channel exceeds the limit."""
    limit = spec.limits.true_peak_dbtp
    level = file.measurements.true_peak_dbtp
    if limit is not None and level > limit + spec.limits.tolerance_db:
        at_s = file.measurements.true_peak_s
        yield Finding(
            code="true-peak:over",
            message=f"true peak {level:z.2f} dBTP, limit {level_shown(limit)} dBTP",
            fix=lowering_advice(level - limit, is_cut_off=file.measurements.is_cut_off),
            measured=level,
            limit=limit,
            unit="dBTP",
            start_s=at_s,
            end_s=at_s,
        )
