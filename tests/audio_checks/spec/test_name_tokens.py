"""Names made of tokens: which fit, and what is said of the others."""

import pytest

from audio_checks.spec.name_tokens import Token, misfit
from tests.support.steps import at_most

TOKENS = (
    Token("kind", one_of=("sfx", "amb")),
    Token("what", case="lower", repeats=True),
    Token("variation", digits=2, optional=True),
    Token("suffix", pattern="x[0-9]", optional=True),
)


@pytest.mark.parametrize(
    "stem", ["sfx_laser", "sfx_laser_fire", "amb_bridge_02", "sfx_laser_fire_far_11", "sfx_door_01_x3", "sfx_door_x3"]
)
def test_right_names(stem):
    assert misfit(stem, TOKENS, "_") is None


@pytest.mark.parametrize(
    ("stem", "why"),
    [
        ("laser_fire", 'part 1 is "laser", wanted kind (sfx or amb)'),
        ("sfx", "what (lower-case letters and digits) is missing at the end"),
        ("sfx_Laser", 'part 2 is "Laser", wanted what (lower-case letters and digits)'),
        ("sfx__laser", 'part 2 is "", wanted what (lower-case letters and digits)'),
        (
            "sfx_laser_Fire",
            'part 3 is "Fire", wanted what (lower-case letters and digits) or variation (2 digits) or suffix (x[0-9])',
        ),
        ("", 'part 1 is "", wanted kind (sfx or amb)'),
    ],
)
def test_what_is_wrong(stem, why):
    assert misfit(stem, TOKENS, "_") == why


def test_one_part_too_many():
    assert misfit("sfx_a", TOKENS[:1], "_") == 'part 2 is "a", wanted no more parts'


@pytest.mark.parametrize(
    ("case", "right", "wrong"),
    [("lower", "door2", "Door"), ("upper", "DOOR2", "DOoR"), ("capital", "Door", "door"), ("any", "dOoR", "dö")],
)
def test_cases(case, right, wrong):
    token = Token("word", case=case)
    assert misfit(right, [token], "-") is None
    assert misfit(wrong, [token], "-") is not None


def test_another_separator():
    assert misfit("sfx-laser-02", TOKENS, "-") is None


def test_digits_of_another_script_are_none():
    assert misfit("sfx_a_٣٣", TOKENS, "_") is not None


def test_a_name_made_to_be_slow_is_not():
    tokens = [Token(f"t{number}", optional=True, repeats=True) for number in range(12)]
    with at_most(1_000_000):  # it takes 70,000; every share of the words would be 10**16
        assert misfit("_".join(["a"] * 120) + "_!", tokens, "_") is not None
