"""Effects of verdicts and the counting of rounds, stated without a database."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from enum import StrEnum
from typing import Literal
from uuid import UUID

from app.reviews.errors import ChecklistInvalid, NotMentionable, RangeInvalid, StaleView, TooLateToUndo
from app.sound_lists.rules import Need


class VerdictKind(StrEnum):
    """The approver's verdict on a take."""

    APPROVE = "approve"
    REQUEST_CHANGE = "request_change"
    SET_ASIDE = "set_aside"
    WITHDRAW = "withdraw"  # an earlier verdict was taken back


class HistoryKind(StrEnum):
    """An event of a take."""

    RECEIVED = "received"
    CHECKED = "checked"
    WAIVED = "waived"
    APPROVE = "approve"
    SET_ASIDE = "set_aside"
    REQUEST_CHANGE = "request_change"
    WITHDRAW = "withdraw"
    COMMENT = "comment"
    LABELLED = "labelled"


class QueueKind(StrEnum):
    """The way of playing the waiting takes of a cue."""

    SINGLE = "single"
    ALTERNATES = "alternates"  # one of several is picked
    SET = "set"  # variations are played and accepted together


class ApprovalBlockers(StrEnum):
    """The things to close in a project before a take is approved."""

    NONE = "none"
    NOTES = "notes"
    ITEMS = "items"
    BOTH = "both"

    @property
    def are_notes(self) -> bool:
        """Whether notes that are open block approval."""
        return self in (ApprovalBlockers.NOTES, ApprovalBlockers.BOTH)

    @property
    def are_items(self) -> bool:
        """Whether items of the checklist that are not checked block approval."""
        return self in (ApprovalBlockers.ITEMS, ApprovalBlockers.BOTH)


class VersionKind(StrEnum):
    """Whether what waits answers a change request."""

    FIRST = "first"
    NEW = "new"


@dataclass(frozen=True)
class QueueFilter:
    """The wanted part of the review queue; fields left out filter nothing."""

    category: str | None = None
    designer_id: UUID | None = None
    due_by: date | None = None
    need: Need | None = None
    kind: QueueKind | None = None
    version: VersionKind | None = None
    unheard: bool = False  # a take waits that the caller has not heard
    text: str = ""  # each word is in the name, the description or the use of the cue


EVERYTHING = QueueFilter()
PausedBy = Literal["question", "change_order", "undecided_versions"]  # the days that a silent studio has
UNDO_WITHIN = timedelta(minutes=1)
SEND_AFTER = timedelta(seconds=10)  # a change request that sends itself; it can be undone until then
REVERSAL = "the approver reversed an approval"
NAMED_ITEMS = 3  # of those that are not checked
SECONDS_BEYOND_END = 0.01  # a time typed or clicked at the very end may round up

STATE_WORDS = {
    "received": "is being checked",
    "conforming": "waits for review",
    "returned": "was returned to its designer",
    "unjudged": "could not be checked",
    "approved": "is approved",
    "change_requested": "was returned with a change request",
    "set_aside": "was set aside",
}


def ensure_seen(now: str, seen: str) -> None:
    """Raise StaleView unless a take is still in the state that the caller saw."""
    if now != seen:
        raise StaleView(
            f"since you opened this page, this version {STATE_WORDS[now]}; your decision was not saved",
            fix="reload the page and decide again",
        )


def ensure_undoable(given_at: datetime, now: datetime) -> None:
    """Raise TooLateToUndo more than a minute after a verdict."""
    if now - given_at > UNDO_WITHIN:
        raise TooLateToUndo(
            "a decision can be undone for one minute only",
            fix="approve another version or request a change instead",
        )


def ensure_range(start_s: float | None, end_s: float | None, duration_s: float | None) -> None:
    """Raise RangeInvalid unless a time or range is within the sound."""
    if start_s is None:
        if end_s is not None:
            raise RangeInvalid("a range needs its start too")
        return
    last_s = start_s if end_s is None else end_s
    if start_s < 0 or last_s < start_s:
        raise RangeInvalid("a range starts at 0 s or later, and ends after its start")
    if duration_s is not None and last_s > duration_s + SECONDS_BEYOND_END:
        raise RangeInvalid(f"{last_s:.3f} s is beyond the end of the sound, {duration_s:.3f} s")


def missing_variations(variations: int, approved: Collection[int]) -> list[int]:
    """Return the variations of a cue that still lack their approved take; a cue is accepted when none does."""
    return [variation for variation in range(1, variations + 1) if variation not in approved]


def queue_kind(variations: int, waiting: Sequence[int]) -> QueueKind:
    """Return the way of playing a cue's waiting takes, given by their variations."""
    if variations > 1:
        return QueueKind.SET
    return QueueKind.ALTERNATES if len(waiting) > 1 else QueueKind.SINGLE


def why_not_counted(reversals: Sequence[bool], unanswered_round: int | None = None) -> str | None:
    """Return the reason a sending is no round for a cue, given its requests that reverse an approval; None: it is.

    A request that follows one that nothing was delivered for belongs to the round of that one.
    """
    if all(reversals):
        return REVERSAL
    return None if unanswered_round is None else f"part of round {unanswered_round}: nothing was delivered since"


def names_mentioned(text: str, person_ids: Collection[UUID], people: Mapping[UUID, str]) -> dict[str, str]:
    """Return the names that stand after an @ in a text, by person; `people` are those who may be mentioned.

    Raises NotMentionable for a person who is none of them, and for one whose name the text lacks.
    """
    for person_id in person_ids:
        if person_id not in people:
            raise NotMentionable(f"person {person_id} may not see this version", fix="choose a person from the list")
        if f"@{people[person_id]}" not in text:
            raise NotMentionable(
                f"the text does not say @{people[person_id]}", fix="choose the person again, or do not mention them"
            )
    return {str(person_id): people[person_id] for person_id in dict.fromkeys(person_ids)}


def mentioned_in(mentions: Mapping[str, str]) -> list[dict[str, str]]:
    """Return the people whom a text mentions, as a list."""
    return [{"person_id": person_id, "name": name} for person_id, name in mentions.items()]


def what_is_open(comments: int, notes: int, items: Sequence[str]) -> str:
    """Return the open points of a take in words: comments, notes on earlier versions, items that are not checked."""
    parts = []
    if comments:
        parts.append(f"{comments} {'comment is' if comments == 1 else 'comments are'} not resolved")
    if notes:
        named = "note on an earlier version is" if notes == 1 else "notes on earlier versions are"
        parts.append(f"{notes} {named} not done")
    if items:
        named = ", ".join(f"“{item}”" for item in items[:NAMED_ITEMS])
        more = f" and {len(items) - NAMED_ITEMS} more" if len(items) > NAMED_ITEMS else ""
        parts.append(f"{named}{more} {'is' if len(items) == 1 else 'are'} not checked")
    return "; ".join(parts)


def ensure_checklist(items: Sequence[str]) -> None:
    """Raise ChecklistInvalid unless each item of a checklist is written once."""
    seen: set[str] = set()
    for index, item in enumerate(items):
        if item in seen:
            message = f"“{item}” is in the checklist twice"
            raise ChecklistInvalid(
                message, errors=[{"where": f"items.{index}", "message": message}], fix="keep one of the two"
            )
        seen.add(item)
