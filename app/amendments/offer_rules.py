"""The outcome of a change since the signature, stated without a database."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from enum import StrEnum
from typing import Any
from uuid import UUID


class OfferKind(StrEnum):
    """The kind of a change since a contract was signed for which a change order is offered."""

    ROUND = "round"  # beyond those included
    DESCRIBED = "described"  # differently, after work on the cue began
    NEEDED = "needed"  # on an earlier day
    SPEC = "spec"  # another version applies to cues of the contract
    ANSWERED = "answered"  # after the day on which the cue was due
    ADDED = "added"  # to the list, in the contract's categories
    REFERENCE = "reference"  # added after work on a cue began
    CUT = "cut"  # from the list, and no clause says what is owed


@dataclass(frozen=True)
class ListChange:
    """The change of one cue by one revision of the list."""

    cue_id: UUID
    revision: int
    at: datetime
    by: str
    before: Mapping[str, Any]
    after: Mapping[str, Any]


# What a designer prices a cue by, and how it is called.
PRICED_FACTS = {
    "description": "description",
    "use": "use in the game",
    "category": "category",
    "duration_s": "length",
    "duration_min_s": "shortest length",
    "duration_max_s": "longest length",
    "length_locked": "exact length",
    "loop": "loop",
    "reverb": "reverb",
    "channels": "mono or stereo",
    "variations": "variations",
}
LONG_TEXTS = frozenset({"description", "use"})
DUE = "due_on"


def net_change(changes: Sequence[ListChange], facts: Sequence[str]) -> dict[str, tuple[Any, Any]]:
    """Return the facts before the first change and after the last, without those that are the same again."""
    net: dict[str, tuple[Any, Any]] = {}
    for change in changes:
        for fact in facts:
            if fact in change.after:
                before = net[fact][0] if fact in net else change.before.get(fact)
                net[fact] = (before, change.after[fact])
    return {fact: net[fact] for fact in facts if fact in net and net[fact][0] != net[fact][1]}


def facts_in_words(differences: Mapping[str, tuple[Any, Any]]) -> str:
    """Return changed facts in words: "description, length 2 s instead of 0.8 s"."""
    return ", ".join(_fact_in_words(fact, *values) for fact, values in differences.items())


def _fact_in_words(fact: str, before: Any, after: Any) -> str:
    name = PRICED_FACTS[fact]
    if fact in LONG_TEXTS:
        return name
    return f"{name} {_value(fact, after)} instead of {_value(fact, before)}"


def _value(fact: str, value: Any) -> str:
    if value is None or value == "":
        return "none"
    if isinstance(value, bool):
        return "yes" if value else "no"
    return f"{value:g} s" if fact.startswith("duration_") else str(value)


def without_answers(changes: Sequence[ListChange], answers: Sequence[str]) -> Iterator[ListChange]:
    """Yield changes of a cue without the descriptions that only took up the answer to a question."""
    for change in changes:
        description = change.after.get("description")
        is_answer = isinstance(description, str) and any(description.endswith(answer) for answer in answers)
        if not is_answer:
            yield change
            continue
        after = {fact: value for fact, value in change.after.items() if fact != "description"}
        if after:
            yield ListChange(change.cue_id, change.revision, change.at, change.by, change.before, after)


def earlier_day(changes: Sequence[ListChange], agreed_on: date | None) -> tuple[date, date] | None:
    """Return the days between which a cue's day moved up, None where it did not.

    `agreed_on` is the day of the cue's milestone: a day on the list that is later asks for nothing new.
    """
    moved = net_change(changes, [DUE]).get(DUE)
    if moved is None or not moved[1]:
        return None
    listed = date.fromisoformat(moved[0]) if moved[0] else None
    now = date.fromisoformat(moved[1])
    held = [day for day in (listed, agreed_on) if day is not None]
    return (min(held), now) if held and now < min(held) else None


def day_after_answer(due_on: date, asked_at: datetime, answered_at: datetime) -> date | None:
    """Return a milestone's day moved on by the days that an answer took, None where it came in time.

    In time is an answer on the due day or before, and one to a question that was asked after that day.
    """
    if not asked_at.date() <= due_on < answered_at.date():
        return None
    return due_on + timedelta(days=(answered_at.date() - asked_at.date()).days)
