"""When a contract may end early, stated without a database."""

from datetime import date, timedelta
from enum import StrEnum

from app.amendments.errors import NoticeTooShort


class ChangeOrderState(StrEnum):
    """How far the parties are with a change order."""

    PROPOSED = "proposed"
    AGREED = "agreed"
    REFUSED = "refused"  # by the other party
    WITHDRAWN = "withdrawn"  # by the party that proposed it
    LAPSED = "lapsed"  # the contract ended


def end_of_notice(today: date, notice_days: int | None, wanted: date | None) -> date | None:
    """Return the last day of a contract whose notice is given today; None where it ends only if both agree.

    Raises NoticeTooShort for a day before the one that the contract allows.
    """
    if notice_days is None:
        if wanted is not None:
            raise NoticeTooShort(
                "no clause of this contract lets one party end it on a day of their own",
                fix="give notice without a day; it ends when both agree to the statement",
            )
        return None
    earliest = today + timedelta(days=notice_days)
    if wanted is not None and wanted < earliest:
        raise NoticeTooShort(
            f"{wanted} is before {earliest}; the contract wants {notice_days} days of notice",
            errors=[{"where": "ends_on", "message": f"wanted {earliest} or later"}],
            fix=f"give notice for {earliest}; it ends at once when both agree to the statement",
        )
    return wanted or earliest


def is_over(ends_on: date | None, today: date) -> bool:
    """Return whether the last day of a notice has passed, in UTC as every day of a contract."""
    return ends_on is not None and ends_on < today
