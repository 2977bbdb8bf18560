"""The roster, stated without a database: what is kept of a designer, who matches a search, which weeks are free."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from enum import StrEnum

WEEKS_SHOWN = 12
WEEK = timedelta(days=7)
WORKING_DAYS = 5  # Monday to Friday
MAX_ENTRIES = 5_000  # of one studio
MAX_RANGES = 400  # of one designer


class RosterService(StrEnum):
    """A service of a designer besides making sounds."""

    COMPOSES = "composes"
    DIRECTS = "directs"
    SUPPLIES_TALENT = "supplies_talent"
    NARRATION = "narration"
    FIELD_RECORDING = "field_recording"
    IMPLEMENTS = "implements"


SERVICE_WORDS = {
    RosterService.COMPOSES: "composes music",
    RosterService.DIRECTS: "directs voice sessions",
    RosterService.SUPPLIES_TALENT: "supplies voice talent",
    RosterService.NARRATION: "records narration",
    RosterService.FIELD_RECORDING: "records in the field",
    RosterService.IMPLEMENTS: "implements in the engine",
}


class Exclusivity(StrEnum):
    """Whether a designer works on one project alone while it lasts, as they say."""

    UNKNOWN = "unknown"
    ALONE = "alone"
    SEVERAL = "several"


class RateUnit(StrEnum):
    """The unit that a rate counts."""

    HOUR = "hour"
    DAY = "day"


class BusyKind(StrEnum):
    """The taken part of a day."""

    BOOKED = "booked"
    HALF_DAYS = "half_days"


class WeekState(StrEnum):
    """The state of a designer's week: a booked day makes it partly booked, booked working days make it booked."""

    FREE = "free"
    HALF_DAYS = "half_days"
    PARTLY = "partly"
    BOOKED = "booked"


@dataclass(frozen=True)
class Busy:
    """Days that are taken, the last one included."""

    from_on: date
    to_on: date
    kind: BusyKind = BusyKind.BOOKED
    note: str = ""


@dataclass(frozen=True)
class Known:
    """Facts of a designer on file that a search can find."""

    texts: Sequence[str]
    specialities: Sequence[str]
    services: Sequence[str]
    languages: Sequence[str]


@dataclass(frozen=True)
class RosterFilter:
    """A person's search; empty fields ask for nothing."""

    words: str = ""
    speciality: str = ""
    service: RosterService | None = None
    language: str = ""


def matches(known: Known, wanted: RosterFilter) -> bool:
    """Whether a designer has everything that is looked for: each word somewhere, and each chosen field."""
    if wanted.service is not None and wanted.service not in known.services:
        return False
    for value, own in ((wanted.speciality, known.specialities), (wanted.language, known.languages)):
        if value and value.casefold() not in {name.casefold() for name in own}:
            return False
    words = wanted.words.casefold().split()
    if not words:
        return True
    everything = "\n".join((*known.texts, *known.specialities, *known.services, *known.languages)).casefold()
    return all(word in everything for word in words)


def counted(values: Iterable[Sequence[str]]) -> list[tuple[str, int]]:
    """Return each value with how many designers have it, the most frequent first; case makes no difference."""
    counts: Counter[str] = Counter()
    shown: dict[str, str] = {}
    for own in values:
        for folded, value in {name.casefold(): name for name in own}.items():
            counts[folded] += 1
            shown.setdefault(folded, value)
    return [(shown[folded], count) for folded, count in sorted(counts.items(), key=lambda pair: (-pair[1], pair[0]))]


def tidy_values(values: Iterable[str]) -> list[str]:
    """Return words and phrases as they are kept: trimmed, none twice, in their order."""
    kept: dict[str, str] = {}
    for value in values:
        if plain := " ".join(value.split()):
            kept.setdefault(plain.casefold(), plain)
    return list(kept.values())


def monday_of(day: date) -> date:
    """Return the Monday of a day's week."""
    return day - timedelta(days=day.weekday())


def weeks(ranges: Sequence[Busy], today: date, available_from_on: date | None = None) -> list[WeekState]:
    """Return the state of each of the coming weeks, this one first, by its working days from today on.

    Days before `available_from_on` are booked.
    """
    first = monday_of(today)
    last = first + WEEKS_SHOWN * WEEK
    booked, half = set(_days(ranges, BusyKind.BOOKED, today, last)), set(_days(ranges, BusyKind.HALF_DAYS, today, last))
    states = []
    for week in range(WEEKS_SHOWN):
        monday = first + week * WEEK
        days = [day for offset in range(WORKING_DAYS) if (day := monday + timedelta(days=offset)) >= today]
        taken = sum(day in booked or (available_from_on is not None and day < available_from_on) for day in days)
        if days and taken == len(days):
            states.append(WeekState.BOOKED)
        elif taken:
            states.append(WeekState.PARTLY)
        elif half.intersection(days):
            states.append(WeekState.HALF_DAYS)
        else:
            states.append(WeekState.FREE)
    return states


def free_days(ranges: Sequence[Busy], today: date, available_from_on: date | None = None) -> list[float]:
    """Return the number of free working days of each coming week, from today on; a half day counts as half."""
    first = monday_of(today)
    last = first + WEEKS_SHOWN * WEEK
    booked, half = set(_days(ranges, BusyKind.BOOKED, today, last)), set(_days(ranges, BusyKind.HALF_DAYS, today, last))
    free = []
    for week in range(WEEKS_SHOWN):
        days = [first + week * WEEK + timedelta(days=offset) for offset in range(WORKING_DAYS)]
        open_days = [day for day in days if day >= max(today, available_from_on or today) and day not in booked]
        free.append(sum(0.5 if day in half else 1.0 for day in open_days))
    return free


def _days(ranges: Sequence[Busy], kind: BusyKind, first: date, last: date) -> Iterator[date]:
    for busy in ranges:
        if busy.kind is kind:
            start = max(busy.from_on, first)
            for offset in range((min(busy.to_on, last) - start).days + 1):
                yield start + timedelta(days=offset)


def clashes(
    ranges: Sequence[Busy], first: date | None, last: date | None, available_from_on: date | None = None
) -> list[Busy]:
    """Return the taken days in a period, cut to it, the earliest first; a period without an end has none."""
    if first is None or last is None:
        return []
    taken = list(ranges)
    if available_from_on is not None and available_from_on > first:
        taken.append(Busy(first, available_from_on - timedelta(days=1), note="not available yet"))
    within = [
        Busy(max(busy.from_on, first), min(busy.to_on, last), busy.kind, busy.note)
        for busy in taken
        if busy.from_on <= last and first <= busy.to_on
    ]
    return sorted(within, key=lambda busy: (busy.from_on, busy.to_on))


def free_from(ranges: Sequence[Busy], today: date, available_from_on: date | None) -> date:
    """Return the first day from today on that is not booked; half days count as free."""
    day = max(today, available_from_on or today)
    booked = sorted((busy for busy in ranges if busy.kind is BusyKind.BOOKED), key=lambda busy: busy.from_on)
    for booking in booked:
        if booking.from_on <= day <= booking.to_on:
            day = booking.to_on + timedelta(days=1)
    return day


def merged(ranges: Iterable[Busy]) -> list[Busy]:
    """Return ranges of one kind and note that touch or overlap as one, the earliest first."""
    joined: list[Busy] = []
    for busy_range in sorted(ranges, key=lambda busy: (busy.kind, busy.note, busy.from_on)):
        last = joined[-1] if joined else None
        if (
            last
            and (last.kind, last.note) == (busy_range.kind, busy_range.note)
            and busy_range.from_on <= last.to_on + timedelta(days=1)
        ):
            joined[-1] = Busy(last.from_on, max(last.to_on, busy_range.to_on), busy_range.kind, busy_range.note)
        else:
            joined.append(busy_range)
    return sorted(joined, key=lambda busy: (busy.from_on, busy.to_on))
