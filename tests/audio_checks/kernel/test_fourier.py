"""Powers of bins, held to numpy's transform."""

import numpy as np
import pytest

from audio_checks import kernel
from audio_checks.measure.window_powers import twiddle_factors


@pytest.mark.parametrize("length", [1, 2, 14, 45, 242, 400, 2_000])
@pytest.mark.parametrize("channels", [1, 2, 3])
def test_powers_of_windows(length: int, channels: int):
    rng = np.random.default_rng(length + channels)
    hop, count, first, bins = max(1, length // 3), 5, 2, length // 2 + 1
    signal = rng.standard_normal((channels, first + (count - 1) * hop + length + 1))
    window = np.hanning(length + 1)[:-1] + 0.1
    powers = np.empty((count * channels, bins))
    kernel.powers(signal, window, first, hop, twiddle_factors(length), powers, False)
    for number in range(count):
        start = first + number * hop
        wanted = np.abs(np.fft.rfft(signal[:, start : start + length] * window, axis=1)) ** 2
        np.testing.assert_allclose(powers[number * channels :][:channels], wanted, rtol=1e-9, atol=1e-9 * length)
    by_bin = np.empty((channels * bins, count + 2))[:, :count]  # rows that lie apart
    kernel.powers(signal, window, first, hop, twiddle_factors(length), by_bin, True)
    np.testing.assert_array_equal(by_bin, powers.reshape(count, -1).T)
    sums = np.ones(bins)
    kernel.power_sums(signal, window, first, hop, count, twiddle_factors(length), sums)
    np.testing.assert_allclose(sums, 1 + powers.sum(axis=0), rtol=1e-12)


@pytest.mark.parametrize(
    ("frames", "length", "first", "rows", "bins"),
    [(99, 100, 0, 1, 10), (150, 100, 51, 1, 10), (150, 100, 0, 3, 10), (150, 100, 0, 1, 101), (150, 117, 0, 1, 10)],
)
def test_what_would_reach_beyond_is_refused(frames: int, length: int, first: int, rows: int, bins: int):
    signal = np.zeros((1, frames))
    with pytest.raises(ValueError, match="wanted"):
        kernel.powers(signal, np.ones(length), first, 30, twiddle_factors(length), np.empty((rows, bins)), False)
    with pytest.raises(ValueError, match="wanted"):
        kernel.powers(signal, np.ones(length), first, 30, twiddle_factors(length), np.empty((bins, rows)), True)
    with pytest.raises(ValueError, match="wanted"):
        kernel.power_sums(signal, np.ones(length), first, 30, rows, twiddle_factors(length), np.empty(bins))
