"""`internal-silence`: the file holds one sound, not several with silence between them.

Why: takes that were exported in one file play one after the other each time, and never one at random; a blip long
after the sound holds a voice of the mixer for nothing. Loops, ambience, music and voice pause by nature, and are left
alone: a cue that the list calls a loop, a file with loop points, and categories of these kinds.
How to fix: split the file at the pauses, or at its markers, into the variations of the cue; or close the pause.
Source: practice in the field. Silence is what stays below -60 dBFS, or 60 dB under the file's peak if that is lower,
for 0.6 s or more, with sound before and after.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Internal silence"
NOT_FIXED = "Which part is which variation, a person says: split it on the desk, or in the session."
FIGURES = ("pauses",)
PAUSING_KINDS = frozenset({"ambience", "music", "voice"})
PLACES_NAMED = 3


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Not for a loop, nor for what pauses by nature."""
    return spec.kind not in PAUSING_KINDS and not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `internal-silence:pause`, once for the file, at its longest pause."""
    pauses = file.measurements.pauses
    if not pauses or loops_by_itself(file.layout.loops, cue):
        return
    start_s, end_s = max(pauses, key=lambda pause: pause[1] - pause[0])
    named = ", ".join(f"{start:.2f} s" for start, _ in pauses[:PLACES_NAMED])
    more = ", ..." if len(pauses) > PLACES_NAMED else ""
    longest = "" if len(pauses) == 1 else "the longest "
    yield Finding(
        code="internal-silence:pause",
        message=(
            f"{len(pauses) + 1} sounds with silence between them ({named}{more}), {longest}{end_s - start_s:.2f} s long"
        ),
        fix=_fix(cue, len(pauses) + 1),
        measured=end_s - start_s,
        unit="s",
        start_s=start_s,
        end_s=end_s,
    )


def _fix(cue: CueFacts | None, parts: int) -> str:
    into = f"the cue's {cue.variations} variations" if cue is not None and cue.variations > 1 else "variations"
    return f"split it at the silence or at its markers into {parts} files, as {into}; or close the pause"
