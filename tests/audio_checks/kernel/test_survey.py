"""A survey, in doubles and in whole numbers, held to what each loop finds alone."""

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from numpy.typing import NDArray

from audio_checks import kernel
from audio_checks.measure.maxima import maxima_of
from tests.audio_checks.kernel.signals import Samples, signals

HISTORY = 6
PIECE = 16_192  # frames of 16 bit that are measured together, with cells of 22 frames
LOUDEST, DEEPEST = 32_767, -32_768
Whole = NDArray[np.int16]


def surveyed(raw: bytes, bits: int, floats: bool, whole: Samples, size: int, hops: tuple[Samples, int, int] | None):
    """Maxima, figures and cells of what is decoded behind the history that `whole` has; then what it returns."""
    channels, frames = len(whole), len(raw) * 8 // bits // len(whole)
    maxima, figures = np.empty((channels, -(-frames // 32))), np.zeros((channels, 3))
    cells = np.empty((5 * channels, frames // size))
    given_hops = hops or (None, 1, 0)
    said = kernel.survey(raw, bits, floats, whole, HISTORY, maxima, figures, cells, size, *given_hops)
    return maxima, figures, cells, said


@pytest.mark.slow
@given(signals(most_frames=5_000, most_channels=4), st.integers(1, 50), st.sampled_from([True, False]))
def test_a_survey_finds_what_each_loop_finds_alone(samples: Samples, size: int, floats: bool):
    channels, frames = samples.shape[1], len(samples)
    raw, bits = (samples.astype("<f8"), 64) if floats else ((samples * 2**24).astype("<i4"), 32)
    whole, block = np.zeros((channels, HISTORY + frames + 10)), np.zeros((channels, frames))
    maxima, figures, cells, said = surveyed(raw.tobytes(), bits, floats, whole, size, None)
    if floats:
        assert said == (0, kernel.decode_float(raw.tobytes(), 64, block))
    else:
        assert said == (kernel.decode_pcm(raw.tobytes(), 32, block), 0)
    np.testing.assert_array_equal(whole[:, HISTORY : HISTORY + frames], block)
    np.testing.assert_array_equal(maxima, maxima_of(block))
    alone, sums = np.empty_like(cells), np.zeros((channels, 2))
    kernel.cells(whole, HISTORY, size, alone)
    np.testing.assert_array_equal(cells, alone[:, : frames // size])
    kernel.sums(block, sums)
    np.testing.assert_allclose(figures[:, :2], sums, rtol=1e-11, atol=1e-9 * (1 + np.abs(block).max(initial=0)))
    np.testing.assert_array_equal(figures[:, 2], np.abs(block).max(axis=1, initial=0))


@st.composite
def sixteen_bits(draw: st.DrawFn) -> Whole:
    """Samples of shape (frames, channels) of any level, with runs of the largest and deepest there are."""
    near_a_piece = st.integers(PIECE - 20, PIECE + 20)
    frames = draw(st.one_of(st.integers(0, 70), st.integers(0, 3_000), near_a_piece))
    channels = draw(st.integers(1, 8))
    rng = np.random.default_rng(draw(st.integers(0, 2**32 - 1)))
    samples = (rng.uniform(-1, 1, (frames, channels)) * draw(st.sampled_from([3, 900, LOUDEST]))).astype(np.int16)
    for _ in range(draw(st.integers(0, 4)) if frames else 0):
        start, length = draw(st.integers(0, frames - 1)), draw(st.integers(1, 300))
        samples[start : start + length] = draw(st.sampled_from([0, LOUDEST, DEEPEST]))
        samples[start : start + length : 2] *= draw(st.sampled_from([1, 0, -1]))
    return samples


@pytest.mark.slow
@given(
    sixteen_bits(),
    st.integers(1, 140),
    st.sampled_from([0.0, 1.0 - 2**-15, -1.0, 0.3]),
    st.integers(1, 5_000),
    st.integers(0, 4_999),
)
@example(np.full((2 * PIECE + 1, 2), DEEPEST, np.int16), 22, -1.0, 4_410, 7)
@example(np.tile([[DEEPEST, LOUDEST], [LOUDEST, DEEPEST]], (1_000, 1)).astype(np.int16), 128, 0.0, 4_410, 0)
def test_whole_numbers_give_the_same_bits_as_doubles(samples: Whole, size: int, before: float, hop: int, at: int):
    frames, channels = samples.shape
    raw, at = samples.astype("<i2").tobytes(), at % hop
    whole = np.zeros((channels, HISTORY + frames + 10))
    whole[:, :HISTORY] = before  # 0.3 is not a whole number of steps
    hops = np.full((frames // hop + 2, 4), 0.25)
    compared = hops.copy()
    maxima, figures, cells, said = surveyed(raw, 16, False, whole, size, (hops, hop, at) if channels == 2 else None)
    block = samples.T / 2.0**15
    np.testing.assert_array_equal(whole[:, HISTORY : HISTORY + frames], block)
    assert said == (int(np.bitwise_or.reduce(samples, axis=None)), 0)
    alone, sums = np.empty_like(cells), np.zeros((channels, 2))
    kernel.cells(whole, HISTORY, size, alone)
    kernel.sums(kernel.by_channel(samples / 2.0**15), sums)
    assert cells.tobytes() == alone.tobytes()
    assert maxima.tobytes() == maxima_of(kernel.by_channel(samples / 2.0**15)).tobytes()
    np.testing.assert_array_equal(figures, np.column_stack((sums, np.abs(block).max(axis=1, initial=0))))
    if channels == 2:
        kernel.stereo_products(kernel.by_channel(samples / 2.0**15), at, hop, compared)
        assert hops.tobytes() == compared.tobytes()


@pytest.mark.slow
@given(signals(most_frames=5_000, most_channels=3), sixteen_bits(), st.integers(4, 60))
def test_the_sums_of_cells_alone_have_the_same_bits(samples: Samples, sixteen: Whole, size: int):
    sounds = ((samples * 2**24).astype("<i4"), 32), (samples.astype("<f8"), 64), (sixteen.astype("<i2"), 16)
    for sound, bits in sounds:
        channels, frames = sound.shape[1], len(sound)
        wanted, alone = np.empty((5 * channels, frames // size)), np.empty((2 * channels, frames // size))
        for cells in (wanted, alone):
            whole, maxima = np.zeros((channels, HISTORY + frames)), np.empty((channels, -(-frames // 32)))
            given_cells = cells, size, None, 1, 0
            kernel.survey(
                sound.tobytes(), bits, bits == 64, whole, HISTORY, maxima, np.zeros((channels, 3)), *given_cells
            )
        assert alone.tobytes() == wanted[: 2 * channels].tobytes()


HOPS = np.zeros((2, 4))


@pytest.mark.parametrize(
    ("raw", "bits", "floats", "first", "maxima", "cells", "cell", "hops"),
    [
        (81, 16, False, 6, 2, 10, 10, None),
        (80, 16, False, 5, 1, 10, 10, None),
        (80, 16, False, 27, 1, 10, 10, None),
        (80, 16, False, 6, 1, 10, 5, None),
        (80, 16, False, 6, 1, 9, 10, None),
        (80, 16, False, 6, 1, 4, 3, None),
        (80, 12, False, 6, 1, 10, 10, None),
        (80, 16, True, 6, 1, 10, 10, None),
        (80, 16, False, 6, 0, 10, 10, None),
        (80, 16, False, 6, 1, 10, 0, None),
        (80, 16, False, 6, 1, 10, 10, (HOPS, 9, 0)),
        (80, 16, False, 6, 1, 10, 10, (HOPS, 10, 1)),
        (80, 16, False, 6, 1, 10, 10, (HOPS, 10, -1)),
        (80, 16, False, 6, 1, 10, 10, (HOPS, 20, 20)),
        (80, 16, False, 6, 1, 10, 10, (HOPS[:, :3], 20, 0)),
        (80, 16, False, 6, 1, 10, 10, (HOPS, 0, 0)),
    ],
)
def test_a_survey_refuses_what_does_not_fit(raw, bits, floats, first, maxima, cells, cell, hops):
    whole, figures = np.zeros((2, 46)), np.zeros(6)
    with pytest.raises(ValueError, match="wanted"):
        kernel.survey(
            bytes(raw),
            bits,
            floats,
            whole,
            first,
            np.empty((2, maxima)),
            figures,
            np.empty((cells, 2)),
            cell,
            *(hops or (None, 1, 0)),
        )


def test_only_two_channels_can_be_compared():
    with pytest.raises(ValueError, match="two channels"):
        kernel.survey(bytes(80), 16, False, np.zeros((1, 46)), 6, np.empty((1, 2)), np.zeros(3), None, 1, HOPS, 40, 0)
