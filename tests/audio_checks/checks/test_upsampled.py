"""`upsampled`: a question, only where the spec names it."""

import pytest
from scipy import signal

from tests.support.waves import noise, silence

ASKED = "checks.upsampled = 'warning'"
CLIFF = ["upsampled:cliff"]
FULL = noise()
BROUGHT_UP = signal.resample(noise(rate=22_050), 48_000, axis=0)


@pytest.mark.parametrize(
    ("samples", "codes"),
    [(BROUGHT_UP, CLIFF), (FULL, []), (silence(), []), (silence(seconds=1 / 48_000) + 0.5, [])],
    ids=["brought up", "full", "silence", "one frame"],
)
def test_only_what_ends_in_a_cliff(codes_of, samples, codes):
    assert codes_of("upsampled", samples, ASKED) == codes


@pytest.mark.parametrize(("tables", "codes"), [("", []), (ASKED, CLIFF)])
def test_only_where_the_spec_asks(codes_of, tables, codes):
    assert codes_of("upsampled", BROUGHT_UP, tables) == codes


def test_it_asks_with_its_figures(found_by):
    (finding,) = found_by("upsampled", BROUGHT_UP, ASKED)
    assert "from 22050 Hz?" in finding.message
    assert finding.measured == pytest.approx(11_025, rel=0.06)
    assert (finding.limit, finding.unit) == (24_000, "Hz")


def test_where_no_common_rate_ends_it_asks_for_the_source(found_by):
    odd = signal.resample(noise(rate=48_000, seconds=0.5), 32_727, axis=0)  # ends at 17.6 kHz
    (finding,) = found_by("upsampled", odd, ASKED)
    assert finding.message.endswith("was it brought up, or pitched down?")
