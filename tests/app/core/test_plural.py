"""Sentences with a number, read with 0, 1 and 2."""

from collections.abc import Callable, Sequence
from datetime import date
from typing import Any

import pytest

from app.builds.packs.key_pdf import sums_of
from app.client import adopting, terminal
from app.core.plural import counted, verb
from app.core.record import faults
from app.deliveries.errors import VariationUnknown
from app.deliveries.rules import ensure_variation
from app.money.bonuses.rules import BonusCue, BonusWhen, bonus_status_of
from app.notifications.rules import Fold
from app.projects.rules import audio_leads_warning
from app.scenes.rules import CoveredBand, masking_words
from app.sound_lists.save_edits import _in_words
from audio_checks.system import plural
from tests.app.core.test_record import chain


@pytest.mark.parametrize("count_words", [counted, terminal.counted, plural.counted])
def test_a_number_with_its_noun(count_words):
    assert [count_words(count, "file") for count in (0, 1, 2, 1_200)] == ["0 files", "1 file", "2 files", "1,200 files"]
    assert [count_words(count, "category", "categories") for count in (0, 1, 2)] == [
        *("0 categories", "1 category", "2 categories"),
    ]


def test_a_verb_agrees_with_its_number():
    for form in (verb, plural.verb):
        assert [form(count, "is", "are") for count in (0, 1, 2)] == ["are", "is", "are"]


def missing_entries(count: int) -> str | None:
    whole = chain("a", "b", "c")
    kept = whole[: 3 - count]
    return next(faults(kept, of="a contract", length=3, last_sha256=whole[-1].sha256), None)


def added_entries(count: int) -> str | None:
    longer = chain("a", "b", "c")
    length = 3 - count
    return next(faults(longer, of="a contract", length=length, last_sha256=longer[length - 1].sha256), None)


def accepted(count: int) -> str:
    cues = [BonusCue(f"cue {at}", None, date(2026, 11, 20) if at < count else None, False) for at in range(3)]
    today = date(2026, 11, 21)
    return bonus_status_of(BonusWhen.ON_TIME, cues, today=today, is_running=True, shipped_on=None).because


def unknown_variation(count: int) -> str:
    with pytest.raises(VariationUnknown) as refused:
        ensure_variation(9, count)
    return str(refused.value)


def heard_bands(count: int) -> str:
    return masking_words([CoveredBand(1_000.0, True, True, 3.0, "bed")] * count).partition(".")[0]


def adopted(count: int, capsys: pytest.CaptureFixture[str]) -> str:
    plan: dict[str, Any] = {"files": count, "cues": [{}] * count, "categories": dict.fromkeys("ab"[:count], 1)}
    capsys.readouterr()
    adopting._print_plan(plan | {"sets": count, "oddities": [], "duplicates": [], "skipped": []})
    return capsys.readouterr().out.splitlines()[0]


@pytest.mark.parametrize(
    ("sentence", "said"),
    [
        (
            lambda count: sums_of(count, count).split(";")[0],
            [
                "0 of 0 accepted sounds have a file",
                "1 of 1 accepted sound has a file",
                "2 of 2 accepted sounds have a file",
            ],
        ),
        (
            Fold("Wing", "file returned", "files returned").subject,
            [f"Wing: {files} returned" for files in ("0 files", "1 file", "2 files")],
        ),
        (lambda count: _in_words(count, 0), ["", "1 cue added", "2 cues added"]),
        (lambda count: _in_words(0, count), ["", "1 cue changed", "2 cues changed"]),
        (lambda count: _in_words(1, count), ["1 cue added", "1 cue added, 1 changed", "1 cue added, 2 changed"]),
        (missing_entries, [None, "the last 1 of 3 entries is missing", "the last 2 of 3 entries are missing"]),
        (added_entries, [None, "1 entry was added past the end", "2 entries were added past the end"]),
        (accepted, ["0 of 3 cues are accepted", "1 of 3 cues is accepted", "2 of 3 cues are accepted"]),
        (
            unknown_variation,
            [f"the cue has {count}; there is no number 9" for count in ("0 variations", "1 variation", "2 variations")],
        ),
        (heard_bands, ["The sound is silent", "Heard in 1 of 1 band", "Heard in 2 of 2 bands"]),
        (
            audio_leads_warning,
            ["No audio lead speaks for the team; name one or two, so that designers know whom to ask", None, None],
        ),
    ],
)
def test_a_sentence_says_none_one_and_two(sentence: Callable[[int], str | None], said: Sequence[str | None]) -> None:
    assert [sentence(count) for count in (0, 1, 2)] == said


def test_a_plan_of_adoption_says_none_one_and_two(capsys: pytest.CaptureFixture[str]) -> None:
    assert [adopted(count, capsys) for count in (0, 1, 2)] == [
        "0 files become 0 cues in 0 categories, 0 of them sets",
        "1 file becomes 1 cue in 1 category, 1 of them a set",
        "2 files become 2 cues in 2 categories, 2 of them sets",
    ]
