"""`phase`: a stereo sound is still there when it is played in mono.

Why: phones, many televisions and most 3D sources play one channel. What is out of phase between left
and right is cancelled there: a wide sound turns thin, or is gone.
How to fix: look for a swapped polarity, a stereo widener or a delay of some samples between left
and right; narrow the lows; listen in mono.
Source: the delivery spec, `[limits] mono_loss_db`: mean power of the channels over that of
(left + right) / 2. Equal channels lose 0 dB, unrelated ones 3 dB.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Mono fold-down loss"
LIMITS = {"mono_loss_db": (0.0, 120.0)}
NOT_FIXED = (
    "How the channels stand to each other is part of the sound: turn the polarity round or narrow the width in "
    "the session."
)
FIGURES = ("mono_loss_db", "mono_loss_spans")
NOTHING_LEFT_DB = 90.0


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits it."""
    return spec.limits.mono_loss_db is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `phase:mono-loss` when the sound loses more than the limit in mono; its longest such stretch is named."""
    limit, loss = spec.limits.mono_loss_db, file.measurements.mono_loss_db
    if limit is None or loss is None or loss <= limit + spec.limits.tolerance_db:
        return
    start_s, end_s = max(
        file.measurements.mono_loss_spans(limit), key=lambda span: span[1] - span[0], default=(0.0, None)
    )
    lost = "all of its level" if loss > NOTHING_LEFT_DB else f"{loss:.1f} dB"
    yield Finding(
        code="phase:mono-loss",
        message=f"loses {lost} when summed to mono, limit {limit:g} dB",
        fix="look for swapped polarity, a widener or a delay between left and right",
        measured=loss,
        limit=limit,
        unit="dB",
        start_s=start_s,
        end_s=end_s,
    )
