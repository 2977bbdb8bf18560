"""Whether a bonus is earned, still possible or missed, and why: from plain values."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date
from enum import StrEnum

from app.agreements.clauses.terms import BonusWhen
from app.core.plural import counted, day_in_words, verb


class BonusState(StrEnum):
    """The outcome of a bonus."""

    EARNED = "earned"
    POSSIBLE = "possible"
    MISSED = "missed"


@dataclass(frozen=True)
class BonusCue:
    """A cue as a bonus looks at it; one that was cut does not count."""

    name: str
    due_on: date | None  # of its milestone
    accepted_on: date | None
    has_round: bool  # a round of changes was counted


@dataclass(frozen=True)
class BonusStatus:
    """The outcome of a bonus, and its reason, in words."""

    state: BonusState
    because: str


def bonus_status_of(
    when: BonusWhen, cues: Sequence[BonusCue], *, today: date, is_running: bool, shipped_on: date | None
) -> BonusStatus:
    """Return whether a bonus that the software calculates is earned; `cues` are those that were not cut."""
    if when is BonusWhen.SHIPPED:
        if shipped_on is not None:
            return BonusStatus(BonusState.EARNED, f"the game shipped on {day_in_words(shipped_on)}, as the studio said")
        return _open(is_running, "the studio has not said yet that the game has shipped")
    fault = next((fault for cue in cues if (fault := _fault(when, cue, today))), None)
    if fault is not None:
        return BonusStatus(BonusState.MISSED, fault)
    accepted = sum(cue.accepted_on is not None for cue in cues)
    if not cues:
        return BonusStatus(BonusState.MISSED, "no cue of the contract is left")
    if accepted < len(cues):
        return _open(is_running, f"{accepted} of {counted(len(cues), 'cue')} {verb(accepted, 'is', 'are')} accepted")
    how = "by the date of its milestone" if when is BonusWhen.ON_TIME else "without a round of changes"
    return BonusStatus(BonusState.EARNED, f"every cue was accepted {how}")


def _open(is_running: bool, because: str) -> BonusStatus:
    if not is_running:
        return BonusStatus(BonusState.MISSED, "the contract ended early")
    return BonusStatus(BonusState.POSSIBLE, because)


def _fault(when: BonusWhen, cue: BonusCue, today: date) -> str | None:
    """Return the reason a cue misses the bonus, if it does."""
    if when is BonusWhen.NO_REJECTED_TAKE:
        return f"a round of changes was counted for {cue.name}" if cue.has_round else None
    if cue.due_on is None or (cue.accepted_on or today) <= cue.due_on:
        return None
    day = day_in_words(cue.due_on)
    if cue.accepted_on is None:
        return f"{cue.name} was not accepted by {day}"
    return f"{cue.name} was accepted on {day_in_words(cue.accepted_on)}; the date was {day}"
