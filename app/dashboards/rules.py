"""Where a cue stands, stated without a database."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from app.deliveries.rules import TakeState
from app.sound_lists.rules import CueState


class CueStatus(StrEnum):
    """The one word that a list shows for a cue."""

    TO_MAKE = "to_make"
    CHECKING = "checking"
    TO_REVIEW = "to_review"
    RETURNED = "returned"
    UNJUDGED = "unjudged"
    QUESTION = "question"
    CHANGE_REQUESTED = "change_requested"
    PARTLY_ACCEPTED = "partly_accepted"
    ACCEPTED = "accepted"
    PLACEHOLDER = "placeholder"
    CUT = "cut"


STATUS_OF_TAKE = {
    TakeState.RECEIVED: CueStatus.CHECKING,
    TakeState.CONFORMING: CueStatus.TO_REVIEW,
    TakeState.RETURNED: CueStatus.RETURNED,
    TakeState.UNJUDGED: CueStatus.UNJUDGED,
    TakeState.APPROVED: CueStatus.ACCEPTED,
    TakeState.CHANGE_REQUESTED: CueStatus.CHANGE_REQUESTED,
    TakeState.SET_ASIDE: CueStatus.TO_MAKE,
}
# What of a set needs somebody soonest speaks for the set.
MOST_URGENT_FIRST = (
    CueStatus.CHANGE_REQUESTED,
    CueStatus.RETURNED,
    CueStatus.UNJUDGED,
    CueStatus.TO_REVIEW,
    CueStatus.CHECKING,
)
NEEDS_THE_TEAM = frozenset({CueStatus.TO_REVIEW, CueStatus.QUESTION, CueStatus.UNJUDGED})


@dataclass(frozen=True)
class TakeFact:
    """What a cue's standing depends on of one take."""

    variation: int
    number: int
    state: TakeState


def variation_status(takes: Sequence[TakeFact]) -> CueStatus:
    """Return where one variation stands: approved once is accepted; else the newest take that is not set aside."""
    if any(take.state is TakeState.APPROVED for take in takes):
        return CueStatus.ACCEPTED
    open_takes = [take for take in takes if take.state is not TakeState.SET_ASIDE]
    if not open_takes:
        return CueStatus.TO_MAKE
    waiting = [take for take in open_takes if take.state is TakeState.CONFORMING]
    newest = max(open_takes, key=lambda take: take.number)
    return CueStatus.TO_REVIEW if waiting and newest.state is TakeState.RETURNED else STATUS_OF_TAKE[newest.state]


def cue_status(
    state: CueState, variations: Sequence[CueStatus], *, open_questions: int, placeholder: bool
) -> CueStatus:
    """Return the one word for a cue with the statuses of its variations."""
    if state is CueState.CUT:
        return CueStatus.CUT
    if all(status is CueStatus.ACCEPTED for status in variations):
        return CueStatus.ACCEPTED
    for status in MOST_URGENT_FIRST:
        if status in variations:
            return status
    if open_questions:
        return CueStatus.QUESTION
    if CueStatus.ACCEPTED in variations:
        return CueStatus.PARTLY_ACCEPTED
    return CueStatus.PLACEHOLDER if placeholder else CueStatus.TO_MAKE
