"""`channels`: as many as the project accepts."""

import pytest

from tests.support.waves import silence


@pytest.mark.parametrize(
    ("channels", "accepted", "codes"),
    [
        (1, "[1]", []),
        (2, "[1]", ["channels:not-accepted"]),
        (2, "[1, 2]", []),
        (1, "[2]", ["channels:not-accepted"]),
        (6, "[1, 2]", ["channels:not-accepted"]),
        (6, '"any"', []),
    ],
)
def test_channels(codes_of, channels, accepted, codes):
    assert codes_of("channels", silence(channels=channels), f"accept.channels = {accepted}") == codes


def test_in_words(found_by):
    (finding,) = found_by("channels", silence(channels=6), "accept.channels = [1, 2]")
    assert finding.message == "6 channels, accepted mono or stereo"
    assert finding.fix == "export it from the session as stereo"


@pytest.mark.parametrize(("wanted", "codes"), [("1", ["channels:not-accepted"]), ("2", []), ('"master"', [])])
def test_a_render_has_the_channels_of_its_target(codes_of, wanted, codes):
    target = f"targets.game = {{ sample_rate_hz = 48000, bit_depth = 24, channels = {wanted} }}"
    tables = f"accept.channels = [1, 2]\n{target}"
    assert codes_of("channels", silence(channels=2), tables, target="game") == codes
