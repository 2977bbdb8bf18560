"""Scores: one rule for what a report keeps and for what findings and pages say of it."""

import pytest

from audio_checks.judge import score_in_words, truncated_score


@pytest.mark.parametrize(
    ("score", "kept", "said"),
    [(0.0, 0.0, "0.00"), (0.9949, 0.994, "0.99"), (0.995, 0.995, "0.99"), (0.99999, 0.999, "0.99"), (1.0, 1.0, "1.00")],
)
def test_decimals_are_cut_off(score, kept, said):
    assert truncated_score(score) == kept
    assert score_in_words(kept) == said


def test_what_has_two_decimals_stays():
    # 0.29 * 100 is 28.999999999999996 in binary.
    assert [score_in_words(number / 100) for number in range(101)] == [f"{number / 100:.2f}" for number in range(101)]


def test_no_score_says_nothing_for_sure():
    assert score_in_words(None) == "0.00"
