"""`loudness`: between the bounds of the spec."""

import pytest

from tests.support.waves import silence, sine

BOUNDS = "limits.loudness_lufs = { min = -30.0, max = -20.0 }"


@pytest.mark.parametrize(
    ("dbfs", "codes"),
    [(-19.8, ["loudness:over"]), (-20.2, []), (-29.8, []), (-30.2, ["loudness:under"])],
)
def test_bounds(codes_of, dbfs, codes):
    # BS.1770: a stereo tone of 1 kHz reads its own peak level in LUFS.
    assert codes_of("loudness", sine(hz=997, dbfs=dbfs, seconds=2, channels=2), BOUNDS) == codes


def test_mono_is_three_decibels_quieter(codes_of):
    assert codes_of("loudness", sine(hz=997, dbfs=-18.5, seconds=2), BOUNDS) == []


def test_a_sound_under_one_block_has_its_own_figure(found_by):
    # 0.2 s of a tone fill half of the 0.4 s block: 3.01 dB less than if it went on.
    (finding,) = found_by("loudness", sine(hz=997, dbfs=-10.0, seconds=0.2, channels=2), BOUNDS)
    assert finding.measured == pytest.approx(-13.0, abs=0.2)
    assert "loudest 0.4 s" in finding.message


@pytest.mark.parametrize("seconds", [1.0, 1 / 48_000])
def test_silence_is_left_to_the_silence_check(codes_of, seconds):
    assert codes_of("loudness", silence(seconds=seconds), BOUNDS) == []
