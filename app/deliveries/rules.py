"""How a take may go from state to state, stated without a database."""

from enum import StrEnum

from app.deliveries.errors import WrongState


class TakeState(StrEnum):
    """Where a take stands."""

    RECEIVED = "received"
    CONFORMING = "conforming"
    RETURNED = "returned"
    UNJUDGED = "unjudged"
    APPROVED = "approved"
    CHANGE_REQUESTED = "change_requested"
    SET_ASIDE = "set_aside"


class ArchiveState(StrEnum):
    """Where a delivered ZIP stands."""

    RECEIVED = "received"
    UNPACKED = "unpacked"
    REFUSED = "refused"


S = TakeState
NEXT_STATES: dict[TakeState, frozenset[TakeState]] = {
    S.RECEIVED: frozenset({S.RECEIVED, S.CONFORMING, S.RETURNED, S.UNJUDGED}),
    S.CONFORMING: frozenset({S.RECEIVED, S.APPROVED, S.CHANGE_REQUESTED, S.SET_ASIDE}),
    S.RETURNED: frozenset({S.RECEIVED, S.CONFORMING}),
    S.UNJUDGED: frozenset({S.RECEIVED}),
    S.APPROVED: frozenset({S.SET_ASIDE, S.CHANGE_REQUESTED}),
    S.CHANGE_REQUESTED: frozenset(),
    S.SET_ASIDE: frozenset({S.APPROVED}),
}


def ensure_may_become(now: TakeState, wanted: TakeState) -> None:
    """Raise WrongState unless a take may go from one state to the other."""
    if wanted not in NEXT_STATES[now]:
        raise WrongState(f"a {now} take cannot become {wanted}")
