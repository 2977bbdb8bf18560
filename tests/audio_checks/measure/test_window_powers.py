import numpy as np
import pytest

from audio_checks.measure.window_powers import WindowPowers, hann_powers


@pytest.mark.parametrize("length", [64, 360, 62])  # 62 = 2 · 31: the kernel has no such transform
@pytest.mark.parametrize("channels", [1, 2, 5])
def test_they_are_those_of_the_definition(length, channels):
    rng = np.random.default_rng(1)
    signal, window = rng.standard_normal((channels, 1_000)), rng.standard_normal(length)
    found = WindowPowers(window).of(signal, first=7, hop=50, count=11, bins=20)
    assert found.shape == (11, channels, 20)
    room = np.full((channels * 20, 13), np.nan)
    WindowPowers(window).by_bin(signal, first=7, hop=50, powers=room[:, 1:12])
    np.testing.assert_array_equal(room[:, 1:12], found.reshape(11, -1).T)
    assert np.isnan(room[:, [0, 12]]).all()
    turns = np.exp(-2j * np.pi * np.outer(np.arange(20), np.arange(length)) / length)
    for number in range(11):
        part = signal[:, 7 + 50 * number :][:, :length] * window
        assert np.allclose(found[number], np.abs(part @ turns.T) ** 2)


@pytest.mark.parametrize("length", [128, 106])
def test_a_sine_in_a_bin_has_the_power_that_is_promised(length):
    powers = hann_powers(length)
    tone = 0.5 * np.cos(2 * np.pi * 10 * np.arange(length) / length)[np.newaxis]
    found = powers.of(tone, first=0, hop=1, count=1)[0, 0]
    assert len(found) == length // 2 + 1
    assert found[10] == pytest.approx((0.5 * length / 2 / 2) ** 2)  # a Hann window adds up to half its length
    assert found[30:].max() < 1e-20
    assert not powers.of(np.zeros((1, length)), first=0, hop=1, count=1).any()
