"""Runs of low figures, and lulls, against plain references."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from audio_checks import kernel


def runs_of(low: NDArray[np.bool_]) -> list[tuple[int, int]]:
    """Where each run of True starts, and where it has ended."""
    turns = np.flatnonzero(np.diff(np.concatenate(([False], low, [False])).astype(np.int8))).tolist()
    return list(zip(turns[::2], turns[1::2], strict=True))


@pytest.mark.slow
@given(
    st.lists(st.sampled_from([0.0, 1e-4, 0.5]), max_size=80),
    st.sampled_from([0.0, 1e-4]),
    st.sampled_from([0.0, 0.2]),
    st.tuples(st.integers(0, 3), st.integers(1, 6), st.integers(-2, 8), st.integers(-2, 12), st.integers(-2, 81)),
)
@example([0.0, 1.0, 0.0, 0.0, 1.0, 0.0], 0.0, 0.0, (1, 2, 2, 0, 6))  # that starts there is too early
@example([0.0, 1.0, 0.0, 0.0, 1.0, 0.0], 0.0, 0.0, (1, 2, -1, 1, 4))  # that ends there is known
@example([0.0, 1.0, 0.0, 0.0, 1.0, 0.0], 0.0, 0.0, (2, 2, -1, 0, 4))
@example([0.0, 1.0, 0.0, 0.0, 1.0, 0.0], 0.0, 0.0, (1, 1, -1, 0, 3))
@example([1.0] * 50 + [0.0], 0.0, 0.0, (1, 1, -1, 0, 51))  # the last of many
def test_runs_of_low_figures(figures: list[float], low: float, beside: float, bounds: tuple[int, ...]):
    shortest, longest, starts_after, ends_after, ends_by = bounds
    row, out = np.array(figures), np.empty((len(figures) // 2 + 1, 2), np.int64)
    found = kernel.low_runs(row, low, beside, shortest, longest, starts_after, ends_after, ends_by, out)
    assert [tuple(run) for run in out[:found].tolist()] == [
        (start, end)
        for start, end in runs_of(row <= low)
        if shortest <= end - start <= longest and start > starts_after and ends_after < end <= ends_by
        if min(row[max(start - 2, 0) : start].max(initial=0), row[end : end + 2].max(initial=0)) >= beside
    ]


def test_no_more_runs_are_reported_than_there_is_room_for():
    row, out = np.array([0.0, 1.0, 0.0, 1.0, 0.0]), np.empty((2, 2), np.int64)
    assert kernel.low_runs(row, 0.0, 0.0, 1, 9, -1, 0, 9, out) == 2


DEEP, LEVEL, LONGEST = 200.0, 2.0, 30


def lulls(squares: NDArray[np.float64]) -> list[tuple[int, int]]:
    out = np.empty((len(squares) // 2 + 1, 2), np.int64)
    found = kernel.lulls(squares, DEEP, LEVEL, LONGEST, -1, 0, len(squares), out)
    return [(start, end) for start, end in out[:found].tolist()]


@pytest.mark.parametrize("at", range(10, 27))  # of many cells that are passed over together, each
@pytest.mark.parametrize("length", [3, 4, 29])
def test_a_lull_is_found_where_it_is(at, length):
    squares = np.ones(80)
    squares[at : at + length] = 1e-3
    assert lulls(squares) == [(at, at + length)]


@pytest.mark.parametrize(
    "inside",
    [
        [1e-3] * 2,
        [1e-3] * 31,
        [1e-2] * 5,  # no more than 20 dB down
        [1e-3, 1e-3, 4.9e-3, 1e-3, 1e-3, 1e-3],  # not level
        [0.0] * 5,  # nothing at all; such holes stand still
    ],
)
def test_what_is_short_long_shallow_uneven_or_empty_is_no_lull(inside):
    assert lulls(np.array([1.0] * 20 + inside + [1.0] * 20)) == []


def test_outermost_cells_may_hold_some_of_the_sound():
    squares = np.array([1.0] * 20 + [0.3, 8e-3] + [1e-3] * 5 + [8e-3, 0.3] + [1.0] * 20)
    assert lulls(squares) == [(21, 28)]


def test_a_sound_that_comes_back_slowly_makes_no_lull():
    assert lulls(np.array([1.0] * 20 + [1e-3] * 8 + [0.05] * 5 + [1.0] * 20)) == []


def test_lulls_lie_where_they_are_wanted():
    squares, out = np.ones(60), np.empty((9, 2), np.int64)
    squares[20:25] = squares[40:45] = 1e-3
    assert kernel.lulls(squares, DEEP, LEVEL, LONGEST, 20, 0, 60, out) == 1
    assert kernel.lulls(squares, DEEP, LEVEL, LONGEST, -1, 25, 60, out) == 1
    assert kernel.lulls(squares, DEEP, LEVEL, LONGEST, -1, 0, 44, out) == 1
    assert kernel.lulls(squares, DEEP, LEVEL, LONGEST, -1, 0, 60, out[:1]) == 1
    assert kernel.lulls(squares[:4], DEEP, LEVEL, LONGEST, -1, 0, 4, out) == 0
