"""Sentences with a number, read with 0, 1 and 2."""

import pytest

from app.builds.key_pdf import sums_of
from app.client import terminal
from app.kit.plural import counted, verb


@pytest.mark.parametrize("count_words", [counted, terminal.counted])
def test_a_number_with_its_noun(count_words):
    assert [count_words(count, "file") for count in (0, 1, 2, 1_200)] == ["0 files", "1 file", "2 files", "1,200 files"]
    assert [count_words(count, "category", "categories") for count in (0, 1, 2)] == [
        *("0 categories", "1 category", "2 categories"),
    ]


def test_a_verb_agrees_with_its_number():
    assert [verb(count, "is", "are") for count in (0, 1, 2)] == ["are", "is", "are"]


def test_how_many_sounds_have_a_file():
    assert [sums_of(count, count).split(";")[0] for count in (0, 1, 2)] == [
        "0 of 0 accepted sounds have a file",
        "1 of 1 accepted sound has a file",
        "2 of 2 accepted sounds have a file",
    ]
