"""`baked-reverb`: the file comes without reverb where the game adds its own.

Why: a game puts each sound into the room it plays in. Reverb that is already in the file is heard in every
room, the open air included, and is reverberated once more.
How to fix: deliver the sound dry, with its own decay but without sends, rooms or plates. Where the tail is
part of the design, say so in the sound list (`designed-tail`), or deliver it as a layer of its own.
Source: the delivery spec, `[engine] adds`. Reverb is judged, not measured: by how the bands fall, what the
tail is made of beside the head, and how alike left and right stay; docs/judgements.md says how often that is
right. Beside a dry stem (`warp_in__dry.wav` beside `warp_in.wav`) it is what was added that counts. "Cannot
tell" is not a finding, and a cue whose list asks for a designed tail has none.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.judge import judge, score_in_words
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Baked-in reverb"
FIGURES = ()
JUDGEMENT = "reverb"


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Only where the spec names reverb or this check, and not for a cue that asks for a designed tail."""
    return spec.asks_for_dry_sound(cue)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `baked-reverb:heard` when the judgement is positive."""
    judged = judge("reverb", file, spec.kind)
    if judged.verdict != "reverb":
        return
    rt60_s, score = judged.figures["rt60_s"], score_in_words(judged.score)
    why = "the game adds its own" if "reverb" in spec.engine.adds else "the spec asks for a dry sound"
    added = f" added to {judged.figures['beside']}" if "beside" in judged.figures else ""
    yield Finding(
        code="baked-reverb:heard",
        message=f"reverb of about {rt60_s:.1f} s{added}, score {score} of 1, and {why}: needs a listen",
        fix="take the reverb off, and deliver its tail as a layer of its own"
        if cue is not None and cue.reverb == "separate-tail"
        else "take the reverb off, or say in the sound list that the tail is part of the design",
        measured=rt60_s,
        unit="s",
    )
