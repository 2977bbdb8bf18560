"""A ledger's permitted content, stated without a database."""

from datetime import date, timedelta
from enum import StrEnum

from app.core.plural import day_in_words
from app.money.errors import DayInFuture


class LineKind(StrEnum):
    """The reason for a line of the ledger."""

    DEPOSIT = "deposit"
    ACCEPTED = "accepted"
    HELD_BACK = "held_back"  # what of an accepted cue's share waited for the last cue
    CUT = "cut"
    EXTRA_ROUND = "extra_round"
    WORKED_DAY = "worked_day"
    WORKED_HOURS = "worked_hours"
    RETAINER = "retainer"  # of one month
    EXTRA_WORK = "extra_work"  # beside the cues, by a change order: rush, a voice session
    LATE_INTEREST = "late_interest"  # on an invoice that was not paid in time
    BONUS = "bonus"  # its trigger, which Soundlist calculates, was met
    TAX = "tax"
    REVERSED = "reversed"  # takes back a line of any kind above
    PAID = "paid"
    REFUNDED = "refunded"  # takes back a line of a payment


def ensure_not_ahead(day: date, today: date, why: str) -> None:
    """Raise DayInFuture for a day that has come nowhere on earth yet: somewhere it is tomorrow already."""
    if day > today + timedelta(days=1):
        raise DayInFuture(f"{day_in_words(day)} is in the future; {why}", fix="give the day on which it happened")


def hours_in_words(minutes: int) -> str:
    """Return minutes as hours: 3 h, 2 h 30 min, 45 min."""
    hours, rest = divmod(minutes, 60)
    return " ".join(part for part in (f"{hours} h" if hours or not rest else "", f"{rest} min" if rest else "") if part)
