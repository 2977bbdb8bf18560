"""`sample-rate`: the file has a sample rate that the project accepts.

Why: masters are kept at the highest quality and converted down for each platform. A file at
another rate plays at the wrong speed or is resampled by whatever tool meets it first.
How to fix: export at an accepted rate from the session. Converting a finished file up adds
nothing but the look of quality, so ask for the original where the rate is too low.
Source: the delivery spec, `[accept] sample_rates_hz`, or the target's rate.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Sample rate"
IN_CATEGORIES = True
NOT_FIXED = (
    "A fix never changes the sample rate: going down is a render to a target, and nothing above what was "
    "recorded is made up. Export the session at an accepted rate."
)
FIGURES = ()


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec lists rates."""
    return spec.accept.sample_rates_hz is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `sample-rate:not-accepted` for a rate that the spec does not list."""
    sample_rates = sorted(spec.accept.sample_rates_hz or ())
    rate = file.facts.sample_rate_hz
    if rate in sample_rates:
        return
    nearest = min(sample_rates, key=lambda accepted: abs(accepted - rate))
    if spec.target is not None:
        fix = f"render it again from its master to {nearest} Hz"
    elif rate < sample_rates[0]:
        fix = f"export the session at {sample_rates[0]} Hz; do not convert this file up, which adds no quality"
    else:
        fix = f"export the session at {nearest} Hz"
    yield Finding(
        code="sample-rate:not-accepted",
        message=f"sample rate {rate} Hz, accepted {', '.join(map(str, sample_rates))} Hz",
        fix=fix,
        measured=float(rate),
        limit=float(nearest),
        unit="Hz",
    )
