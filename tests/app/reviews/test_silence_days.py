"""The days that a silent studio has, as plain rules: reminders, holidays, pauses and clocks that are turned."""

from datetime import UTC, date, datetime, time, timedelta
from typing import Any
from zoneinfo import ZoneInfo

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.clauses.deemed_acceptance import DeemedAcceptance, Pause, Wait, WorkCalendar
from tests.app.reviews.test_silence import FRIDAY, days


@pytest.mark.parametrize(
    ("since", "last_day"),
    [
        (FRIDAY, "2026-12-04"),  # Monday to Friday, twice
        (FRIDAY + days(1), "2026-12-04"),  # what comes on a weekend waits from Monday
        (FRIDAY + days(2), "2026-12-04"),
        (FRIDAY + days(3), "2026-12-07"),  # Tuesday is the first day
        (datetime.fromisoformat("2026-11-20T23:30:00-02:00"), "2026-12-04"),  # Saturday by UTC
    ],
)
def test_ten_working_days_are_two_weeks(since: datetime, last_day: str) -> None:
    wait = Wait(DeemedAcceptance(days=10, reminder_days=3), since)
    assert wait.last_day(since).isoformat() == last_day
    midnight = datetime.fromisoformat(f"{last_day}T00:00:00+00:00") + days(1)
    assert not wait.is_over(midnight - timedelta(microseconds=1))
    assert wait.is_over(midnight)


def test_reminders_come_on_every_third_working_day_before_the_last() -> None:
    wait = Wait(DeemedAcceptance(days=10, reminder_days=3), FRIDAY)
    counted = [wait.reminders(FRIDAY + days(day)) for day in range(16)]
    #                  fr sa su mo tu we th fr sa su mo tu we th fr sa
    assert counted == [0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 3, 3, 3]
    assert Wait(DeemedAcceptance(days=6, reminder_days=3), FRIDAY).reminders(FRIDAY + days(60)) == 1


BERLIN = ZoneInfo("Europe/Berlin")


def wait_of(*pauses: Pause, holidays: tuple[str, ...] = (), since: datetime = FRIDAY, zone: Any = BERLIN) -> Wait:
    entered_at = FRIDAY - days(30)
    calendar = WorkCalendar(zone, {date.fromisoformat(day): entered_at for day in holidays})
    return Wait(DeemedAcceptance(days=10, reminder_days=3, by_studio_calendar=True), since, calendar, pauses)


def at(moment: str) -> datetime:
    return datetime.fromisoformat(moment)


@pytest.mark.parametrize(
    ("wait", "now", "last_day"),
    [
        (wait_of(), FRIDAY, "2026-12-04"),
        (wait_of(holidays=("2026-11-26", "2026-11-27")), FRIDAY, "2026-12-08"),
        (wait_of(holidays=("2026-11-28",)), FRIDAY, "2026-12-04"),  # a Saturday
        (wait_of(since=at("2026-11-20T23:30:00+00:00")), FRIDAY, "2026-12-04"),  # Saturday in Berlin
        (wait_of(since=at("2026-11-22T23:30:00+00:00")), FRIDAY, "2026-12-07"),  # Monday in Berlin does not count then
        # Open from Tuesday afternoon to Thursday morning: three days do not count.
        (
            wait_of(Pause("question", at("2026-11-24T15:00+01:00"), at("2026-11-26T09:00+01:00"))),
            FRIDAY + days(9),
            "2026-12-09",
        ),
        # Two that overlap are counted once, and one over a weekend costs its two working days.
        (
            wait_of(
                Pause("question", at("2026-11-24T15:00+01:00"), at("2026-11-24T16:00+01:00")),
                Pause("change_order", at("2026-11-24T10:00+01:00"), at("2026-11-24T18:00+01:00")),
            ),
            FRIDAY + days(9),
            "2026-12-07",
        ),
        (
            wait_of(Pause("question", at("2026-11-27T15:00+01:00"), at("2026-11-30T09:00+01:00"))),
            FRIDAY + days(12),
            "2026-12-08",
        ),
        # Before the cue began to wait, and on its very day, nothing is stopped.
        (wait_of(Pause("question", FRIDAY - days(9), FRIDAY + timedelta(hours=1))), FRIDAY + days(9), "2026-12-04"),
        # Still open on Wednesday: Tuesday and Wednesday do not count, and the day moves on while it is open.
        (wait_of(Pause("question", at("2026-11-24T15:00+01:00"))), at("2026-11-25T12:00+01:00"), "2026-12-08"),
        (wait_of(Pause("question", at("2026-11-24T15:00+01:00"))), at("2026-12-25T12:00+01:00"), "2027-01-07"),
    ],
)
def test_days_that_count_by_the_studio_s_calendar(wait: Wait, now: datetime, last_day: str) -> None:
    assert wait.last_day(now).isoformat() == last_day


def test_while_something_is_open_nothing_is_accepted_however_long() -> None:
    wait = wait_of(Pause("question", at("2026-12-04T15:00+01:00")))
    assert not wait.is_over(FRIDAY + days(400))
    answered = wait_of(Pause("question", at("2026-12-04T15:00+01:00"), at("2026-12-07T09:00+01:00")))
    assert answered.last_day(FRIDAY + days(30)).isoformat() == "2026-12-08"
    assert not answered.is_over(at("2026-12-08T23:59:59+01:00"))
    assert answered.is_over(at("2026-12-09T00:00+01:00")), "midnight in the studio's zone"


def test_a_holiday_that_is_entered_while_a_cue_waits_does_not_delay_it() -> None:
    calendar = WorkCalendar(BERLIN, {date(2026, 11, 25): FRIDAY + days(1), date(2026, 11, 26): FRIDAY - days(1)})
    wait = Wait(DeemedAcceptance(days=10, reminder_days=3, by_studio_calendar=True), FRIDAY, calendar)
    assert wait.last_day(FRIDAY).isoformat() == "2026-12-07"


def test_days_and_hours_that_the_clocks_are_turned_are_days_like_others() -> None:
    # On 29 March 2026 Berlin's day has 23 hours, on 25 October 25.
    for since, last_day in ((at("2026-03-27T12:00+01:00"), "2026-04-10"), (at("2026-10-23T12:00+02:00"), "2026-11-06")):
        wait = wait_of(since=since)
        assert wait.last_day(since).isoformat() == last_day
        ends = datetime.combine(date.fromisoformat(last_day) + days(1), time(), BERLIN)
        assert (wait.is_over(ends - timedelta(seconds=1)), wait.is_over(ends)) == (False, True)


@pytest.mark.slow
@given(
    began=st.lists(st.tuples(st.integers(0, 600), st.integers(0, 200)), max_size=6),
    holidays=st.sets(st.integers(0, 60), max_size=10),
    needed=st.integers(2, 15),
)
def test_the_last_day_is_the_one_that_a_plain_count_gives(
    began: list[tuple[int, int]], holidays: set[int], needed: int
) -> None:
    pauses = [(FRIDAY + timedelta(hours=start), FRIDAY + timedelta(hours=start + lasts)) for start, lasts in began]
    off = {(FRIDAY + days(number)).date() for number in holidays}
    day, counted = FRIDAY.date(), 0
    while counted < needed:
        day += days(1)
        hours = [datetime.combine(day, time(), UTC) + timedelta(minutes=minute) for minute in range(0, 1_440, 20)]
        is_open = any(start <= hour <= end for start, end in pauses for hour in hours)
        counted += day.weekday() < 5 and day not in off and not is_open
    clause = DeemedAcceptance(days=needed, reminder_days=1, by_studio_calendar=True)
    calendar = WorkCalendar(UTC, dict.fromkeys(off, FRIDAY - days(1)))
    wait = Wait(clause, FRIDAY, calendar, tuple(Pause("question", start, end) for start, end in pauses))
    now = FRIDAY + days(300)
    assert wait.last_day(now) == day
    assert wait.reminders(now) == needed - 1
