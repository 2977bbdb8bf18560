"""`reversed`: the sound plays the way it was recorded.

Why: a recording turned round may hide whose it is, or what is said in it: profanity has shipped as a spell. Turned
round on purpose, as a suck-in or a swell, it is everyday craft.
How to fix: say in the delivery's note that it is meant so and what was turned round, or deliver it forwards.
Source: judged, not measured: by how each octave rises against how it falls; docs/reference/judgements.md says how often
that is right. "Cannot tell" is not a finding. Every take plays backwards at one key on its page and in review.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.judge import judge, score_in_words
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Reversed sound"
FIGURES = ()
JUDGEMENT = "reversed"


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec names this check, and not for a loop, which has no beginning."""
    return "reversed" in spec.checks and not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `reversed:heard` when the judgement is positive."""
    judged = judge("reversed", file, spec.kind)
    if judged.verdict == "reversed":
        yield Finding(
            code="reversed:heard",
            message=f"looks played backwards, score {score_in_words(judged.score)} of 1: is it meant so?",
            fix="listen to it backwards; say in the delivery's note what was turned round, or deliver it forwards",
            measured=judged.score,
        )
