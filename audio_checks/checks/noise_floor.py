"""`noise-floor`: where the sound pauses, it is quiet enough.

Why: the hiss of a preamplifier or a room stands out as soon as a line is cut, gated by the game or
played beside others that are clean.
How to fix: record closer and quieter; reduce the noise with a light hand, or let an expander close
the pauses softly.
Source: the delivery spec, `[limits] noise_floor_dbfs`: the RMS of the quietest 0.2 s, in the noisiest
channel, where it is steady and 12 dB or more under the loudest. A sound without such a pause has
no floor that can be separated from the sound.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Noise floor"
LIMITS = {"noise_floor_dbfs": (-200.0, 60.0)}
NOT_FIXED = "Taking it out changes the sound around it, so it is done by ear: in the session, or in a restoration tool."
FIGURES = ("noise_floor_dbfs",)


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits it."""
    return spec.limits.noise_floor_dbfs is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `noise-floor:over` when the quietest pause is louder than the limit."""
    limit, floor = spec.limits.noise_floor_dbfs, file.measurements.noise_floor_dbfs
    if limit is None or floor is None or floor <= limit + spec.limits.tolerance_db:
        return
    yield Finding(
        code="noise-floor:over",
        message=f"noise floor {floor:.1f} dBFS, limit {level_shown(limit)} dBFS",
        fix=f"bring the noise of the pauses down by {floor - limit:.1f} dB or more",
        measured=floor,
        limit=limit,
        unit="dBFS",
    )
