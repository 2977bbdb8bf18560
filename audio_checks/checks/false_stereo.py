"""`false-stereo`: the two channels of a stereo file are two.

Why: a mono sound in a stereo file takes twice the memory, is not placed in the 3D world by most
engines, and says of itself that it is wide. It comes from a mono track bounced through a stereo bus.
How to fix: export it as mono. If it should be wide, look for the plug-in that summed it.
Source: the level of left − right under the louder channel; at −60 dB no width is audible.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Dual mono"
NOT_FIXED = "Whether it should be mono is its designer's choice: export it with one channel, or with two that differ."
FIGURES = ("channel_difference_db",)
LIMIT_DB = -60.0


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `false-stereo:equal` for equal channels, `false-stereo:nearly` for channels that hardly differ."""
    difference = file.measurements.channel_difference_db
    if difference is None or difference >= LIMIT_DB:
        return
    equal = difference == float("-inf")
    yield Finding(
        code="false-stereo:equal" if equal else "false-stereo:nearly",
        message="dual mono: left and right are identical"
        if equal
        else f"dual mono: left and right differ only at {difference:.0f} dB, limit {LIMIT_DB:.0f} dB",
        fix="export it as mono; or, if it should be wide, look for what sums it in the session",
        measured=difference,
        limit=LIMIT_DB,
        unit="dB",
        start_s=0.0,
        end_s=file.facts.duration_s,
    )
