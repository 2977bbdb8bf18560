"""`channels`: the file has as many channels as the project accepts, in a layout it accepts.

Why: a sound placed in the 3D world must be mono, made so by its designer; interface sounds,
first-person sounds and beds are stereo. An engine that folds channels down changes the mix.
Beds of more channels say by a channel mask where each one stands; without it, quad plays as
whatever the next tool guesses.
How to fix: export with the accepted number of channels, beds with the layout chosen in the export
window; mix to mono yourself and listen to it, since what is out of phase disappears.
Source: the delivery spec, `[accept] channels` and `layouts`, or the target's channels; the sound
list, `channels`: a cue that is mono or stereo comes before the spec; speaker positions of
WAVEFORMATEXTENSIBLE; ambisonic files have (order + 1)² channels and no positions.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.metadata.layouts import LAYOUTS, layouts_of
from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Channels"
IN_CATEGORIES = True
NOT_FIXED = (
    "Which channels stay, and how they are mixed, is the designer's choice: export the sound with the channels "
    "that are wanted."
)
FIGURES = ()
COUNTS = {1: "mono", 2: "stereo"}


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec lists numbers of channels, or layouts, or the cue is mono or stereo."""
    return spec.channels_for(cue) is not None or spec.accept.layouts is not None


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None = None) -> Iterator[Finding]:
    """Yield `channels:cue` for another number than the cue asks for.

    Else `channels:not-accepted` for a number that the spec does not list, or `channels:layout` for a layout.
    """
    counts, layouts = spec.channels_for(cue), spec.accept.layouts
    channels = file.facts.channels
    if counts != spec.accept.channels:
        if counts is not None and channels not in counts:
            yield _other_than_cue(channels, counts[0], of_render=spec.target is not None)
    elif counts is not None and channels not in counts:
        yield _other_count(channels, sorted(counts), of_render=spec.target is not None)
    elif layouts is not None and not set(layouts) & set(_layouts_of(file)):
        yield _other_layout(file, layouts)


def _other_count(channels: int, channel_counts: list[int], *, of_render: bool) -> Finding:
    nearest = min(channel_counts, key=lambda count: abs(count - channels))
    accepted = " or ".join(_words(count) for count in channel_counts)
    again = "render it again from its master" if of_render else "export it from the session"
    return Finding(
        code="channels:not-accepted",
        message=f"{_words(channels)}, accepted {accepted}",
        fix=f"{again} as {_words(nearest)}",
        measured=float(channels),
        limit=float(nearest),
        unit="channels",
    )


def _other_than_cue(channels: int, wanted: int, *, of_render: bool) -> Finding:
    fix = "render it again from its master" if of_render else f"export it from the session as {_words(wanted)}"
    return Finding(
        code="channels:cue",
        message=f"{_words(channels)}, and the sound list asks for {_words(wanted)}",
        fix=fix,
        measured=float(channels),
        limit=float(wanted),
        unit="channels",
    )


def _other_layout(file: "AudioFile", layouts: tuple[str, ...]) -> Finding:
    channels, mask = file.facts.channels, file.layout.channel_mask
    description = _words(channels)
    if channels > max(COUNTS):
        means = _layouts_of(file)
        description += f" as {' or '.join(means)}" if means else f" with the channel mask {mask:#x}" if mask else ""
        description += "" if mask or file.layout.ambisonic else " without a channel mask"
    elif mask:
        description += f" with the channel mask {mask:#x}"
    same = [name for name in layouts if LAYOUTS[name].channels == channels]
    words = " or ".join(LAYOUTS[name].words for name in same or layouts)
    return Finding(
        code="channels:layout",
        message=f"{description}, accepted {' or '.join(layouts)}",
        fix=f"export it as {words}, with the layout written to the header",
    )


def _layouts_of(file: "AudioFile") -> tuple[str, ...]:
    layout = file.layout
    return layouts_of(layout.channels, layout.channel_mask, ambisonic=layout.ambisonic)


def _words(channels: int) -> str:
    return COUNTS.get(channels, f"{channels} channels")
