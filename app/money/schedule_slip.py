"""A milestone's lateness, the party with whom the days went, and any growth."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import UTC, date, datetime, time, timedelta
from enum import StrEnum

from app.agreements.plan.amounts import split


class Holder(StrEnum):
    """Whose turn it is on a cue."""

    DESIGNER = "designer"
    STUDIO = "studio"


@dataclass(frozen=True)
class Turn:
    """The time from which a cue was with one party."""

    at: datetime
    holder: Holder


@dataclass(frozen=True)
class ScheduleSlip:
    """Whole days late, and how many of them lay with whom."""

    days: int
    designer_days: int
    studio_days: int


def schedule_slip_of(
    due_on: date, done_at: datetime | None, turns: Sequence[Sequence[Turn]], now: datetime
) -> ScheduleSlip:
    """Return the delay of a delivery whose cues changed hands at these turns; a cue without turns is with the designer.

    A moment counts for the studio when every unfinished cue is with the studio then, else for the designer: as long
    as one sound is still to make, the designer is not waiting.
    """
    end = done_at or now
    late_from = datetime.combine(due_on + timedelta(days=1), time(), UTC)
    days = (end.astimezone(UTC).date() - due_on).days
    if days <= 0 or end < late_from:
        return ScheduleSlip(0, 0, 0)
    studio_s = sum(
        int((until - since).total_seconds())
        for since, until in _stretches(turns, late_from, end)
        if turns and all(_holder_at(turn, since) is Holder.STUDIO for turn in turns)
    )
    whole_s = int((end - late_from).total_seconds())
    if not whole_s:  # the first moment of the first late day
        is_studios = bool(turns) and all(_holder_at(turn, end) is Holder.STUDIO for turn in turns)
        return ScheduleSlip(days, 0 if is_studios else days, days if is_studios else 0)
    designer_days, studio_days = split(days, [whole_s - studio_s, studio_s])
    return ScheduleSlip(days, designer_days, studio_days)


def _stretches(turns: Sequence[Sequence[Turn]], since: datetime, until: datetime) -> list[tuple[datetime, datetime]]:
    moments = sorted({since, until, *(turn.at for cue_turns in turns for turn in cue_turns if since < turn.at < until)})
    return list(itertools.pairwise(moments))


def _holder_at(turns: Sequence[Turn], moment: datetime) -> Holder:
    past = [turn for turn in turns if turn.at <= moment]
    return max(past, key=lambda turn: turn.at).holder if past else Holder.DESIGNER


def growth_days(slips: Sequence[int]) -> float | None:
    """Return the days by which each milestone slips more than the one before, by least squares; None for one alone."""
    if len(slips) < 2:
        return None
    middle = (len(slips) - 1) / 2
    mean = sum(slips) / len(slips)
    above = sum((index - middle) * (days - mean) for index, days in enumerate(slips))
    return above / sum((index - middle) ** 2 for index in range(len(slips)))
