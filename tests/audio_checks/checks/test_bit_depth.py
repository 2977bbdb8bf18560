"""`bit-depth`: one of the accepted depths."""

import pytest

from tests.support.waves import silence, sine

ACCEPTED = "accept.bit_depths = [16, 24]"
TARGET = "targets.game = { sample_rate_hz = 48000, bit_depth = 16 }"


@pytest.mark.parametrize(
    ("bits", "codes"), [(8, ["bit-depth:not-accepted"]), (16, []), (24, []), (32, ["bit-depth:not-accepted"])]
)
@pytest.mark.parametrize("channels", [1, 2])
def test_depths(codes_of, bits, codes, channels):
    assert codes_of("bit-depth", sine(hz=440, channels=channels), ACCEPTED, bits=bits) == codes


def test_padding_is_never_advised(found_by):
    (finding,) = found_by("bit-depth", silence(), ACCEPTED, bits=8)
    assert "adds no quality" in finding.fix
    (finding,) = found_by("bit-depth", silence(), "accept.bit_depths = [16]", bits=24)
    assert finding.fix == "export the session at 16 bit, with dither"


def test_a_render_has_the_depth_of_its_target(codes_of):
    assert codes_of("bit-depth", silence(), f"{ACCEPTED}\n{TARGET}", target="game", bits=16) == []
    assert codes_of("bit-depth", silence(), f"{ACCEPTED}\n{TARGET}", target="game", bits=24) != []
