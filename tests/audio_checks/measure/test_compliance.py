"""The compliance cases of EBU Tech 3341, EBU Tech 3342 and ITU-R BS.2217 (for BS.1770), synthesised.

Left out are the cases that are recordings: 3341-7, 3341-8, 3342-5, 3342-6 and BS.2217's programmes.
"""

import math

import numpy as np
import pytest
from numpy.typing import NDArray

from audio_checks.measure.loudness import Loudness, channel_weights
from audio_checks.measure.true_peak import true_peak_dbtp

RATES_HZ = (44_100, 48_000, 96_000)
EVERY_RATE_HZ = (32_000, 44_100, 48_000, 88_200, 96_000, 176_400, 192_000)
# ITU-R BS.1770-5, tables 1 and 2, for 48 kHz: what every rate is to sound like
SHELF = ([1.53512485958697, -2.69169618940638, 1.19839281085285], [1.0, -1.69065929318241, 0.73248077421585])
HIGHPASS = ([1.0, -2.0, 1.0], [1.0, -1.99004745483398, 0.99007225036621])


def gain_db(hz: float) -> float:
    z = np.exp(-2j * np.pi * hz / 48_000)
    return 20 * math.log10(
        math.prod(abs(np.polyval(b[::-1], z) / np.polyval(a[::-1], z)) for b, a in (SHELF, HIGHPASS))
    )


def tone(
    level_lufs: float, seconds: float, rate: int, *, hz: float = 1_000.0, channels: int = 2
) -> NDArray[np.float64]:
    """A tone that reads `level_lufs` when it is the same in `channels` channels in front, shape (frames, 1)."""
    level_db = level_lufs + 0.691 - gain_db(hz) + 10 * math.log10(2 / channels)
    times = np.arange(round(seconds * rate)) / rate
    return (10 ** (level_db / 20) * np.sin(2 * np.pi * hz * times))[:, np.newaxis]


def figures(samples: NDArray[np.float64], rate: int, mask: int | None = None) -> dict[str, float]:
    channels = samples.shape[1]
    meter = Loudness(rate, channels, len(samples), weights=channel_weights(channels, mask))
    for start in range(0, len(samples), 32_768):
        meter.add(samples[start : start + 32_768])
    return meter.result()


def programme(rate: int, *parts: tuple[float, float]) -> NDArray[np.float64]:
    """Stereo tones of 1 kHz one after the other, each (LUFS or -inf, seconds)."""
    return np.repeat(np.concatenate([tone(level, seconds, rate) for level, seconds in parts]), 2, axis=1)


INTEGRATED_3341 = {
    1: [(-23, 20)],
    2: [(-33, 20)],
    3: [(-36, 10), (-23, 60), (-36, 10)],
    4: [(-72, 10), (-36, 10), (-23, 60), (-36, 10), (-72, 10)],
    5: [(-26, 20), (-20, 20.1), (-26, 20)],
}


@pytest.mark.slow
@pytest.mark.parametrize("rate", RATES_HZ)
@pytest.mark.parametrize("case", INTEGRATED_3341)
def test_3341_integrated(case: int, rate: int):
    wanted = -33.0 if case == 2 else -23.0
    found = figures(programme(rate, *INTEGRATED_3341[case]), rate)
    assert found["integrated_lufs"] == pytest.approx(wanted, abs=0.03)
    if case <= 2:
        assert found["max_momentary_lufs"] == pytest.approx(wanted, abs=0.03)
        assert found["max_short_term_lufs"] == pytest.approx(wanted, abs=0.03)


@pytest.mark.parametrize("rate", RATES_HZ)
def test_3341_6_five_channels(rate: int):
    levels = 10 ** (np.array([-28, -28, -24, -30, -30]) / 20)
    times = np.arange(20 * rate) / rate
    samples = np.sin(2 * np.pi * 1_000 * times)[:, np.newaxis] * levels
    assert figures(samples, rate)["integrated_lufs"] == pytest.approx(-23.0, abs=0.03)


@pytest.mark.parametrize("rate", RATES_HZ)
def test_3341_9_short_term_of_a_pattern_of_3_s(rate: int):
    samples = programme(rate, *[(-20, 1.34), (-30, 1.66)] * 5)
    assert figures(samples, rate)["max_short_term_lufs"] == pytest.approx(-23.0, abs=0.1)


@pytest.mark.parametrize("number", range(20))
def test_3341_10_short_term_wherever_the_tone_starts(number: int):
    samples = programme(48_000, (-math.inf, 0.15 * number), (-23, 3), (-math.inf, 1))
    assert figures(samples, 48_000)["max_short_term_lufs"] == pytest.approx(-23.0, abs=0.03)


@pytest.mark.slow
def test_3341_11_short_term_of_each_of_twenty_tones():
    parts: list[tuple[float, float]] = []
    for number in range(20):
        parts += [(-math.inf, 0.15 * number), (-38.0 + number, 3), (-math.inf, 3 - 0.15 * number)]
        found = figures(programme(48_000, *parts[-4:]), 48_000)  # each is louder than all before
        assert found["max_short_term_lufs"] == pytest.approx(-38.0 + number, abs=0.03)


@pytest.mark.parametrize("rate", RATES_HZ)
def test_3341_12_momentary_of_a_pattern_of_400_ms(rate: int):
    samples = programme(rate, *[(-20, 0.18), (-30, 0.22)] * 25)
    assert figures(samples, rate)["max_momentary_lufs"] == pytest.approx(-23.0, abs=0.1)


@pytest.mark.parametrize("number", range(20))
def test_3341_13_momentary_wherever_the_tone_starts(number: int):
    samples = programme(48_000, (-math.inf, 0.02 * number), (-23, 0.4), (-math.inf, 1))
    assert figures(samples, 48_000)["max_momentary_lufs"] == pytest.approx(-23.0, abs=0.03)


@pytest.mark.slow
def test_3341_14_momentary_of_each_of_twenty_tones():
    parts: list[tuple[float, float]] = []
    for number in range(20):
        parts += [(-math.inf, 0.02 * number), (-38.0 + number, 0.4), (-math.inf, 0.4 - 0.02 * number)]
        found = figures(programme(48_000, *parts), 48_000)
        assert found["max_momentary_lufs"] == pytest.approx(-38.0 + number, abs=0.03)


TRUE_PEAK_3341 = {15: (4, 0.0, 0.5, -6.0), 16: (4, 45.0, 0.5, -6.0), 17: (6, 60.0, 0.5, -6.0), 18: (8, 67.5, 0.5, -6.0)}
TRUE_PEAK_3341[19] = (4, 45.0, 1.41, 3.0)


@pytest.mark.parametrize("rate", EVERY_RATE_HZ)
@pytest.mark.parametrize("case", TRUE_PEAK_3341)
def test_3341_15_to_19_true_peak_of_tones(case: int, rate: int):
    parts, degrees, amplitude, wanted = TRUE_PEAK_3341[case]
    frame = np.arange(rate // 4)
    fade = np.clip(np.minimum(frame, frame[::-1]) / (rate // 50), 0, 1)  # an abrupt start overshoots
    wave = amplitude * np.sin(np.pi / 2 * fade) ** 2 * np.sin(2 * np.pi * frame / parts + math.radians(degrees))
    assert wanted - 0.4 <= true_peak_dbtp(wave[:, np.newaxis], rate) <= wanted + 0.2


@pytest.mark.parametrize("rate", EVERY_RATE_HZ)
@pytest.mark.parametrize("offset", range(4))
def test_3341_20_to_23_true_peak_between_samples(offset: int, rate: int):
    # Drawn at four times the rate with its crest at full scale, then every fourth sample from `offset` on.
    place = np.arange(-4_000, 4_000)
    drawn = np.exp(-((place / 400.0) ** 2)) * np.cos(2 * np.pi * place / 16)  # a quarter of the lower rate
    assert -0.4 <= true_peak_dbtp(drawn[offset::4, np.newaxis], rate) <= 0.2


RANGE_3342 = {
    1: ([(-20, 20), (-30, 20)], 10),
    2: ([(-20, 20), (-15, 20)], 5),
    3: ([(-40, 20), (-20, 20)], 20),
    4: ([(-50, 20), (-35, 20), (-20, 20), (-35, 20), (-50, 20)], 15),
}


@pytest.mark.parametrize("rate", RATES_HZ)
@pytest.mark.parametrize("case", RANGE_3342)
def test_3342_loudness_range(case: int, rate: int):
    parts, wanted = RANGE_3342[case]
    assert figures(programme(rate, *parts), rate)["loudness_range_lu"] == pytest.approx(wanted, abs=0.03)


@pytest.mark.parametrize("rate", EVERY_RATE_HZ)
@pytest.mark.parametrize("level", [-23.0, -24.0])
@pytest.mark.parametrize("hz", [25, 100, 500, 1_000, 2_000, 10_000])
def test_2217_tones_of_six_frequencies(hz: int, level: float, rate: int):
    samples = np.repeat(tone(level, 4, rate, hz=hz), 2, axis=1)
    assert figures(samples, rate)["integrated_lufs"] == pytest.approx(level, abs=0.03)


FIVE_ONE = 0x3F
SURROUND = {0: -24.0, 1: -24.0, 2: -24.0, 3: -math.inf, 4: -24.0 + 1.5, 5: -24.0 + 1.5}


@pytest.mark.parametrize("channel", SURROUND)
def test_2217_each_channel_of_5_1_by_itself(channel: int):
    samples = np.zeros((4 * 48_000, 6))
    samples[:, [channel]] = tone(-24, 4, 48_000, channels=1)
    found = figures(samples, 48_000, FIVE_ONE)["integrated_lufs"]
    assert found == pytest.approx(SURROUND[channel], abs=0.03)


def test_2217_channels_add_up():
    samples = np.repeat(tone(-24, 4, 48_000, channels=1), 6, axis=1)
    wanted = -24 + 10 * math.log10(3 + 2 * 10**0.15)
    assert figures(samples, 48_000, FIVE_ONE)["integrated_lufs"] == pytest.approx(wanted, abs=0.03)


def test_2217_the_relative_gate():
    # The mean of -10 and -30 LUFS in equal parts is -13: its gate at -23 leaves the quiet half out, but for the change.
    found = figures(programme(48_000, (-10, 20), (-30, 20)), 48_000)["integrated_lufs"]
    assert found == pytest.approx(-10.0, abs=0.05)


def test_2217_the_absolute_gate():
    # What lies below -70 LUFS counts for nothing: -69.5 stays -69.5 with ever so much of -75 around it.
    found = figures(programme(48_000, (-75, 10), (-69.5, 10), (-75, 10)), 48_000)["integrated_lufs"]
    assert found == pytest.approx(-69.5, abs=0.05)


@pytest.mark.parametrize("rate", RATES_HZ)
def test_a_sweep_reads_the_mean_of_the_weighting(rate: int):
    # As BS.2217's sweep: logarithmic, so every octave lasts equally long; no part falls below the relative gate.
    seconds, low, high = 20.0, 60.0, 12_000.0
    times = np.arange(round(seconds * rate)) / rate
    turns = low * seconds / math.log(high / low) * ((high / low) ** (times / seconds) - 1)
    samples = np.repeat(0.1 * np.sin(2 * np.pi * turns)[:, np.newaxis], 2, axis=1)
    powers = [10 ** (gain_db(hz) / 10) for hz in np.geomspace(low, high, 2_000)]
    wanted = -0.691 - 20 + 10 * math.log10(np.mean(powers))
    assert figures(samples, rate)["integrated_lufs"] == pytest.approx(wanted, abs=0.03)
