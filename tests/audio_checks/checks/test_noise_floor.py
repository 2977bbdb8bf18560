"""`noise-floor`: the level of the pauses."""

import numpy as np
import pytest

import audio_checks
from tests.support.waves import join, noise, silence, sine, write_wav

LIMIT = "limits.noise_floor_dbfs = -60.0"
OVER = ["noise-floor:over"]


def synthesize_speech(floor_dbfs, channels=1):
    """A word, a pause of half a second and another word, over noise."""
    word = sine(hz=300, dbfs=-12, seconds=0.5, channels=channels)
    whole = join(word, silence(seconds=0.5, channels=channels), word)
    return whole + noise(dbfs=floor_dbfs, seconds=1.5, channels=channels)


@pytest.mark.parametrize(("dbfs", "codes"), [(-58.5, OVER), (-61.5, [])])
@pytest.mark.parametrize("channels", [1, 2])
def test_the_limit_of_the_spec(codes_of, dbfs, codes, channels):
    assert codes_of("noise-floor", synthesize_speech(dbfs, channels), LIMIT) == codes


def test_it_is_measured(found_by):
    (finding,) = found_by("noise-floor", synthesize_speech(-45.0), LIMIT)
    assert finding.measured == pytest.approx(-45.0, abs=0.5)  # the quietest of the pause's 0.2 s
    assert "15." in finding.fix or "14." in finding.fix


def test_the_noisiest_channel_counts(codes_of):
    samples = synthesize_speech(-70.0, channels=2)
    samples[:, 1:] = synthesize_speech(-50.0)
    assert codes_of("noise-floor", samples, LIMIT) == OVER


def test_a_sound_that_dies_away_has_no_floor(codes_of):
    times = np.arange(96_000) / 48_000
    assert codes_of("noise-floor", noise(dbfs=-10, seconds=2) * 10 ** (-times * 20 / 20)[:, np.newaxis], LIMIT) == []


@pytest.mark.parametrize(
    "samples", [silence(), silence(seconds=1 / 48_000) + 0.5, noise(seconds=2), join(sine(hz=300), silence())]
)
def test_without_a_noisy_pause_nothing_is_found(codes_of, samples):
    assert codes_of("noise-floor", samples, LIMIT) == []


def test_only_where_the_spec_limits_it(codes_of):
    assert codes_of("noise-floor", synthesize_speech(-30.0)) == []


@pytest.mark.parametrize("seconds", [0.4, 0.42, 0.46, 0.5, 0.59, 0.6, 0.61])
def test_a_pause_too_near_both_ends_for_another_beside_it(found_by, seconds):
    pause_s = 0.21  # so that 20 whole steps of 10 ms lie in it, wherever it begins
    word = sine(hz=300, dbfs=-12, seconds=(seconds - pause_s) / 2, channels=2)
    whole = join(word, silence(seconds=pause_s, channels=2), word) + noise(dbfs=-45, seconds=seconds, channels=2)
    (finding,) = found_by("noise-floor", whole, LIMIT)
    assert finding.measured == pytest.approx(-45.0, abs=0.5)


def test_a_pause_whose_squares_have_no_digits_beside_the_sound(tmp_path):
    whole = join(noise(dbfs=0, seconds=0.45), noise(dbfs=-170, seconds=0.3))
    path = write_wav(tmp_path / "deep.wav", whole, bits=64, encoding="float")
    assert audio_checks.measure_file(path).measurements["noise_floor_dbfs"] == pytest.approx(-170, abs=0.5)
