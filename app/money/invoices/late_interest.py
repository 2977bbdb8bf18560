"""Interest on invoices that are paid late, by the day: computed here from plain values, charged by the designer."""

from collections.abc import Iterable
from datetime import date

DAYS_OF_MONTH = 30  # a month's rate is shared over so many days, whichever month it is
WHOLE_BP = 10_000


def interest_minor(
    owed_minor: int, payments: Iterable[tuple[date, int]], *, due_on: date, until: date, monthly_bp: int
) -> int:
    """Return the simple interest of an invoice up to a day: on what was open, for each day after it was due.

    The day of a payment still counts for what it paid. One rounding, half away from zero.
    """
    open_minor, last, minor_days = owed_minor, due_on, 0
    for paid_on, amount_minor in sorted(payments):
        if paid_on > due_on and paid_on <= until:
            minor_days += max(open_minor, 0) * (paid_on - last).days
            last = paid_on
        if paid_on <= until:
            open_minor -= amount_minor
    minor_days += max(open_minor, 0) * max((until - last).days, 0)
    parts, divisor = minor_days * monthly_bp, WHOLE_BP * DAYS_OF_MONTH
    return (2 * parts + divisor) // (2 * divisor)
