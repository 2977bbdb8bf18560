"""Cells, crests, repeats, bursts and what stands out, held to plain references."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.maxima import maxima_of
from tests.audio_checks.kernel.signals import Samples, signals

HISTORY = 6


@pytest.mark.slow
@given(signals(), st.integers(1, 50))
def test_cells_of_any_size(samples: Samples, size: int):
    channels = samples.shape[1]
    rows = np.concatenate((np.zeros((channels, HISTORY)), samples.T), axis=1)
    count = len(samples) // size
    figures = np.empty((5 * channels, count))
    kernel.cells(rows, HISTORY, size, figures)
    sums, squares, steps, sharpness, edges = figures.reshape(5, channels, count)
    used = HISTORY + count * size
    shape = (channels, count, size)
    whole = rows[:, HISTORY:used].reshape(shape)
    sixth = np.diff(rows[:, :used], n=6, axis=1).reshape(shape)
    loudest = np.abs(samples).max(initial=0)
    np.testing.assert_allclose(sums, whole.sum(axis=2), rtol=1e-9, atol=1e-12 * (1 + loudest))
    np.testing.assert_allclose(squares, np.square(whole).sum(axis=2), rtol=1e-12, atol=1e-300)
    np.testing.assert_array_equal(
        steps, np.abs(np.diff(rows[:, HISTORY - 1 : used], axis=1)).reshape(shape).max(axis=2)
    )
    np.testing.assert_allclose(sharpness, np.abs(sixth).max(axis=2), rtol=1e-9, atol=1e-12 * (1 + loudest))
    np.testing.assert_allclose(edges, np.square(sixth).sum(axis=2), rtol=1e-6, atol=1e-12 * (1 + loudest**2))


def crests_of(row: NDArray[np.float64], first: int, shape: list[float]) -> list[list[float]]:
    """The same, sample by sample."""
    sign, floor, least, rail, grain, share, flat, wide = shape
    wave = sign * row
    found, start = [], None
    for at, high in enumerate([*(wave >= floor), False]):
        if high and start is None:
            start = at
        elif not high and start is not None:
            top = wave[start:at].max()
            if first <= at < len(row) and top >= least:
                found.append(crest(wave, start, at, top, rail, max(grain, share * top), flat, wide))
            start = None
    return found


def crest(wave, start, end, top, rail, grain, flat, wide) -> list[float]:
    run, place = longest(wave, start, end, top - grain)
    soft, left = longest(wave, start, end, top * flat)
    right = left + soft
    while left > start and wave[left - 1] >= top * wide:
        left -= 1
    while right < end and wave[right] >= top * wide:
        right += 1
    width = right - left
    while left > 0 and wave[left - 1] > 0:
        left -= 1
    while right < len(wave) and wave[right] > 0:
        right += 1
    before = wave[place - 2] if place >= 2 else 0
    after = wave[place + run + 1] if place + run + 1 < len(wave) else 0
    at_rail, _ = longest(wave, start, end, rail)
    return [place, top, run, top - max(before, after), soft, width, at_rail, right - left]


def longest(wave, start, end, level) -> tuple[int, int]:
    best, place, run = 0, start, 0
    for at in range(start, end):
        run = run + 1 if wave[at] >= level else 0
        if run > best:
            best, place = run, at - run + 1
    return best, place


@pytest.mark.slow
@given(signals(most_channels=1), st.integers(0, 300), st.sampled_from([1.0, -1.0]), st.sampled_from([0.0, 0.01, 0.5]))
def test_crests(samples: Samples, first: int, sign: float, grain: float):
    row = np.ascontiguousarray(np.repeat(samples[:, 0], 2))  # so that some have flat tops
    extreme = float((sign * row).max(initial=0))
    shape = [sign, 0.5 * extreme, 0.6 * extreme, 0.9 * extreme, grain * extreme, 1e-4, 0.98, 0.8]
    first = min(first, len(row))
    out = np.empty((len(row) + 1, 8))
    if extreme:
        count = kernel.crests(row, maxima_of(row[np.newaxis])[0], first, np.array(shape), out)
        assert out[:count].tolist() == crests_of(row, first, shape)


@pytest.mark.parametrize("row", [0, 1, 63, 64, 65, 127, 128, 191, 192, 199])
@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_crest_after_many_rows_without_one(row: int, sign: float):
    signal = np.random.default_rng(row).uniform(-0.1, 0.1, 200 * 32)
    signal[row * 32 + 9 : row * 32 + 12] = sign * np.array([0.7, 0.9, 0.8])
    maxima, shape = maxima_of(signal[np.newaxis])[0], [sign, 0.5, 0.9, 0.95, 0.0, 1e-4, 0.98, 0.8]
    for first in (0, 32, 5_000):
        out = np.empty((4, 8))
        count = kernel.crests(signal, maxima, first, np.array(shape), out)
        assert out[:count].tolist() == crests_of(signal, first, shape)
        assert count == (row * 32 >= first)
    known = np.array([0.2, 0.2])
    kernel.extremes(signal, maxima, 0, known)
    assert known.tolist() == ([0.9, 0.2] if sign > 0 else [0.2, 0.9])


@pytest.mark.slow
@given(signals(most_channels=1), st.integers(0, 5), st.floats(0, 2), st.floats(0, 2))
def test_extremes_of_rows_that_may_hold_them(samples: Samples, row: int, high: float, deep: float):
    signal, known = np.ascontiguousarray(samples[:, 0]), np.array([high, deep])
    kernel.extremes(signal, maxima_of(signal[np.newaxis])[0], row, known)
    rest = signal[row * 32 :]
    assert known.tolist() == [max(high, rest.max(initial=0.0)), max(deep, -rest.min(initial=0.0))]


@pytest.mark.parametrize("times", [1, 2, 4])
def test_a_stretch_that_comes_again_is_found_to_the_frame(times: int):
    found = 0
    for lag in range(64, 464):
        rng = np.random.default_rng(lag)
        before, stretch, after = (rng.standard_normal(count) for count in (500, lag, 700))
        row = np.concatenate((before, np.tile(stretch, times + 1), after))
        out = np.empty((8, 3), np.int64)
        count = kernel.recurrences(row, 0, 1e-3, 60, 500, 4.5, 1, out)
        assert out[:count].tolist() in ([[500 + lag, 500 + lag * (times + 1), lag]], [])
        found += count
    assert found >= 395  # one word in 16 is looked up: of the shortest stretches, one in 40 has none


@pytest.mark.parametrize("buffers", [2, 3, 4])
def test_an_older_buffer_of_a_ring_is_found_to_the_frame(buffers: int):
    found = 0
    for length in range(120, 500, 4):
        row = np.random.default_rng(length).standard_normal(3_000)
        row[2_200 : 2_200 + length] = row[2_200 - buffers * length : 2_200 - (buffers - 1) * length]
        out = np.empty((8, 3), np.int64)
        count = kernel.recurrences(row, 0, 1e-3, 60, 500, 4.5, buffers, out)
        assert out[:count].tolist() in ([[2_200, 2_200 + length, buffers * length]], [])
        assert kernel.recurrences(row, 0, 1e-3, 60, 500, 4.5, buffers - 1, out) == 0
        found += count
    assert found >= 92  # of 95: of the shortest stretches some have no word that is looked up


@pytest.mark.parametrize("beside", [-3, -1, 5])
def test_a_stretch_that_comes_again_elsewhere_is_no_older_buffer(beside: int):
    row = np.random.default_rng(1).standard_normal(3_000)
    row[2_000:2_300] = row[1_400 + beside : 1_700 + beside]
    assert kernel.recurrences(row, 0, 1e-3, 60, 500, 4.5, 4, np.empty((8, 3), np.int64)) == 0


@pytest.mark.slow
@given(signals(most_channels=1), st.integers(0, 2**32 - 1))
def test_what_is_reported_did_come_twice(samples: Samples, seed: int):
    rng = np.random.default_rng(seed)
    row = np.ascontiguousarray(np.tile(samples[:, 0], 3))
    if len(row):
        row[rng.integers(0, len(row), 3)] += 1.0
    out = np.empty((50, 3), np.int64)
    for start, end, lag in out[: kernel.recurrences(row, 0, 1e-3, 40, 800, 4.5, 1, out)].tolist():
        assert 40 <= lag <= 800
        assert lag <= end - start <= 4.5 * lag + 1
        np.testing.assert_array_equal(row[start:end], row[start - lag : end - lag])
        assert row[end] != row[end - lag]
        assert start == lag or row[start - 1] != row[start - 1 - lag]


REACH, CORE, TIMES = 3, 1, 3.5


def unforeseen(row: NDArray[np.float64], window: NDArray[np.float64], order: int, cells: int, least: float = 0.0):
    """The heights of one stretch that starts at `order`; None where nothing may stand out."""
    heights, kept = np.empty((1, cells)), np.empty(1, np.int64)
    starts = np.array([order])
    found = kernel.unforeseen(row, starts, window, order, 24, REACH, CORE, TIMES, least, heights, kept)
    return heights[0] if found else None


def stands_out(heights: list[float], at: int, reach: int = REACH, times: float = TIMES) -> bool:
    """Whether one is so many times those around it."""
    return heights[at] > times * highest_beside(heights, at, reach)


def highest_beside(heights: list[float], at: int, reach: int) -> float:
    """The highest around one, of the nearest two the lower."""
    beside = [heights[near] if 0 <= near < len(heights) else 0.0 for near in (at - 1, at + 1)]
    far = [*heights[max(at - reach, 0) : max(at - CORE, 0)], *heights[at + CORE + 1 : at + reach + 1]]
    return max([min(beside), *far])


@pytest.mark.slow
@given(
    st.lists(st.sampled_from([0.1, 0.2, 1.0, 1.1, 4.0, 5.0]), min_size=15, max_size=40),
    st.sampled_from([3, 7]),
)
def test_what_stands_out(heights: list[float], reach: int):
    assert outstanding(heights, reach) == all_that_stand_out(heights, reach)


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1), st.sampled_from([4, 7, 40]))
def test_what_stands_out_of_many(seed: int, reach: int):
    # Sixty-four at a time are compared with their nearest before one is compared with all.
    rng = np.random.default_rng(seed)
    heights = rng.uniform(0.5, 1.0, 400)
    heights[rng.integers(0, 400, 30)] = rng.choice([3.49, 3.5, 3.51, 9.0], 30)
    assert outstanding(heights.tolist(), reach) == all_that_stand_out(heights.tolist(), reach)


def outstanding(heights: list[float], reach: int, least: float = 0.15) -> list[int]:
    """The places alone, of a sound as loud throughout."""
    even, out = np.ones(len(heights)), np.empty((len(heights), 5))
    rows, firsts = np.array([heights]), np.zeros(1, np.int64)
    found = kernel.outstanding_amid(rows, firsts, TIMES, reach, CORE, least, 0.0, even, even, 2, 0.0, 30.0, out)
    return [int(place) for place in out[:found, 1]]


def all_that_stand_out(heights: list[float], reach: int) -> list[int]:
    inner = range(reach, len(heights) - reach)
    return [at for at in inner if heights[at] > 0.15 and stands_out(heights, at, reach)]


@given(st.integers(0, 2**32 - 1), st.sampled_from([0.0, 0.5, 3.0]))
def test_a_stretch_that_is_passed_over_has_nothing_that_stands_out(seed: int, click: float):
    # The bound: what stands out of all cells stands out of the inner ones, which are looked at first.
    rng = np.random.default_rng(seed)
    row = np.convolve(rng.standard_normal(520), np.hanning(rng.integers(1, 9) + 2), "same")
    row[rng.integers(20, 500)] += click
    all_inner = np.empty((1, 20))
    kernel.unforeseen(
        row, np.array([20]), np.hanning(480), 20, 24, 0, CORE, 0.0, -1.0, all_inner, np.empty(1, np.int64)
    )  # a reach of 0: all cells, and each stands out of nothing
    found = unforeseen(row, np.hanning(480), 20, 20, least=0.01)
    if outstanding(all_inner[0].tolist(), REACH, 0.01):
        assert found is not None
    if found is not None:
        np.testing.assert_array_equal(found, all_inner[0])


WITHIN, COMPARED, LEVEL = 4, 14, 9


def bursts(heights: NDArray[np.float64], squares: NDArray[np.float64], edges: NDArray[np.float64]) -> list[list[float]]:
    """Places, and the power beside each."""
    places, powers = np.empty(50, np.int64), np.empty(50)
    limits = 3.0, 0.2, 0.5, 4.0, 2.0
    found = kernel.bursts(heights, squares, edges, WITHIN, COMPARED, LEVEL, *limits, places, powers)
    return np.stack((places[:found], powers[:found]), axis=1).tolist()


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1))
def test_bursts(seed: int):
    rng = np.random.default_rng(seed)
    heights = rng.uniform(0.1, 0.3, 300)
    for at in rng.integers(0, 300, 12):
        heights[at : at + int(rng.integers(1, 6))] = rng.uniform(0.8, 2.0)
    heights += rng.uniform(0, 1e-6, 300)  # no two are alike
    squares, edges = np.sort(rng.uniform(0.3, 5.0, 300)), rng.uniform(0.5, 1.5, 300)
    wanted = []
    for at in range(COMPARED, 300 - COMPARED):
        far = np.r_[at - COMPARED : at - WITHIN, at + WITHIN + 1 : at + COMPARED + 1]
        if heights[at] < heights[at - WITHIN : at + WITHIN + 1].max() or heights[at] <= 3.0 * heights[far].max():
            continue
        lower, higher = zip(*(sorted(sides_beyond(powers, at)) for powers in (squares, edges)), strict=True)
        if lower[0] >= 0.5 and higher[0] <= 4.0 * lower[0] and higher[1] <= 2.0 * lower[1]:
            wanted.append([at, lower[0]])
    found = bursts(heights, squares, edges)
    np.testing.assert_allclose(np.reshape(found, (-1, 2)), np.reshape(wanted, (-1, 2)), rtol=1e-12)


def sides_beyond(powers: NDArray[np.float64], at: int) -> tuple[float, float]:
    return float(powers[at - LEVEL : at - WITHIN].mean()), float(powers[at + WITHIN + 1 : at + LEVEL + 1].mean())


def test_a_burst_among_even_cells_and_none_near_an_end():
    heights, even = np.full(100, 0.2), np.ones(100)
    heights[[40, 43]] = 1.0, 0.9
    heights[[3, 96]] = 9.0
    assert bursts(heights, even, even) == [[40.0, 1.0]]
    assert bursts(heights, even * 0.4, even) == []  # too quiet
    louder = np.where(np.arange(100) < 42, 1.0, 2.5)
    assert bursts(heights, louder, even) == [[40.0, 1.0]]
    assert bursts(heights, even, louder) == []  # sharper after it than before
    assert bursts(heights / 6, even, even) == []  # too low


@pytest.mark.parametrize(("within", "reach", "level"), [(0, 14, 9), (3, 14, 9), (4, 11, 9), (4, 14, 4), (4, 14, 15)])
def test_bursts_refuse_what_does_not_fit(within: int, reach: int, level: int):
    row, places = np.ones(100), np.empty(5, np.int64)
    with pytest.raises(ValueError, match="wanted"):
        kernel.bursts(row, row, row, within, reach, level, 3.0, 0.2, 0.5, 4.0, 2.0, places, np.empty(5))


@pytest.mark.slow
@given(st.integers(0, 2**32 - 1), st.sampled_from([2.0, 3.5]), st.sampled_from([0.0, 5.0]), st.sampled_from([0.0, 0.8]))
def test_what_stands_out_amid_a_sound_that_goes_on(seed: int, times: float, above_mean: float, quietest: float):
    reach, level, before = 7, 5, 3
    rng = np.random.default_rng(seed)
    heights = rng.uniform(0.5, 1.0, (4, 60))
    heights[rng.integers(0, 4, 12), rng.integers(0, 60, 12)] = rng.choice([3.0, 5.0, 9.0], 12)
    firsts = np.array([3, 0, 40, 17])
    squares, edges = rng.choice([0.1, 1.0, 30.0], (2, 103)) * rng.uniform(0.9, 1.1, (2, 103))
    squares.sort()  # louder and louder, so that both answers come
    wanted = []
    for row, (all_of_it, first) in enumerate(zip(heights, firsts, strict=True)):
        for at in range(reach, 60 - reach):
            if not (all_of_it[at] > 0.15 and stands_out(all_of_it.tolist(), at, reach, times)):
                continue
            if all_of_it[reach:-reach].max() < above_mean * all_of_it.mean():
                continue
            sides = [sorted(sides_of(values, first + at, level)) for values in (squares, edges)]
            if sides[0][0] >= quietest and any(high <= low * before for low, high in sides):
                stands = all_of_it[at] / highest_beside(all_of_it.tolist(), at, reach)
                wanted.append((row, at, all_of_it[at], sides[0][0], stands))
    out = np.empty((100, 5))
    found = kernel.outstanding_amid(
        heights, firsts, times, reach, CORE, 0.15, above_mean, squares, edges, level, quietest, before, out
    )
    np.testing.assert_allclose(out[:found], np.reshape(wanted, (-1, 5)), rtol=1e-12)


def sides_of(values: np.ndarray, place: int, level: int) -> tuple[float, float]:
    return float(values[place - level : place - CORE].mean()), float(
        values[place + CORE + 1 : place + level + 1].mean()
    )


@pytest.mark.parametrize("first", [-3, 25])
def test_cells_beside_what_may_stand_out_are_wanted(first: int):
    cells = np.ones(40)
    with pytest.raises(ValueError, match="wanted"):
        kernel.outstanding_amid(
            np.ones((1, 20)),
            np.array([first]),
            1.0,
            2,
            CORE,
            0.1,
            0.0,
            cells,
            cells,
            5,
            0.0,
            30.0,
            np.empty((9, 5)),
        )


@pytest.mark.slow
@given(st.lists(st.floats(-10, 10), min_size=2, max_size=40))
def test_bends(sums: list[float]):
    out = np.empty(len(sums) - 2)
    kernel.bends(np.array(sums), out)
    np.testing.assert_allclose(out, np.abs(np.diff(sums, n=2)) / 2, atol=1e-12)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda: kernel.cells(np.zeros((1, 100)), 5, 10, np.empty((5, 9))),
        lambda: kernel.cells(np.zeros((1, 100)), 6, 10, np.empty((5, 10))),
        lambda: kernel.cells(np.zeros((2, 100)), 6, 10, np.empty((5, 9))),
        lambda: kernel.bends(np.zeros(5), np.empty(4)),
        lambda: unforeseen(np.zeros(300), np.ones(290), 20, 9),
        lambda: unforeseen(np.zeros(300), np.ones(280), 65, 9),
        lambda: unforeseen(np.zeros(300), np.ones(200), 20, 9),
        lambda: unforeseen(np.zeros(300), np.ones(200), 20, 2 * REACH),
        lambda: unforeseen(np.zeros(300), np.ones(20), 20, 9),
    ],
)
def test_what_would_reach_beyond_the_samples_is_refused(wrong):
    with pytest.raises(ValueError, match="wanted"):
        wrong()
