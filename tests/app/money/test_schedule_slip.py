"""Whole days late, and with whom they went."""

from datetime import UTC, date, datetime, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.money.schedule_slip import Holder, ScheduleSlip, Turn, growth_days, schedule_slip_of

DUE = date(2026, 11, 13)
MIDNIGHT = datetime(2026, 11, 14, tzinfo=UTC)  # the first moment that is late


def at(days: float) -> datetime:
    return MIDNIGHT + timedelta(days=days)


def test_four_days_late_one_with_the_designer_and_three_with_the_studio():
    turns = [Turn(at(-3), Holder.DESIGNER), Turn(at(1), Holder.STUDIO)]
    assert schedule_slip_of(DUE, None, [turns], at(3.999)) == ScheduleSlip(4, 1, 3)


def test_in_time_is_not_late():
    assert schedule_slip_of(DUE, at(-0.1), [[]], at(9)) == ScheduleSlip(0, 0, 0)
    assert schedule_slip_of(DUE, None, [[]], at(-5)) == ScheduleSlip(0, 0, 0)


def test_the_last_day_itself_is_in_time():
    assert schedule_slip_of(DUE, None, [[]], MIDNIGHT - timedelta(seconds=1)) == ScheduleSlip(0, 0, 0)


def test_nothing_delivered_lies_with_the_designer():
    assert schedule_slip_of(DUE, None, [[]], at(5.5)) == ScheduleSlip(6, 6, 0)


def test_as_long_as_one_cue_is_with_the_designer_the_day_is_the_designers():
    waits = [Turn(at(-3), Holder.STUDIO)]
    to_make = [Turn(at(-3), Holder.DESIGNER), Turn(at(2), Holder.STUDIO)]
    assert schedule_slip_of(DUE, None, [waits, to_make], at(4)) == ScheduleSlip(
        5, 3, 2
    )  # two days each, the odd one by the order


def test_acceptance_ends_it():
    assert schedule_slip_of(DUE, at(1.5), [[Turn(at(-1), Holder.STUDIO)]], at(30)) == ScheduleSlip(2, 0, 2)


@pytest.mark.slow
@given(
    st.lists(st.tuples(st.floats(-10, 10), st.sampled_from(Holder)), max_size=8),
    st.floats(0, 30),
)
def test_days_add_up(changes, now_days):
    turns = [Turn(at(days), holder) for days, holder in changes]
    slip = schedule_slip_of(DUE, None, [turns], at(now_days))
    assert slip.designer_days + slip.studio_days == slip.days
    assert slip.days >= 1


@pytest.mark.parametrize(
    ("slips", "growth"), [([0, 2, 4], 2.0), ([3, 3, 3], 0.0), ([5, 1], -4.0), ([1], None), ([], None)]
)
def test_growth(slips, growth):
    assert growth_days(slips) == (None if growth is None else pytest.approx(growth))
