"""Hours of work against the hours there are, stated without a database; what is unknown stays unknown."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from uuid import UUID

WEEK = timedelta(days=7)
MINUTES = 60.0


@dataclass(frozen=True)
class OpenWork:
    """A cue of an agreed contract that is neither accepted nor cut."""

    cue_id: UUID
    designer_id: UUID
    category: str
    estimate_min: int | None
    worked_min: int
    due_on: date | None


@dataclass(frozen=True)
class Sum:
    """Hours left and done of some cues, and how many of them have no estimate."""

    cues: int
    unknown: int
    left_h: float
    done_h: float


@dataclass(frozen=True)
class WeekOutlook:
    """The hours due by the end of a week against the hours there are until then."""

    week_on: date  # its Monday
    due_h: float
    wanted_h: float  # since today
    there_h: float | None  # since today; None: not known
    is_short: bool


def left_hours(work: OpenWork) -> float:
    """Return the hours left of an estimate; nothing of a cue without one, which is counted as unknown."""
    return 0.0 if work.estimate_min is None else max(0, work.estimate_min - work.worked_min) / MINUTES


def summed(works: Iterable[OpenWork]) -> Sum:
    """Return the hours of cues."""
    every = list(works)
    return Sum(
        cues=len(every),
        unknown=sum(work.estimate_min is None for work in every),
        left_h=sum(map(left_hours, every)),
        done_h=sum(work.worked_min for work in every) / MINUTES,
    )


def by_category(works: Iterable[OpenWork]) -> list[tuple[str, Sum]]:
    """Return the hours of each category, the most hours first."""
    works_by_category: dict[str, list[OpenWork]] = defaultdict(list)
    for work in works:
        works_by_category[work.category].append(work)
    return sorted(
        ((name, summed(category_works)) for name, category_works in works_by_category.items()),
        key=lambda pair: (-pair[1].left_h, pair[0]),
    )


def outlook(
    works: Sequence[OpenWork], first_monday: date, free_days: Sequence[float], weekly_hours: float | None
) -> list[WeekOutlook]:
    """Return week by week what is due against what is there, both added up since today.

    `free_days` are the working days of each week that are not taken, of five. What is overdue is due in the first week.
    Cues without an estimate or without a day are in no week.
    """
    due_h = there = 0.0
    weeks = []
    for week, days in enumerate(free_days):
        monday = first_monday + week * WEEK
        due = sum(
            left_hours(work)
            for work in works
            if work.due_on is not None and work.due_on < monday + WEEK and (week == 0 or work.due_on >= monday)
        )
        due_h += due
        there += days / 5 * (weekly_hours or 0.0)
        capacity_h = there if weekly_hours is not None else None
        weeks.append(WeekOutlook(monday, due, due_h, capacity_h, capacity_h is not None and due_h > capacity_h + 1e-9))
    return weeks
