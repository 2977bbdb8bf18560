"""Splitting an amount, against the definition of the largest remainder."""

import itertools
from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.errors import NothingToSplit
from app.agreements.plan.amounts import split

AMOUNTS = st.integers(0, 10**12)


@pytest.mark.slow
@given(AMOUNTS, st.lists(st.integers(0, 10**9), min_size=1, max_size=40))
def test_parts_add_up_and_none_is_a_cent_off(amount, weights):
    parts = split(amount, weights)
    assert sum(parts) == amount
    shown = weights if any(weights) else [1] * len(weights)
    for part, weight in zip(parts, shown, strict=True):
        assert abs(part - Fraction(amount * weight, sum(shown))) < 1


@pytest.mark.slow
@given(AMOUNTS, st.lists(st.integers(0, 10**9), min_size=2, max_size=40))
def test_more_weight_never_gets_less(amount, weights):
    pairs = sorted(zip(weights, split(amount, weights), strict=True))
    assert all(a[1] <= b[1] for a, b in itertools.pairwise(pairs) if a[0] < b[0])


def test_the_largest_remainder_gets_the_cent():
    assert split(100, [1, 1, 1]) == [34, 33, 33]
    assert split(10, [3, 3, 1]) == [4, 4, 2]  # 4.29, 4.29, 1.43
    assert split(10_001, [0, 0]) == [5_001, 5_000]


def test_no_cues_share_nothing():
    with pytest.raises(NothingToSplit, match="over no cues"):
        split(100, [])


@pytest.mark.parametrize(("amount", "weights"), [(-1, [1]), (100, [2, -1])])
def test_amounts_and_weights_below_zero_are_refused(amount, weights):
    with pytest.raises(ValueError, match="zero or more"):
        split(amount, weights)
