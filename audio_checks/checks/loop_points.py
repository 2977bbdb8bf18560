"""`loop-points`: loops are wanted, lie inside the file, and repeat without a click.

Why: engines play a file with loop points round and round, also where the list asks for a sound that
plays once. Where the wave jumps or bends from the loop's last frame to its first, a tick is heard at
every turn. A loop that points outside the file plays noise, or nothing, depending on the engine, and
one of a single frame holds one value: silence, and a click before and after it.
How to fix: delete the loop points of a sound that plays once. Otherwise move the loop's end so that
wave and slope meet, or fade across the seam in the editor; write new points after every change of
length or sample rate.
Source: the `smpl` chunk (Microsoft and IBM, Multimedia Data Standards Update, 1994); without one, a
cue that is asked for as a loop loops as a whole. The step at the seam is compared with the largest
one in the 10 ms before and after it, and so is the bend. A loop that is played backward crosses the
same seam; one that is played back and forth turns at both ends, where the wave may only bend; one of
a manufacturer's own kind is taken for a forward one.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Loop points"
NOT_FIXED = "Where a loop begins and ends is its designer's choice: set the points in the editor."
FIGURES = ("seam_step_db", "seam_slope_db", "loop_seams")
STEP_DB = 6.0  # over the largest step nearby
BEND_DB = 12.0  # over the largest change of slope nearby
AROUND_S = 0.01
FIX = "move the loop's end so that wave and slope meet, or fade across the seam"


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield the faults of a file's loops.

    `loop-points:outside` for loops beyond the file, `loop-points:unwanted` where the list asks for no loop,
    `loop-points:one-frame`, and `loop-points:step` or `:bend` for a seam that is heard.
    """
    for loop in file.layout.loops_outside:
        yield Finding(
            code="loop-points:outside",
            message=f"a loop runs from frame {loop.start} to {loop.end}, "
            f"but the file has {_frames_in_words(file.facts.frames)}",
            fix="export the loop points again from the session",
        )
    loops, rate = file.layout.loops, file.facts.sample_rate_hz
    if loops and not loops_by_itself(file.layout.loops, cue):
        yield Finding(
            code="loop-points:unwanted",
            message=f"the sound list says that this sound is no loop, but the file has {_loops_in_words(len(loops))}: "
            f"engines repeat frames {loops[0].start} to {loops[0].end} until the sound is stopped",
            fix="delete the loop points in the editor, or call the cue a loop in the list",
            start_s=loops[0].start / rate,
            end_s=(loops[0].end + 1) / rate,
        )
        return
    seams = file.measurements.loop_seams
    for number, (loop, (step, bend)) in enumerate(zip(loops, seams, strict=True), start=1):
        which = "the loop" if len(loops) == 1 else f"loop {number}"
        if loop.start == loop.end:
            yield Finding(
                code="loop-points:one-frame",
                message=f"{which} is one frame long ({loop.start}): it holds one value in place of a sound",
                fix="set the loop's end after its start in the editor, or delete the loop points",
                start_s=loop.start / rate,
                end_s=(loop.start + 1) / rate,
            )
        else:
            where = f"where {which} turns back" if loop.kind == "alternating" else f"at the seam of {which}"
            yield from _of_seam(step, bend, where, (loop.end + 1) / rate)
    if not loops and cue is not None and cue.loop:
        step, bend = file.measurements.seam_step_db, file.measurements.seam_slope_db
        yield from _of_seam(step, bend, "at the loop's seam", file.facts.frames / rate)


def _of_seam(step: float, bend: float, where: str, seam_s: float) -> Iterator[Finding]:
    if step > STEP_DB:
        yield _finding("step", f"the wave jumps {where}, {step:.1f} dB over", step, STEP_DB, seam_s)
    elif bend > BEND_DB:
        yield _finding("bend", f"the wave bends {where}, {bend:.1f} dB over", bend, BEND_DB, seam_s)


def _frames_in_words(count: int) -> str:
    return "1 frame" if count == 1 else f"{count} frames"


def _loops_in_words(count: int) -> str:
    return "a loop" if count == 1 else f"{count} loops"


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
