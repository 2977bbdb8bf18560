"""`baked-reverb`: the file comes without reverb where the game adds its own.

Why: a game puts each sound into the room it plays in. Reverb that is already in the file is heard in every
room, the open air included, and is reverberated once more.
How to fix: deliver the sound dry, with its own decay but without sends, rooms or plates. Where the tail is
part of the design, say so in the sound list (`designed-tail`), or deliver it as a layer of its own.
Source: the delivery spec, `[engine] adds`. A cue that the sound list calls `dry` is judged in any project, and one
with a designed tail in none. Reverb is judged, not measured: by how the bands fall, what the tail is made of beside
the head, and how alike left and right stay; docs/reference/judgements.md says how often that is right. Beside a dry
stem (`warp_in__dry.wav` beside `warp_in.wav`) it is what was added that counts. What likely has reverb is told as
information, for an ear; it returns no file. "Cannot tell" is not a finding: the report says in how many files.
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
    """Apply only where the spec names reverb or this check or the cue is to be dry, and not for a designed tail."""
    return spec.asks_for_dry_sound(cue)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `baked-reverb:heard` when the judgement is positive, `baked-reverb:likely` when it is probably so."""
    judged = judge("reverb", file, spec.kind)
    if judged.verdict not in ("reverb", "likely reverb"):
        return
    rt60_s, score = judged.figures["rt60_s"], score_in_words(judged.score)
    if judged.verdict == "likely reverb":
        yield Finding(
            code="baked-reverb:likely",
            message=f"sounds as if it has a room, RT60 about {rt60_s:.1f} s, score {score} of 1: listen",
            fix="listen: if it has reverb, take it off; if its tail is part of the design, say so in the sound list",
            severity="information",
            measured=rt60_s,
            unit="s",
        )
        return
    is_added = "reverb" in spec.engine.adds
    why = "the game adds its own" if is_added else f"the {'list' if _is_dry(cue) else 'spec'} asks for a dry sound"
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


def _is_dry(cue: CueFacts | None) -> bool:
    return cue is not None and cue.reverb == "dry"
