"""The pace of a project, from decisions and their times: plain figures of plain values."""

import math
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from datetime import date, datetime, timedelta
from statistics import median

LATELY = timedelta(days=28)
SHORTEST_PACE = timedelta(days=7)  # what was accepted within fewer days is counted as the work of a week
MANY_ROUNDS = 3  # so many for one cue are too many
FEW = 3  # fewer make no figure


@dataclass(frozen=True)
class CuePace:
    """The decisions on one cue so far."""

    rounds: int  # changes that were sent to the designer
    first_decided_at: datetime | None
    accepted_at: datetime | None  # None: not all its variations are approved
    due_on: date | None
    is_adopted: bool = False  # approved as the game had it, with no review: accepted, and no measure of the work

    @property
    def is_decided(self) -> bool:
        """Whether a review accepted it or sent it back; an approved part of a set decides nothing."""
        return not self.is_adopted and (self.accepted_at is not None or self.rounds > 0)

    @property
    def is_first_pass(self) -> bool:
        """Whether it was accepted as it came first."""
        return self.accepted_at is not None and self.rounds == 0

    def days_late(self, today: date) -> int | None:
        """Return the days from its due day to its acceptance, or to today once that is later; None: not known yet."""
        if self.is_adopted or self.due_on is None or (self.accepted_at is None and today <= self.due_on):
            return None
        return ((self.accepted_at.date() if self.accepted_at else today) - self.due_on).days


def first_pass_share(cues: Collection[CuePace]) -> float | None:
    """Return the share of the decided cues that was accepted as it came first; None: too few are decided."""
    decided = [cue for cue in cues if cue.is_decided]
    return sum(cue.is_first_pass for cue in decided) / len(decided) if len(decided) >= FEW else None


def decided_before_and_since(cues: Collection[CuePace], at: datetime) -> tuple[list[CuePace], list[CuePace]]:
    """Part the decided cues by when they were first decided upon."""
    dated = [(cue.first_decided_at, cue) for cue in cues if cue.is_decided and cue.first_decided_at is not None]
    before = [cue for decided_at, cue in dated if decided_at < at]
    return before, [cue for decided_at, cue in dated if decided_at >= at]


def mean_rounds(cues: Collection[CuePace]) -> float | None:
    """Return the rounds that a decided cue took so far, accepted or not; None: too few are decided."""
    rounds = [cue.rounds for cue in cues if cue.is_decided]
    return sum(rounds) / len(rounds) if len(rounds) >= FEW else None


def days_late(cues: Collection[CuePace], today: date) -> float | None:
    """Return the median of the days by which cues missed their due day; an overdue cue counts up to today."""
    late = [days for cue in cues if (days := cue.days_late(today)) is not None]
    return median(late) if len(late) >= FEW else None


def on_time_share(cues: Collection[CuePace], today: date) -> float | None:
    """Return the share of cues accepted by their due day, of those accepted or overdue; None: too few."""
    late = [days for cue in cues if (days := cue.days_late(today)) is not None]
    return sum(days <= 0 for days in late) / len(late) if len(late) >= FEW else None


def median_so_far(finished: Sequence[float], open_ones: Sequence[float]) -> float | None:
    """Return the median duration; an open one counts once it lasts longer than half of the finished ones did.

    Before that its end is not known well enough to raise or lower the median. None: nothing is finished.
    """
    if not finished:
        return None
    middle = median(finished)
    return median([*finished, *(lasted for lasted in open_ones if lasted > middle)])


def median_hours(spans: Sequence[tuple[datetime, datetime | None]], now: datetime) -> float | None:
    """Return the median hours from a beginning to its end, open ones so far; None: it happened too seldom."""
    finished = [_hours(began, ended) for began, ended in spans if ended is not None and ended >= began]
    open_ones = [_hours(began, now) for began, ended in spans if ended is None]
    return median_so_far(finished, open_ones) if len(finished) >= FEW else None


def longest_wait_hours(began: Collection[datetime], now: datetime) -> float | None:
    """Return the longest wait in hours; None: none waits."""
    return _hours(min(began), now) if began else None


def _hours(began: datetime, ended: datetime) -> float:
    return max(0.0, (ended - began).total_seconds() / 3600)


def finish_on(cues: Collection[CuePace], now: datetime) -> date | None:
    """Return the day on which the last cue is accepted at the recent pace; None: nothing was accepted lately.

    The recent pace is that of the last four weeks, or of the time since the first decision where that is shorter.
    """
    reviewed = [cue for cue in cues if not cue.is_adopted]
    lately = sum(cue.accepted_at is not None and cue.accepted_at >= now - LATELY for cue in reviewed)
    left = sum(cue.accepted_at is None for cue in reviewed)
    if left == 0 or lately == 0:
        return None
    began_at = min((cue.first_decided_at for cue in reviewed if cue.first_decided_at is not None), default=now)
    window = min(LATELY, max(SHORTEST_PACE, now - began_at))
    return (now + timedelta(days=math.ceil(left * (window / lately) / timedelta(days=1)))).date()
