"""Sounds of every shape go through everything that is made of a sound, and nothing raises; other seeds each week."""

import datetime as dt

import numpy as np
import pytest

from tests.audio_checks.sound_fuzz import survive
from tests.support.any_sound import any_sound

pytestmark = pytest.mark.slow

SOUNDS, TOGETHER = 300, 10
WEEK = dt.datetime.now(dt.UTC).isocalendar()
FIRST = 10_000_000 + (WEEK.year * 53 + WEEK.week) * 1_000


@pytest.mark.timeout(600)
@pytest.mark.parametrize("first", range(FIRST, FIRST + SOUNDS, TOGETHER))
def test_everything_is_made_of_any_sound(first):
    for seed in range(first, first + TOGETHER):
        try:
            survive(seed, longest_s=4.0)
        except Exception as error:
            raise AssertionError(f"seed {seed}: {any_sound(seed, longest_s=4.0).words}") from error


def test_the_sounds_are_of_every_shape():
    sounds = [any_sound(seed) for seed in range(400)]
    assert {sound.samples.shape[1] for sound in sounds} == set(range(1, 9))
    assert {(sound.bits, sound.encoding) for sound in sounds} == {
        (8, "pcm"), (16, "pcm"), (24, "pcm"), (32, "pcm"), (32, "float"), (64, "float"),
    }  # fmt: skip
    assert len({sound.rate_hz for sound in sounds}) > 15
    lengths = sorted(len(sound.samples) / sound.rate_hz for sound in sounds)
    assert lengths[0] < 0.001
    assert 0.02 < lengths[200] < 0.6
    assert lengths[-1] > 2
    peaks = [float(np.abs(sound.samples).max()) for sound in sounds]
    assert min(peaks) == 0
    assert max(peaks) > 1e6


def test_a_seed_is_one_sound():
    assert any_sound(7).content == any_sound(7).content
