"""The day on which masters are deleted, and its announcement."""

from datetime import date, timedelta

ANNOUNCED_BEFORE = timedelta(days=30)


def years_after(day: date, years: int) -> date:
    """Return the same day some years later; 1 March for 29 February where that year has none."""
    try:
        return day.replace(year=day.year + years)
    except ValueError:
        return date(day.year + years, 3, 1)


def end_of_masters(last_delivery_on: date, agreed_on: date, years: int) -> date:
    """Return the first day on which masters need not be kept any more; years count from the later of both days."""
    return years_after(max(last_delivery_on, agreed_on), years)


def is_to_be_announced(ends_on: date, today: date) -> bool:
    """Return whether the parties are to be told by now that masters are deleted on a day."""
    return today >= ends_on - ANNOUNCED_BEFORE


def announced_day(ends_on: date, today: date) -> date:
    """Return the day to announce: the end of the years, and never sooner than the days of notice."""
    return max(ends_on, today + ANNOUNCED_BEFORE)
