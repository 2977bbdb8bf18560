"""`naming`: the name by the pattern, its ending, and no alternate among renders."""

import pytest

from tests.support.waves import silence

PATTERN = "naming.pattern = '[a-z0-9]+(_[a-z0-9]+)*'\nnaming.extension = '.wav'"
TARGET = "targets.game = { sample_rate_hz = 48000, bit_depth = 24 }"


@pytest.mark.parametrize(
    ("name", "codes"),
    [
        ("laser_fire.wav", []),
        ("laser_fire_02.wav", []),
        ("laser_fire__alt2.wav", []),
        ("laser_fire_altB.wav", []),
        ("laser_fire_v03.wav", []),
        ("Laser_fire.wav", ["naming:pattern"]),
        ("laser fire.wav", ["naming:pattern"]),
        ("laser__fire.wav", ["naming:pattern"]),
        ("lasér.wav", ["naming:pattern"]),
        ("laser\n.wav", ["naming:pattern"]),
        ("laser.fire.wav", ["naming:pattern"]),
        ("laser_fire.WAV", ["naming:extension"]),
        ("laser_fire", ["naming:extension"]),
        ("Laser.mp3", ["naming:pattern", "naming:extension"]),
        ("l" * 10_000 + "!.wav", ["naming:pattern"]),
    ],
)
def test_names(codes_of, name, codes):
    assert codes_of("naming", silence(seconds=0.01), PATTERN, name=name) == codes


def test_the_new_name_is_proposed(found_by):
    (finding,) = found_by("naming", silence(seconds=0.01, channels=2), PATTERN, name="Café Door 01.wav")
    assert finding.fix == "rename it to cafe_door_01.wav"


def test_digits_of_another_script_are_no_ascii_digits(codes_of):
    assert codes_of("naming", silence(seconds=0.01), r"naming.pattern = '[\d\w]+'", name="laser_٣.wav") != []


def test_a_render_is_never_named_as_an_alternate(codes_of):
    assert codes_of("naming", silence(), TARGET, target="game", name="laser_fire__alt2.wav") == ["naming:alternate"]
    assert codes_of("naming", silence(), TARGET, target="game", name="laser_fire.wav") == []
    assert codes_of("naming", silence(), TARGET, name="laser_fire__alt2.wav") == []


@pytest.mark.parametrize(
    ("name", "codes"),
    [
        ("con.wav", ["naming:reserved"]),
        ("nul.tar.wav", ["naming:reserved"]),
        ("COM7.wav", ["naming:reserved"]),
        ("console.wav", []),
        ("com10.wav", []),
        ("laser .wav", ["naming:not-portable"]),
        (" laser.wav", ["naming:not-portable"]),
        ("laser..wav", ["naming:not-portable"]),
        ("laser.wav ", ["naming:not-portable"]),
        ("laser?.wav", ["naming:not-portable"]),
        ("laser\x07.wav", ["naming:not-portable"]),
        ("l" * 252 + ".wav", ["naming:not-portable"]),
        ("ü" * 125 + ".wav", []),
        ("Lasér Fire 3.wav", []),
    ],
)
def test_names_that_every_system_can_hold(codes_of, name, codes):
    assert codes_of("naming", silence(seconds=0.01), "naming.portable = true", name=name) == codes


def test_a_reserved_name_may_follow_the_pattern(codes_of):
    assert codes_of("naming", silence(seconds=0.01), PATTERN, name="aux.wav") == ["naming:reserved"]
    assert codes_of("naming", silence(seconds=0.01), f"{PATTERN}\nnaming.portable = false", name="aux.wav") == []


def test_control_characters_are_named_not_shown(found_by):
    (finding,) = found_by("naming", silence(seconds=0.01), "naming.portable = true", name="a\x07b.wav")
    assert "a control character" in finding.message


TOKENS = """
naming.tokens = [
  { name = "kind", one_of = ["sfx"] }, { name = "what" }, { name = "number", digits = 2, optional = true },
]
"""


@pytest.mark.parametrize(
    ("name", "codes"),
    [
        ("sfx_laser.wav", []),
        ("sfx_laser_02__alt2.wav", []),
        ("amb_laser.wav", ["naming:tokens"]),
        ("sfx.wav", ["naming:tokens"]),
    ],
)
def test_names_by_tokens(codes_of, name, codes):
    assert codes_of("naming", silence(seconds=0.01), TOKENS, name=name) == codes


def test_what_a_token_should_be_is_reported(found_by):
    (finding,) = found_by("naming", silence(seconds=0.01), TOKENS, name="amb_laser.wav")
    assert 'part 1 is "amb", wanted kind (sfx)' in finding.message
    assert finding.fix == "rename it after the form kind_what_[number]"


UCS = "naming = { grammar = 'ucs', ucs_ids = ['GUNAuto', 'DOORWood'] }"


@pytest.mark.parametrize(
    ("name", "codes"),
    [
        ("GUNAuto_M4 Burst_ML_SHIELD.wav", []),
        ("GUNMisc_M4 Burst_ML_SHIELD.wav", ["naming:ucs"]),
        ("laser_fire.wav", ["naming:ucs"]),
    ],
)
def test_names_after_the_universal_category_system(codes_of, name, codes):
    assert codes_of("naming", silence(seconds=0.01), UCS, name=name) == codes
