"""Correlation, and stereo in mono: closed forms, and where the loss is."""

import numpy as np
import pytest

from audio_checks.measure.phase import Phase
from tests.support.waves import join, noise, silence, sine


def measured(samples, block_frames=65_536):
    phase = Phase(48_000, samples.shape[1], len(samples))
    for start in range(0, len(samples), block_frames):
        phase.add(samples[start : start + block_frames])
    return phase.result()


def stereo(left, right):
    return np.hstack([left, right])


TONE = sine(hz=997)


@pytest.mark.parametrize(
    ("samples", "loss_db", "difference_db"),
    [
        (stereo(TONE, TONE), 0.0, -np.inf),
        (stereo(TONE, -TONE), 120.0, 6.02),
        (stereo(TONE, 0 * TONE), 3.01, 0.0),
        (stereo(TONE, TONE * 0.999), 0.0, -60.0),
        (stereo(TONE, sine(hz=997, phase=np.pi / 2)), 3.01, 3.01),
        (stereo(TONE, sine(hz=997, phase=2 * np.pi / 3)), 6.02, 4.77),
    ],
)
def test_closed_forms(samples, loss_db, difference_db):
    figures = measured(samples)
    assert figures["mono_loss_db"] == pytest.approx(loss_db, abs=0.01)
    assert figures["channel_difference_db"] == pytest.approx(difference_db, abs=0.01)


def test_unrelated_channels_lose_3_db():
    assert measured(noise(channels=2, seconds=4))["mono_loss_db"] == pytest.approx(3.01, abs=0.1)


@pytest.mark.parametrize("samples", [silence(channels=2), noise(), noise(channels=6, seconds=0.1)])
def test_silence_and_other_channels_have_none(samples):
    figures = measured(samples)
    assert {figures[name] for name in ("mono_loss_db", "channel_difference_db", "mono_loss_spans")} == {None}


def test_one_frame():
    assert measured(np.array([[0.5, -0.5]]))["mono_loss_db"] == 120.0
    assert measured(np.array([[0.5, -0.5]]))["mono_loss_spans"](6) == [(0.0, pytest.approx(1 / 48_000))]


def test_where_it_is_lost():
    whole = join(
        stereo(TONE, TONE), stereo(TONE, -TONE), silence(seconds=0.5, channels=2), stereo(TONE, -TONE)[:12_000]
    )
    spans = measured(whole)["mono_loss_spans"]
    assert spans(6) == [pytest.approx((1.0, 2.0)), pytest.approx((2.5, 2.75))]
    assert spans(130) == spans(6)  # nothing at all is left there


@pytest.mark.parametrize("block_frames", [1, 999, 4_800, 48_000])
def test_blocks_make_no_difference(block_frames):
    samples = noise(channels=2, seconds=0.33)
    whole, pieces = measured(samples), measured(samples, block_frames)
    assert pieces["mono_loss_db"] == pytest.approx(whole["mono_loss_db"], abs=1e-9)
    assert pieces["mono_loss_spans"](2.9) == whole["mono_loss_spans"](2.9)


def correlation(samples):
    return measured(samples)["channel_correlation"]


def test_correlation():
    one, other = noise(channels=2).T
    assert correlation(np.stack((one, one), axis=1)) == pytest.approx(1)
    assert correlation(np.stack((one, -0.3 * one), axis=1)) == pytest.approx(-1)
    assert correlation(np.stack((one, other), axis=1)) == pytest.approx(0, abs=0.02)
    assert correlation(np.stack((one, one, -one), axis=1)) == pytest.approx(-1)
    assert correlation(np.stack((one, 0 * one), axis=1)) is None
    assert correlation(np.stack((one, 0 * one, 0 * one), axis=1)) is None
    assert correlation(one[:, np.newaxis]) is None
    assert correlation(silence(channels=2)) is None
