"""`click`: no moment is far sharper than all that lies around it.

Why: a splice between two waves, a lost sample, a plug-in that starts late or a scratched recording
leave a step of one or a few samples. It is heard as a tick, in a game a thousand times.
It does not find a click among lone knocks as short and as sharp, as of a coin that spins or a hinge that
creaks: there a fault cannot be distinguished from intended clicks.
How to fix: go to the named places and redraw the samples, use a declicker, or move the edit to
where both waves meet and fade across it. Crackle that is meant may stay: say so, or turn this off.
Source: Godsill and Rayner, Digital Audio Restoration (1998), chapter 5: what is sudden stands out of
its surroundings once what moves slowly is taken away, here by a sixth difference; and, where that is
in doubt, where samples can be predicted neither from those before nor from those after them. What
the sound around it masks in every critical band above 1 kHz (Zwicker and Fastl, Psychoacoustics,
chapter 4), but for less than 18 dB, is no click.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Clicks"
NOT_FIXED = "Taking it out changes the sound around it, so it is done by ear: in the session, or in a restoration tool."
FIGURES = ("clicks", "click_places", "sample_peak_dbfs")
PLACES_NAMED = 3
AROUND_S = 0.0005


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield one `click:isolated` for the file, at its sharpest click, when there is any."""
    if file.measurements.is_inaudible:
        return
    places = file.measurements.click_places
    if not places:
        return
    count = file.measurements.clicks
    sharpest = max(places, key=lambda click: click.level_dbfs)
    named = ", ".join(f"{click.at_s:.3f} s" for click in places[:PLACES_NAMED])
    more = ", ..." if count > PLACES_NAMED else ""
    yield Finding(
        code="click:isolated",
        message=(
            f"{count} {'click' if count == 1 else 'clicks'} ({named}{more}),"
            f" the sharpest at {sharpest.level_dbfs:.1f} dBFS"
        ),
        fix="repair it with a declicker, or move the edit to a zero crossing and crossfade",
        measured=float(count),
        limit=0.0,
        unit="clicks",
        start_s=max(0.0, sharpest.at_s - AROUND_S),
        end_s=min(file.facts.duration_s, sharpest.at_s + 2 * AROUND_S),
    )
