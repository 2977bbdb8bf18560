"""`padded-bits`: the file makes use of the bits it has.

Why: a 16-bit sound written with 24 bits is no better than it was, and says that it is. What is made
of it later (gain, fades, reverb) starts from the coarse steps and their noise.
How to fix: export from the session, where the sound still has its depth, or deliver it at the depth
that it really has. A quiet recording raised by 24 dB or more looks the same, and has lost as much.
Source: every sample is a whole multiple of one step, within rounding and dither: of 256 for 16 bits
padded to 24, of another number after a change of level. Four lost bits or more are named.
"""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Zero-padded bits"
NOT_FIXED = (
    "The finer steps were never recorded: export the session at its own depth, or deliver the depth that is there."
)
FIGURES = ("sample_step",)
FEWEST_LOST_BITS = 4


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `padded-bits:zeros` for empty lower bits, `padded-bits:steps` where a change of level hides them."""
    step, depth, used = file.measurements.sample_step, file.facts.bit_depth, file.facts.effective_bits
    if step is None or step == 1:
        return
    if used is not None and depth - used >= FEWEST_LOST_BITS:
        code, bits = "padded-bits:zeros", float(used)
        message = f"zero-padded: the lower {depth - used} of {depth} bits are empty, so it is really {used}-bit"
    else:
        code, bits = "padded-bits:steps", depth - math.log2(step)
        message = f"{depth} bits, but every sample stands on steps of {step:.1f}: a sound of {bits:.1f} bits"
    yield Finding(
        code=code,
        message=message,
        fix="export it from the session at its true depth; padding a file adds no quality",
        measured=bits,
        limit=float(depth),
        unit="bit",
        start_s=0.0,
        end_s=file.facts.duration_s,
    )
