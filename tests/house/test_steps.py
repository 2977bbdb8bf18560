"""A test of what something costs counts lines, which is right only if each turn of a loop counts."""

import sys

import pytest

from tests.support.steps import TooManySteps, at_most


def turn(times: int) -> None:
    for _ in range(times):
        pass


def test_each_turn_of_a_loop_counts():
    with at_most(10_000) as few:
        turn(10)
    with at_most(10_000) as many:
        turn(1_010)
    assert many.taken - few.taken >= 1_000


def test_what_takes_more_is_ended_and_the_tracer_of_before_is_back():
    before = sys.gettrace()
    with pytest.raises(TooManySteps, match=r"more than 1,000 lines"), at_most(1_000):
        turn(1 << 60)
    assert sys.gettrace() is before
