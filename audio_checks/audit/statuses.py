"""Compares a sound of a build with the approved one: a status, and the figures behind it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, get_args

from audio_checks.audit.fingerprinted import FingerprintedFile
from audio_checks.audit.likeness import Likeness

Status = Literal[
    "same",
    "gain",
    "trimmed",
    "resampled",
    "re-encoded",
    "changed",
    "missing",
    "unknown",
    "placeholder",
    "duplicate",
    "converted",
    "unapproved",
    "unused",
    "depends",
]
STATUSES: tuple[Status, ...] = get_args(Status)
NO_DRIFT: tuple[Status, ...] = ("same", "depends")

LEAST_GAIN_DB = 0.1  # at the same rate and depth
LEAST_GAIN_RECODED_DB = 0.5  # where another rate, depth or codec makes the figure less sure
TILTED_DB = 1.0  # an equaliser, not a mere gain
MOVED_S = 0.005  # an end that has moved
MOVED_CODED_S = 0.06  # codecs add silence up to whole frames


@dataclass(frozen=True)
class Comparison:
    """The comparison of a build's sound with the approved one.

    Attributes
    ----------
    status : str
        See `became`.
    gain_db : float
        By how much the build's is louder, over the part that both have.
    offset_s : float
        Where in the approved sound the build's begins.
    message : str
        All differences in words.
    """

    status: Status
    gain_db: float
    offset_s: float
    message: str


def compare(approved: FingerprintedFile, built: FingerprintedFile, like: Likeness) -> Comparison:
    """Return the comparison of a build's sound of other samples with the approved one.

    Where several hold, the word is the first of: trimmed (an end has moved), re-encoded by an equaliser (the
    gain is not the same in all bands), gain, re-encoded (codec, depth, channels), resampled, re-encoded by whatever
    else changes samples. The message names all of them.
    """
    coded = built.codec is not None or approved.codec is not None
    recoded = coded or built.bit_depth != approved.bit_depth
    resampled = built.sample_rate_hz != approved.sample_rate_hz
    moved_s = MOVED_CODED_S if coded else MOVED_S
    head_s = like.offset_s
    tail_s = approved.duration_s - (built.duration_s + like.offset_s)
    words: list[str] = []
    if trimmed := max(abs(head_s), abs(tail_s)) >= moved_s:
        words += [_end(head_s, "start", moved_s), _end(tail_s, "end", moved_s)]
    if tilted := like.tilt_db >= TILTED_DB:
        words.append(
            f"its bands are changed by {like.tilt_db:.1f} dB against each other, as by an equaliser or a codec"
        )
    least_db = LEAST_GAIN_RECODED_DB if recoded or resampled or trimmed or tilted else LEAST_GAIN_DB
    if louder := abs(like.gain_db) >= least_db:
        words.append(f"{abs(like.gain_db):.1f} dB {'louder' if like.gain_db > 0 else 'quieter'}")
    if built.codec is not None:
        words.append(f"coded as {built.codec}")
    elif built.bit_depth != approved.bit_depth and approved.bit_depth is not None:
        words.append(f"{built.bit_depth} bits instead of {approved.bit_depth}")
    if mixed := built.channels != approved.channels:
        words.append(f"{built.channels} channels instead of {approved.channels}")
    if resampled:
        words.append(f"{built.sample_rate_hz:,} Hz instead of {approved.sample_rate_hz:,} Hz")
    status: Status = "re-encoded"
    if trimmed:
        status = "trimmed"
    elif not tilted and louder:
        status = "gain"
    elif resampled and not (tilted or recoded or mixed):
        status = "resampled"
    message = ", ".join(word for word in words if word) or "its samples differ, and its sound hardly"
    return Comparison(status, round(like.gain_db, 2), round(like.offset_s, 4), message)


def _end(cut_s: float, end: str, least_s: float) -> str:
    if abs(cut_s) < least_s:
        return ""
    return f"{cut_s:.3f} s cut off its {end}" if cut_s > 0 else f"{-cut_s:.3f} s added at its {end}"
