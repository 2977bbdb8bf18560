"""`dc-offset`: the waveform is centred on zero.

Why: an offset wastes headroom, and clicks where the sound starts, stops or is cut. It comes
from a faulty converter, an asymmetric distortion or a badly made synthesis.
How to fix: put a high-pass filter at 10 to 20 Hz on the sound, or use the editor's DC removal. Where the
whole sound stands on the same offset, `audio-checks fix` takes it out.
Source: the delivery spec, `[limits] dc_offset_percent`, of full scale, in the worst channel.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "DC offset"
LIMITS = {"dc_offset_percent": (0.0, 100.0)}
FIGURES = ("dc_offset_percent",)


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits the offset."""
    return spec.limits.dc_offset_percent is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `dc-offset:over` when the mean of any channel lies further from zero than the limit."""
    limit = spec.limits.dc_offset_percent
    offset = file.measurements.dc_offset_percent
    if limit is not None and abs(offset) > limit:
        yield Finding(
            code="dc-offset:over",
            message=f"DC offset {offset:.2f} % of full scale, limit {limit:g} %",
            fix="remove it with a high-pass filter at 10 to 20 Hz, then check the level again",
            measured=offset,
            limit=limit,
            unit="%",
        )
