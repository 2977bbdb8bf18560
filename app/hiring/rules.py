"""Postings and bids, stated without a database: states, what is asked for, sums and order."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from enum import StrEnum
from typing import Any

from app.core.errors import FieldProblem
from app.hiring.errors import BidInvalid, PostingClosed, PostingInvalid, ScoresInvalid, WrongPostingState

HUNDREDTHS = 100
DEFAULT_HEADINGS = ("Quality of work", "Shared vision", "Reliability", "Communication", "Fit with the team")
NO_CATEGORY = "Other sounds"


class PostingState(StrEnum):
    """The stage of a posting between writing and award."""

    DRAFT = "draft"
    OPEN = "open"
    CLOSED = "closed"
    AWARDED = "awarded"


class PostingPhase(StrEnum):
    """The subject of a posting: making sounds, or advice before that."""

    PRODUCTION = "production"
    ADVISORY = "advisory"


class AskedScope(StrEnum):
    """The cues that a posting asks for."""

    ALL = "all"
    CATEGORIES = "categories"
    CUES = "cues"


class BidState(StrEnum):
    """The state of a bid; the fate of a sent one follows from its posting."""

    DRAFT = "draft"
    SENT = "sent"
    WITHDRAWN = "withdrawn"


class BidNoteKind(StrEnum):
    """The occasion of a note of the team on a bid."""

    CALL = "call"
    INTERVIEW = "interview"
    OTHER = "other"


class SampleState(StrEnum):
    """The result of the check of a sample."""

    PENDING = "pending"
    CONFORMING = "conforming"
    RETURNED = "returned"
    UNCHECKED = "unchecked"  # the check failed: nothing is said of the sound


MAX_SAMPLES = 8  # of one bid
SAMPLES_KEPT = timedelta(days=30)  # after a bid was refused


def sample_is_open(now: datetime, *, is_refused: bool, refused_at: datetime | None) -> bool:
    """Whether a sample can be played: always but for a refused bid, whose samples are closed after 30 days."""
    return not is_refused or refused_at is None or now < refused_at + SAMPLES_KEPT


class BidLineKind(StrEnum):
    """The purpose of a line of a bid: one asked for by the posting, or an extra."""

    ASKED = "asked"
    RUSH = "rush"
    VOICE = "voice"
    DIRECTION = "direction"
    NARRATION = "narration"
    MUSIC = "music"


class BidUnit(StrEnum):
    """The unit that the price of a line counts."""

    PER_CUE = "per_cue"
    PER_HOUR = "per_hour"
    FLAT = "flat"


@dataclass(frozen=True)
class CountedCue:
    """A cue as a posting counts it."""

    id: str
    category: str
    variations: int
    is_concept: bool = False


def asked_lines(cues: Iterable[CountedCue]) -> list[dict[str, Any]]:
    """Return the lines for bids: one for each category in the order of the list, with its cues and files."""
    lines: dict[str, dict[str, Any]] = {}
    for cue in cues:
        line = lines.setdefault(
            cue.category,
            {"key": cue.category, "label": category_label(cue.category), "cues": 0, "files": 0, "concepts": 0},
        )
        line["cues"] += 1
        line["concepts"] += cue.is_concept
        line["files"] += cue.variations
    return list(lines.values())


def category_label(category: str) -> str:
    """Return a category as a line names it: "ui" reads UI, "footsteps_wood" reads Footsteps wood."""
    words = category.replace("-", " ").replace("_", " ").strip()
    if not words:
        return NO_CATEGORY
    return words.upper() if len(words) <= 2 else words[:1].upper() + words[1:]


def ensure_dates_in_order(first: date | None, last: date | None, *, names: tuple[str, str]) -> list[FieldProblem]:
    """Return a problem where a period ends before it begins."""
    if first is not None and last is not None and last < first:
        return [FieldProblem(where=names[1], message="ends before it begins")]
    return []


def ensure_can_open(state: PostingState, *, lines: int, phase: PostingPhase, until: date | None, today: date) -> None:
    """Raise unless a posting can take bids from now on; a closed one may be opened again."""
    if state not in (PostingState.DRAFT, PostingState.CLOSED):
        raise WrongPostingState(f"this posting is {state.value}")
    errors = []
    if phase is PostingPhase.PRODUCTION and not lines:
        errors.append(FieldProblem(where="scope", message="asks for no cue of the list"))
    if until is not None and until < today:
        errors.append(FieldProblem(where="bids_until_on", message="is over"))
    if errors:
        raise PostingInvalid("; ".join(f"{error['where']} {error['message']}" for error in errors), errors=errors)


def takes_bids(state: PostingState, until: date | None, today: date) -> bool:
    """Whether bids can be sent: the posting is open, and its last day is not over."""
    return state is PostingState.OPEN and (until is None or today <= until)


def ensure_takes_bids(state: PostingState, until: date | None, today: date) -> None:
    """Raise PostingClosed unless bids can be sent."""
    if not takes_bids(state, until, today):
        raise PostingClosed(
            "this posting no longer takes bids", fix="ask the studio to open it again; your draft is kept"
        )


def amount_minor(line: Mapping[str, Any]) -> int:
    """Return the amount of a line of a bid, rounded once to the nearest minor unit."""
    return int((line["quantity_hundredths"] * line["price_minor"] + HUNDREDTHS // 2) // HUNDREDTHS)


def total_minor(lines: Iterable[Mapping[str, Any]]) -> int:
    """Return the total of the lines of a bid."""
    return sum(amount_minor(line) for line in lines)


def concept_minor(asked: Iterable[Mapping[str, Any]], lines: Iterable[Mapping[str, Any]]) -> int:
    """Return a bid's price for cues that are concepts still: the share of each line that they are in."""
    counts = {line["key"]: (line.get("concepts", 0), line["cues"]) for line in asked}
    total_minor = 0
    for line in lines:
        concepts, cues = counts.get(line["key"], (0, 0)) if line["kind"] == BidLineKind.ASKED else (0, 0)
        total_minor += amount_minor(line) * concepts // cues if cues else 0
    return total_minor


def missing_lines(asked: Sequence[Mapping[str, Any]], lines: Iterable[Mapping[str, Any]]) -> list[str]:
    """Return the labels of the asked lines that a bid does not offer."""
    offered = {line["key"] for line in lines if line["kind"] == BidLineKind.ASKED}
    return [line["label"] for line in asked if line["key"] not in offered]


def hourly_rate_minor(whole_minor: int, hours_hundredths: int | None) -> int | None:
    """Return the effective hourly rate, rounded to the nearest minor unit; None without hours."""
    if not hours_hundredths:
        return None
    return (2 * whole_minor * HUNDREDTHS + hours_hundredths) // (2 * hours_hundredths)


def ensure_bid_fits(asked: Sequence[Mapping[str, Any]], content: Mapping[str, Any]) -> None:
    """Raise BidInvalid where lines repeat or name nothing that is asked for, or dates are out of order."""
    known = {line["key"] for line in asked}
    seen: set[tuple[str, str]] = set()
    errors: list[FieldProblem] = []
    for index, line in enumerate(content["lines"]):
        where = f"lines.{index}"
        if line["kind"] == BidLineKind.ASKED and line["key"] not in known:
            errors.append(FieldProblem(where=where, message="is not among the lines that the posting asks for"))
        name = (line["kind"], line["key"])
        if name in seen:
            errors.append(FieldProblem(where=where, message="is there twice"))
        seen.add(name)
    if content["from_on"] and content["to_on"] and content["to_on"] < content["from_on"]:
        errors.append(FieldProblem(where="to_on", message="ends before it begins"))
    if errors:
        raise BidInvalid("; ".join(f"{error['where']} {error['message']}" for error in errors), errors=errors)


def ensure_sendable(content: Mapping[str, Any]) -> None:
    """Raise BidInvalid for a bid without a line."""
    if not content["lines"]:
        message = "offers no line yet"
        raise BidInvalid(f"this bid {message}", errors=[FieldProblem(where="lines", message=message)])


def ensure_scores_fit(headings: Sequence[str], scores: Mapping[str, int]) -> None:
    """Raise ScoresInvalid for a score under another heading than those of the posting."""
    if unknown := [name for name in scores if name not in headings]:
        raise ScoresInvalid(
            f"no heading {unknown[0]}",
            errors=[FieldProblem(where=name, message="is not a heading") for name in unknown],
        )


def overlap(first: tuple[date | None, date | None], second: tuple[date | None, date | None]) -> bool:
    """Whether two periods share a day; one without a beginning or an end shares none."""
    (first_from, first_to), (second_from, second_to) = first, second
    if first_from is None or first_to is None or second_from is None or second_to is None:
        return False
    return first_from <= second_to and second_from <= first_to


def place_of(*, is_shortlisted: bool, sent_at: datetime) -> tuple[bool, datetime]:
    """Return the place of a bid in the comparison: those shortlisted first, then the one that was sent first."""
    return (not is_shortlisted, sent_at)
