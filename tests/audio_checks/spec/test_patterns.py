"""Patterns in linear time: they mean what Python's mean, and no text makes them slow."""

import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from audio_checks import SpecError, parse_spec
from audio_checks.spec.globs import matches
from audio_checks.spec.patterns import LONGEST_TEXT, MOST_REMEMBERED, Pattern, PatternUnsupported, compiled
from tests.support.steps import at_most

ATOMS = ["a", "b", "A", "_", "1", ".", r"\d", r"\w", r"\s", r"\D", r"\W", "[a-c]", "[^a]", "[A-Z_]", r"[\d_]", r"[^\w]"]
ATOMS += ["^", "$", r"\A", r"\Z", r"\b", "é", "\n", "(?i:b)", "(?i:[a-b])", "(?i:[^a])", "(?s:.)", "(?m:$)"]
REPEATS = ["*", "+", "?", "{2}", "{1,3}", "{0,2}?", "*?", "{2,}"]
PATTERNS = st.recursive(
    st.sampled_from(ATOMS),
    lambda inner: st.one_of(
        st.tuples(inner, inner).map("".join),
        st.tuples(inner, inner).map(lambda two: f"(?:{two[0]}|{two[1]})"),
        st.tuples(inner, st.sampled_from(REPEATS)).map(lambda two: f"({two[0]}){two[1]}"),
    ),
    max_leaves=8,
)


@pytest.mark.slow
@settings(max_examples=400, deadline=None)
@given(PATTERNS, st.lists(st.text("abAB_1é \n", max_size=7), min_size=1, max_size=12))
def test_a_pattern_means_what_python_means_by_it(pattern: str, texts: list[str]):
    expected = re.compile(pattern, re.ASCII)
    for text in texts:
        assert Pattern(pattern).matches(text) == (expected.fullmatch(text) is not None), (pattern, text)


@pytest.mark.parametrize(
    "pattern",
    [
        "[a-z0-9]+(_[a-z0-9]+)*",
        "[A-Z][A-Z0-9_]*",
        "[A-Z]{2}_[A-Za-z0-9_]+",
        "[a-z_]+",
        r"[\d\w]+",
        "x[0-9]",
        r"""[a-z]+(_"\d+")?""",
        r"'a'\d+",
    ],
)
@pytest.mark.parametrize(
    "name",
    ["laser_fire", "laser_fire_02", "Laser", "SW_Laser", "x7", "_a", "a_", "", "laser_٣", "'a'12", 'a_"1"', "a\n"],
)
def test_patterns_of_presets_docs_and_tests_keep_their_meaning(pattern: str, name: str):
    assert compiled(pattern).matches(name) == (re.fullmatch(pattern, name, re.ASCII) is not None)


@pytest.mark.parametrize(
    "pattern",
    [
        "(a+)+b",
        "(a|a)*b",
        "(.*a){20}b",
        "(a?){200}a{200}b",
        "([a-z]{1,64}_){1,30}x",
        "(?i)(?:.*[a-z]*)*_$",
        "(" * 50 + "a" + ")*" * 50 + "b",
    ],
    ids=lambda pattern: pattern[:12],
)
def test_what_a_search_never_ends_takes_a_moment(pattern: str):
    with at_most(5_000_000):  # the most that one takes is 1,300,000; a search of (a+)+b has 2**255 steps
        assert not Pattern(pattern).matches("a" * 255)


def test_sets_of_states_are_forgotten_before_they_fill_the_memory():
    pattern = Pattern("(.*a.{200}){3}")
    text = "".join("ab"[(place * place) % 7 % 2] for place in range(LONGEST_TEXT))
    pattern.matches(text)
    assert pattern._remembered < 2 * MOST_REMEMBERED


def test_longer_texts_than_any_path_fit_nothing():
    assert compiled("a*").matches("a" * LONGEST_TEXT)
    assert not compiled("a*").matches("a" * (LONGEST_TEXT + 1))


@pytest.mark.parametrize(
    ("pattern", "words"),
    [
        (r"(a)\1", "reference back to a group"),
        ("(?!x_)[a-z]+", "looking ahead or behind"),
        ("[a-z]+(?=_)", "looking ahead or behind"),
        ("(?<=a)b", "looking ahead or behind"),
        ("(?<!a)b", "looking ahead or behind"),
        ("(?>a+)b", "atomic group"),
        ("a*+", "possessive repeat"),
        ("(a)?(?(1)b|c)", "condition on a group"),
        ("(?u:a)", "of ASCII"),
        ("(a", "not a regular expression: missing )"),
        ("((a{0,90}){0,90})", "more than 5,000 steps"),
        ("(?:(?:(?:){65535}){65535}){65535}", "more than 5,000 steps"),
        ("a" * 1001, "1,001 characters"),
        ("(" * 51 + "a" + ")" * 51, "more than 50 deep"),
    ],
    ids=lambda value: value[:16],
)
def test_what_cannot_be_matched_in_linear_time_is_refused_when_the_spec_is_read(pattern: str, words: str):
    with pytest.raises(PatternUnsupported, match=re.escape(words)):
        compiled(pattern)
    for toml in (f"naming.pattern = '{pattern}'", f"[[naming.tokens]]\nname = 'x'\npattern = '{pattern}'"):
        with pytest.raises(SpecError) as refused:
            parse_spec(f"format = 1\n{toml}")
        assert "naming" in refused.value.where


@pytest.mark.parametrize("glob", ["*a" * 100 + "b", "**/" * 60 + "b", "**a" * 60 + "b", "?*" * 100 + "b"])
def test_globs_take_a_moment_too(glob: str):
    with at_most(2_000_000):  # the most that one takes is 240,000
        assert not matches(glob, "/".join(["a" * 100] * 40), None)
