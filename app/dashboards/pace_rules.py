"""How a project goes, from what was decided and when: plain figures of plain values."""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from statistics import median

LATELY = timedelta(days=28)
MANY_ROUNDS = 3  # so many for one cue are too many
FEW = 3  # fewer make no figure


@dataclass(frozen=True)
class CuePace:
    """What was decided of one cue."""

    rounds: int  # changes that were sent to the designer
    first_decided_at: datetime | None
    accepted_at: datetime | None  # None: not all its variations are approved
    due_on: date | None

    @property
    def is_first_pass(self) -> bool:
        """Whether it was accepted as it came first."""
        return self.accepted_at is not None and self.rounds == 0


def first_pass_share(cues: Collection[CuePace]) -> float | None:
    """Return which share of the cues that were decided upon was accepted as it came first; None: too few."""
    decided = [cue for cue in cues if cue.first_decided_at is not None]
    return sum(cue.is_first_pass for cue in decided) / len(decided) if len(decided) >= FEW else None


def decided_before_and_since(cues: Collection[CuePace], at: datetime) -> tuple[list[CuePace], list[CuePace]]:
    """Part the cues that were decided upon by when that happened first."""
    before = [cue for cue in cues if cue.first_decided_at is not None and cue.first_decided_at < at]
    return before, [cue for cue in cues if cue.first_decided_at is not None and cue.first_decided_at >= at]


def mean_rounds(cues: Collection[CuePace]) -> float | None:
    """Return the rounds that an accepted cue took; None: too few are accepted."""
    accepted = [cue.rounds for cue in cues if cue.accepted_at is not None]
    return sum(accepted) / len(accepted) if len(accepted) >= FEW else None


def days_late(cues: Collection[CuePace]) -> float | None:
    """Return by how many days accepted cues missed the day on which they were needed, half of them by more."""
    late = [
        (cue.accepted_at.date() - cue.due_on).days
        for cue in cues
        if cue.accepted_at is not None and cue.due_on is not None
    ]
    return median(late) if len(late) >= FEW else None


def on_time_share(cues: Collection[CuePace]) -> float | None:
    """Return which share of the accepted cues with a day was accepted by it; None: too few."""
    dated = [cue for cue in cues if cue.accepted_at is not None and cue.due_on is not None]
    on_time = sum(cue.accepted_at.date() <= cue.due_on for cue in dated if cue.accepted_at and cue.due_on)
    return on_time / len(dated) if len(dated) >= FEW else None


def median_hours(spans: Sequence[tuple[datetime, datetime]]) -> float | None:
    """Return how many hours something took, half of the time longer; None: it happened too seldom."""
    hours = [(ended - began).total_seconds() / 3600 for began, ended in spans if ended >= began]
    return median(hours) if len(hours) >= FEW else None


def finish_on(cues: Collection[CuePace], now: datetime) -> date | None:
    """Return the day on which the last cue is accepted at the pace of the last four weeks; None: there was none."""
    lately = sum(cue.accepted_at is not None and cue.accepted_at >= now - LATELY for cue in cues)
    left = sum(cue.accepted_at is None for cue in cues)
    if left == 0 or lately == 0:
        return None
    return (now + timedelta(days=math.ceil(left * LATELY.days / lately))).date()
