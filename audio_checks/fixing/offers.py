"""Findings that a fix can put right, and the reasons for no fix of the others.

A fix changes as little as the finding asks: it moves the level, takes out a constant offset, cuts
silence, renames, writes the header, or lowers the depth. It never makes up what was not recorded, and never filters,
denoises or resamples: only a listener can judge whether the result is still the intended sound.
"""

import math
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

from audio_checks.checks import all_checks
from audio_checks.fixing.header import SIZES
from audio_checks.fixing.names import valid_name
from audio_checks.report.findings import FileReport, Finding
from audio_checks.spec.delivery_spec import DeliverySpec

RepairKind = Literal["gain", "head", "tail", "name", "header", "depth", "offset"]
ORDER: tuple[RepairKind, ...] = ("header", "head", "tail", "offset", "gain", "depth", "name")  # of the sound's way
HEADROOM_DB = 1e-6  # of rounding, when a level is raised just to its limit
WAV_BYTES = 0xFFFFFFFF - (1 << 20)  # of sound in a WAV file, with room for a megabyte of chunks
MOST_FIXED_BITS = 24  # what integers of a converter hold; the mantissa of a 32-bit float too


@dataclass(frozen=True)
class Offer:
    """A fix's answer to one finding, or the reason for none.

    Attributes
    ----------
    repair : str or None
        "gain", "head", "tail", "name", "header", "depth" or "offset"; None where no fix answers the finding.
    words : str
        What the fix does, as in "lowers the level by 1.70 dB"; without a repair a sentence that
        says why there is none, and who can put it right.
    gain_db : float
        By how much the level would be moved for this finding alone; 0 for other repairs.
    """

    repair: RepairKind | None
    words: str
    gain_db: float = 0.0

    def __bool__(self) -> bool:
        """Return whether there is a repair."""
        return self.repair is not None


def fix_offer(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    """State a fix's answer to one finding of a report, or the reason for none.

    Parameters
    ----------
    finding : Finding
        One of the report's.
    report : FileReport
        What was said of the file; its path ends in the name that the file was judged under.
    spec : DeliverySpec
        The view for the file's category and target, as it was judged by.

    Returns
    -------
    Offer
        Made from the report alone: no sample is read. Measured levels in dB, positions in frames.
        What cannot be known from it (whether a right header makes a broken file whole) shows when
        the fix is made.
    """
    if _facts(report).get("container", "wav") == "flac":
        return Offer(None, NOT_FLAC)
    offer = _OFFERS.get(finding.code)
    if offer is not None:
        return offer(finding, report, spec)
    if finding.check == "naming" and finding.code not in _WHY_NOT:
        return _renaming(finding, report, spec)
    return Offer(None, _WHY_NOT.get(finding.code) or _not_fixed(finding.check) or ONLY_THE_SESSION)


def _not_fixed(name: str) -> str | None:
    check = all_checks().get(name)
    return check.not_fixed if check else None


def fix_in_words(offers: Iterable[Offer]) -> str:
    """Return a fix's effects, as in "trims 407.0 ms from the start and lowers the level by 1.70 dB"; "" for nothing.

    Of several findings about the level, the one that lowers it most counts: the level is changed once.
    """
    by_kind: dict[str, Offer] = {}
    for offer in offers:
        if offer.repair is not None and (offer.repair not in by_kind or offer.gain_db < by_kind[offer.repair].gain_db):
            by_kind[offer.repair] = offer
    parts = [by_kind[kind].words for kind in ORDER if kind in by_kind]
    return " and ".join(part for part in (", ".join(parts[:-1]), *parts[-1:]) if part)


def excess_db(finding: Finding) -> float:
    """Return the excess of a level over its limit, in dB; negative below a lower bound."""
    if finding.measured is None or finding.limit is None:
        return 0.0
    return finding.measured - finding.limit


def frames_over(finding: Finding, report: FileReport) -> int:
    """Return the number of frames of silence to go, so that the limit is kept to the frame."""
    if finding.measured is None or finding.limit is None or report.facts is None:
        return 0
    rate = int(report.facts["sample_rate_hz"])
    stay = math.floor(finding.limit * rate / 1000 + 1e-9)  # 5 ms at 44.1 kHz are 220.5 frames
    return max(0, round(finding.measured * rate / 1000) - stay)


def accepted_depth(report: FileReport, spec: DeliverySpec) -> int | None:
    """Return the highest depth of integers that the spec accepts and the file can be lowered to; None for none."""
    facts = _facts(report)
    depth, encoding = facts.get("bit_depth"), facts.get("encoding")
    if depth is None or (spec.accept.encodings is not None and "pcm" not in spec.accept.encodings):
        return None
    most = MOST_FIXED_BITS if encoding == "float" else depth
    bit_depths = spec.accept.bit_depths
    if bit_depths is None:
        return min(most, MOST_FIXED_BITS)
    return max(
        (accepted for accepted in bit_depths if accepted <= most and (encoding == "float" or accepted < depth)),
        default=None,
    )


def base_name(path: str) -> str:
    """Return a path's last part, whichever system wrote it."""
    return re.split(r"[/\\]", path)[-1]


def _facts(report: FileReport) -> Mapping[str, Any]:
    return report.facts or {}


def _lowering(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    figures = report.measurements
    is_cut_off = figures.get("clipped_runs") and (figures.get("sample_peak_dbfs") or 0.0) <= 0.0
    kept = ", which leaves its cut-off tops flat" if is_cut_off else ""
    return Offer("gain", f"lowers the level by {excess_db(finding):.2f} dB{kept}", -excess_db(finding))


def _raising(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    wanted_db = -excess_db(finding)
    room_db = headroom_db(report, spec)
    if room_db is None or room_db + HEADROOM_DB < wanted_db:
        peak = "its peaks" if room_db is None else f"its peaks after {max(room_db, 0.0):.1f} dB"
        return Offer(
            None,
            f"Raising the level by {wanted_db:.1f} dB would take {peak} over their limit: "
            "less dynamic range is needed, which is made in the session.",
        )
    return Offer("gain", f"raises the level by {wanted_db:.2f} dB", wanted_db)


def headroom_db(report: FileReport, spec: DeliverySpec) -> float | None:
    """Return the headroom until a peak meets its limit, in dB; None where peaks were not measured.

    Without limits, full scale is the limit.
    """
    figures, rooms = report.measurements, []
    for figure, limit in (
        ("sample_peak_dbfs", spec.limits.sample_peak_dbfs or 0.0),
        ("true_peak_dbtp", spec.limits.true_peak_dbtp),
    ):
        if limit is None:
            continue
        level = figures.get(figure)
        if level is None:
            return None
        rooms.append(limit - float(level))
    return min(rooms)


def _head(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    return Offer("head", f"trims {_in_ms(finding, report):.1f} ms from the start")


def _tail(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    return Offer("tail", f"trims {_in_ms(finding, report):.1f} ms from the end")


def _offset(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    return Offer("offset", "takes out the DC offset")


def _in_ms(finding: Finding, report: FileReport) -> float:
    return 1000 * frames_over(finding, report) / int(_facts(report)["sample_rate_hz"])


def _renaming(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    now = base_name(report.path)
    name = valid_name(now, spec)
    if name is None or name == now:
        return Offer(None, "No valid name can be made of this one: name the file after its cue.")
    return Offer("name", f"names it {name}")


def _depth(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    depth = accepted_depth(report, spec)
    if depth is None:
        return Offer(
            None,
            "A fix never raises the depth: what finer steps would hold was never recorded. "
            "Export the session at an accepted depth.",
        )
    return Offer("depth", f"brings it to {depth} bit" + (" with dither" if depth <= 16 else ""))


def _encoding(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    if _facts(report).get("encoding") != "float":
        return Offer(None, "Samples are made float where they are computed: export the session as float.")
    return _depth(finding, report, spec)


def _container(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    facts = _facts(report)
    if facts.get("container") != "rf64" or "wav" not in (spec.accept.containers or ()):
        return Offer(None, ONLY_WAV)
    sound_bytes = facts["frames"] * facts["channels"] * -(-facts["bit_depth"] // 8)
    if sound_bytes > WAV_BYTES:
        return Offer(None, "It is longer than a WAV file can be: ask the studio to accept RF64, or split it.")
    return Offer("header", "writes it as WAV")


def _sizes(finding: Finding, report: FileReport, spec: DeliverySpec) -> Offer:
    return Offer("header", "rewrites the sizes in the header")


_OFFERS: dict[str, Callable[[Finding, FileReport, DeliverySpec], Offer]] = {
    "sample-peak:over": _lowering,
    "true-peak:over": _lowering,
    "loudness:over": _lowering,
    "loudness:under": _raising,
    "head-silence:over": _head,
    "tail-silence:over": _tail,
    "dc-offset:over": _offset,
    "bit-depth:not-accepted": _depth,
    "encoding:not-accepted": _encoding,
    "container:not-accepted": _container,
    **dict.fromkeys(SIZES, _sizes),
}

NOT_FLAC = (
    "A fix is written as WAV, and a FLAC master would come back as another kind of file: export it as WAV and "
    "deliver that, and the fix is offered."
)
ONLY_WAV = "A fix writes WAV from WAV: export the sound in an accepted container."
ONLY_THE_SESSION = "No repair of the finished file answers this: it is put right where the sound is made."
_WHY_NOT = {  # by the code of a finding; a check says it of all its findings in its own file
    "naming:twins": "Which of the two gets another name, a person says.",
    "naming:listed": "The sound list calls it so: whoever keeps the list and the spec makes the two agree.",
    "naming:unlisted": "Which cue it is for, a person says: match it to its cue, or rename it to the cue's file name.",
    "structure:truncated": "The end of the sound is missing from the file: export or copy it again.",
    "structure:partial-frame": "The last frame is not whole, so the file was cut short: export or copy it again.",
}
