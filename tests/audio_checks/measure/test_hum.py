"""Hum is looked for in windows that lie evenly over the whole sound, whatever the stretches that its cells come in."""

import numpy as np
import pytest

from audio_checks.measure.hum import KEPT, _Windows
from audio_checks.measure.window_powers import hann_powers

LENGTH, HOP = 64, 32


@pytest.mark.parametrize(
    ("cells", "stretch"),
    [
        (LENGTH, 1),
        (2_000, 1),
        (2_000, 37),
        ((KEPT - 1) * HOP + LENGTH - 2, 8_192),
        ((KEPT - 1) * HOP + LENGTH + HOP - 1, 8_192),  # the cell that ends in silence ends a window too much
        (9 * KEPT * HOP, 9_999),
    ],
)
@pytest.mark.parametrize("channels", [1, 3])
def test_no_more_windows_than_are_kept_are_transformed(cells: int, stretch: int, channels: int):
    sums = np.random.default_rng(cells).standard_normal((channels, cells + 1))
    windows = _Windows(channels, 2_000.0, LENGTH, 24, cells)
    padded = np.concatenate((np.zeros((channels, LENGTH)), sums), axis=1)
    for place in range(0, cells + 1, stretch):
        new = min(stretch, cells + 1 - place)
        windows.add(np.ascontiguousarray(padded[:, place : place + LENGTH + new]), place - LENGTH)
    number = (cells + 1 - LENGTH) // HOP + 1
    every = next(every for every in (1, 2, 4, 8, 16, 32) if -(-number // every) <= max(8, KEPT // channels))
    bins, count = windows.spectra.shape[1:]
    assert count == -(-number // every)
    wanted = hann_powers(LENGTH).of(sums, first=0, hop=HOP * every, count=count, bins=bins)
    np.testing.assert_allclose(windows.spectra, wanted.transpose(1, 2, 0), rtol=1e-9, atol=1e-12)
