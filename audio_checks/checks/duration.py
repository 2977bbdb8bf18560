"""`duration`: the sound is as long as the project accepts, and about as long as its cue asks.

Why: memory is budgeted by length, and a sound cut to an animation must fit it. Other requests
are estimates, so a length beyond a quarter more or less only warns, as does one beyond the bounds
that the sound list gives ("at most 2 s"); where the list locks a length, more than one video frame
is an error.
How to fix: trim or extend the sound in the session; if the request is what is wrong, say so on
the cue.
Source: the delivery spec, `[accept] duration_s`; the sound list, `duration_s`, `duration_min_s`,
`duration_max_s` and `length_locked`.
"""

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache
from typing import TYPE_CHECKING

from audio_checks.report.findings import Finding
from audio_checks.spec.delivery_spec import CueFacts, DeliverySpec

if TYPE_CHECKING:
    from audio_checks.audio.audio_file import AudioFile

SEVERITY = "error"
LABEL = "Length"
IN_CATEGORIES = True
NOT_FIXED = "How long a sound lasts is its designer's choice: edit it in the session."
FIGURES = ()
USUAL_FPS = 60.0
SPREAD = Fraction(1, 4)  # of the length asked for, either way


def applies(spec: DeliverySpec, cue: CueFacts | None) -> bool:
    """Apply where the spec bounds lengths, or the cue asks for one."""
    return bool(spec.accept.duration_s) or (cue is not None and (cue.duration_s is not None or cue.has_length_bounds))


def check(file: "AudioFile", spec: DeliverySpec, cue: CueFacts | None) -> Iterator[Finding]:
    """Yield `duration:short`, `:long` against the spec, and `:cue`, `:bounds` or `:locked` against the cue."""
    length = Fraction(file.facts.frames, file.facts.sample_rate_hz)
    low, high = spec.accept.duration_s.min, spec.accept.duration_s.max
    if low is not None and length < _exact(low):
        yield Finding(
            code="duration:short",
            message=f"{_seconds(length)}, at least {low:g} s accepted",
            fix="check that the export holds the whole sound",
            measured=float(length),
            limit=low,
            unit="s",
        )
    if high is not None and length > _exact(high):
        yield Finding(
            code="duration:long",
            message=f"{_seconds(length)}, at most {high:g} s accepted",
            fix=f"shorten the sound by {_seconds(length - _exact(high))} or more",
            measured=float(length),
            limit=high,
            unit="s",
            start_s=high,
            end_s=float(length),
        )
    if cue is not None and cue.has_length_bounds:
        yield from _against_bounds(length, cue)
    elif cue is not None and cue.duration_s is not None:
        yield from _against_request(length, _exact(cue.duration_s), cue)


def _against_bounds(length: Fraction, cue: CueFacts) -> Iterator[Finding]:
    low, high = cue.duration_min_s, cue.duration_max_s
    is_short = low is not None and length < _exact(low)
    limit = low if is_short else high
    if limit is None or not (is_short or length > _exact(limit)):
        return
    yield Finding(
        code="duration:bounds",
        message=f"{_seconds(length)} long; the sound list asks for {_bounds(low, high)}",
        fix=f"{'lengthen' if is_short else 'shorten'} the sound by {_seconds(abs(length - _exact(limit)))} or more",
        severity="error" if cue.length_locked else "warning",
        measured=float(length),
        limit=limit,
        unit="s",
    )


def _bounds(low: float | None, high: float | None) -> str:
    if low is None or high is None:
        return f"at least {low:g} s" if low is not None else f"at most {high:g} s"
    return f"{low:g} to {high:g} s"


def _against_request(length: Fraction, asked: Fraction, cue: CueFacts) -> Iterator[Finding]:
    off = length - asked
    turn = "shorten" if off > 0 else "lengthen"
    if cue.length_locked:
        fps = cue.frame_rate_fps or USUAL_FPS
        if abs(off) > 1 / _exact(fps):
            yield Finding(
                code="duration:locked",
                message=f"{_seconds(length)} long; locked to {float(asked):g} s within one frame of {fps:g} fps",
                fix=f"{turn} the sound by {_seconds(abs(off))}",
                severity="error",
                measured=float(length),
                limit=float(asked),
                unit="s",
            )
    elif abs(off) > asked * SPREAD:
        yield Finding(
            code="duration:cue",
            message=f"{_seconds(length)} long; the sound list asks for about {float(asked):g} s",
            fix=f"{turn} the sound, or say on the cue why it needs this length",
            severity="warning",
            measured=float(length),
            limit=float(asked),
            unit="s",
        )


@lru_cache(maxsize=64)
def _exact(value: float) -> Fraction:
    """Return the decimal as it was written: 0.1 s means a tenth, not the float nearest to it."""
    return Fraction(repr(value))


def _seconds(length: Fraction) -> str:
    return f"{float(length):.3f} s"
