"""The roster's rules: who matches, which weeks are free, what clashes."""

from datetime import date, timedelta

import pytest

from app.hiring.roster.columns import RosterField, field_of, known_heads_in, read_cell, read_rate
from app.hiring.roster.rules import (
    Busy,
    BusyKind,
    Exclusivity,
    Known,
    RateUnit,
    RosterFilter,
    RosterService,
    WeekState,
    clashes,
    counted,
    free_days,
    free_from,
    merged,
    monday_of,
    tidy_values,
    weeks,
)
from app.hiring.roster.rules import matches as is_match
from app.hiring.rules import overlap

MONDAY = date(2026, 11, 23)
DAY = timedelta(days=1)
KNOWN = Known(
    texts=("A designer", "designer@example.test", "Two ribbon microphones"),
    specialities=("Weapons", "Creatures"),
    services=(RosterService.COMPOSES,),
    languages=("German",),
)


@pytest.mark.parametrize(
    ("wanted", "found"),
    [
        (RosterFilter(), True),
        (RosterFilter(words="ribbon weap"), True),  # each word anywhere, parts of words too
        (RosterFilter(words="ribbon piano"), False),
        (RosterFilter(speciality="weapons", language="GERMAN"), True),
        (RosterFilter(speciality="weap"), False),  # a chosen value is the whole value
        (RosterFilter(service=RosterService.COMPOSES), True),
        (RosterFilter(service=RosterService.DIRECTS), False),
    ],
)
def test_everything_that_is_looked_for_is_there(wanted: RosterFilter, found: bool) -> None:
    assert is_match(KNOWN, wanted) is found


def test_a_week_is_booked_when_its_working_days_are() -> None:
    states = weeks(
        [
            Busy(MONDAY, MONDAY + 4 * DAY),  # Monday to Friday
            Busy(MONDAY + 9 * DAY, MONDAY + 9 * DAY),  # a Wednesday
            Busy(MONDAY + 14 * DAY, MONDAY + 16 * DAY, BusyKind.HALF_DAYS),
            Busy(MONDAY + 26 * DAY, MONDAY + 27 * DAY),  # a weekend
        ],
        MONDAY,
    )
    assert len(states) == 12
    assert states[:4] == [WeekState.BOOKED, WeekState.PARTLY, WeekState.HALF_DAYS, WeekState.FREE]


def test_free_days_are_working_days_from_today_on_that_are_not_booked() -> None:
    wednesday = MONDAY + 2 * DAY
    ranges = [
        Busy(MONDAY, wednesday),
        Busy(MONDAY + 7 * DAY, MONDAY + 8 * DAY, BusyKind.HALF_DAYS),
        Busy(MONDAY + 14 * DAY, MONDAY + 20 * DAY),
    ]
    assert free_days(ranges, wednesday)[:4] == [2.0, 4.0, 0.0, 5.0]
    assert free_days(ranges, wednesday, available_from_on=MONDAY + 8 * DAY)[:4] == [0.0, 3.5, 0.0, 5.0]
    assert free_days(ranges, wednesday, available_from_on=MONDAY)[0] == 2.0  # a day that is over


def test_days_that_are_over_do_not_count_and_days_before_the_first_are_booked() -> None:
    friday = MONDAY + 4 * DAY
    assert weeks([Busy(MONDAY, friday - DAY)], friday)[0] is WeekState.FREE
    assert weeks([Busy(friday, friday)], friday)[0] is WeekState.BOOKED
    late = weeks([], MONDAY, MONDAY + 8 * DAY)  # free from the Tuesday after
    assert late[:3] == [WeekState.BOOKED, WeekState.PARTLY, WeekState.FREE]
    assert weeks([], MONDAY + 5 * DAY)[0] is WeekState.FREE  # a Saturday: no working day is left


def test_a_clash_is_cut_to_the_period() -> None:
    busy = [Busy(MONDAY, MONDAY + 10 * DAY, note="another game")]
    (found,) = clashes(busy, MONDAY + 7 * DAY, MONDAY + 30 * DAY)
    assert (found.from_on, found.to_on, found.note) == (MONDAY + 7 * DAY, MONDAY + 10 * DAY, "another game")
    assert clashes(busy, MONDAY + 11 * DAY, MONDAY + 30 * DAY) == []
    assert clashes(busy, MONDAY, None) == []
    (late,) = clashes([], MONDAY, MONDAY + 30 * DAY, available_from_on=MONDAY + 3 * DAY)
    assert (late.from_on, late.to_on) == (MONDAY, MONDAY + 2 * DAY)


def test_free_from_passes_ranges_that_follow_each_other() -> None:
    busy = [Busy(MONDAY + 5 * DAY, MONDAY + 9 * DAY), Busy(MONDAY, MONDAY + 4 * DAY)]
    assert free_from(busy, MONDAY, None) == MONDAY + 10 * DAY
    assert free_from([Busy(MONDAY, MONDAY, BusyKind.HALF_DAYS)], MONDAY, None) == MONDAY
    assert free_from([], MONDAY, MONDAY + 3 * DAY) == MONDAY + 3 * DAY


def test_days_that_touch_become_one_range() -> None:
    days = [Busy(MONDAY + n * DAY, MONDAY + n * DAY) for n in (2, 0, 1, 4)]
    assert [(one.from_on, one.to_on) for one in merged(days)] == [
        (MONDAY, MONDAY + 2 * DAY),
        (MONDAY + 4 * DAY, MONDAY + 4 * DAY),
    ]


def test_values_are_tidied_and_counted_without_case() -> None:
    assert tidy_values([" Weapons ", "weapons", "", "UI  sounds"]) == ["Weapons", "UI sounds"]
    assert counted([["Weapons", "UI"], ["weapons"]]) == [("Weapons", 2), ("UI", 1)]
    assert monday_of(MONDAY + 6 * DAY) == MONDAY


@pytest.mark.parametrize(
    ("head", "field"),
    [
        ("E-Mail", RosterField.EMAIL),
        ("Name (full)", RosterField.NAME),
        ("Hours / week", RosterField.WEEKLY_HOURS),
        ("Demo reel", RosterField.LINKS),
        ("Shoe size", None),
        ("x" * 5_000, None),
    ],
)
def test_heads(head: str, field: RosterField | None) -> None:
    assert field_of(head) is field


def test_heads_are_counted_once_a_field() -> None:
    assert known_heads_in(["Name", "Designer", "Email", "", "Shoe size"]) == 2


@pytest.mark.parametrize(
    ("field", "text", "value"),
    [
        (RosterField.EMAIL, "A Designer <Designer@Example.test>", "designer@example.test"),
        (RosterField.SPECIALITIES, "weapons; Creatures / weapons", ["weapons", "Creatures"]),
        (RosterField.SERVICES, "Composer, voice direction", ["composes", "directs"]),
        (RosterField.LINKS, "example.test/reel", [{"title": "", "url": "https://example.test/reel"}]),
        (RosterField.EXCLUSIVITY, "Yes", Exclusivity.ALONE),
        (RosterField.WEEKLY_HOURS, "20 h/week", 20),
        (RosterField.AVAILABLE_FROM_ON, "2027-01-11", date(2027, 1, 11)),
        (RosterField.AVAILABLE_FROM_ON, "now", None),
    ],
)
def test_cells(field: RosterField, text: str, value: object) -> None:
    assert read_cell(field, text) == value


@pytest.mark.parametrize(
    ("text", "amount", "currency", "unit"),
    [
        ("45 USD/hour", 4_500, "USD", RateUnit.HOUR),
        ("€400 a day", 40_000, "EUR", RateUnit.DAY),
        ("1.250,50 EUR per day", 125_050, "EUR", RateUnit.DAY),
        ("6000 JPY/h", 6_000, "JPY", RateUnit.HOUR),  # a currency without a minor unit
    ],
)
def test_rates(text: str, amount: int, currency: str, unit: RateUnit) -> None:
    assert read_rate(text) == {"rate_minor": amount, "rate_currency": currency, "rate_unit": unit}


@pytest.mark.parametrize(
    ("field", "text"),
    [
        (RosterField.EMAIL, "none"),
        (RosterField.SERVICES, "juggles"),
        (RosterField.EXCLUSIVITY, "maybe"),
        (RosterField.WEEKLY_HOURS, "200"),
        (RosterField.RATE, "45"),  # without a currency and a unit it says nothing
        (RosterField.RATE, "cheap"),
        (RosterField.SPECIALITIES, "w" * 61),
        (RosterField.NOTES, "n" * 5_001),
    ],
)
def test_a_cell_that_cannot_be_read_says_what_was_wanted(field: RosterField, text: str) -> None:
    with pytest.raises(ValueError, match="wanted"):
        read_cell(field, text)


@pytest.mark.parametrize(
    ("second", "they_do"),
    [
        ((date(2026, 3, 1), date(2026, 3, 9)), False),
        ((date(2026, 3, 1), date(2026, 3, 10)), True),
        ((date(2026, 3, 12), date(2026, 3, 13)), True),
        ((date(2026, 3, 20), date(2026, 4, 1)), True),
        ((date(2026, 3, 21), date(2026, 4, 1)), False),
        ((None, date(2026, 3, 12)), False),
        ((date(2026, 3, 12), None), False),
    ],
)
def test_periods_overlap_where_they_share_a_day(second: tuple[date | None, date | None], they_do: bool) -> None:
    first = (date(2026, 3, 10), date(2026, 3, 20))
    assert overlap(first, second) is overlap(second, first) is they_do
