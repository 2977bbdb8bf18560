"""Work by the hour and retainers, stated without a database: months, included hours, caps and amounts."""

import calendar
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from datetime import date

from app.agreements.clauses.terms import MoneyTerms

MINUTES = 60  # of an hour

Minutes = Mapping[int, int]  # by the number of the contract's month


@dataclass(frozen=True)
class HourTerms:
    """A contract's terms for hours; minutes beyond those that a retainer includes are paid by the hour."""

    rate_minor: int = 0
    cap_min: int = 0
    month_cap_min: int = 0
    retainer_minor: int = 0
    included_min: int = 0
    months: int = 0

    @classmethod
    def of(cls, terms: MoneyTerms) -> "HourTerms":
        """Return the hours of a contract's terms."""
        return cls(
            rate_minor=terms.hour_rate_minor,
            cap_min=terms.hours_cap * MINUTES if terms.hour_rate_minor else 0,
            month_cap_min=terms.hours_month_cap * MINUTES if terms.hour_rate_minor else 0,
            retainer_minor=terms.retainer_minor,
            included_min=terms.retainer_hours * MINUTES if terms.retainer_total_minor else 0,
            months=terms.retainer_months,
        )

    def included_in(self, month: int) -> int:
        """Return the minutes that the retainer of a month includes."""
        return self.included_min if month <= self.months else 0

    def paid_in(self, month: int, minutes: int) -> int:
        """Return the minutes of a month that are paid by the hour."""
        return max(0, minutes - self.included_in(month))

    def paid(self, minutes: Minutes) -> int:
        """Return the number of minutes paid by the hour, over all months."""
        return sum(self.paid_in(month, of_it) for month, of_it in minutes.items())

    def left(self, month: int, minutes: Minutes) -> int:
        """Return the further minutes of a month that the contract pays for: those included, then up to the caps."""
        worked = minutes.get(month, 0)
        included = max(0, self.included_in(month) - worked)
        caps = (self.month_cap_min - self.paid_in(month, worked), self.cap_min - self.paid(minutes))
        return included + max(0, min(caps))

    def price(self, minutes: int) -> int:
        """Return the price of minutes by the hour, rounded once, half away from zero."""
        return (2 * minutes * self.rate_minor + MINUTES) // (2 * MINUTES)

    def charge(self, month: int, minutes: int, approved: Minutes) -> int:
        """Return the cost of further minutes of a month; all lines together cost what all minutes cost."""
        before = self.paid(approved)
        after = self.paid({**approved, month: approved.get(month, 0) + minutes})
        return self.price(after) - self.price(before)

    def months_due(self, agreed_on: date, today: date, charged: Collection[int]) -> list[int]:
        """Return the months of the retainer that have begun and are not charged yet."""
        if not self.retainer_minor:
            return []
        begun = min(self.months, month_of(today, agreed_on))
        return [month for month in range(1, begun + 1) if month not in charged]


def month_of(day: date, agreed_on: date) -> int:
    """Return the month of a contract in which a day is; the first begins on the day of agreement.

    Work of the days before counts in the first month.
    """
    months = (day.year - agreed_on.year) * 12 + day.month - agreed_on.month
    return max(1, months + (day >= month_begins_on(months + 1, agreed_on)))


def month_begins_on(month: int, agreed_on: date) -> date:
    """Return the first day of a contract's month: the 31st is the last day of a month that has none."""
    years, month_index = divmod(agreed_on.month - 1 + month - 1, 12)
    year = agreed_on.year + years
    return date(year, month_index + 1, min(agreed_on.day, calendar.monthrange(year, month_index + 1)[1]))
