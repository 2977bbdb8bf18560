"""Gains planted in the projects that were kept apart from the readers, and what their sounds depend on."""

import pytest

from benchmarks.audits.apart import APART
from benchmarks.audits.levels import Count, apart, undeclared


@pytest.mark.parametrize("engine", APART)
def test_each_planted_gain_is_found_and_no_other(engine: str) -> None:
    count = Count()
    apart(engine, count)
    assert (count.wrong, count.missed, count.false) == ([], 0, 0)
    assert count.right == count.files == sum(map(len, APART[engine].moved.values())) > 20


@pytest.mark.parametrize("engine", APART)
def test_what_else_changes_a_level_is_said(engine: str) -> None:
    assert undeclared(engine) == []
