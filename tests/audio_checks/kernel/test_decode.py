"""Decoding, held to a plain numpy reference."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from audio_checks import kernel

FLOATS = st.floats(width=32) | st.sampled_from([float("nan"), float("inf"), -float("inf"), 1e-45, -0.0, 2.0**64])


def integers(raw: bytes, bits: int) -> NDArray[np.integer]:
    """Interleaved PCM as signed integers; of 24 bits, the upper three bytes of 32."""
    if bits == 8:
        return (np.frombuffer(raw, np.uint8) ^ 0x80).view(np.int8)
    if bits == 24:
        wide = np.zeros((len(raw) // 3, 4), np.uint8)
        wide[:, 1:] = np.frombuffer(raw, np.uint8).reshape(-1, 3)
        return wide.view("<i4")[:, 0]
    return np.frombuffer(raw, f"<i{bits // 8}")


@pytest.mark.slow
@given(st.data(), st.sampled_from([8, 16, 24, 32]), st.integers(1, 8), st.integers(0, 70))
def test_pcm_of_any_depth_and_any_number_of_channels(data, bits: int, channels: int, frames: int):
    size = channels * frames * bits // 8
    raw = data.draw(st.binary(min_size=size, max_size=size))
    block = np.full((channels, frames), np.nan)
    used = kernel.decode_pcm(raw, bits, block)
    whole = integers(raw, bits)
    scale = 2.0 ** (1 - 8 * whole.itemsize)
    np.testing.assert_array_equal(block, whole.reshape(-1, channels).T * scale)
    assert used == int(np.bitwise_or.reduce(whole, initial=0))


@pytest.mark.parametrize("bits", [8, 16, 24, 32])
def test_full_scale_is_one(bits: int):
    lowest = b"\x00" if bits == 8 else bytes(bits // 8 - 1) + b"\x80"
    highest = b"\xff" if bits == 8 else b"\xff" * (bits // 8 - 1) + b"\x7f"
    block = np.empty((1, 2))
    kernel.decode_pcm(lowest + highest, bits, block)
    assert block.tolist() == [[-1.0, 1 - 2.0 ** (1 - bits)]]


@pytest.mark.slow
@given(st.sampled_from([32, 64]), st.integers(1, 8), st.lists(FLOATS, max_size=90))
def test_floats_and_what_is_no_number(bits: int, channels: int, values: list[float]):
    frames = len(values) // channels
    interleaved = np.array(values[: frames * channels], f"<f{bits // 8}").reshape(-1, channels)
    block = np.zeros((channels, frames))
    broken = kernel.decode_float(interleaved.tobytes(), bits, block)
    sound = (np.abs(interleaved) < 2.0**64).all(axis=0)
    wrong = int(np.argmin(sound))
    endless = not sound.all() and not np.isfinite(interleaved[:, wrong]).all()
    assert broken == (0 if sound.all() else wrong + 1 if endless else -(wrong + 1))
    if not broken:
        np.testing.assert_array_equal(block, interleaved.T)


def test_rows_may_stand_apart():
    wide = np.zeros((2, 10))
    kernel.decode_pcm(b"\x00\x40\x00\xc0" * 3, 16, wide[:, 2:5])
    assert wide.tolist() == [[0, 0, 0.5, 0.5, 0.5, 0, 0, 0, 0, 0], [0, 0, -0.5, -0.5, -0.5, 0, 0, 0, 0, 0]]


@pytest.mark.parametrize(
    ("raw", "bits", "block"),
    [
        (b"\0" * 5, 16, np.zeros((1, 3))),
        (b"\0" * 4, 16, np.zeros((1, 3))),
        (b"\0" * 6, 20, np.zeros((1, 3))),
        (b"\0" * 6, 16, np.zeros((3, 1), np.float32)),
        (b"\0" * 6, 16, np.zeros((3, 2)).T[:, :3]),
        (b"\0" * 6, 16, np.zeros(3)),
    ],
)
def test_what_does_not_fit_is_refused(raw: bytes, bits: int, block: NDArray[np.floating]):
    with pytest.raises(ValueError, match="wanted"):
        kernel.decode_pcm(raw, bits, block)


@pytest.mark.parametrize("bits", [-64, 0, 16, 40, 48, 72, 1 << 40])
def test_floats_of_other_sizes_are_refused(bits: int):
    with pytest.raises(ValueError, match="32 or 64 are wanted"):
        kernel.decode_float(bytes(64), bits, np.zeros((1, 8)))
