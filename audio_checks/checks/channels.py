"""`channels`: the file has as many channels as the project accepts.

Why: a sound placed in the 3D world must be mono, made so by its designer; interface sounds,
first-person sounds and beds are stereo. An engine that folds channels down changes the mix.
How to fix: export with the accepted number of channels; mix to mono yourself and listen to it,
since what is out of phase between left and right disappears.
Source: the delivery spec, `[accept] channels`, or the target's channels.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.findings import Finding
from audio_checks.spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio import AudioFile

FIGURES = ()
LAYOUTS = {1: "mono", 2: "stereo"}


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:  # noqa: ARG001
    """Only where the spec lists numbers of channels."""
    return spec.accept.channels is not None


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `channels:not-accepted` for a number of channels that the spec does not list."""
    wanted = sorted(spec.accept.channels or ())
    channels = file.facts.channels
    if channels in wanted:
        return
    nearest = min(wanted, key=lambda one: abs(one - channels))
    accepted = " or ".join(_words(one) for one in wanted)
    again = "render it again from its master" if spec.target is not None else "export it from the session"
    yield Finding(
        code="channels:not-accepted",
        message=f"{_words(channels)}, accepted {accepted}",
        fix=f"{again} as {_words(nearest)}",
        measured=float(channels),
        limit=float(nearest),
        unit="channels",
    )


def _words(channels: int) -> str:
    return LAYOUTS.get(channels, f"{channels} channels")
