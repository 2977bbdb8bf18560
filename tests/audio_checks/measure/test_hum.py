"""Hum is told from the same windows whether or not their number was known before they came."""

import numpy as np
import pytest

from audio_checks.measure.hum import KEPT, _Windows


@pytest.mark.parametrize("cells", [2_000, 2 * KEPT * 32 + 37, 9 * KEPT * 32])
@pytest.mark.parametrize("channels", [1, 3])
def test_windows_that_would_be_left_out_are_not_transformed(cells: int, channels: int):
    sums = np.random.default_rng(cells).standard_normal((channels, cells))
    foreseen, unforeseen = (_Windows(channels, 2_000.0, 64, 24, known) for known in (cells, 0))
    for windows in (foreseen, unforeseen):
        for place in range(0, cells, 8_192):
            windows.add(sums[:, : place + 8_192])
    np.testing.assert_allclose(foreseen.spectra(), unforeseen.spectra(), rtol=1e-9)
    number = (cells - 64) // 32 + 1
    assert foreseen.spectra().shape[2] == -(-number // foreseen._every) <= max(8, KEPT // channels)
    assert foreseen._every == 1 or -(-2 * number // foreseen._every) > max(8, KEPT // channels)
