"""How octaves go on and how loud rows of pitch are, held to what numpy makes of the same windows."""

from itertools import pairwise

import numpy as np
import pytest

from audio_checks import kernel
from audio_checks.measure.window_powers import twiddle_factors

HOP, FIRST = 60, 1
WINDOW = np.hanning(2 * HOP + 1)[:-1]
OCTAVES = np.array([[1, 2, 1], [2, 5, 3], [5, 20, 14], [19, 20, 1]])  # first bin, last but one, width
FINE = np.array([1, 3, 8, 8, 20])
BINS = 20
COLUMNS = 7 * len(OCTAVES) + len(FINE) - 1 + 2
TINY = 1e-20


def signal_of(channels: int, rows: int) -> np.ndarray:
    rng = np.random.default_rng(channels + rows)
    frames = FIRST + (rows + 1) * HOP
    return rng.standard_normal((channels, frames)) * np.exp(-np.linspace(0, 20, frames))


def by_octave(bins: np.ndarray) -> np.ndarray:
    return np.stack([bins[..., first:end].sum(axis=-1) for first, end, _ in OCTAVES], axis=-1)


def wanted_rows(signal: np.ndarray, rows: int) -> np.ndarray:
    windows = np.lib.stride_tricks.sliding_window_view(signal, 2 * HOP, axis=1)[:, FIRST::HOP][:, :rows]
    spectra = np.fft.rfft(windows * WINDOW, axis=2)[:, :, :BINS]
    powers = np.abs(spectra) ** 2
    levels, width = 10 * np.log10(powers + TINY), OCTAVES[:, 2]
    before = levels[:, np.maximum(0, np.arange(rows) - 2)]
    flatness = (by_octave(levels) / width - 10 * np.log10(by_octave(powers) / width + TINY)).mean(axis=0)
    flutter = (by_octave(np.abs(levels - before)) / width).mean(axis=0)
    mean = powers.mean(axis=0)
    fine = np.stack([mean[:, first:end].sum(axis=1) for first, end in pairwise(FINE)], axis=1)
    squares = np.square(np.diff(signal[:, : FIRST + rows * HOP], axis=1)).reshape(len(signal), rows, HOP)
    edges = np.stack([squares.mean(axis=(0, 2)), np.square(squares).mean(axis=(0, 2))], axis=1)
    columns = [by_octave(mean), fine, flatness, flutter, edges]
    if len(signal) > 1:
        product = spectra[0] * spectra[1].conj()
        parts = (powers[0], powers[1], product.real, product.imag)
        columns.append(np.stack([by_octave(part) for part in parts], axis=2).reshape(rows, -1))
    return np.concatenate(columns, axis=1)


def found_rows(signal: np.ndarray, cuts: list[int]) -> np.ndarray:
    """Rows that are found by several calls, each up to one of the cuts."""
    held, rows = np.empty((len(signal), BINS, 2)), np.zeros((cuts[-1], COLUMNS))
    for start, end in zip([0, *cuts], cuts, strict=False):
        part = np.ascontiguousarray(signal[:, start * HOP : FIRST + (end + 1) * HOP])
        kernel.decay_rows(part, WINDOW, HOP, twiddle_factors(2 * HOP), OCTAVES, FINE, held, start == 0, rows[start:end])
    return rows


@pytest.mark.parametrize("channels", [1, 2, 3])
@pytest.mark.parametrize("cuts", [[1], [21], [1, 2, 3, 12, 21], [8, 8, 16]])
def test_rows_of_a_decay(channels: int, cuts: list[int]):
    signal = signal_of(channels, cuts[-1])
    wanted = wanted_rows(signal, cuts[-1])
    found = found_rows(signal, cuts)[:, : wanted.shape[1]]
    np.testing.assert_allclose(found, wanted, rtol=1e-9, atol=1e-11)


def test_levels_reach_from_nothing_to_the_loudest_float():
    for exponent in (-200, -20, -1, 0, 1, 40):
        signal = 2.0**exponent * signal_of(1, 9)
        np.testing.assert_allclose(
            found_rows(signal, [9])[:, : COLUMNS - 4 * len(OCTAVES)], wanted_rows(signal, 9), rtol=1e-9, atol=1e-10
        )


def test_a_silent_channel_has_no_power_beside_a_loud_one():
    signal = signal_of(2, 20)
    signal[1] = 0.0
    sides = found_rows(signal, [20])[:, -4 * len(OCTAVES) :].reshape(20, -1, 4)
    assert (sides[:, :, 0] > 0).all()
    assert not sides[:, :, 1:].any()


@pytest.mark.parametrize(
    ("rows", "octave", "edge", "columns"),
    [(21, 20, 20, COLUMNS), (20, 21, 20, COLUMNS), (20, -1, 20, COLUMNS), (20, 20, 21, COLUMNS), (20, 20, 20, 5)],
)
def test_rows_that_would_reach_beyond_are_refused(rows: int, octave: int, edge: int, columns: int):
    signal, octaves, fine = signal_of(2, 20), np.array([[1, octave, 1], *OCTAVES[1:]]), np.array([*FINE[:-1], edge])
    held, out = np.empty((2, BINS, 2)), np.empty((rows, columns))
    with pytest.raises(ValueError, match="wanted"):
        kernel.decay_rows(signal, WINDOW, HOP, twiddle_factors(2 * HOP), octaves, fine, held, True, out)


@pytest.mark.parametrize("channels", [1, 2, 3])
@pytest.mark.parametrize("count", [1, 8, 11])
def test_rows_of_pitch(channels: int, count: int):
    length, hop, first = 64, 20, 3
    signal = np.random.default_rng(count).standard_normal((channels, first + (count - 1) * hop + length))
    window = np.hanning(length + 1)[:-1]
    below, shares = np.array([0, 5, -1, 31, 7]), np.array([0.0, 0.3, 0.5, 1.0, 0.2])
    spans = np.array([[0, 0], [0, 0], [0, 0], [20, 33], [4, 6]])
    found = np.empty((count, 5))
    kernel.pitch_rows(signal, window, first, hop, twiddle_factors(length), below, shares, spans, found)
    windows = np.lib.stride_tricks.sliding_window_view(signal, length, axis=1)[:, first::hop]
    powers = (np.abs(np.fft.rfft(windows * window, axis=2)) ** 2).mean(axis=0)
    between = 0.7 * powers[:, 5] + 0.3 * powers[:, 6]
    wanted = (powers[:, 0], between, np.zeros(count), powers[:, 20:33].max(axis=1), powers[:, 4:6].max(axis=1))
    np.testing.assert_allclose(found, np.stack(wanted, axis=1), rtol=1e-9)


@pytest.mark.parametrize(
    ("count", "below", "span"), [(3, 1, (0, 2)), (2, 32, (0, 2)), (2, 1, (0, 34)), (2, 1, (-1, 2))]
)
def test_rows_of_pitch_beyond_their_bins_are_refused(count: int, below: int, span: tuple[int, int]):
    rows = np.array([below]), np.array([0.5]), np.array([span])
    with pytest.raises(ValueError, match="wanted"):
        kernel.pitch_rows(np.zeros((1, 80)), np.ones(64), 0, 16, twiddle_factors(64), *rows, np.empty((count, 1)))
