"""`loop-points`: loops lie inside the file, and repeat without a click.

Why: where the wave jumps or bends from the loop's last frame to its first, a tick is heard at every
turn. A loop that points outside the file plays noise, or nothing, depending on the engine.
How to fix: move the loop's end so that wave and slope meet, or fade across the seam in the editor;
write new points after every change of length or sample rate.
Source: the `smpl` chunk (Microsoft and IBM, Multimedia Data Standards Update, 1994); without one, a
cue that is asked for as a loop loops as a whole. The step at the seam is compared with the largest
one in the 10 ms before and after it, and so is the bend.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Loop points"
NOT_FIXED = "Where a loop begins and ends is its designer's choice: set the points in the editor."
FIGURES = ("seam_step_db", "seam_slope_db")
STEP_DB = 6.0  # over the largest step nearby
BEND_DB = 12.0  # over the largest change of slope nearby
AROUND_S = 0.01
FIX = "move the loop's end so that wave and slope meet, or fade across the seam"


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `loop-points:outside` for loops beyond the file, `loop-points:step` or `:bend` for a seam that is heard."""
    for loop in file.layout.loops_outside:
        yield Finding(
            code="loop-points:outside",
            message=f"a loop runs from frame {loop.start} to {loop.end}, but the file has {file.facts.frames} frames",
            fix="export the loop points again from the session",
        )
    loops = file.layout.loops
    if loops:
        last, turns_back = loops[0].end, loops[0].kind != "forward"
    else:
        last, turns_back = file.facts.frames - 1, not (cue is not None and cue.loop)
    if turns_back:
        return
    seam_s = (last + 1) / file.facts.sample_rate_hz
    step, bend = file.measurements.seam_step_db, file.measurements.seam_slope_db
    if step > STEP_DB:
        yield _finding("step", f"the wave jumps at the loop's seam, {step:.1f} dB over", step, STEP_DB, seam_s)
    elif bend > BEND_DB:
        yield _finding("bend", f"the wave bends at the loop's seam, {bend:.1f} dB over", bend, BEND_DB, seam_s)


def _finding(condition: str, what: str, measured: float, limit: float, seam_s: float) -> Finding:
    return Finding(
        code=f"loop-points:{condition}",
        message=f"{what} the largest {condition} near it, limit {limit:g} dB",
        fix=FIX,
        measured=measured,
        limit=limit,
        unit="dB",
        start_s=max(0.0, seam_s - AROUND_S),
        end_s=seam_s,
    )
