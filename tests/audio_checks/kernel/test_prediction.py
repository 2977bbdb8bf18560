"""What can and cannot be predicted from the samples around it, held to plain references."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from audio_checks import kernel
from tests.audio_checks.kernel.test_faults import REACH, stands_out, unforeseen


@pytest.mark.parametrize("frames", [400, 1_003])
@pytest.mark.parametrize("order", [1, 8, 20])
def test_what_cannot_be_predicted(frames: int, order: int):
    rng = np.random.default_rng(frames + order)
    times = np.arange(frames + order)
    row = np.sin(0.3 * times) + 0.5 * np.sin(1.1 * times) + 0.01 * rng.standard_normal(len(times))
    row[order + 200] += 5.0
    window = np.hanning(frames)
    faded = row[order:] * window
    products = np.array([faded[: frames - lag] @ faded[lag:] for lag in range(order + 1)])
    products[0] *= 1 + 1e-10
    lags = np.abs(np.subtract.outer(np.arange(order), np.arange(order)))
    coefficients = np.linalg.solve(products[lags], products[1:])
    rest = row[order:].copy()
    for place in range(order):
        rest -= coefficients[place] * row[order - 1 - place :][:frames]
    cells = frames // 24
    wanted = np.abs(rest[: cells * 24]).reshape(-1, 24).max(axis=1)
    inner = wanted[REACH:-REACH].tolist()
    found = unforeseen(row, window, order, cells)
    if found is None:
        assert not any(stands_out(inner, at) for at in range(len(inner)))
    else:
        np.testing.assert_allclose(found, wanted, rtol=1e-6)


SIZE, PLACE, SPAN, AROUND = 10, 3, 8, 12  # frames of a cell, and cells
MIDDLE = AROUND + PLACE + AROUND + 5


def both_ways(row: NDArray[np.float64], order: int, times_beside: float, times_around: float) -> bool:
    """Whether the place in the middle of a row is kept."""
    places, kept = np.array([MIDDLE * SIZE]), np.empty(1, np.int64)
    windows = np.hanning(SPAN * SIZE), np.hanning((PLACE + 2 * AROUND) * SIZE)
    return bool(
        kernel.unforeseen_both_ways(row, 1, places, *windows, order, SIZE, PLACE, times_beside, times_around, kept)
    )


def rests(row: NDArray[np.float64], first: int, end: int, order: int, weighed: slice) -> NDArray[np.float64]:
    """What cannot be predicted of frames, by the coefficients that fit some of them best."""
    faded = row[weighed] * np.hanning(weighed.stop - weighed.start)
    products = np.array([faded[: len(faded) - lag] @ faded[lag:] for lag in range(order + 1)])
    products[0] *= 1 + 1e-10
    lags = np.abs(np.subtract.outer(np.arange(order), np.arange(order)))
    coefficients = np.linalg.solve(products[lags], products[1:])
    return np.array([abs(row[at] - coefficients @ row[at - order : at][::-1]) for at in range(first, end)])


def how_hard_to_predict(row: NDArray[np.float64], order: int) -> tuple[float, float]:
    """How many times as badly the middle is predicted as the sound on either side (the lesser), or any place near."""
    start, end, span, length = MIDDLE * SIZE, (MIDDLE + PLACE) * SIZE, SPAN * SIZE, len(row)
    beside = []
    for turned, first in ((row, start), (row[::-1], length - end)):
        predicted = rests(turned, first - span + order, first + PLACE * SIZE, order, slice(first - span, first))
        beside.append(predicted[span - order :].max() / predicted[: span - order].max())
    around = slice(start - AROUND * SIZE, end + AROUND * SIZE)
    before = rests(row, around.start, around.stop, order, around)
    after = rests(
        row[::-1],
        length - around.stop,
        length - around.start,
        order,
        slice(length - around.stop, length - around.start),
    )[::-1]
    cells = [one.reshape(-1, SIZE).max(axis=1) for one in (before, after)]
    worst = [min(cell[at : at + PLACE].max() for cell in cells) for at in range(2 * AROUND + 1)]
    others = worst[: AROUND - PLACE] + worst[AROUND + PLACE + 1 :]
    return min(beside), worst[AROUND] / max(others)


@settings(max_examples=30)
@given(st.integers(0, 2**32 - 1), st.sampled_from([1, 8, 20]), st.sampled_from([0.0, 0.3, 4.0]), st.booleans())
def test_what_can_be_predicted_neither_way(seed: int, order: int, click: float, is_step: bool):
    rng = np.random.default_rng(seed)
    times = np.arange((2 * MIDDLE + PLACE) * SIZE)
    row = np.sin(rng.uniform(0.05, 1) * times) + 0.02 * rng.standard_normal(len(times))
    at = (MIDDLE + 1) * SIZE + 3
    row[at : None if is_step else at + 1] += click
    beside, around = how_hard_to_predict(row, order)
    assert both_ways(row, order, beside * 0.999, around * 0.999)
    assert not both_ways(row, order, beside * 1.001, around * 0.999)
    assert not both_ways(row, order, beside * 0.999, around * 1.001)


@settings(max_examples=30)
@given(st.integers(0, 2**32 - 1), st.sampled_from([2, 3, 5]), st.sampled_from([0.0, 0.3, 2.0]))
def test_what_is_thinned_is_predicted_as_the_sums(seed: int, thin: int, click: float):
    rng = np.random.default_rng(seed)
    row = np.sin(0.1 * np.arange((2 * MIDDLE + PLACE) * SIZE)) + 0.05 * rng.standard_normal((2 * MIDDLE + PLACE) * SIZE)
    row[(MIDDLE + 1) * SIZE] += click
    windows = np.hanning(SPAN * SIZE), np.hanning((PLACE + 2 * AROUND) * SIZE)
    limits = 20, SIZE, PLACE, 1.5, 1.1
    kept = np.empty(1, np.int64)
    spread = rng.dirichlet(np.ones(thin), len(row))  # thinned, it is the row again, but for rounding
    thick = (row[:, np.newaxis] * spread).ravel()
    found = kernel.unforeseen_both_ways(thick, thin, np.array([MIDDLE * SIZE * thin]), *windows, *limits, kept)
    assert found == kernel.unforeseen_both_ways(row, 1, np.array([MIDDLE * SIZE]), *windows, *limits, kept)


@pytest.mark.parametrize(
    ("at", "beside", "around", "order", "size", "place"),
    [
        (100, 40, 110, 20, 10, 4),  # an odd number of cells on both sides together
        (100, 45, 110, 20, 10, 3),  # half a cell
        (100, 30, 110, 30, 10, 3),  # no more frames than coefficients
        (100, 20, 110, 10, 10, 3),  # fewer than the place has
        (100, 50, 110, 20, 10, 3),  # more than around it
        (100, 40, 110, 65, 10, 3),
        (100, 40, 110, 0, 10, 3),
        (100, 40, 110, 20, 0, 3),
        (100, 40, 110, 20, 10, 0),
        (59, 40, 110, 20, 10, 3),  # one frame too few before it
        (211, 40, 110, 20, 10, 3),  # and after it
    ],
)
def test_places_that_do_not_fit(at: int, beside: int, around: int, order: int, size: int, place: int):
    windows, kept = (np.ones(beside), np.ones(around)), np.empty(1, np.int64)
    with pytest.raises(ValueError, match="wanted"):
        kernel.unforeseen_both_ways(np.zeros(300), 1, np.array([at]), *windows, order, size, place, 4.0, 1.3, kept)


@pytest.mark.parametrize("at", [60, 210])
def test_the_outermost_places_that_fit(at: int):
    windows, kept = (np.ones(40), np.ones(110)), np.empty(1, np.int64)
    assert kernel.unforeseen_both_ways(np.zeros(300), 1, np.array([at]), *windows, 20, 10, 3, 4.0, 1.3, kept) == 0


def test_silence_is_predicted():
    assert unforeseen(np.zeros(300), np.hanning(280), 20, 10) is None
