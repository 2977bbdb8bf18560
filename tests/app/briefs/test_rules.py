"""Answers in words, as they are printed into what is signed."""

from typing import Any

import pytest

from app.briefs.questions import AnswerKind, Choice, Question
from app.briefs.rules import UNKNOWN, in_words

CHOICES = (Choice("reverb", "Reverb"), Choice("doppler", "Doppler shift"))


def said(kind: AnswerKind, value: Any, *, is_unknown: bool = False, note: str = "") -> str:
    question = Question("key", "topic", "Text?", "why", "example", kind, CHOICES, unit="MB")
    return in_words(question, {"value": value, "is_unknown": is_unknown, "note": note})


@pytest.mark.parametrize(
    ("kind", "value", "wanted"),
    [
        (AnswerKind.CHOICE, "reverb", "Reverb"),
        (AnswerKind.CHOICES, ["doppler", "reverb"], "Doppler shift\nReverb"),
        (AnswerKind.TEXT, "A platformer", "A platformer"),
        (AnswerKind.NUMBER, 64.5, "64.5 MB"),
        (AnswerKind.LINES, ["one", "two"], "one\ntwo"),
        (
            AnswerKind.PER_CATEGORY,
            {"everything": ["reverb"], "ui": [], "vehicle": ["reverb", "doppler"]},
            "Everything: reverb\nui: nothing\nvehicle: reverb, doppler shift",
        ),
        (
            AnswerKind.PER_SCENE,
            [{"scene": "Deck", "ambience": "Wind", "music": True}, {"scene": "Hold", "ambience": "", "music": False}],
            "Deck: Wind, music\nHold: no ambience",
        ),
        (
            AnswerKind.NAMES,
            {
                "tokens": [
                    {"name": "kind", "one_of": ["sfx", "mus"]},
                    {"name": "word", "repeats": True},
                    {"name": "variation", "digits": 2, "optional": True},
                ],
                "separator": "_",
                "extension": ".wav",
            },
            "[kind sfx/mus]_[word …]_(variation 01).wav",
        ),
    ],
)
def test_each_kind_of_answer(kind: AnswerKind, value: Any, wanted: str) -> None:
    assert said(kind, value) == wanted


def test_what_is_not_known_is_said_and_a_note_follows() -> None:
    assert said(AnswerKind.TEXT, None, is_unknown=True, note="Ask the publisher") == f"{UNKNOWN}\nAsk the publisher"
    assert said(AnswerKind.TEXT, "Yes", note="") == "Yes"
