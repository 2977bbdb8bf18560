"""`loudness`: the sound is as loud as the project asks, as the ear adds it up.

Why: peaks say nothing about how loud a sound is heard. Where a project asks for one loudness per
category, a file outside it stands out of the mix.
How to fix: raise or lower the level by the amount named; where the peak limit stands in the way,
use less dynamic range.
Source: ITU-R BS.1770 and EBU R 128; integrated loudness, and for sounds shorter than 0.4 s the
loudest 0.4 s with silence added.
"""

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding, level_shown
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Loudness"
LIMITS = {"loudness_lufs": (-200.0, 60.0)}
FIGURES = ("integrated_lufs", "short_loudness_lufs")
ONE_BLOCK_S = 0.4  # a gating block of BS.1770: below, integrated loudness is not defined


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec bounds loudness."""
    return bool(spec.limits.loudness_lufs)


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `loudness:over` or `loudness:under`; digital silence is left to the silence check."""
    short = file.facts.duration_s < ONE_BLOCK_S
    level = file.measurements.short_loudness_lufs if short else file.measurements.integrated_lufs
    figure = "loudness of its loudest 0.4 s" if short else "integrated loudness"
    bounds, tolerance = spec.limits.loudness_lufs, spec.limits.tolerance_db
    if bounds.max is not None and level > bounds.max + tolerance:
        yield Finding(
            code="loudness:over",
            message=f"{figure} {level:z.1f} LUFS, at most {level_shown(bounds.max)} LUFS",
            fix=f"lower the level by {level - bounds.max:.1f} dB or more",
            measured=level,
            limit=bounds.max,
            unit="LUFS",
        )
    if bounds.min is not None and -math.inf < level < bounds.min - tolerance:
        yield Finding(
            code="loudness:under",
            message=f"{figure} {level:z.1f} LUFS, at least {level_shown(bounds.min)} LUFS",
            fix=f"raise the level by {bounds.min - level:.1f} dB or more, keeping to the peak limits",
            measured=level,
            limit=bounds.min,
            unit="LUFS",
        )
