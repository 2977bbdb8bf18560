"""`upsampled`: the file has what its sample rate can hold.

Why: bringing a sound up to a higher rate adds nothing to it but its size, and what the game makes of it later is
made of the lower rate. A master at its true rate is the better one.
How to fix: deliver the sound at the rate it was made or recorded at, or say in the delivery's note what it is: a
library sound pitched down, or a vintage source, ends as steeply, and is everyday craft.
Source: judged, not measured: by where the mean spectrum ends, how steeply, and whether a resampler from a common
rate would end there; docs/reference/judgements.md says how often that is right. "Cannot tell" is not a finding.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.judge import judge, score_in_words
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Upsampled sound"
FIGURES = ()
JUDGEMENT = "upsampled"


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec names this check."""
    return "upsampled" in spec.checks


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `upsampled:cliff` when the judgement is positive."""
    judged = judge("upsampled", file, spec.kind)
    if judged.verdict != "upsampled":
        return
    edge_hz, drop_db, from_hz = (judged.figures[name] for name in ("edge_hz", "drop_db", "from_hz"))
    ends = f"the spectrum ends at {edge_hz / 1000:.1f} kHz and drops by {drop_db:.0f} dB there"
    question = "was it brought up" + (f" from {from_hz} Hz?" if from_hz else ", or pitched down?")
    yield Finding(
        code="upsampled:cliff",
        message=f"{ends}, score {score_in_words(judged.score)} of 1: {question}",
        fix="deliver it at the rate it was made at, or say in the delivery's note what the source is",
        measured=edge_hz,
        limit=file.facts.sample_rate_hz / 2,
        unit="Hz",
    )
