"""Energies of hops, held to scipy's recursion."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.signal import lfilter

from audio_checks import kernel
from audio_checks.measure.loudness import Loudness, k_weighting
from tests.audio_checks.kernel.signals import Samples, cut, signals


def recursion(rate: int) -> np.ndarray:
    b, a = k_weighting(rate)
    return np.concatenate((b[0] * b[1, 0], a[0, 1:], a[1, 1:]))


def hop_energies(samples: Samples, rate: int, weights: np.ndarray) -> np.ndarray:
    """Weighted energy of every whole hop of 10 ms, the filter run from the first frame to the last."""
    filtered = samples
    for b, a in zip(*k_weighting(rate), strict=True):
        filtered = lfilter(b, a, filtered, axis=0)
    starts = np.arange(0, len(samples) * 100 // rate + 2) * rate
    starts = (2 * starts + 100) // 200
    starts = starts[starts <= len(samples)]
    sums = np.concatenate((np.zeros((1, samples.shape[1])), np.cumsum(np.square(filtered), axis=0)))
    return np.diff(sums[starts], axis=0) @ weights


@pytest.mark.slow
@settings(max_examples=60)
@given(signals(most_frames=4_000), st.sampled_from([1_000, 8_000, 11_025, 44_100, 192_000]), st.integers(0, 99))
def test_every_hop_of_blocks_of_any_length(samples: Samples, rate: int, seed: int):
    channels = samples.shape[1]
    even = channels + channels % 2
    weights = np.zeros(even)
    weights[:channels] = np.linspace(0.5, 1.5, channels)
    memory, open_energies, seen, found = np.zeros(6 * even), np.zeros(even), 0, []
    for block in cut(samples, np.random.default_rng(seed)):
        hops = np.full(len(block) * 100 // rate + 2, np.nan)
        whole = kernel.hop_energies(
            kernel.by_channel(block), recursion(rate), weights, memory, open_energies, hops, rate, seen, len(found)
        )
        found += hops[:whole].tolist()
        seen += len(block)
    wanted = hop_energies(samples, rate, weights[:channels])
    np.testing.assert_allclose(found, wanted, rtol=1e-7, atol=1e-11 * (1 + wanted.max(initial=0)))


def test_loudness_is_that_of_the_serial_recursion():
    # AUDIO's bound for a kernel that works in lanes: 0.001 LU. It is a ten-thousandth of that.
    rng = np.random.default_rng(5)
    samples = rng.standard_normal((96_000, 2)) * np.geomspace(0.3, 0.001, 96_000)[:, np.newaxis]
    meter = Loudness(96_000, 2, len(samples))
    for start in range(0, len(samples), 5_001):
        meter.add(samples[start : start + 5_001])
    hops = hop_energies(samples, 96_000, np.ones(2))
    loudest = max(np.convolve(hops, np.ones(40), "valid")) / 38_400
    assert meter.result()["max_momentary_lufs"] == pytest.approx(-0.691 + 10 * np.log10(loudest), abs=1e-7)


@pytest.mark.parametrize("channels", [1, 2, 3])
@pytest.mark.parametrize("rate", [44_100, 48_000, 96_000])
def test_parts_filtered_at_the_same_time_are_those_of_the_serial_recursion(channels: int, rate: int):
    # Loud and then 100 dB quieter, so that a part would show what it lacks of the one before.
    rng = np.random.default_rng(rate + channels)
    samples = rng.standard_normal((rate * 6 // 5 + 77, channels))
    samples[len(samples) * 3 // 10 :] *= 1e-5
    even = channels + channels % 2
    weights = np.append(np.linspace(0.5, 1.5, channels), 0.0)[:even]

    def hops_of(blocks: list[Samples]) -> list[float]:
        memory, open_energies, found, seen = np.zeros(6 * even), np.zeros(even), [], 0
        for block in blocks:
            hops = np.empty(len(block) * 100 // rate + 2)
            rows = kernel.by_channel(block)
            whole = kernel.hop_energies(
                rows, recursion(rate), weights, memory, open_energies, hops, rate, seen, len(found)
            )
            found += hops[:whole].tolist()
            seen += len(block)
        return found

    serial = hops_of(np.split(samples, range(0, len(samples), rate // 4)))  # too short to be cut into parts
    at_once = hops_of(np.split(samples, [33]))
    np.testing.assert_allclose(at_once, serial, rtol=1e-9)
    wanted = hop_energies(samples, rate, weights[:channels])
    np.testing.assert_allclose(at_once, wanted, rtol=1e-7, atol=1e-11 * wanted.max())


def test_after_the_sound_the_filter_comes_to_rest():
    # Numbers near the smallest that there are would make it a hundred times slower.
    memory, open_energies, hops = np.zeros(12), np.zeros(2), np.zeros(600)
    samples = np.zeros((1, 48_000 * 5))
    samples[0, 0] = 1.0
    kernel.hop_energies(samples, recursion(48_000), np.ones(2), memory, open_energies, hops, 48_000, 0, 0)
    assert not memory.any()
    assert hops[0] > 0
    assert not hops[400:].any()


@pytest.mark.parametrize(("room", "hop", "rate"), [(9, 0, 48_000), (10, 1, 48_000), (10, 0, 99)])
def test_room_for_every_hop_is_wanted(room: int, hop: int, rate: int):
    with pytest.raises(ValueError, match="wanted"):
        kernel.hop_energies(
            np.zeros((1, 4_800)), recursion(48_000), np.ones(2), np.zeros(12), np.zeros(2), np.zeros(room), rate, 0, hop
        )


def window_powers(hops: np.ndarray, first: int, length: int, rate: int, windows: int) -> np.ndarray:
    """Mean power of the last windows, between the differences of running sums."""
    sums = np.concatenate(([0.0], np.cumsum(hops)))
    bounds = (2 * np.arange(first, first + len(hops) + 1) * rate + 100) // 200
    return (np.maximum(sums[length:] - sums[:-length], 0.0) / (bounds[length:] - bounds[:-length]))[-windows:]


@pytest.mark.slow
@given(
    st.integers(1, 700),
    st.sampled_from([1, 2, 40, 300]),
    st.sampled_from([1_000, 11_025, 22_050, 44_100, 48_000, 192_000]),
    st.integers(-300, 10_000_000),
    st.integers(0, 99),
)
def test_windows_of_hops_to_the_last_bit(windows: int, length: int, rate: int, first: int, seed: int):
    rng = np.random.default_rng(seed)
    hops = rng.uniform(0, 1, windows + length - 1 + seed) ** 9
    hops[: len(hops) // 3] = 0.0
    powers = np.full(windows, np.nan)
    highest = kernel.window_loudness(hops, first, length, rate, powers)
    assert powers.tobytes() == window_powers(hops, first, length, rate, windows).tobytes()
    assert highest == powers.max()


@pytest.mark.parametrize(
    ("hops", "length", "rate", "windows"), [(10, 0, 48_000, 4), (10, 8, 48_000, 4), (10, 4, 99, 4)]
)
def test_windows_that_do_not_fit_are_refused(hops, length, rate, windows):
    with pytest.raises(ValueError, match="wanted"):
        kernel.window_loudness(np.ones(hops), 0, length, rate, np.empty(windows))
