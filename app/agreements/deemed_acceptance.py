"""What a contract says of a silent studio: when a cue counts as accepted, and when its approver is reminded.

Working days are Monday to Friday by UTC, and a day counts once it is over; the day on which a file began to wait
is none of them.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from datetime import UTC, date, datetime, time, timedelta
from typing import Any

CLAUSE = "silence"  # its key in the library
SATURDAY, DAYS_OF_WEEK = 5, 7


def working_days(after: date, upto: date) -> int:
    """Return how many working days lie after one day, up to another and with it; 0 where that is not later."""
    days = max((upto - after).days, 0)
    weeks, rest = divmod(days, DAYS_OF_WEEK)
    left = sum((after + timedelta(days=step)).weekday() < SATURDAY for step in range(1, rest + 1))
    return weeks * SATURDAY + left


def working_day(after: date, number: int) -> date:
    """Return the working day of that number after a day."""
    weeks, rest = divmod(number - 1, SATURDAY)
    found = after + timedelta(weeks=weeks)
    for _ in range(rest + 1):
        found += timedelta(days=1)
        while found.weekday() >= SATURDAY:
            found += timedelta(days=1)
    return found


@dataclass(frozen=True)
class DeemedAcceptance:
    """The clause of one contract."""

    days: int
    reminder_days: int

    @classmethod
    def of(cls, terms: Mapping[str, Any]) -> "DeemedAcceptance | None":
        """Read the terms that hold; None where the clause does not stand.

        Texts from before this software kept the clause name no reminders: what they say is kept by the parties.
        """
        days, reminder_days = terms.get("silence_days"), terms.get("silence_reminder_days")
        return cls(days, reminder_days) if days and reminder_days else None

    def last_day(self, since: datetime) -> date:
        """Return the day that must pass without a verdict."""
        return working_day(_day(since), self.days)

    def is_over(self, since: datetime, now: datetime) -> bool:
        """Return whether that day has passed."""
        return now >= datetime.combine(self.last_day(since) + timedelta(days=1), time(), UTC)

    def reminders(self, since: datetime, now: datetime) -> int:
        """Return how many reminders are due by now; the last one comes before the last day is over."""
        return min(working_days(_day(since), _day(now)), self.days - 1) // self.reminder_days


def _day(moment: datetime) -> date:
    return moment.astimezone(UTC).date()
