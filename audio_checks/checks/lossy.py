"""`lossy`: the file did not come out of a lossy codec.

Why: MP3, AAC, Vorbis and the like leave out what is inaudible in the sound as it is. Pitched, equalised, layered or
coded again for the game, it is heard that something is missing; and a library's terms may ask for its own files.
How to fix: deliver the sound from a source that was never coded, or say in the delivery's note where it comes from: a
voice over a radio, or a find that exists no other way, is everyday craft.
Source: judged, not measured: by spectral lines that fall silent on the codec's own frames (ISO/IEC 11172-3,
ISO/IEC 14496-3, Vorbis I, RFC 6716, ATSC A/52); docs/reference/judgements.md says how often that is right. "Cannot
tell" is not a finding.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.judge import judge, score_in_words
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Lossy source"
FIGURES = ()
JUDGEMENT = "lossy"


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec names this check."""
    return "lossy" in spec.checks


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `lossy:frames` when the judgement is positive."""
    judged = judge("lossy", file, spec.kind)
    if judged.verdict != "lossy":
        return
    figures = judged.figures
    silent, elsewhere = 100 * figures["silent_share"], 100 * figures["elsewhere_share"]
    low_pass = f", and it ends at {figures['low_pass_hz'] / 1000:.1f} kHz" if figures["low_pass_hz"] else ""
    shares = f"{silent:.0f} % of its spectral lines are silent, {elsewhere:.0f} % anywhere else"
    question = f"score {score_in_words(judged.score)} of 1: was it {figures['codec']} before?"
    yield Finding(
        code="lossy:frames",
        message=f"on the frames of {figures['codec']} {shares}{low_pass}, {question}",
        fix="deliver it from a source that was never coded, or say in the delivery's note where it comes from",
        measured=round(silent, 1),
        limit=round(elsewhere, 1),
        unit="%",
    )
