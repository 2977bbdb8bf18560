"""The sums of a cue's takes, stated without a database."""

from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import NamedTuple
from uuid import UUID

from app.deliveries.rules import TakeState

WITH_DESIGNER = (TakeState.RETURNED, TakeState.CHANGE_REQUESTED, TakeState.UNJUDGED)
# A variation has the rank of its newest take that is not set aside; 0 is none. Stored in three bits: never change one.
STATE_CODES = {
    TakeState.RECEIVED: 1,
    TakeState.CONFORMING: 2,
    TakeState.RETURNED: 3,
    TakeState.UNJUDGED: 4,
    TakeState.APPROVED: 5,
    TakeState.CHANGE_REQUESTED: 6,
    TakeState.SET_ASIDE: 7,
}
STATES_BY_CODE = {code: state for state, code in STATE_CODES.items()}
CODE_BASE = 8


@dataclass(frozen=True)
class VariationFact:
    """The facts that the status of one variation depends on."""

    has_approved: bool
    has_waiting: bool
    newest: TakeState | None  # of those not set aside

    @property
    def packed(self) -> int:
        """The fact as a whole number."""
        code = 0 if self.newest is None else STATE_CODES[self.newest]
        return (2 * self.has_approved + self.has_waiting) * CODE_BASE + code

    @classmethod
    def unpacked(cls, packed: int) -> "VariationFact":
        """Read a fact back from the whole number that was made of it."""
        flags, code = divmod(packed, CODE_BASE)
        return cls(flags >= 2, flags % 2 == 1, STATES_BY_CODE.get(code))


class TakeForSums(NamedTuple):
    """The facts of a matched take that count in the sums of its cue."""

    id: UUID
    designer_id: UUID
    variation: int
    number: int
    state: TakeState
    state_since: datetime
    received_at: datetime


@dataclass(frozen=True)
class Sums:
    """The sums of a cue's takes."""

    facts: str  # of its variations in order, packed: "17,0,10"
    newest_id: UUID  # of the take that came last
    newest_back_since: datetime | None  # since when that is with its designer
    back_since: datetime | None  # since when the first is with its designer of those that no other followed


def sums_of(takes: Sequence[TakeForSums]) -> Sums:
    """Sum up the takes of a cue, one or more."""
    variations: list[list[TakeForSums]] = [[] for _ in range(max(take.variation for take in takes))]
    for take in sorted(takes, key=lambda take: take.number):
        variations[take.variation - 1].append(take)
    last = max(takes, key=lambda take: (take.received_at, take.id))
    back = [own[-1] for own in variations if own and own[-1].state in WITH_DESIGNER]
    return Sums(
        facts=",".join(str(_fact_of([take.state for take in own]).packed) for own in variations),
        newest_id=last.id,
        newest_back_since=last.state_since if last.state in WITH_DESIGNER else None,
        back_since=min((take.state_since for take in back), default=None),
    )


def _fact_of(states: Sequence[TakeState]) -> VariationFact:
    seen = [state for state in states if state is not TakeState.SET_ASIDE]
    return VariationFact(TakeState.APPROVED in states, TakeState.CONFORMING in states, seen[-1] if seen else None)
