"""Error rates, their spread and the dates they forecast, against sums done by hand."""

from datetime import date, timedelta

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.money.estimates.rules import Habit, error_percent, error_rate, forecast, minor_per_hour

BEGAN, DUE = date(2027, 3, 1), date(2027, 3, 11)


def test_an_error_in_percent():
    assert error_percent(2.0, 3.0) == 50
    assert error_percent(4.0, 3.0) == -25


@pytest.mark.parametrize(("minutes", "minor"), [(0, None), (60, 10_000), (90, 6_667), (120, 5_000), (1, 600_000)])
def test_an_hour_earns_the_fee_divided_by_the_hours(minutes: int, minor: int | None):
    assert minor_per_hour(10_000, minutes) == minor


def test_mean_and_spread():
    rate = error_rate([(10, 12), (10, 14), (10, 13)])  # 20, 40 and 30 %
    assert rate.mean_percent == pytest.approx(30)
    assert rate.spread_points == pytest.approx((200 / 3) ** 0.5)
    assert rate.habit is Habit.STEADY


def test_a_steady_rate_forecasts_the_date():
    rate = error_rate([(10, 12), (10, 14), (10, 13)])
    assert forecast(BEGAN, DUE, rate) == date(2027, 3, 14)  # ten days become thirteen


def test_a_forecast_is_exact_to_the_day():
    rate = error_rate([(10, 12), (10, 14), (10, 13)])
    assert forecast(BEGAN, BEGAN + timedelta(days=1000), rate) == BEGAN + timedelta(days=1300)
    assert forecast(BEGAN, BEGAN + timedelta(days=1001), rate) == BEGAN + timedelta(days=1302)  # 1301.3, rounded up


def test_a_wild_rate_forecasts_nothing():
    rate = error_rate([(10, 5), (10, 20), (10, 11)])
    assert rate.habit is Habit.UNRELIABLE
    assert forecast(BEGAN, DUE, rate) is None


def test_too_few_pairs_say_nothing():
    assert error_rate([]).habit is Habit.UNKNOWN
    rate = error_rate([(10, 13), (10, 13)])
    assert rate.habit is Habit.UNKNOWN
    assert forecast(BEGAN, DUE, rate) is None


def test_no_estimate_has_no_rate():
    with pytest.raises(ValueError, match="no error rate"):
        error_percent(0, 3)


@given(st.floats(0.1, 1e4), st.floats(0.1, 10), st.integers(3, 20))
def test_who_is_always_off_by_the_same_factor_is_steady(estimate, factor, pairs):
    rate = error_rate([(estimate * (1 + place), estimate * (1 + place) * factor) for place in range(pairs)])
    assert rate.habit is Habit.STEADY
    assert rate.mean_percent == pytest.approx(100 * (factor - 1), abs=1e-6)
