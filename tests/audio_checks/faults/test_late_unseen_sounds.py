"""The sounds of the third and the fourth half hold no fault by their making: no detector looks at them here."""

import pickle

import numpy as np
import pytest

from benchmarks.faults import (
    fourth_unseen_sounds,
    known,
    once_unseen_sounds,
    second_unseen_sounds,
    sounds,
    third_unseen_sounds,
    unseen,
)
from benchmarks.faults.sounds import Family, draw

FAMILIES = third_unseen_sounds.FAMILIES | fourth_unseen_sounds.FAMILIES

each_family = pytest.mark.parametrize("family", FAMILIES.values(), ids=FAMILIES)


@each_family
@pytest.mark.parametrize("seconds", [0.5, 1.5])
def test_a_sound_is_whole_centred_and_rises_from_silence_and_falls_to_it(family: Family, seconds: float) -> None:
    sound = family(np.random.default_rng(44_100), 44_100, seconds)
    assert sound.shape in ((44_100 * seconds, 1), (44_100 * seconds, 2))
    assert np.isfinite(sound).all()
    peak = np.abs(sound).max()
    assert peak > 0
    assert np.abs(sound.mean(axis=0)).max() < 0.001 * peak
    assert np.abs(np.concatenate((sound[:20], sound[-20:]))).max() < 0.02 * peak


@each_family
def test_a_drawn_sound_stays_within_full_scale(family: Family) -> None:
    sound, _ = draw(family, 5)
    assert 10 ** (-12.1 / 20) < np.abs(sound).max() < 10 ** (-0.9 / 20)


@each_family
def test_a_seed_gives_its_own_sound_each_time(family: Family) -> None:
    first, again, other = (family(np.random.default_rng(seed), 44_100, 0.3) for seed in (1, 1, 2))
    assert np.array_equal(first, again)
    assert first.shape != other.shape or not np.allclose(first, other)


@each_family
def test_nothing_comes_or_goes_within_a_sample(family: Family) -> None:
    # What does reaches up to half the sample rate; what takes half a millisecond does not.
    sound = family(np.random.default_rng(11), 96_000, 0.5)
    spectrum = np.fft.rfft(sound, axis=0)
    spectrum[np.fft.rfftfreq(len(sound), 1 / 96_000) < 44_000] = 0
    assert np.abs(np.fft.irfft(spectrum, len(sound), axis=0)).max() < 0.008 * np.abs(sound).max()


def test_no_family_is_in_two_parts() -> None:
    parts = (sounds, once_unseen_sounds, second_unseen_sounds, third_unseen_sounds, fourth_unseen_sounds)
    names = [name for part in parts for name in part.FAMILIES]
    assert len(names) == len(set(names))
    assert not unseen.FAMILIES.keys() & (known.FAMILIES | known.CLICK_FAMILIES).keys()


def test_what_is_unseen_can_be_handed_to_other_processes() -> None:
    assert pickle.dumps(unseen.TRIED)  # raises where a family or a fault was made inside a function
