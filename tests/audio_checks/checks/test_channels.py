"""`channels`: as many as the project accepts, in a layout it accepts."""

import pytest

from audio_checks.audio.audio_file import AudioFile
from audio_checks.checks import channels as channels_check
from audio_checks.spec.delivery_spec import CueFacts, parse_spec
from tests.support.waves import PCM_GUID, chunk, extensible, riff, silence


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


QUAD, QUAD_SIDES, FIVE_ONE = 0x33, 0x603, 0x60F
B_FORMAT = bytes.fromhex("010000002107d3118644c8c1ca000000")


@pytest.fixture
def layout_codes(tmp_path):
    """Return what is found in silence under an extensible header."""

    def layout_codes(channels, mask, accepted, *, guid=PCM_GUID):
        header = extensible(channels=channels, container_bits=16, valid_bits=16, mask=mask, guid=guid)
        path = tmp_path / "bed.wav"
        path.write_bytes(riff(chunk(b"fmt ", header), chunk(b"data", bytes(20 * channels))))
        spec = parse_spec(f"format = 1\naccept.layouts = {accepted}")
        with AudioFile(path) as file:
            return [finding.code for finding in channels_check.check(file, spec)]

    return layout_codes


@pytest.mark.parametrize(
    ("channels", "mask", "accepted", "codes"),
    [
        (4, QUAD, '["quad"]', []),
        (4, QUAD_SIDES, '["quad"]', []),
        (4, 0, '["quad"]', ["channels:layout"]),
        (4, 0x107, '["quad"]', ["channels:layout"]),
        (4, 0, '["quad", "ambisonic-1"]', []),
        (4, QUAD, '["ambisonic-1"]', ["channels:layout"]),
        (6, FIVE_ONE, '["5.1", "7.1"]', []),
        (6, 0x3F, '["5.1"]', []),
        (8, 0x63F, '["5.1"]', ["channels:layout"]),
        (9, 0, '["ambisonic-2"]', []),
        (12, 0x2D63F, '["7.1.4"]', []),
        (2, 0x3, '["stereo"]', []),
        (2, 0, '["stereo"]', []),
        (2, 0x30, '["stereo"]', ["channels:layout"]),
        (1, 0x4, '["mono"]', []),
        (1, 0, '["stereo"]', ["channels:layout"]),
        (5, 0x37, '"any"', []),
    ],
)
def test_layouts(layout_codes, channels, mask, accepted, codes):
    assert layout_codes(channels, mask, accepted) == codes


def test_a_header_can_say_ambisonics_itself(layout_codes):
    assert layout_codes(4, 0, '["ambisonic-1"]', guid=B_FORMAT) == []
    assert layout_codes(4, 0, '["quad"]', guid=B_FORMAT) == ["channels:layout"]


def test_a_plain_header_is_mono_or_stereo(codes_of, found_by):
    assert codes_of("channels", silence(channels=2), 'accept.layouts = ["stereo"]') == []
    (finding,) = found_by("channels", silence(channels=4), 'accept.layouts = ["quad"]')
    assert finding.message == "4 channels as ambisonic-1 without a channel mask, accepted quad"
    assert "two in front, two behind" in finding.fix


def test_a_wrong_number_is_said_once(codes_of):
    assert codes_of("channels", silence(channels=2), "accept.channels = [1]\naccept.layouts = ['mono']") == [
        "channels:not-accepted"
    ]


@pytest.mark.parametrize(
    ("channels", "asked", "accepted", "codes"),
    [
        (2, "mono", "[1, 2]", ["channels:cue"]),
        (1, "mono", "[1, 2]", []),
        (1, "stereo", "[1, 2]", ["channels:cue"]),
        (2, "stereo", "[1]", []),  # what one cue asks for comes before the spec
        (2, "mono", '"any"', ["channels:cue"]),
        (2, None, "[1]", ["channels:not-accepted"]),
    ],
)
def test_a_cue_is_mono_or_stereo(codes_of, channels, asked, accepted, codes):
    cue = CueFacts("SW-001", channels=asked)
    assert codes_of("channels", silence(channels=channels), f"accept.channels = {accepted}", cue=cue) == codes


@pytest.mark.parametrize(("wanted", "codes"), [("1", ["channels:not-accepted"]), ('"master"', [])])
def test_a_target_that_folds_channels_comes_before_the_cue(codes_of, wanted, codes):
    tables = f"targets.game = {{ sample_rate_hz = 48000, bit_depth = 24, channels = {wanted} }}"
    cue = CueFacts("SW-001", channels="stereo")
    assert codes_of("channels", silence(channels=2), tables, target="game", cue=cue) == codes


def test_another_number_than_the_cue_asks_for_in_words(found_by):
    cue = CueFacts("SW-001", channels="mono")
    (finding,) = found_by("channels", silence(channels=2), "accept.channels = [1, 2]", cue=cue)
    assert finding.message == "stereo, and the sound list asks for mono"
    assert finding.fix == "export it from the session as mono"
