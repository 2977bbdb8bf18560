"""A contract's rule on a silent studio: the times of a cue's acceptance and of its approver's reminder.

A working day counts once it is over; the day on which a file began to wait is none of them. Which days are working
days, and whether anything stops the count, is the contract's choice: the studio's own calendar, time zone and open
points, or Monday to Friday by UTC.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from datetime import UTC, date, datetime, time, timedelta, tzinfo
from typing import Any

from app.reviews.rules import PausedBy

CLAUSE = "silence"  # its key in the library
SATURDAY, DAYS_OF_WEEK = 5, 7
ONE_DAY = timedelta(days=1)


def working_days(after: date, upto: date) -> int:
    """Return the number of days from Monday to Friday after one day, up to and with another; 0 if that is earlier."""
    days = max((upto - after).days, 0)
    weeks, rest = divmod(days, DAYS_OF_WEEK)
    left = sum((after + timedelta(days=step)).weekday() < SATURDAY for step in range(1, rest + 1))
    return weeks * SATURDAY + left


@dataclass(frozen=True)
class WorkCalendar:
    """A studio's working days: Monday to Friday by a time zone, but no holiday."""

    zone: tzinfo = UTC
    holidays: Mapping[date, datetime] = field(default_factory=dict)  # each with the moment at which it was entered

    def day_of(self, moment: datetime) -> date:
        """Return the day that a moment is in."""
        return moment.astimezone(self.zone).date()

    def start_of(self, day: date) -> datetime:
        """Return the moment at which a day begins."""
        return datetime.combine(day, time(), self.zone)

    def is_working_day(self, day: date, *, as_of: datetime) -> bool:
        """Whether a day is one for a cue that began to wait then: a holiday that was entered since is ignored."""
        entered_at = self.holidays.get(day)
        return day.weekday() < SATURDAY and (entered_at is None or entered_at > as_of)


MONDAY_TO_FRIDAY = WorkCalendar()


@dataclass(frozen=True)
class Pause:
    """A time in which something was open that stops the count."""

    by: PausedBy
    began_at: datetime
    ended_at: datetime | None = None

    def lasts(self, now: datetime) -> bool:
        """Whether it is open at a moment."""
        return self.began_at <= now and (self.ended_at is None or self.ended_at > now)


@dataclass(frozen=True)
class DeemedAcceptance:
    """The clause of one contract."""

    days: int
    reminder_days: int
    by_studio_calendar: bool = False

    @classmethod
    def of(cls, terms: Mapping[str, Any]) -> "DeemedAcceptance | None":
        """Read the terms that hold; None where the clause does not stand.

        Texts from before this software kept the clause name no reminders: what they say is kept by the parties. Texts
        that name no calendar count Monday to Friday by UTC, and nothing stops the count.
        """
        days, reminder_days = terms.get("silence_days"), terms.get("silence_reminder_days")
        by_studio_calendar = terms.get("silence_calendar") == "studio"
        return cls(days, reminder_days, by_studio_calendar) if days and reminder_days else None


@dataclass(frozen=True)
class Wait:
    """One cue that waits under the clause since a moment."""

    clause: DeemedAcceptance
    since: datetime
    calendar: WorkCalendar = MONDAY_TO_FRIDAY
    pauses: tuple[Pause, ...] = ()

    @classmethod
    def under(
        cls, clause: DeemedAcceptance, since: datetime, calendar: WorkCalendar, pauses: Iterable[Pause]
    ) -> "Wait":
        """Return a wait by the calendar of its clause."""
        return cls(clause, since, calendar, tuple(pauses)) if clause.by_studio_calendar else cls(clause, since)

    def paused_by(self, now: datetime) -> PausedBy | None:
        """Return the cause that stops the count at a moment; None where nothing does."""
        return next((pause.by for pause in self.pauses if pause.lasts(now)), None)

    def counts(self, day: date, now: datetime) -> bool:
        """Whether a day counts: a working day after the wait began, on which nothing was open at any moment."""
        calendar = self.calendar
        if day <= calendar.day_of(self.since) or not calendar.is_working_day(day, as_of=self.since):
            return False
        begins, ends = calendar.start_of(day), calendar.start_of(day + ONE_DAY)
        return not any(pause.began_at < ends and (pause.ended_at or now) >= begins for pause in self.pauses)

    def last_day(self, now: datetime) -> date:
        """Return the day that must pass without a verdict; what is open now counts as closed today."""
        day, left = self.calendar.day_of(self.since), self.clause.days
        while left:
            day += ONE_DAY
            left -= self.counts(day, now)
        return day

    def is_over(self, now: datetime) -> bool:
        """Whether that day has passed, and nothing stops the count."""
        return self.paused_by(now) is None and now >= self.calendar.start_of(self.last_day(now) + ONE_DAY)

    def reminders(self, now: datetime) -> int:
        """Return the number of reminders due by now; the last one comes before the last day is over."""
        day, today, counted = self.calendar.day_of(self.since), self.calendar.day_of(now), 0
        while day < today and counted < self.clause.days - 1:
            day += ONE_DAY
            counted += self.counts(day, now)
        return counted // self.clause.reminder_days
