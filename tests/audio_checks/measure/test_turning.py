"""How a sound rises against how it falls: opposite from the other end, by the way the figures are made."""

import numpy as np
import pytest

from audio_checks.measure.decay import Decay
from audio_checks.measure.turning import features_of, rises_and_falls
from tests.support.rooms import hits
from tests.support.waves import noise, silence, sine


def decay_of(samples, rate=48_000):
    following = Decay(rate, samples.shape[1], len(samples))
    following.add(samples)
    return following.result()["decay"]


def test_a_reversed_sound_has_the_opposite_features():
    # Whole hops and silence at both ends, so that both are cut into the same windows.
    samples = np.concatenate((silence(seconds=0.005), hits(seconds=1.5), silence(seconds=0.005)))[:72_000]
    forwards, backwards = features_of(decay_of(samples)), features_of(decay_of(samples[::-1]))
    known = ~np.isnan(forwards)
    assert np.array_equal(known, ~np.isnan(backwards))
    # Of four equal knocks the first one met is the top: a turn does not show where that lies in time.
    known &= ~np.isin(np.arange(len(known)), [11, 12, 24, 25, 37, 38])
    off = np.abs(forwards + backwards)[known] / (np.abs(forwards - backwards)[known] / 2 + 0.5)
    assert off.max() < 0.5


def test_nothing_to_report():
    for samples in (silence(), silence(seconds=0), sine(hz=997, seconds=0.02)):
        assert features_of(decay_of(samples)) is None
        assert rises_and_falls(decay_of(samples)) == []


def test_steady_noise_leans_neither_way():
    (rise, fall) = np.median(
        [(band["rise_db_s"], band["fall_db_s"]) for band in rises_and_falls(decay_of(noise(seconds=2)))], axis=0
    )
    assert rise == pytest.approx(fall, rel=0.35)
