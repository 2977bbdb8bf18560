"""`bit-depth`: the file has a bit depth that the project accepts.

Why: the depth sets the noise floor. Masters want room below the sound for later gain and
conversion; a game file wants exactly the depth its platform was budgeted for.
How to fix: export at an accepted depth from the session, with dither when going down to 16 bit.
Source: the delivery spec, `[accept] bit_depths`, or the target's depth.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Bit depth"
IN_CATEGORIES = True
FIGURES = ()


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec lists depths."""
    return spec.accept.bit_depths is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `bit-depth:not-accepted` for a depth that the spec does not list."""
    bit_depths = sorted(spec.accept.bit_depths or ())
    depth = file.facts.bit_depth
    if depth in bit_depths or file.facts.bit_rate_kbps is not None:  # what a codec keeps has no depth
        return
    nearest = min(bit_depths, key=lambda accepted: (abs(accepted - depth), -accepted))
    if spec.target is not None:
        fix = f"render it again from its master to {nearest} bit"
    elif depth < bit_depths[0]:
        fix = f"export the session at {bit_depths[0]} bit; padding this file with zeros adds no quality"
    else:
        fix = f"export the session at {nearest} bit" + (", with dither" if nearest < depth else "")
    yield Finding(
        code="bit-depth:not-accepted",
        message=f"bit depth {depth} bit, accepted {', '.join(map(str, bit_depths))} bit",
        fix=fix,
        measured=float(depth),
        limit=float(nearest),
        unit="bit",
    )
