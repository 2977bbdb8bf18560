"""Days that contracts name, of which both parties are reminded; stated without a database."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from datetime import date, timedelta

from app.agreements.clauses.rules import TermValue, day_of_term

DAY_TERMS = ("option_until_on", "points_until_on", "exclusive_until")
SHOWN_BEFORE = timedelta(days=14)
SHOWN_AFTER = timedelta(days=14)
STATEMENT_DAYS = ((1, 31), (7, 31))  # of the half of the year before


@dataclass(frozen=True)
class NamedDay:
    """One day that a contract names."""

    term: str
    day: date
    words: str  # what is to be thought of, without the day

    def is_near(self, today: date) -> bool:
        """Whether both are to think of it now."""
        return self.day - SHOWN_BEFORE <= today <= self.day + SHOWN_AFTER


def named_days(terms: Mapping[str, TermValue], agreed_on: date) -> Iterator[NamedDay]:
    """Yield the days that the standing clauses of an agreed contract name."""
    days = {term: day_of_term(terms[term]) for term in DAY_TERMS if term in terms}
    if option := days.get("option_until_on"):
        yield NamedDay("option_until_on", option, "the option on the next project ends")
    if exclusive := days.get("exclusive_until"):
        yield NamedDay("exclusive_until", exclusive, "exclusivity ends")
    if points := days.get("points_until_on"):
        for day in statement_days(agreed_on, points):
            yield NamedDay("points_until_on", day, "a statement of points is due")


def statement_days(after: date, until: date) -> Iterator[date]:
    """Yield the days on which statements are due for the time from one day to another; the last one comes after it."""
    for year in range(after.year, until.year + 2):
        for month, day in STATEMENT_DAYS:
            due = date(year, month, day)
            begins = date(year - 1, 7, 1) if month == 1 else date(year, 1, 1)  # of the half that it accounts for
            if due > after and begins <= until:
                yield due
