"""`low-level`: files that are too quiet to be used."""

import pytest

from audio_checks import check_file
from audio_checks.spec.delivery_spec import new_spec, parse_spec
from tests.support.waves import click, join, noise, silence, sine, write_wav

LIMIT = "limits.low_level_dbfs = -40.0"


@pytest.mark.parametrize("tables", [LIMIT, ""])
@pytest.mark.parametrize(("dbfs", "codes"), [(-40.1, ["low-level:peak"]), (-40.0, []), (-6.0, [])])
def test_a_file_that_never_reaches_the_limit(codes_of, dbfs, codes, tables):
    assert codes_of("low-level", click(dbfs=dbfs), tables) == codes


def test_the_project_says_what_is_too_quiet(codes_of):
    assert codes_of("low-level", click(dbfs=-30.0), "limits.low_level_dbfs = -24") == ["low-level:peak"]


def test_it_says_by_how_much(found_by):
    (finding,) = found_by("low-level", sine(hz=440, dbfs=-59.6), LIMIT)
    assert finding.message == "peak only -59.6 dBFS, too quiet below -40.0 dBFS"
    assert finding.fix.startswith("raise the level by 19.6 dB or more")
    assert (finding.measured, finding.limit, finding.unit) == (pytest.approx(-59.6, abs=0.05), -40.0, "dBFS")


@pytest.mark.parametrize("samples", [silence(), click(dbfs=-91.0), silence(seconds=1 / 48_000)])
def test_silence_is_left_to_the_silence_check(codes_of, samples):
    assert codes_of("low-level", samples, f"{LIMIT}\nlimits.silence_below_dbfs = -90") == []


def test_nothing_else_is_said_of_what_no_one_hears(tmp_path):
    """A sound that starts in mid-wave, has a click, a hole and a cut end, all 54 dB under a normal level."""
    sound = join(sine(hz=300, dbfs=-6, phase=1.2), silence(seconds=0.02), noise(dbfs=-18), sine(hz=300, phase=0.4))
    sound[24_000] += 0.2
    spec = parse_spec(new_spec())

    def codes(samples):
        report = check_file(write_wav(tmp_path / "laser_fire.wav", samples), spec)
        return {finding.check for finding in report.findings}

    assert codes(sound) >= {"click", "cut-start"}
    assert codes(sound * 10 ** (-54 / 20)) == {"low-level"}
