"""The state that a verdict gives a take, and the key of a check: without a database."""

import dataclasses
import hashlib
import json
from collections import defaultdict
from collections.abc import Collection, Iterable, Mapping, Sequence
from enum import StrEnum
from functools import lru_cache
from typing import Any, NamedTuple
from uuid import UUID

import audio_checks
from app.deliveries.rules import TakeState

TRIES = 3
# Checks of which the desk knows the result before a file is sent. The page computes these from the bytes, held to
# frontend/src/precheck/vectors.json; what is wrong with a name the server answers.
JUDGED_IN_BROWSER = (
    "container", "encoding", "sample-rate", "bit-depth", "channels", "duration", "sample-peak", "silence",
)  # fmt: skip
PLACEHOLDER_CODE = "placeholder:marked"  # the file says that it is a placeholder
COMPARISON_FAILED = "failed"
Report = dict[str, Any]  # the file object of the report


FIXABLE_STATES = frozenset({TakeState.RETURNED, TakeState.CONFORMING})  # not yet decided upon, and judged


class FixState(StrEnum):
    """The state of a fixed copy, or of the parts of a split."""

    MAKING = "making"
    MADE = "made"
    REFUSED = "refused"


def levels_in_browser(spec: audio_checks.DeliverySpec) -> dict[str, str]:
    """Return a spec view's levels for the checks that the page computes: a severity or off, where it says any."""
    return {name: level for name, level in spec.checks.items() if name in JUDGED_IN_BROWSER}


def awaits_check(state: TakeState, *, is_checked: bool) -> bool:
    """Whether the result of a check of a take is to be recorded: it came now, or it was adopted without one."""
    return state is TakeState.RECEIVED or (state is TakeState.APPROVED and not is_checked)


@lru_cache(maxsize=64)
def parsed_spec(toml: str) -> audio_checks.DeliverySpec:
    """Return the spec from its stored form."""
    return audio_checks.parse_spec(toml)


def asked_of(spec: audio_checks.DeliverySpec) -> str:
    """Return the hash of what a spec asks of a file; what it asks of other categories does not count."""
    return (spec if spec.category else spec.for_category("")).sha256


def run_key(
    master_sha256: str,
    spec: audio_checks.DeliverySpec,
    cue: audio_checks.CueFacts | None,
    name: str,
    stem_sha256: str | None = None,
    *,
    shipped: bool = False,
) -> str:
    """Return the key of a check run: two runs with one key have the same result."""
    facts = None if cue is None else {k: v for k, v in dataclasses.asdict(cue).items() if k != "more"}
    parts = [master_sha256, asked_of(spec), spec.category, facts, name, audio_checks.TOOL_VERSION]
    if stem_sha256 is not None:
        parts.append(stem_sha256)
    if shipped:
        parts.append("shipped")
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def error_codes(report: Mapping[str, Any]) -> list[str]:
    """Return the codes of the findings for which a take is returned, each once."""
    return sorted({finding["code"] for finding in report["findings"] if finding["severity"] == "error"})


def state_after(report: Mapping[str, Any], waived: Collection[str]) -> TakeState:
    """Return the new state of a take by its report; a waiver of every error holds when it is checked again."""
    verdict = report["verdict"]
    if verdict == "unjudged":
        return TakeState.UNJUDGED
    if verdict == "conforming" or (verdict == "rejected" and set(error_codes(report)) <= set(waived)):
        return TakeState.CONFORMING
    return TakeState.RETURNED


def with_reverb_before(report: Report, before: Mapping[str, Any] | None) -> Report:
    """Return a report with its reverb compared with an earlier take, in place of any earlier comparison."""
    judgements = report["judgements"]
    if "reverb" not in judgements:
        return report
    reverb = {key: value for key, value in judgements["reverb"].items() if key != "before"}
    return {**report, "judgements": {**judgements, "reverb": {**reverb, "before": dict(before)} if before else reverb}}


def with_stem(report: Report, sha256: str, *, failed: bool = False) -> Report:
    """Return a report with the dry stem that it used; with the reason if our comparison failed."""
    with_hash = {**report, "stem_sha256": sha256}
    judgements = report["judgements"]
    if not failed or "reverb" not in judgements:
        return with_hash
    stem = {"verdict": COMPARISON_FAILED, "why": "our comparison of the two failed"}
    return with_hash | {"judgements": {**judgements, "reverb": {**judgements["reverb"], "stem": stem}}}


def has_failed_comparison(report: Report) -> bool:
    """Whether a report lacks a comparison for a fault of ours, so that another check may have it."""
    stem = report["judgements"].get("reverb", {}).get("stem") or {}
    return bool(stem.get("verdict") == COMPARISON_FAILED)


def with_waived(findings: Collection[Mapping[str, Any]], codes: Collection[str]) -> list[dict[str, Any]]:
    """Return findings with those marked that the approver let through."""
    return [{**finding, "waived": finding["code"] in codes} for finding in findings]


def fix_offers(report: Mapping[str, Any], spec: audio_checks.DeliverySpec) -> list[audio_checks.Offer]:
    """Return a fix's action on each finding of a report, or the reason for none, in the report's order."""
    entry = audio_checks.FileReport.from_dict(report)
    return [audio_checks.fix_offer(finding, entry, spec) for finding in entry.findings]


def with_offers(findings: Sequence[Mapping[str, Any]], offers: Sequence[audio_checks.Offer]) -> list[dict[str, Any]]:
    """Return findings with what a fix does about each, or why none can."""
    return [
        {**finding, "auto_fix": offer.words if offer else None, "no_auto_fix": None if offer else offer.words}
        for finding, offer in zip(findings, offers, strict=True)
    ]


def is_enough(report: Mapping[str, Any], offers: Sequence[audio_checks.Offer]) -> bool:
    """Whether a fix does anything, and answers every finding for which the take would come back again."""
    errors = [
        offer for finding, offer in zip(report["findings"], offers, strict=True) if finding["severity"] == "error"
    ]
    return report["verdict"] != "unjudged" and any(offers) and all(errors)


def unjudged(name: str, category: str | None, why: str) -> Report:
    """Return the report of a file that our checker could not judge."""
    finding = {
        "check": "audio-checks",
        "code": "audio-checks:failed",
        "severity": "error",
        "message": f"the check failed {TRIES} times on this file ({why}); that is not the file's fault",
        "fix": "this is our fault and not yours: ask for another check, or contact the operator of this server",
        "measured": None,
        "limit": None,
        "unit": None,
        "start_s": None,
        "end_s": None,
    }
    return {
        "path": name,
        "sha256": None,
        "pcm_sha256": None,
        "category": category,
        "verdict": "unjudged",
        "facts": None,
        "measurements": {},
        "judgements": {},
        "findings": [finding],
    }


class MemberFact(NamedTuple):
    """The facts that decide whether a take belongs to its set."""

    take_id: UUID
    variation: int
    alternate: int | None
    number: int
    approved: bool


def members_of_set(takes: Iterable[MemberFact]) -> list[UUID]:
    """Return the takes of a set: of each variation the approved one, else the newest of each alternate."""
    by_variation: dict[int, list[MemberFact]] = defaultdict(list)
    for take in takes:
        by_variation[take.variation].append(take)
    access: list[UUID] = []
    for _, here in sorted(by_variation.items()):
        approved = [take for take in here if take.approved]
        newest = {take.alternate: take for take in sorted(approved or here, key=lambda take: take.number)}
        access += [take.take_id for take in newest.values()]
    return access


def several_sounds(report: Report, *, one_sound_expected: bool) -> str | None:
    """Return by what a check saw that a WAV file holds several sounds, as a sentence; None where it saw none.

    Markers alone say nothing where the list asks for one file.
    """
    facts = report["facts"] or {}
    if facts.get("container") not in ("wav", "rf64"):
        return None
    frames = {point["frame"] for point in (facts.get("metadata") or {}).get("cue_points", [])}
    if len(frames) > 1 and not one_sound_expected:
        return f"It has {len(frames)} markers."
    pauses = (finding for finding in report["findings"] if finding["code"] == "internal-silence:pause")
    return next((f"{finding['message']}." for finding in pauses), None)
