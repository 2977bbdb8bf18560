"""One recording is known again, whatever was done to it; two of the same thing are not."""

import numpy as np
import pytest

from audio_checks.audit.fingerprint import PIECE_BYTES, fingerprint
from audio_checks.audit.likeness import Waves, likeness
from audio_checks.audit.search import Search, cells_of
from benchmarks.audits.changes import CHANGES, TRIMS
from benchmarks.faults.sounds import FAMILIES

RATE = 48_000


def sound(family, seed=1, seconds=1.0, rate=RATE):
    samples = FAMILIES[family](np.random.default_rng(seed), rate, seconds)
    return samples / np.abs(samples).max() * 0.5


def waves(samples, rate=RATE):
    return Waves(fingerprint([samples], rate))


@pytest.mark.parametrize("family", ["footsteps", "bell", "rain", "voice"])
@pytest.mark.parametrize(
    "change", [change for name, change in (CHANGES | TRIMS).items() if name not in ("Ogg Vorbis", "MP3", "Opus")]
)
def test_what_was_changed_is_known_again(family, change):
    samples = sound(family)
    made = change(samples, RATE, np.random.default_rng(5))
    assert likeness(waves(samples), waves(made.samples, made.rate)).is_same_sound


@pytest.mark.parametrize("put_db", [-18.0, -0.3, 0.3, 5.0])
def test_the_gain(put_db):
    samples = sound("footsteps")
    like = likeness(waves(samples), waves(samples * 10 ** (put_db / 20)))
    assert like.gain_db == pytest.approx(put_db, abs=0.1)
    assert like.offset_s == pytest.approx(0, abs=1e-5)
    assert like.tilt_db < 0.3


@pytest.mark.parametrize("cut", [1, 4_803, 20_011])
def test_where_it_begins_to_a_tenth_of_a_millisecond(cut):
    samples = sound("voice")
    like = likeness(waves(samples), waves(samples[cut:]))
    assert like.is_same_sound
    assert like.offset_s == pytest.approx(cut / RATE, abs=1e-4)


def test_what_stands_before_it():
    samples = sound("voice")
    like = likeness(waves(samples), waves(np.concatenate((np.zeros((4_800, samples.shape[1])), samples))))
    assert like.is_same_sound
    assert like.offset_s == pytest.approx(-0.1, abs=1e-4)


def test_an_equaliser_is_distinguished_from_gain():
    samples = sound("rain")
    steep = np.diff(samples, axis=0, prepend=0) * 4  # +6 dB an octave
    assert likeness(waves(samples), waves(steep)).tilt_db > 2


@pytest.mark.slow
@pytest.mark.parametrize("family", ["footsteps", "impact", "rain", "voice", "bell", "wind"])
def test_variations_are_not_the_same(family):
    variations = [waves(sound(family, seed)) for seed in range(6)]
    for variation in variations:
        for other in variations:
            like = likeness(variation, other)
            assert (like is not None and like.is_same_sound) == (variation is other)


def test_a_footstep_on_the_same_floor_is_another():
    # The same bands and the same envelope: only the noise was drawn again.
    fall = np.exp(-np.arange(9_600) / 1_500)[:, np.newaxis]
    one, other = (np.random.default_rng(seed).standard_normal((9_600, 1)) * 0.1 * fall for seed in (1, 2))
    assert not likeness(waves(one), waves(other)).is_same_sound


def test_a_short_tone_is_not_found_in_a_long_one():
    long, short = (np.sin(2 * np.pi * 440 * np.arange(frames) / RATE)[:, np.newaxis] / 2 for frames in (48_000, 9_600))
    assert likeness(waves(long), waves(short)) is None


@pytest.mark.filterwarnings("error")
def test_a_wave_too_faint_for_its_fingerprint_is_like_nothing():
    tone, nothing = waves(sound("bell")), Waves(b"\xff" * PIECE_BYTES * 200)
    assert likeness(tone, nothing) is None
    assert likeness(nothing, tone) is None


def test_a_steady_tone_was_not_moved():
    tone = np.sin(2 * np.pi * 440 * np.arange(48_000) / RATE)[:, np.newaxis] / 2
    like = likeness(waves(tone), waves(tone[:40_000] / 2))
    assert like.is_same_sound
    assert abs(like.offset_s) < 1e-4
    assert like.gain_db == pytest.approx(-6.02, abs=0.1)


def test_another_envelope_on_the_same_tone_is_another_sound():
    tone = np.sin(2 * np.pi * 440 * np.arange(24_000) / RATE)[:, np.newaxis] / 2
    chopped = tone * (np.arange(24_000) // 2_400 % 2 == 0)[:, np.newaxis]
    assert not likeness(waves(tone), waves(chopped)).is_same_sound


@pytest.mark.slow
def test_the_search_puts_the_right_one_first():
    names = [(family, seed) for family in FAMILIES for seed in range(3)]
    sounds = [sound(*name, seconds=0.7) for name in names]
    search = Search([cells_of(waves(one).wave) for one in sounds])
    cut = [cells_of(waves(one[7_001:] * 0.3).wave) for one in sounds]
    found = search.found(cut)
    assert sum(candidates[0] == place for place, candidates in enumerate(found)) >= 0.95 * len(names)
    assert all(place in candidates for place, candidates in enumerate(found))


def test_the_search_in_parts_finds_the_same(monkeypatch):
    cells = [cells_of(waves(sound("footsteps", seed, 0.3)).wave) for seed in range(8)] + [cells_of(np.ones(30, "f4"))]
    whole = Search(cells).found(cells)
    monkeypatch.setattr("audio_checks.audit.search.MOST_ROWS", 20)
    assert Search(cells).found(cells) == whole
