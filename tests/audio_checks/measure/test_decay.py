"""Energy by octave every 5 ms, and the curves of how a sound dies away: held to what theory says."""

import numpy as np
import pytest

from audio_checks.measure.decay import OCTAVES_HZ, Decay
from audio_checks.measure.tails import decay_curves, energy_decay_db, features_of, likeness_of_sides
from tests.support.rooms import hits, in_a_room
from tests.support.waves import join, noise, silence, sine


def decay_of(samples, rate=48_000):
    decay = Decay(rate, samples.shape[1], len(samples))
    decay.add(samples)
    return decay.result()["decay"]


@pytest.mark.parametrize("rate", [22_050, 44_100, 48_000, 96_000, 192_000])
def test_a_tone_has_its_power_in_its_octave(rate):
    figures = decay_of(sine(hz=1_000, dbfs=-6, rate=rate), rate)
    middle = 10 * np.log10(np.median(figures.energies, axis=0))
    assert middle[OCTAVES_HZ.index(1_000)] == pytest.approx(-9.01, abs=0.05)  # the mean square of a sine
    assert np.nanmax(np.delete(middle, OCTAVES_HZ.index(1_000))) < -35
    assert figures.hop_s == pytest.approx(0.005, rel=0.005)


def test_an_octave_above_the_sample_rate_is_unknown():
    figures = decay_of(noise(rate=11_025), 11_025)
    assert np.isnan(figures.energies[:, OCTAVES_HZ.index(8_000)]).all()
    assert not np.isnan(figures.energies[:, OCTAVES_HZ.index(4_000)]).any()


def test_noise_is_flat_flutters_and_has_the_kurtosis_of_chance_and_a_tone_has_not():
    chance, tone = decay_of(noise()), decay_of(sine(hz=2_050))
    octave = OCTAVES_HZ.index(2_000)
    assert np.median(chance.flatness_db[:, octave]) > -4 > -8 > np.median(tone.flatness_db[:, octave])
    assert np.median(chance.flutter_db[:, octave]) > 5 > 1 > np.median(tone.flutter_db[10:-10, octave])
    second, fourth = chance.edges.mean(axis=0)
    assert fourth / second**2 == pytest.approx(3, abs=0.2)


@pytest.mark.parametrize("rt60_s", [0.4, 1.2, 3.0])
def test_noise_that_falls_by_60_db_in_a_known_time(rt60_s):
    sound = noise(dbfs=-12, seconds=rt60_s * 1.2)
    sound *= 10 ** (-3 * np.arange(len(sound)) / 48_000 / rt60_s)[:, np.newaxis]
    bands = {band["hz"]: band for band in decay_curves(decay_of(sound))["bands"]}
    for hz in (1_000, 2_000, 4_000, 8_000):
        assert bands[hz]["rt60_s"] == pytest.approx(rt60_s, rel=0.15)
        assert bands[hz]["rate_db_s"] == pytest.approx(-60 / rt60_s, rel=0.15)
        assert bands[hz]["curve_db"][0] == 0
        assert bands[hz]["curve_db"] == sorted(bands[hz]["curve_db"], reverse=True)
        assert len(bands[hz]["curve_db"]) <= 61


def test_what_is_still_to_come_of_a_straight_fall_falls_as_straight():
    curve = energy_decay_db(np.arange(0, -120, -0.5))
    assert np.diff(curve)[:100] == pytest.approx(-0.5, abs=0.01)


def test_equal_channels_are_alike_and_those_of_chance_are_not():
    together, apart = noise(seconds=1), noise(seconds=1, channels=2)
    fall = 10 ** (-2 * np.arange(48_000) / 48_000)[:, np.newaxis]
    same = likeness_of_sides(decay_of(np.repeat(together, 2, axis=1) * fall))
    other = likeness_of_sides(decay_of(apart * fall))
    assert all(band["tail"] == 1 for band in same)
    assert max(band["tail"] for band in other if band["hz"] >= 500) < 0.5
    assert likeness_of_sides(decay_of(together)) is None


@pytest.mark.parametrize(
    "samples",
    [silence(), silence(seconds=0), sine(hz=997, seconds=0.02), noise(dbfs=-195, seconds=0.3)],
    ids=["silence", "empty", "short", "under all levels"],
)
def test_nothing_to_say(samples):
    assert features_of(decay_of(samples)) is None


def test_features_do_not_depend_on_level_or_on_silence_around():
    dry = hits() + noise(dbfs=-80, seconds=2.0)
    known = features_of(decay_of(dry))
    quieter = features_of(decay_of(join(silence(seconds=0.2), dry * 0.1)))
    assert quieter == pytest.approx(known, abs=0.05, nan_ok=True)
    assert len(known) == len(features_of(decay_of(in_a_room(np.repeat(dry, 2, axis=1)))))
