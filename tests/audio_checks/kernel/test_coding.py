"""Rounding, runs of silence and bytes of PCM, held to plain numpy."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from audio_checks import kernel

DEPTHS = [8, 12, 16, 20, 24, 32]


@pytest.mark.parametrize("channels", [1, 2, 3])
@pytest.mark.parametrize("frames", [0, 1, 1_003])
def test_steps_with_noise_and_silence(channels: int, frames: int) -> None:
    rng = np.random.default_rng(frames + channels)
    samples = rng.uniform(-1.2, 1.2, (channels, frames))
    words = rng.integers(0, 2**64, (frames, channels), dtype=np.uint64, endpoint=False)
    silent = (rng.uniform(0, 1, samples.shape) < 0.1).astype(np.uint8)
    noise = ((words >> 32).astype(float) - (words & 0xFFFFFFFF)).T / 2**32
    wanted = np.where(silent, 0, np.floor(samples * 32_768 + noise + 0.5))
    steps = np.empty(samples.shape, np.int64)
    energy = kernel.rounded_steps(samples, 32_768.0, words.ravel(), silent, steps)
    np.testing.assert_array_equal(steps, wanted)
    assert energy == pytest.approx(np.square(wanted - samples * 32_768).sum(), rel=1e-12)


def test_steps_without_noise_are_the_nearest_and_stay_whole_numbers_however_loud() -> None:
    samples = np.array([[0.5, -0.5, 1.4 / 128, -1.6 / 128, 1e300, -1e300]])
    steps = np.empty(samples.shape, np.int64)
    kernel.rounded_steps(samples, 128.0, None, None, steps)
    assert steps.tolist() == [[64, -64, 1, -2, 2**62, -(2**62)]]


@pytest.mark.slow
@given(st.lists(st.booleans(), min_size=6, max_size=60), st.integers(0, 3), st.integers(1, 5))
def test_zeros_in_long_runs_are_silent(sounding: list[bool], margin: int, run: int) -> None:
    zero = [not sounds for sounds in sounding]

    def in_a_run(at: int) -> bool:
        starts = range(max(0, at - run + 1), min(at, len(zero) - run) + 1)
        return any(all(zero[start : start + run]) for start in starts)

    marks = np.full((2, len(zero) - 2 * margin), 9, np.uint8)
    kernel.silent_runs(np.array([sounding, [True] * len(zero)], dtype=float), margin, run, marks)
    assert marks[0].tolist() == [in_a_run(at) for at in range(margin, len(zero) - margin)]
    assert not marks[1].any()


@pytest.mark.slow
@given(st.data(), st.sampled_from(DEPTHS), st.integers(1, 4), st.integers(0, 20))
def test_bytes_of_any_depth(data: st.DataObject, bits: int, channels: int, frames: int) -> None:
    most = 1 << (bits - 1)
    values = st.lists(st.integers(-most, most - 1), min_size=channels * frames, max_size=channels * frames)
    steps = np.array(data.draw(values), np.int64).reshape(channels, frames)
    width = -(-bits // 8)
    wanted = (steps.T << (8 * width - bits)) + (128 if width == 1 else 0)
    out = bytearray(steps.size * width)
    assert kernel.encode_pcm(steps, channels, bits, out)
    assert out == b"".join(int(one).to_bytes(width, "little", signed=width > 1) for one in wanted.ravel())


@pytest.mark.parametrize("bits", DEPTHS)
@pytest.mark.parametrize("by", [0, 1 << 40])
def test_what_does_not_fit_into_the_bits_is_reported(bits: int, by: int) -> None:
    most = 1 << (bits - 1)
    for value in (most + by, -most - 1 - by):
        steps = np.array([[0, value, 0]], np.int64)
        assert not kernel.encode_pcm(steps, 1, bits, bytearray(3 * (-(-bits // 8))))


def test_what_does_not_fit_together_is_refused() -> None:
    block, steps = np.zeros((2, 10)), np.zeros((2, 10), np.int64)
    with pytest.raises(ValueError, match="wanted"):
        kernel.rounded_steps(block, 1.0, np.zeros(19, np.uint64), None, steps)
    with pytest.raises(ValueError, match="wanted"):
        kernel.rounded_steps(block, 1.0, None, np.zeros(19, np.uint8), steps)
    with pytest.raises(ValueError, match="wanted"):
        kernel.rounded_steps(block, 1.0, None, None, steps[:1])
    with pytest.raises(ValueError, match="wanted"):
        kernel.silent_runs(block, 6, 1, np.zeros(0, np.uint8))
    with pytest.raises(ValueError, match="wanted"):
        kernel.silent_runs(block, 1, 1, np.zeros((2, 10), np.uint8))
    with pytest.raises(ValueError, match="wanted"):
        kernel.encode_pcm(steps, 3, 16, bytearray(40))
    with pytest.raises(ValueError, match="wanted"):
        kernel.encode_pcm(steps, 2, 33, bytearray(100))
    with pytest.raises(ValueError, match="wanted"):
        kernel.encode_pcm(steps, 2, 16, bytearray(39))
