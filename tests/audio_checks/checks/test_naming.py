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
