"""Calendar files: the days that their events take, and what is refused."""

from datetime import date

import pytest

from app.hiring.errors import CalendarUnreadable
from app.hiring.roster.files import MAX_CALENDAR_BYTES, parse_calendar

TODAY = "2026-11-23"  # a Monday


def calendar(*events: str) -> bytes:
    lines = ["BEGIN:VCALENDAR", "VERSION:2.0", "PRODID:-//test//EN"]
    for number, event in enumerate(events):
        lines += [
            "BEGIN:VEVENT",
            f"UID:{number}@example.test",
            "DTSTAMP:20261101T000000Z",
            *event.split(),
            "END:VEVENT",
        ]
    return "\r\n".join([*lines, "END:VCALENDAR", ""]).encode()


@pytest.mark.parametrize(
    ("event", "ranges"),
    [
        ("DTSTART;VALUE=DATE:20261201 DTEND;VALUE=DATE:20261205", [("2026-12-01", "2026-12-04", "booked")]),
        ("DTSTART;VALUE=DATE:20261201", [("2026-12-01", "2026-12-01", "booked")]),
        ("DTSTART:20261201T090000 DTEND:20261201T150000", [("2026-12-01", "2026-12-01", "booked")]),
        ("DTSTART:20261201T090000 DTEND:20261201T145900", [("2026-12-01", "2026-12-01", "half_days")]),
        ("DTSTART:20261201T090000 DTEND:20261201T115900", []),  # an hour at the dentist takes no day
        ("DTSTART:20261201T090000 DURATION:PT7H", [("2026-12-01", "2026-12-01", "booked")]),
        ("DTSTART;VALUE=DATE:20261201 STATUS:CANCELLED", []),
        ("DTSTART;VALUE=DATE:20261201 TRANSP:TRANSPARENT", []),
        (
            "DTSTART;VALUE=DATE:20261101 DTEND;VALUE=DATE:20261125",
            [("2026-11-23", "2026-11-24", "booked")],
        ),  # past days
        ("DTSTART;VALUE=DATE:20290101", []),  # beyond the year that is read
    ],
)
def test_what_an_event_takes(event: str, ranges: list[tuple[str, str, str]]) -> None:
    assert parse_calendar(calendar(event), TODAY) == ranges


def test_short_events_of_one_day_add_up() -> None:
    morning, noon = "DTSTART:20261201T080000 DTEND:20261201T113000", "DTSTART:20261201T120000 DTEND:20261201T150000"
    assert parse_calendar(calendar(morning, noon), TODAY) == [("2026-12-01", "2026-12-01", "booked")]


def test_a_repeating_event_is_followed_for_a_year_and_no_further() -> None:
    fridays = parse_calendar(calendar("DTSTART;VALUE=DATE:20200103 RRULE:FREQ=WEEKLY"), TODAY)  # without an end
    assert fridays[0] == ("2026-11-27", "2026-11-27", "booked")
    assert len(fridays) == 52
    assert fridays[-1][0] <= "2027-11-24"
    assert {date.fromisoformat(first).weekday() for first, _, _ in fridays} == {4}


def test_a_rule_ends_where_it_says_and_leaves_out_its_exceptions() -> None:
    event = (
        "DTSTART;TZID=Europe/Berlin:20261130T090000 DTEND;TZID=Europe/Berlin:20261130T170000 "
        "RRULE:FREQ=DAILY;UNTIL=20261203T080000Z EXDATE;TZID=Europe/Berlin:20261201T090000"
    )
    assert parse_calendar(calendar(event), TODAY) == [
        ("2026-11-30", "2026-11-30", "booked"),
        ("2026-12-02", "2026-12-03", "booked"),
    ]


def test_a_moved_occurrence_replaces_its_own() -> None:
    text = calendar("DTSTART;VALUE=DATE:20261201 RRULE:FREQ=WEEKLY;COUNT=2").decode()
    moved = calendar("DTSTART;VALUE=DATE:20261210 RECURRENCE-ID;VALUE=DATE:20261208").decode()
    event = moved[moved.index("BEGIN:VEVENT") : moved.index("END:VCALENDAR")]
    both = text.replace("END:VCALENDAR", f"{event}END:VCALENDAR").encode()
    assert [first for first, _, _ in parse_calendar(both, TODAY)] == ["2026-12-01", "2026-12-10"]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("data", "says"),
    [
        (b"not a calendar", "calendar"),
        (b"", "calendar"),
        (b"\xff\xfe\x00\x01", "calendar"),
        (b"x" * (MAX_CALENDAR_BYTES + 1), "bytes"),
        (calendar("DTSTART;VALUE=DATE:20261201 RRULE:FREQ=SECONDLY"), "within a day"),
        (calendar("DTSTART;VALUE=DATE:20261201 RRULE:FREQ=NEVER"), "cannot be read"),
        (calendar(*["DTSTART;VALUE=DATE:20261201"] * 10_001), "events"),
        (calendar(*["DTSTART;VALUE=DATE:20261201 RRULE:FREQ=DAILY"] * 60), "times a year"),
    ],
)
def test_what_cannot_be_read_says_why(data: bytes, says: str) -> None:
    with pytest.raises(CalendarUnreadable, match=says):
        parse_calendar(data, TODAY)
