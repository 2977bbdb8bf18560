"""Numbers of a designer's invoices: which one follows, and what a typed one leaves out."""

import re
from collections.abc import Collection
from dataclasses import dataclass
from datetime import date

COUNT = re.compile(r"(?P<before>.*?)(?P<count>\d{1,15})(?P<after>\D*)", re.ASCII | re.DOTALL)  # the last digits count
NOT_IN_FILE_NAMES = re.compile(r"[^A-Za-z0-9._-]+")


@dataclass(frozen=True)
class _Counted:
    """A number as its series and its place in it: "INV-2026-014" is 14 of "INV-2026-"."""

    before: str
    count: int
    digits: int
    after: str

    @property
    def series(self) -> tuple[str, str]:
        return self.before, self.after

    def at(self, count: int) -> str:
        return f"{self.before}{count:0{self.digits}d}{self.after}"


def following(last: str, last_on: date, today: date, used: Collection[str] = ()) -> str:
    """Return the number after a designer's last one that is not used.

    A series that has the year in it begins again at 1 in another year: after INV-2026-014 comes INV-2027-001.
    """
    counted = _counted(last)
    if counted is None:
        return _unused(_Counted(f"{last}-", 1, 1, ""), 2, used)
    if today.year > last_on.year and str(last_on.year) in counted.before:
        before = counted.before.replace(str(last_on.year), str(today.year))
        return _unused(_Counted(before, 0, counted.digits, counted.after), 1, used)
    return _unused(counted, counted.count + 1, used)


def advice(number: str, used: Collection[str]) -> str:
    """Return the advice on a number before it is used, in a sentence; "" where it follows the one before."""
    if number in used:
        return f"You have issued an invoice {number} already."
    counted = _counted(number)
    if counted is None:
        return f"It has no digits to count on; the next one would be {number}-2."
    series = [other for other in map(_counted, used) if other is not None and other.series == counted.series]
    if not series:
        return ""
    highest = max(other.count for other in series)
    if counted.count < highest:
        return f"{counted.at(highest)} is issued already; this one stands before it."
    missing = counted.count - highest - 1
    if missing == 0:
        return ""
    first, last = counted.at(highest + 1), counted.at(counted.count - 1)
    return f"{first} is left out." if missing == 1 else f"{first} to {last} are left out."


def file_part(number: str) -> str:
    """Return a number as part of a file name."""
    return NOT_IN_FILE_NAMES.sub("-", number).strip("-") or "number"


def _unused(counted: _Counted, count: int, used: Collection[str]) -> str:
    while counted.at(count) in used:
        count += 1
    return counted.at(count)


def _counted(number: str) -> _Counted | None:
    match = COUNT.fullmatch(number)
    if match is None:
        return None
    return _Counted(match["before"], int(match["count"]), len(match["count"]), match["after"])
