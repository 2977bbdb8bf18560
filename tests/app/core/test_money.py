"""Sums in minor units: written as contracts write them, parted with one rounding."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.core.money import money, part_of, percent


@pytest.mark.parametrize(
    ("amount_minor", "currency", "written"),
    [
        (720_000, "USD", "USD 7,200.00"),
        (5, "EUR", "EUR 0.05"),
        (-15_750, "USD", "−USD 157.50"),
        (0, "USD", "USD 0.00"),
        (7_200, "JPY", "JPY 7,200"),
        (1_234_567, "KWD", "KWD 1,234.567"),
    ],
)
def test_amounts_are_written_with_their_currency(amount_minor: int, currency: str, written: str):
    assert money(amount_minor, currency) == written


@pytest.mark.parametrize(
    ("basis_points", "written"), [(2500, "25 %"), (1250, "12.5 %"), (5, "0.05 %"), (0, "0 %"), (10_000, "100 %")]
)
def test_parts_are_written_as_percent(basis_points: int, written: str):
    assert percent(basis_points) == written


def test_the_figures_of_the_demo():
    assert part_of(31_500, 5000) == 15_750  # a cue of 315.00 cut in work
    assert part_of(31_500, 2500) == 7_875  # its third round of two
    assert part_of(720_000, 2000) == 144_000  # the deposit


@pytest.mark.parametrize(("amount_minor", "half"), [(1, 1), (3, 2), (-1, -1), (-3, -2), (2, 1)])
def test_a_half_goes_away_from_zero(amount_minor: int, half: int):
    assert part_of(amount_minor, 5000) == half


@given(st.integers(-(10**15), 10**15), st.integers(0, 10_000))
def test_a_part_is_the_nearest_whole_unit(amount_minor: int, basis_points: int):
    part = part_of(amount_minor, basis_points)
    assert abs(Fraction(amount_minor * basis_points, 10_000) - part) <= Fraction(1, 2)
    assert part == -part_of(-amount_minor, basis_points)
