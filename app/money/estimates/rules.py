"""Estimates against actual values: an error rate, its spread, and the date that follows."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import date, timedelta
from enum import StrEnum

ENOUGH = 3  # fewer pairs say nothing about a habit
STEADY_POINTS = 20.0  # spread in percentage points up to which a rate forecasts


class Habit(StrEnum):
    """The trustworthiness of a person's estimates once corrected by their error rate."""

    UNKNOWN = "unknown"
    STEADY = "steady"
    UNRELIABLE = "wild"


@dataclass(frozen=True)
class ErrorRate:
    """The percentage by which actuals exceed estimates, and its variation; None for too few pairs."""

    pairs: int
    mean_percent: float | None
    spread_points: float | None

    @property
    def habit(self) -> Habit:
        """Return the usefulness of the rate."""
        if self.spread_points is None or self.pairs < ENOUGH:
            return Habit.UNKNOWN
        return Habit.STEADY if self.spread_points <= STEADY_POINTS else Habit.UNRELIABLE


def error_percent(estimate: float, actual: float) -> float:
    """Return the percentage by which an actual exceeds its estimate; below zero it took less."""
    if estimate <= 0:
        raise ValueError(f"an estimate of {estimate} has no error rate")
    return 100 * (actual - estimate) / estimate


def error_rate(pairs: Sequence[tuple[float, float]]) -> ErrorRate:
    """Return the mean error of (estimate, actual) pairs and its standard deviation over the pairs."""
    if not pairs:
        return ErrorRate(0, None, None)
    errors = [error_percent(estimate, actual) for estimate, actual in pairs]
    mean = math.fsum(errors) / len(errors)
    spread = math.sqrt(math.fsum((error - mean) ** 2 for error in errors) / len(errors))
    return ErrorRate(len(errors), mean, spread)


def forecast(began_on: date, due_on: date, rate: ErrorRate) -> date | None:
    """Return the day that a steady error rate makes of an estimated one; None where no rate is steady."""
    if rate.habit is not Habit.STEADY or rate.mean_percent is None:
        return None
    days = (due_on - began_on).days
    return began_on + timedelta(days=math.ceil(days * (1 + rate.mean_percent / 100) - 1e-9))


def minor_per_hour(fee_minor: int, minutes: int) -> int | None:
    """Return the earnings of an hour, rounded to the nearest minor unit; None without time."""
    return (2 * 60 * fee_minor + minutes) // (2 * minutes) if minutes else None
