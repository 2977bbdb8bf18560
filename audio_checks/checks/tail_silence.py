"""`tail-silence`: the file ends when the sound does.

Why: silence after the sound costs memory on every platform and holds a voice of the game's mixer
that another sound could have had. Loops rightly end in mid-wave, so they are left alone:
a cue that the list calls a loop, and a file with loop points, unless the list says that its cue is none.
How to fix: trim the tail to where the sound has faded out. A render can do so by itself (`trim_below_dbfs`).
Source: the delivery spec, `[limits] tail_silence_ms`. Silence is digital silence: what stays below -120 dBFS, or at
16 bit within one step for half a second, as dither leaves it. A natural decay or the noise of a recording is none,
however quiet. Under 250 ms, or 5 % of the file's length, it costs too little memory to matter.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec
from audio_checks.spec.parts import loops_by_itself

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Trailing silence"
LIMITS = {"tail_silence_ms": (0.0, 3_600_000.0)}
FIGURES = ("sample_peak_dbfs", "tail_silence_ms")
DIGITAL_DBFS = -120.0
DITHERED_BITS, DITHERED_DBFS = 16, -89.9  # one step of 16 bit is at -90.3 dBFS
LEAST_MS, LEAST_DITHERED_MS = 250.0, 500.0
LEAST_SHARE = 0.05  # of the file's length


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply only where the spec limits it, and not for a loop."""
    return spec.limits.tail_silence_ms is not None and not (cue is not None and cue.loop)


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `tail-silence:over` when the silence after the sound is longer than the limit."""
    limit = spec.limits.tail_silence_ms
    if limit is None or loops_by_itself(file.layout.loops, cue) or file.measurements.sample_peak_dbfs == float("-inf"):
        return
    length_s = file.facts.duration_s
    tail_ms, least_ms = _tail_ms(file, DIGITAL_DBFS), LEAST_MS
    if file.facts.bit_depth == DITHERED_BITS and tail_ms <= max(limit, LEAST_MS, 1000 * LEAST_SHARE * length_s):
        tail_ms, least_ms = _tail_ms(file, DITHERED_DBFS), LEAST_DITHERED_MS
    most_ms = max(limit, least_ms, 1000 * LEAST_SHARE * length_s)
    if tail_ms > most_ms:
        yield Finding(
            code="tail-silence:over",
            message=f"{tail_ms:.1f} ms of silence after the sound, over {most_ms:.4g} ms",
            fix=f"trim {tail_ms - limit:.1f} ms or more from the end",
            measured=tail_ms,
            limit=limit,
            unit="ms",
            start_s=length_s - tail_ms / 1000,
            end_s=length_s,
        )


def _tail_ms(file: "AudioFile", below_dbfs: float) -> float:
    return file.measurements.edges(below_dbfs)[1]
