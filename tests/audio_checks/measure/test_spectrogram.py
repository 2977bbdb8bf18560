import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks.measure.spectrogram import BOTTOM_HZ, MOST_COLUMNS, ROWS, TOP_HZ, Spectrogram
from tests.support.waves import Samples, click, join, silence, sine

CENTRES_HZ = TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** ((np.arange(ROWS) + 0.5) / ROWS)


def levels(samples: Samples, rate: int = 48_000, block: int = 1_000) -> NDArray[np.float64]:
    spectrogram = Spectrogram(rate, samples.shape[1], len(samples))
    for start in range(0, len(samples), block):
        spectrogram.add(samples[start : start + block])
    return spectrogram.levels()


def row_of(hz: float) -> int:
    """The row that a frequency falls into: equal steps of pitch from top to bottom."""
    return int(ROWS * np.log(TOP_HZ / hz) / np.log(TOP_HZ / BOTTOM_HZ))


@pytest.mark.parametrize("rate", [22_050, 44_100, 48_000, 192_000])
@pytest.mark.parametrize("hz", [120, 1_000, 9_000])
def test_a_tone_is_a_line_at_its_frequency_and_level(rate: int, hz: float) -> None:
    shown = levels(sine(hz=hz, dbfs=-20, rate=rate), rate)
    middle = shown[:, shown.shape[1] // 2]
    loudest = int(np.argmax(middle))
    assert abs(loudest - row_of(hz)) <= 1
    # A tone between two bins of a Hann window reads at most 1.42 dB low; between two rows as much again.
    assert -23.0 <= middle[loudest] <= -19.9
    far = np.abs(CENTRES_HZ - hz) > 150 + 0.07 * hz  # more than six bins away, side lobes lie 50 dB down
    assert middle[far].max() < -60


def test_nothing_is_above_half_the_rate() -> None:
    shown = levels(sine(hz=1_000, dbfs=-3, rate=22_050), 22_050)
    above_nyquist = [row for row in range(ROWS) if TOP_HZ * (BOTTOM_HZ / TOP_HZ) ** ((row + 1) / ROWS) > 11_025]
    assert (shown[above_nyquist] == -np.inf).all()


def test_channels_against_each_other_do_not_cancel() -> None:
    tone = sine(hz=1_000, dbfs=-20, channels=2)
    assert levels(tone * [1, -1]).max() == pytest.approx(levels(tone).max(), abs=0.01)


def test_a_channel_alone_counts_half() -> None:
    tone = sine(hz=1_000, dbfs=-20, channels=2)
    assert levels(tone * [1, 0]).max() == pytest.approx(levels(tone).max() - 3.01, abs=0.01)


def test_a_click_in_a_long_sound_is_seen_where_it_is() -> None:
    sound = join(silence(seconds=20.0), click(at_s=0.5, dbfs=0, seconds=1.0), silence(seconds=19.0))
    shown = levels(sound, block=65_536)
    assert shown.shape == (ROWS, MOST_COLUMNS)
    lit = np.flatnonzero(shown[row_of(5_000)] > -90)
    assert lit.size
    assert np.abs(lit / MOST_COLUMNS * 40.0 - 20.5).max() < 0.1


@pytest.mark.parametrize("seconds", [0.05, 0.3, 3.0])
@pytest.mark.parametrize("share", [0.25, 0.75])
def test_a_click_in_a_short_sound_is_brightest_where_it_is(seconds: float, share: float) -> None:
    shown = levels(click(at_s=share * seconds, dbfs=0, seconds=seconds))
    columns = shown.shape[1]
    assert columns >= seconds / 0.043 * 4  # the resolution in time is finer than a window is long
    assert np.argmax(shown[row_of(5_000)]) + 0.5 == pytest.approx(share * columns, abs=1)


@pytest.mark.parametrize("frames", [1, 2, 47, 48, 3_000])
def test_the_shortest_sounds_are_drawn_too(frames: int) -> None:
    shown = levels(np.full((frames, 1), 0.5))
    assert shown.shape[0] == ROWS
    assert 1 <= shown.shape[1] <= MOST_COLUMNS
    assert shown[-1].max() > -100


@pytest.mark.parametrize("block", [1, 77, 30_000])
def test_how_the_stream_is_cut_changes_nothing(block: int) -> None:
    sound = sine(hz=440, dbfs=-6, seconds=0.2, channels=2)
    assert np.allclose(levels(sound, block=block), levels(sound, block=len(sound)), atol=1e-6)


def test_silence_is_silence() -> None:
    assert (levels(silence(seconds=0.2)) == -np.inf).all()
