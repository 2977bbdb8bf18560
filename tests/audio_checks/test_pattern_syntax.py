"""The private parser that our patterns are built on: the trees that it gives, and the versions that it is known in."""

import re
import sys
import tomllib
from pathlib import Path

import pytest

from audio_checks.spec.pattern_syntax import MAXREPEAT, parse

ROOT = Path(__file__).resolve().parents[2]
PYPROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text())
VERSION = "Programming Language :: Python :: 3."


def plain(value):
    """Return a tree in lists and words, whatever classes the parser has for it."""
    if hasattr(value, "data"):
        return [plain(one) for one in value.data]
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return value.name if hasattr(value, "name") else value


@pytest.mark.parametrize(
    ("pattern", "tree"),
    [
        ("a.", [["LITERAL", 97], ["ANY", None]]),
        ("[^a-c_]", [["IN", [["NEGATE", None], ["RANGE", [97, 99]], ["LITERAL", 95]]]]),
        (r"\d", [["IN", [["CATEGORY", "CATEGORY_DIGIT"]]]]),
        ("a|bc", [["BRANCH", [None, [[["LITERAL", 97]], [["LITERAL", 98], ["LITERAL", 99]]]]]]),
        ("(?:ab)+", [["MAX_REPEAT", [1, "MAXREPEAT", [["LITERAL", 97], ["LITERAL", 98]]]]]),
        ("a{2,5}?", [["MIN_REPEAT", [2, 5, [["LITERAL", 97]]]]]),
        ("(?P<x>a)", [["SUBPATTERN", [1, 0, 0, [["LITERAL", 97]]]]]),
        ("^a$", [["AT", "AT_BEGINNING"], ["LITERAL", 97], ["AT", "AT_END"]]),
        (r"(a)\1", [["SUBPATTERN", [1, 0, 0, [["LITERAL", 97]]]], ["GROUPREF", 1]]),
        ("(?=a)", [["ASSERT", [1, [["LITERAL", 97]]]]]),
        ("(?>a)", [["ATOMIC_GROUP", [["LITERAL", 97]]]]),
        ("a*+", [["POSSESSIVE_REPEAT", [0, "MAXREPEAT", [["LITERAL", 97]]]]]),
    ],
)
def test_the_parser_gives_the_trees_that_patterns_are_built_on(pattern, tree):
    assert plain(parse(pattern, re.ASCII)) == tree


def test_what_is_no_pattern_is_an_error_of_re():
    with pytest.raises(re.error):
        parse("(", re.ASCII)
    assert parse("a*", 0).data[0][1][1] is MAXREPEAT


def test_the_versions_that_it_is_known_in_are_stated():
    stated = [int(line.removeprefix(VERSION)) for line in PYPROJECT["project"]["classifiers"] if VERSION in line]
    assert stated == [11, 12, 13, 14]
    assert sys.version_info[:2] in [(3, minor) for minor in stated], "this version is stated nowhere"


def test_no_other_module_touches_the_parser():
    touching = [
        path.name
        for path in (ROOT / "audio_checks").rglob("*.py")
        if re.search(r"re import _parser|re\._parser|sre_parse", path.read_text())
    ]
    assert touching == ["pattern_syntax.py"]
