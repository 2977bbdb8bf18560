"""`sample-rate`: one of the accepted rates."""

import pytest

from tests.support.waves import silence

ACCEPTED = "accept.sample_rates_hz = [48000, 96000]"
TARGET = "targets.game = { sample_rate_hz = 44100, bit_depth = 24 }"


@pytest.mark.parametrize(
    ("rate", "codes"),
    [
        (48_000, []),
        (96_000, []),
        (44_100, ["sample-rate:not-accepted"]),
        (47_999, ["sample-rate:not-accepted"]),
        (192_000, ["sample-rate:not-accepted"]),
    ],
)
def test_rates(codes_of, rate, codes):
    assert codes_of("sample-rate", silence(seconds=0.01), ACCEPTED, rate=rate) == codes


def test_converting_up_is_never_advised(found_by):
    (finding,) = found_by("sample-rate", silence(seconds=0.01, channels=2), ACCEPTED, rate=22_050)
    assert "do not convert this file up" in finding.fix
    assert (finding.measured, finding.limit, finding.unit) == (22_050.0, 48_000.0, "Hz")


def test_a_render_has_the_rate_of_its_target(codes_of):
    both = f"{ACCEPTED}\n{TARGET}"
    assert codes_of("sample-rate", silence(seconds=0.01), both, target="game", rate=44_100) == []
    assert codes_of("sample-rate", silence(seconds=0.01), both, target="game", rate=48_000) != []


def test_any_lifts_the_limit(codes_of):
    assert codes_of("sample-rate", silence(seconds=0.01), 'accept.sample_rates_hz = "any"', rate=8_000) == []
