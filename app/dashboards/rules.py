"""Where a cue stands, stated without a database."""

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache

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
WITH_DESIGNER = (TakeState.RETURNED, TakeState.CHANGE_REQUESTED, TakeState.UNJUDGED)


# The newest take that is not set aside speaks for its variation; 0 is none. Codes fit in three bits.
STATE_CODES = {state: code for code, state in enumerate(STATUS_OF_TAKE, start=1)}
STATES_BY_CODE = {code: state for state, code in STATE_CODES.items()}
CODE_BASE = 8


@dataclass(frozen=True)
class VariationFact:
    """What the standing of one variation depends on; the database sums it up from the takes."""

    has_approved: bool
    has_waiting: bool
    newest: TakeState | None  # of those not set aside

    @classmethod
    def unpacked(cls, packed: int) -> "VariationFact":
        """Read a fact back from the whole number that the database makes of it."""
        flags, code = divmod(packed, CODE_BASE)
        return cls(flags >= 2, flags % 2 == 1, STATES_BY_CODE.get(code))


def variation_status(fact: VariationFact) -> CueStatus:
    """Return where one variation stands: approved once is accepted; else the newest take that is not set aside."""
    if fact.has_approved:
        return CueStatus.ACCEPTED
    if fact.newest is None:
        return CueStatus.TO_MAKE
    if fact.has_waiting and fact.newest is TakeState.RETURNED:
        return CueStatus.TO_REVIEW
    return STATUS_OF_TAKE[fact.newest]


@lru_cache(maxsize=4096)
def statuses_of(packed: str, variations: int) -> tuple[CueStatus, ...]:
    """Return where the variations of a cue stand, from their packed facts in no order; the rest is still to make."""
    told = [variation_status(VariationFact.unpacked(int(part))) for part in packed.split(",") if part]
    return (*told, *[CueStatus.TO_MAKE] * (variations - len(told)))


def cue_status(state: CueState, variations: Sequence[CueStatus], *, is_asked: bool, placeholder: bool) -> CueStatus:
    """Return the one word for a cue with the statuses of its variations."""
    if state is CueState.CUT:
        return CueStatus.CUT
    if all(status is CueStatus.ACCEPTED for status in variations):
        return CueStatus.ACCEPTED
    for status in MOST_URGENT_FIRST:
        if status in variations:
            return status
    if is_asked:
        return CueStatus.QUESTION
    if CueStatus.ACCEPTED in variations:
        return CueStatus.PARTLY_ACCEPTED
    return CueStatus.PLACEHOLDER if placeholder else CueStatus.TO_MAKE
