"""`silence`: the file holds a sound, in every channel.

Why: an export from a muted track, or from the wrong range of the session, looks like any other
file until someone listens. A stereo file with one dead channel is heard from one side only.
How to fix: unmute the track, or choose the right range, and export again.
Source: the delivery spec, `[limits] silence_below_dbfs`.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Silence"
LIMITS = {"silence_below_dbfs": (-200.0, 60.0, "Counts as silence below")}
NOT_FIXED = "There is no sound to fix: unmute the track or choose the right range, and export again."
FIGURES = ("sample_peak_dbfs", "channel_peaks_dbfs")


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec defines silence."""
    return spec.limits.silence_below_dbfs is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `silence:file` for a file that never exceeds the limit, else `silence:channel` for channels that do not."""
    limit = spec.limits.silence_below_dbfs
    if limit is None:
        return
    peak = file.measurements.sample_peak_dbfs
    if peak < limit - spec.limits.tolerance_db:
        level = "digital silence" if peak == float("-inf") else f"peak only {peak:.1f} dBFS"
        yield Finding(
            code="silence:file",
            message=f"{level}, silent below {level_shown(limit)} dBFS",
            fix="unmute the track or choose the right range, and export again",
            measured=peak,
            limit=limit,
            unit="dBFS",
            start_s=0.0,
            end_s=file.facts.duration_s,
        )
        return
    channels = enumerate(file.measurements.channel_peaks_dbfs, start=1)
    dead = [channel for channel, level in channels if level < limit - spec.limits.tolerance_db]
    if dead:
        named = ", ".join(map(str, dead))
        yield Finding(
            code="silence:channel",
            message=f"no sound in channel {named} of {file.facts.channels}",
            fix="export the sound in mono, or bring the missing channel back",
            severity="warning",
            start_s=0.0,
            end_s=file.facts.duration_s,
        )
