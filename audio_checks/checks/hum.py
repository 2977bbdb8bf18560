"""`hum`: there is no mains hum under the sound.

Why: a ground loop, a transformer or a dimmer near the microphone adds steady tones at multiples of
50 or 60 Hz. One sound hides them; a game that plays thirty at once adds them up.
How to fix: remove the lines with a hum remover or narrow notches, and look for the cause before the
next recording. A tone that is meant, and happens to be tuned to the mains, may stay.
Source: mains stay within 1 % of 50 Hz nearly all year (EN 50160); the nearest notes are 2 % off. Three or
more multiples, in tune with each other, stand 12 dB over what lies beside them in a quarter of all
windows or more, or keep one phase between loud strokes from start to end, and together reach -70 dBFS.
The 9th and 15th, which dimmers on three phases leave, count beside the mains and the 3rd.
In sounds under a second, hum and a note cannot be distinguished.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "warning"
LABEL = "Hum"
NOT_FIXED = "Taking it out changes the sound around it, so it is done by ear: in the session, or in a restoration tool."
FIGURES = ("hum_dbfs", "hum_hz")


def check(file: "AudioFile", spec: DeliverySpec) -> Iterator[Finding]:
    """Yield `hum:mains` when steady multiples of 50 or 60 Hz are found."""
    level, mains_hz = file.measurements.hum_dbfs, file.measurements.hum_hz
    if level is None or mains_hz is None:
        return
    yield Finding(
        code="hum:mains",
        message=f"hum at {level:.1f} dBFS, in steady tones at multiples of {mains_hz:g} Hz",
        fix="remove the lines with a hum remover or narrow notches, and find the cause before the next recording",
        measured=level,
        unit="dBFS",
        start_s=0.0,
        end_s=file.facts.duration_s,
    )
