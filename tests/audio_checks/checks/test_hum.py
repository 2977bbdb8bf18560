"""`hum`: steady lines at multiples of the mains."""

import numpy as np
import pytest

from tests.support.waves import noise, silence, sine

MAINS = ["hum:mains"]


def hum(hz=50.0, dbfs=-50.0, seconds=3.0, multiples=(1, 2, 3, 5), channels=1):
    """Lines of equal level whose RMS together is `dbfs`."""
    each = dbfs + 3.01 - 10 * np.log10(len(multiples))
    return sum(
        sine(hz=hz * multiple, dbfs=each, seconds=seconds, channels=channels, phase=multiple) for multiple in multiples
    )


def sound(seconds=3.0, channels=1):
    """Noise that comes and goes once a second."""
    times = np.arange(round(seconds * 48_000)) / 48_000
    return noise(dbfs=-30, seconds=seconds, channels=channels) * np.clip(np.sin(2 * np.pi * times), 0, 1)[:, np.newaxis]


@pytest.mark.parametrize("hz", [49.55, 49.9, 50.0, 60.0, 60.1, 60.55])
@pytest.mark.parametrize("channels", [1, 2])
def test_hum_is_found_and_measured(found_by, hz, channels):
    (finding,) = found_by("hum", sound(channels=channels) + hum(hz, channels=channels))
    assert finding.code == "hum:mains"
    assert f"{round(hz, -1):g} Hz" in finding.message
    assert finding.measured == pytest.approx(-50, abs=1)
    assert (finding.start_s, finding.end_s) == (0, 3)


@pytest.mark.parametrize(("dbfs", "codes"), [(-69.0, MAINS), (-71.0, [])])
def test_quieter_than_minus_70_dbfs_counts_for_nothing(codes_of, dbfs, codes):
    assert codes_of("hum", hum(dbfs=dbfs)) == codes


@pytest.mark.parametrize(("hz", "codes"), [(50.15, MAINS), (49.0, []), (51.9, []), (58.27, []), (61.74, [])])
def test_notes_near_the_mains_are_no_hum(codes_of, hz, codes):
    assert codes_of("hum", sound() + hum(hz)) == codes


@pytest.mark.parametrize(
    ("multiples", "codes"), [((1, 2, 3), MAINS), ((2, 4, 6), MAINS), ((1, 2), []), ((4, 5, 6), [])]
)
def test_three_lines_make_a_hum(codes_of, multiples, codes):
    assert codes_of("hum", sound() + hum(multiples=multiples)) == codes


# What three phases leave in their neutral: a tone on 150 Hz alone, without the mains themselves, may be meant.
@pytest.mark.parametrize(
    ("multiples", "codes"), [((1, 3, 9, 15), MAINS), ((1, 3, 15), MAINS), ((3, 9, 15), []), ((1, 9, 11), [])]
)
@pytest.mark.parametrize("hz", [49.7, 60.0])
def test_the_third_multiple_and_its_odd_ones_beside_the_mains(codes_of, hz, multiples, codes):
    assert codes_of("hum", sound() + hum(hz, multiples=multiples)) == codes


def strokes(seconds=3.0):
    """Bursts of noise eight times a second, so that every window of a fifth of a second holds one or two."""
    times = np.arange(round(seconds * 48_000)) / 48_000
    return noise(dbfs=-14, seconds=seconds) * np.exp(-(times % 0.125) / 0.015)[:, np.newaxis]


@pytest.mark.parametrize("hz", [49.9, 60.1])
def test_hum_between_strokes_is_found_by_its_phase(found_by, hz):
    assert found_by("hum", strokes()) == []
    (finding,) = found_by("hum", strokes() + hum(hz, dbfs=-54))
    assert f"{round(hz, -1):g} Hz" in finding.message
    assert finding.measured == pytest.approx(-54, abs=0.5)


def test_what_comes_and_goes_is_no_hum(codes_of):
    played = hum(dbfs=-20)
    played[48_000:] = 0
    assert codes_of("hum", played) == []


@pytest.mark.parametrize(("seconds", "codes"), [(1.1, MAINS), (0.9, [])])
def test_a_second_is_needed_to_distinguish_it_from_a_note(codes_of, seconds, codes):
    assert codes_of("hum", hum(seconds=seconds)) == codes


@pytest.mark.parametrize("samples", [silence(seconds=2), silence(seconds=1 / 48_000) + 0.5, sound(), sound(channels=2)])
def test_sounds_without_hum_pass(codes_of, samples):
    assert codes_of("hum", samples) == []
