"""Loudness against BS.1770's tabulated filters and closed forms; the compliance cases are in test_compliance.py."""

import math

import numpy as np
import pytest

from audio_checks.measure.loudness import Loudness, channel_weights, k_weighting
from tests.support.waves import join, noise, silence, sine

# ITU-R BS.1770-5, tables 1 and 2, for 48 kHz
TABULATED = (
    ([1.53512485958697, -2.69169618940638, 1.19839281085285], [1.0, -1.69065929318241, 0.73248077421585]),
    ([1.0, -2.0, 1.0], [1.0, -1.99004745483398, 0.99007225036621]),
)
REAR = 10**0.15


def loudness(samples, rate=48_000, block_frames=65_536, **kinds):
    meter = Loudness(rate, samples.shape[1], len(samples), **kinds)
    for start in range(0, len(samples), block_frames):
        meter.add(samples[start : start + block_frames])
    return meter.result()


def response_db(hz, rate, filters=None):
    """The K-weighting's gain at a frequency."""
    z = np.exp(-2j * np.pi * hz / rate)
    pairs = zip(*k_weighting(rate), strict=True) if filters is None else filters
    gain = math.prod(abs(np.polyval(b[::-1], z) / np.polyval(a[::-1], z)) for b, a in pairs)
    return 20 * math.log10(gain)


def tone_lufs(dbfs, hz=1_000, rate=48_000, channels=2):
    """The loudness of a steady tone, in closed form."""
    return -0.691 + dbfs - 10 * math.log10(2) + 10 * math.log10(channels) + response_db(hz, rate)


def test_at_48_khz_the_filters_are_the_tabulated_ones():
    numerators, denominators = k_weighting(48_000)
    for stage, (b, a) in enumerate(TABULATED):
        assert numerators[stage] == pytest.approx(b, abs=1e-9)
        assert denominators[stage] == pytest.approx(a, abs=1e-9)


@pytest.mark.parametrize("rate", [22_050, 32_000, 44_100, 88_200, 96_000, 192_000])
def test_at_other_rates_they_sound_the_same(rate):
    for hz in (30, 100, 500, 997, 2_000):
        assert response_db(hz, rate) == pytest.approx(response_db(hz, 48_000, TABULATED), abs=0.03)


@pytest.mark.parametrize("rate", [8_000, 11_025, 22_050, 44_100, 48_000, 96_000, 192_000])
@pytest.mark.parametrize("hz", [100, 997, 3_000])
def test_a_tone_reads_its_closed_form(rate, hz):
    figures = loudness(sine(hz=hz, dbfs=-20, seconds=4, rate=rate, channels=2), rate)
    for name in ("integrated_lufs", "max_momentary_lufs", "max_short_term_lufs", "short_loudness_lufs"):
        assert figures[name] == pytest.approx(tone_lufs(-20, hz, rate), abs=0.03)
    assert figures["loudness_range_lu"] == pytest.approx(0, abs=0.01)


def test_997_hz_at_full_scale_in_one_channel_reads_minus_3_01():
    # ITU-R BS.1770-5, Annex 1: by this the constant -0.691 is chosen.
    tone = join(sine(hz=997, dbfs=0, seconds=5))
    assert loudness(tone)["integrated_lufs"] == pytest.approx(-3.01, abs=0.01)


@pytest.mark.parametrize("seconds", [0.05, 0.1, 0.2, 0.39])
def test_shorter_than_400_ms_the_rest_counts_as_silence(seconds):
    figures = loudness(sine(hz=1_000, dbfs=-12, seconds=seconds))
    wanted = tone_lufs(-12, channels=1) + 10 * math.log10(seconds / 0.4)
    assert figures["short_loudness_lufs"] == pytest.approx(wanted, abs=0.1)
    assert figures["max_momentary_lufs"] == figures["short_loudness_lufs"]
    assert figures["integrated_lufs"] == -math.inf
    assert figures["loudness_range_lu"] is None


def test_silence_has_no_loudness():
    figures = loudness(silence(seconds=4, channels=2))
    assert {value for name, value in figures.items() if name != "loudness_range_lu"} == {-math.inf}
    assert figures["loudness_range_lu"] is None
    assert loudness(np.zeros((1, 1)))["short_loudness_lufs"] == -math.inf


@pytest.mark.parametrize("rate", [44_100, 11_025, 22_050])
@pytest.mark.parametrize("block_frames", [1, 100, 441, 5_000])
def test_blocks_of_any_size_give_the_same(rate, block_frames):
    samples = noise(seconds=0.5 if block_frames == 1 else 4, rate=rate, channels=2)[
        : 3_000 if block_frames == 1 else None
    ]
    parts = loudness(samples, rate, block_frames)
    whole = loudness(samples, rate, len(samples))
    assert parts == pytest.approx(whole, abs=1e-6)


@pytest.mark.parametrize(
    ("channels", "mask", "weights"),
    [
        (1, None, [1]),
        (2, None, [1, 1]),
        (4, None, [1, 1, REAR, REAR]),
        (5, None, [1, 1, 1, REAR, REAR]),
        (6, None, [1, 1, 1, 0, REAR, REAR]),
        (6, 0x60F, [1, 1, 1, 0, REAR, REAR]),
        (8, 0x63F, [1, 1, 1, 0, 1, 1, REAR, REAR]),
        (2, 0x3, [1, 1]),
        (3, 0x0, [1, 1, 1]),
    ],
)
def test_channel_weights(channels, mask, weights):
    assert channel_weights(channels, mask) == pytest.approx(weights)
