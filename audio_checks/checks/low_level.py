"""`low-level`: the sound is loud enough to be used.

Why: a file whose peak lies far under full scale was exported from a turned-down bus or recorded too low. The game
must raise it, and raises its noise and its rounding with it; and every other check of it looks at what no one hears.
How to fix: raise the level in the session, before the export, or record it again. A sound that is meant to be that
quiet is turned down in the game, not in its file.
Source: the delivery spec, `[limits] low_level_dbfs`, -40 dBFS where it says nothing; ±1.0 is 0 dBFS.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Low level"
LIMITS = {"low_level_dbfs": (-200.0, 0.0, "Too quiet below")}
NOT_FIXED = "Raising the file's level raises its noise and its rounding too: raise it in the session, and export again."
FIGURES = ("sample_peak_dbfs", "sample_peak_s")
LIMIT_DBFS = -40.0


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `low-level:peak` when no sample reaches the limit; silence is left to the silence check."""
    stated = spec.limits.low_level_dbfs
    limit = LIMIT_DBFS if stated is None else stated
    silent = spec.limits.silence_below_dbfs
    peak = file.measurements.sample_peak_dbfs
    if peak == float("-inf") or (silent is not None and peak < silent - spec.limits.tolerance_db):
        return
    if peak < limit - spec.limits.tolerance_db:
        yield Finding(
            code="low-level:peak",
            message=f"peak only {peak:.1f} dBFS, too quiet below {level_shown(limit)} dBFS",
            fix=f"raise the level by {limit - peak:.1f} dB or more in the session, and export again",
            measured=peak,
            limit=limit,
            unit="dBFS",
            start_s=file.measurements.sample_peak_s,
            end_s=file.measurements.sample_peak_s,
        )
