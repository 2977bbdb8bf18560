"""Files that people send for the roster, read in the bounded child: sheets of designers, calendar files.

Of a calendar only days are kept: no title, no place and no person of an event leaves the child.
"""

from collections import defaultdict
from collections.abc import Iterator
from datetime import UTC, date, datetime, time, timedelta
from typing import Any

from dateutil.rrule import rrulestr

from app.hiring.errors import CalendarUnreadable
from app.hiring.roster.columns import known_heads_in
from app.hiring.roster.rules import MAX_RANGES, Busy, BusyKind, merged
from app.sound_lists.sheets.rules import ParsedSheet, parse_bytes, parse_text

MAX_CALENDAR_BYTES = 2_000_000
MAX_EVENTS = 10_000
MAX_OCCURRENCES = 20_000  # of all events together
HORIZON = timedelta(days=366)  # how far ahead repeating events are followed
BOOKED_HOURS, HALF_DAY_HOURS = 6.0, 3.0  # of events on one day, from which on it is taken, or half of it
DAY_S = 86_400.0
TOO_OFTEN = ("HOURLY", "MINUTELY", "SECONDLY")

Range = tuple[str, str, str]  # first day, last day, kind
Event = Any  # a component: what its properties are depends on what was sent


def parse_roster_bytes(data: bytes) -> ParsedSheet:
    """Return the fields of a sheet of designers in a CSV or XLSX file."""
    return parse_bytes(data, known_heads_in)


def parse_roster_text(text: str, pasted: bool) -> ParsedSheet:
    """Return the fields of a sheet of designers in CSV text or in pasted cells."""
    return parse_text(text, pasted, known_heads_in)


def parse_calendar(data: bytes, today: str) -> list[Range]:
    """Return the days from `today` on that the events of a calendar file take, a year ahead.

    A day with six hours of events or more is booked, one with three or more is a half day. Events that are cancelled or
    marked as free take nothing. Raises CalendarUnreadable.
    """
    if len(data) > MAX_CALENDAR_BYTES:
        raise CalendarUnreadable(
            f"a calendar file may have {MAX_CALENDAR_BYTES:,} bytes; this one has {len(data):,}",
            fix="export the coming year only",
        )
    try:
        from icalendar import Calendar  # loaded where files are parsed only

        calendars: Any = Calendar.from_ical(data, multiple=True)
        events: list[Event] = [
            event for calendar in calendars for event in calendar.walk("VEVENT") if _takes_time(event)
        ]
    except (ValueError, KeyError, IndexError, TypeError, AttributeError) as error:
        raise CalendarUnreadable(
            f"this is not a calendar file that can be read: {str(error)[:200]}", fix="export it as iCalendar (.ics)"
        ) from None
    if not calendars:
        raise CalendarUnreadable("this file holds no calendar", fix="export it as iCalendar (.ics)")
    if len(events) > MAX_EVENTS:
        raise CalendarUnreadable(
            f"a calendar may have {MAX_EVENTS:,} events; this one has {len(events):,}",
            fix="export the coming year only",
        )
    first = date.fromisoformat(today)
    taken = _seconds_by_day(events, first, first + HORIZON)
    ranges = merged(
        Busy(day, day, BusyKind.BOOKED if seconds >= BOOKED_HOURS * 3600 else BusyKind.HALF_DAYS)
        for day, seconds in taken.items()
        if seconds >= HALF_DAY_HOURS * 3600
    )
    if len(ranges) > MAX_RANGES:
        raise CalendarUnreadable(
            f"a calendar may take {MAX_RANGES} separate periods of a year; this one takes {len(ranges)}",
            fix="type the booked days instead",
        )
    return [(period.from_on.isoformat(), period.to_on.isoformat(), period.kind.value) for period in ranges]


def _takes_time(event: Event) -> bool:
    is_cancelled = str(event.get("STATUS", "")).upper() == "CANCELLED"
    is_free = str(event.get("TRANSP", "")).upper() == "TRANSPARENT"
    return "DTSTART" in event and not is_free and not is_cancelled


def _seconds_by_day(events: list[Event], first: date, last: date) -> dict[date, float]:
    taken: defaultdict[date, float] = defaultdict(float)
    moved = {  # occurrences that an event of their own replaces
        (str(event.get("UID", "")), _naive(event["RECURRENCE-ID"].dt)) for event in events if "RECURRENCE-ID" in event
    }
    count = 0
    for event in events:
        try:
            begin, length = _naive(event["DTSTART"].dt), _length(event)
            for start in _starts(event, begin, length, first, last):
                if "RECURRENCE-ID" not in event and (str(event.get("UID", "")), start) in moved:
                    continue
                count += 1
                if count > MAX_OCCURRENCES:
                    raise CalendarUnreadable(
                        f"events may happen {MAX_OCCURRENCES:,} times a year; these happen more often",
                        fix="type the booked days instead",
                    )
                for day, seconds in _days(start, length, first, last):
                    taken[day] = min(DAY_S, taken[day] + seconds)
        except (ValueError, TypeError, OverflowError, AttributeError) as error:
            begins = str(getattr(event.get("DTSTART"), "dt", ""))[:40]
            raise CalendarUnreadable(
                f"an event has dates that cannot be read: {str(error)[:200]} {begins}".strip(),
                fix="export the calendar again, or type the booked days",
            ) from None
    return taken


def _naive(moment: date | datetime) -> datetime:
    """Return a moment as the clock of its own place shows it: what counts is the designer's day."""
    if not isinstance(moment, datetime):
        return datetime.combine(moment, time())
    return moment.replace(tzinfo=None)


def _length(event: Event) -> timedelta:
    start = event["DTSTART"].dt
    if "DURATION" in event:
        length: timedelta = event["DURATION"].dt
    elif "DTEND" in event:
        length = _naive(event["DTEND"].dt) - _naive(start)
    else:
        length = timedelta() if isinstance(start, datetime) else timedelta(days=1)
    return max(length, timedelta())


def _starts(event: Event, begin: datetime, length: timedelta, first: date, last: date) -> Iterator[datetime]:
    """Yield the starts of an event, of a repeating one as often as it touches the period."""
    if "RRULE" not in event:
        yield begin
        yield from _moments(event, "RDATE")
        return
    rules = event["RRULE"] if isinstance(event["RRULE"], list) else [event["RRULE"]]
    left_out = set(_moments(event, "EXDATE"))
    after = datetime.combine(first, time()) - length
    until = datetime.combine(last, time())
    for rule in rules:
        if (rule.get("FREQ") or [""])[0].upper() in TOO_OFTEN:
            raise ValueError("it repeats within a day")
        if "UNTIL" in rule:
            rule["UNTIL"] = [_until(repeat_end, event["DTSTART"].dt) for repeat_end in rule["UNTIL"]]
        for start in rrulestr(rule.to_ical().decode(), dtstart=begin).xafter(after, inc=True):
            if start >= until:
                break
            if start not in left_out:
                yield start
    yield from _moments(event, "RDATE")


def _until(moment: date | datetime, start: date | datetime) -> datetime:
    """Return the end of a rule by the clock of its event; it is given in UTC where the event has a time zone."""
    if isinstance(moment, datetime) and moment.tzinfo and isinstance(start, datetime) and start.tzinfo:
        return moment.astimezone(start.tzinfo).replace(tzinfo=None)
    if isinstance(moment, datetime):
        return moment.astimezone(UTC).replace(tzinfo=None) if moment.tzinfo else moment
    return datetime.combine(moment, time(23, 59, 59))


def _moments(event: Event, name: str) -> Iterator[datetime]:
    given = event.get(name, [])
    for dates in given if isinstance(given, list) else [given]:
        for moments in dates.dts:
            moment = moments.dt[0] if isinstance(moments.dt, tuple) else moments.dt
            yield _naive(moment)


def _days(start: datetime, length: timedelta, first: date, last: date) -> Iterator[tuple[date, float]]:
    """Yield the days of an event with its seconds on each, within the period."""
    end = start + length
    day = max(start.date(), first)
    while day <= last:
        midnight = datetime.combine(day, time())
        if midnight >= end:
            return
        yield day, (min(end, midnight + timedelta(days=1)) - max(start, midnight)).total_seconds()
        day += timedelta(days=1)
