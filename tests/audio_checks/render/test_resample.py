"""Rates downwards: ripple, alias, delay, length, loops and silence, against what theory says of each."""

import itertools
import math

import numpy as np
import pytest

from audio_checks.errors import RenderRefused
from audio_checks.render.resample import (
    frames_after,
    loop_fit_frames,
    position_after,
    resample,
    resample_blocks,
)

MASTERS = [192_000, 96_000, 88_200, 48_000, 44_100]
TARGETS = [96_000, 48_000, 44_100, 32_000, 24_000, 22_050, 16_000, 11_025]
DOWNWARDS = [(high, low) for high, low in itertools.product(MASTERS, TARGETS) if low < high]


def db(value):
    return 20 * np.log10(value) if value else -np.inf


def tone(hz, rate, frames, phase=0.3):
    return np.sin(2 * np.pi * hz * np.arange(frames) / rate + phase)


def test_all_pairs_of_the_field_are_tried():
    assert len(DOWNWARDS) == 33


@pytest.mark.parametrize(("high", "low"), DOWNWARDS)
def test_what_fits_stays_and_what_does_not_is_gone(high, low):
    # Left: the highest tone that must pass, with its phase, so level and delay are judged at once.
    # Middle: full scale just above the new Nyquist frequency. Right: far above it.
    frames = high // 4 + 1
    nyquist = low / 2
    fits, near, far = 0.95 * nyquist, 1.001 * nyquist, min(1.4 * nyquist, 0.499 * high)
    samples = np.stack([tone(fits, high, frames), tone(near, high, frames), tone(far, high, frames)], axis=1)
    rendered = resample(samples, high, low)
    assert len(rendered) == math.ceil(frames * low / high)
    middle = slice(len(rendered) // 3, 2 * len(rendered) // 3)
    wanted = tone(fits, low, len(rendered))
    assert db(np.abs(rendered[middle, 0] - wanted[middle]).max()) < -180
    assert db(np.abs(rendered[middle, 1:]).max()) < -180


@pytest.mark.parametrize(("high", "low"), [(48_000, 44_101), (47_999, 44_100), (44_100, 8_009), (192_000, 191_999)])
def test_rates_without_a_small_ratio_are_met_as_well(high, low):
    rendered = resample(tone(0.4 * low, high, high // 2)[:, np.newaxis], high, low)[:, 0]
    middle = slice(len(rendered) // 3, 2 * len(rendered) // 3)
    assert db(np.abs(rendered - tone(0.4 * low, low, len(rendered)))[middle].max()) < -180


@pytest.mark.parametrize(("high", "low"), [(96_000, 44_100), (48_000, 11_025), (44_100, 22_050)])
def test_ripple_over_the_whole_pass_band(high, low):
    # The transform of a filtered impulse is the response itself.
    impulse = np.zeros((high, 1))
    impulse[0] = 1.0
    circular = resample(impulse, high, low, loop=True)[:, 0] * (high / low)
    response = np.abs(np.fft.rfft(circular))
    passed = response[: int(0.95 * low / 2)]
    assert np.abs(20 * np.log10(passed)).max() < 0.001


@pytest.mark.parametrize(("high", "low"), [(96_000, 48_000), (96_000, 44_100), (44_100, 22_050)])
def test_an_impulse_stays_where_it_was(high, low):
    common = math.gcd(high, low)
    at = 40 * (high // common)
    impulse = np.zeros((2 * at + 1, 1))
    impulse[at] = 1.0
    rendered = resample(impulse, high, low)[:, 0]
    middle = 40 * (low // common)
    assert np.argmax(np.abs(rendered)) == middle
    mirrored = rendered[2 * middle : None : -1] if 2 * middle < len(rendered) else rendered[::-1]
    assert rendered[: len(mirrored)] == pytest.approx(mirrored, abs=1e-12)


def test_a_steady_level_stays():
    rendered = resample(np.full((30_000, 1), 0.25), 96_000, 44_100, loop=True)
    assert rendered == pytest.approx(0.25, abs=1e-9)


def test_blocks_may_be_cut_anyhow():
    noise = np.random.default_rng(1).uniform(-1, 1, (50_001, 2))
    whole = resample(noise, 96_000, 44_100)
    cuts = [noise[start : start + 777] for start in range(0, len(noise), 777)]
    streamed = np.concatenate(
        list(resample_blocks(lambda: cuts, frames=50_001, channels=2, sample_rate_hz=96_000, to_hz=44_100))
    )
    assert np.array_equal(streamed, whole)


def test_long_sounds_come_in_bounded_blocks():
    frames, piece = 2_000_000, np.ones((10_000, 1))
    sizes = [
        len(block)
        for block in resample_blocks(
            lambda: itertools.repeat(piece, frames // len(piece)),
            frames=frames,
            channels=1,
            sample_rate_hz=96_000,
            to_hz=44_100,
        )
    ]
    assert sum(sizes) == frames_after(frames, 96_000, 44_100)
    assert max(sizes) < 50_000


def test_channels_do_not_touch():
    left = np.random.default_rng(2).uniform(-1, 1, 9_999)
    both = resample(np.stack([left, np.zeros(9_999)], axis=1), 48_000, 32_000)
    alone = resample(left[:, np.newaxis], 48_000, 32_000)
    assert np.abs(both[:, :1] - alone).max() < 1e-10  # -200 dB: alone, it is cut into other blocks
    assert not both[:, 1].any()


def test_digital_silence_stays_silent():
    samples = np.random.default_rng(3).uniform(-1, 1, (60_000, 1))
    samples[10_000:40_000] = 0.0
    rendered = resample(samples, 96_000, 48_000)[:, 0]
    reach = 700  # frames of the target: at 200 dB the filter sees 13 / 0.05 of them to each side, and some
    assert not rendered[5_000 + reach : 20_000 - reach].any()
    assert rendered[: 5_000 - reach].all()
    assert not resample(np.zeros((5_000, 2)), 96_000, 44_100).any()


@pytest.mark.parametrize("high_low", [(96_000, 44_100), (44_100, 22_050)])
def test_one_frame_and_none(high_low):
    assert resample(np.ones((1, 2)), *high_low).shape == (1, 2)
    assert resample(np.ones((1, 1)), *high_low, loop=True) == pytest.approx(1.0, abs=1e-9)
    assert resample(np.empty((0, 2)), *high_low).shape == (0, 2)


def test_the_same_rate_is_the_same_sound():
    noise = np.random.default_rng(4).uniform(-1, 1, (1_000, 2))
    assert np.array_equal(resample(noise, 48_000, 48_000), noise)


@pytest.mark.parametrize(("low", "high"), [(44_100, 48_000), (22_050, 96_000), (44_100, 44_101)])
def test_upwards_is_refused(low, high):
    with pytest.raises(RenderRefused, match="never recorded") as refused:
        resample(np.zeros((10, 1)), low, high)
    assert refused.value.code == "render:upwards"


class TestLoops:
    def test_a_loop_has_no_edges(self):
        # A tone of whole periods, looped, is the same tone at the new rate to its very first frame.
        frames = 96_000
        rendered = resample(tone(441, 96_000, frames)[:, np.newaxis], 96_000, 44_100, loop=True)[:, 0]
        assert np.abs(rendered - tone(441, 44_100, 44_100)).max() < 1e-9

    @pytest.mark.parametrize("frames", [160, 320, 4_800, 96_000])
    def test_twice_in_a_row_equals_its_double(self, frames):
        loop = np.random.default_rng(5).uniform(-1, 1, (frames, 2))
        once = resample(loop, 48_000, 44_100, loop=True)
        double = resample(np.tile(loop, (2, 1)), 48_000, 44_100, loop=True)
        assert len(double) == 2 * len(once)
        assert np.abs(double - np.tile(once, (2, 1))).max() < 1e-9

    @pytest.mark.parametrize("frames", [7_001, 7_002, 50_003])
    def test_a_period_that_does_not_divide_is_fitted_evenly(self, frames):
        # A fitted loop is the same Fourier series, read at as many points as it has new frames.
        loop = np.random.default_rng(6).uniform(-1, 1, (frames, 1))
        rendered = resample(loop, 96_000, 22_050, loop=True)
        wanted, got = np.fft.rfft(loop[:, 0]) / frames, np.fft.rfft(rendered[:, 0]) / len(rendered)
        passed = int(0.94 * len(rendered) / 2)
        assert db(np.abs(wanted[:passed] - got[:passed]).max()) < -200

    @pytest.mark.parametrize(
        ("frames", "whole", "fit"),
        [(96_000, 22_050, 0.0), (640, 147, 0.0), (641, 147, -0.2296875), (10, 2, -0.296875), (1, 1, 0.7703125)],
    )
    def test_fit(self, frames, whole, fit):
        assert frames_after(frames, 96_000, 22_050, loop=True) == whole
        assert loop_fit_frames(frames, 96_000, 22_050) == pytest.approx(fit)


@pytest.mark.parametrize(
    ("frames", "high", "low", "wanted"),
    [
        (96_000, 96_000, 44_100, 44_100),
        (96_001, 96_000, 44_100, 44_101),
        (1, 192_000, 11_025, 1),
        (0, 96_000, 48_000, 0),
    ],
)
def test_length_is_rounded_up(frames, high, low, wanted):
    assert frames_after(frames, high, low) == wanted


@pytest.mark.parametrize(("position", "wanted"), [(0, 0), (1, 1), (2, 1), (3, 2), (5, 3)])
def test_positions_round_half_up(position, wanted):
    assert position_after(position, 96_000, 48_000) == wanted
