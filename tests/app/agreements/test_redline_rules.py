"""Redlines as plain values: for every order of answers the draft has what was agreed, and nothing else."""

from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.agreements.clauses.rules import Clause, Terms
from app.agreements.drafts.comparison import MAX_CHARS
from app.agreements.redlines.marks import clauses_as_sent, marked_clauses
from app.agreements.redlines.rules import (
    Answer,
    Change,
    Redline,
    RedlineAnswerKind,
    RedlineKind,
    Round,
    Wording,
    answered_draft,
    change_errors,
    faults_of_sent,
    is_in,
    keys_in_order,
    numbered,
)

AT = datetime(2026, 11, 20, 9, tzinfo=UTC)
BASE = [Clause(key, key.title(), f"{key} {{days}}.") for key in ("a", "b", "c")]
TERMS: Terms = {"days": 10, "rounds": 2}
CHANGES = [
    Change(RedlineKind.REPLACE, "a", None, Wording("A", "new a {rounds}", {"rounds": 3})),
    Change(RedlineKind.STRIKE, "b", None, Wording()),
    Change(RedlineKind.INSERT, None, "b", Wording("First", "one")),
    Change(RedlineKind.INSERT, None, "b", Wording("Second", "two")),
    Change(RedlineKind.INSERT, None, None, Wording("Top", "zero")),
]
COUNTERS = {number: Wording(f"Counter {number}", f"counter {number}") for number in range(1, len(CHANGES) + 1)}


def begun() -> Round:
    return Round(1, 1, "", "Designer", AT, numbered(CHANGES, 1))


def answered(redline: Redline, kind: RedlineAnswerKind) -> Redline:
    wording = COUNTERS[redline.number] if kind is RedlineAnswerKind.COUNTERED else None
    return replace(redline, answer=Answer(kind, wording, "", "Producer", AT))


def give(round_: Round, draft: tuple[Sequence[Clause], Terms], number: int, kind: RedlineAnswerKind):
    """Return round and draft after an answer."""
    redline = answered(next(one for one in round_.redlines if one.number == number), kind)
    clauses, terms = answered_draft(draft, (BASE, TERMS), round_, redline)
    redlines = [redline if one.number == number else one for one in round_.redlines]
    return replace(round_, redlines=redlines), (clauses, terms)


def expected(round_: Round) -> tuple[list[Clause], Terms]:
    """Return what a draft comes to by the last answers alone: a model written apart."""
    by_key = {clause.key: clause for clause in BASE}
    terms = dict(TERMS)
    for redline in round_.redlines:
        if redline.answer is None or redline.answer.kind is RedlineAnswerKind.REFUSED:
            continue
        if redline.answer.kind is RedlineAnswerKind.COUNTERED:
            by_key[redline.clause_key] = Clause(
                redline.clause_key, f"Counter {redline.number}", f"counter {redline.number}"
            )
        elif redline.kind is RedlineKind.STRIKE:
            by_key[redline.clause_key] = replace(by_key[redline.clause_key], stands=False)
        else:
            by_key[redline.clause_key] = Clause(redline.clause_key, redline.wording.title, redline.wording.text)
            terms |= redline.wording.terms
    order = ["own_top_5", "a", "b", "own_first_3", "own_second_4", "c"]
    return [by_key[key] for key in order if key in by_key], terms


@pytest.mark.slow
@given(st.lists(st.tuples(st.integers(1, len(CHANGES)), st.sampled_from(RedlineAnswerKind)), max_size=20))
def test_the_last_answers_alone_make_the_draft(answers: list[tuple[int, RedlineAnswerKind]]):
    round_, draft = begun(), (BASE, TERMS)
    for number, kind in answers:
        round_, draft = give(round_, draft, number, kind)
    assert (list(draft[0]), draft[1]) == expected(round_)
    assert all(is_in(redline, draft, BASE) for redline in round_.redlines)


def test_a_clause_that_the_studio_removed_comes_back_in_its_place():
    _, (clauses, _) = give(begun(), ([BASE[0], BASE[2]], TERMS), 2, RedlineAnswerKind.COUNTERED)
    assert [clause.key for clause in clauses] == ["a", "b", "c"]
    _, (clauses, _) = give(begun(), ([BASE[2]], TERMS), 4, RedlineAnswerKind.ACCEPTED)
    assert [clause.key for clause in clauses] == ["own_second_4", "c"]


def test_other_edits_of_the_draft_stay():
    edited = [replace(BASE[2], text="edited"), BASE[0], BASE[1]]
    _, (clauses, terms) = give(begun(), (edited, TERMS | {"days": 20}), 1, RedlineAnswerKind.ACCEPTED)
    assert clauses == [edited[0], Clause("a", "A", "new a {rounds}"), BASE[1]]
    assert terms == {"days": 20, "rounds": 3}


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (1, ([Clause("a", "A", "new a  {rounds}"), *BASE[1:]], TERMS | {"rounds": 3})),  # one blank more
        (1, ([Clause("a", "A", "new a {rounds}"), *BASE[1:]], TERMS)),  # another value
        (1, ([replace(BASE[0], title="A", text="new a {rounds}", stands=False), *BASE[1:]], TERMS | {"rounds": 3})),
        (2, (BASE, TERMS)),  # it stands
        (3, (BASE, TERMS)),  # it is not there
    ],
)
def test_one_character_that_differs_is_found(number: int, text: tuple[Sequence[Clause], Terms]):
    redlines = [
        answered(redline, RedlineAnswerKind.ACCEPTED) if redline.number == number else redline
        for redline in begun().redlines
    ]
    assert not is_in(redlines[number - 1], text, BASE)
    sent = replace(begun(), redlines=redlines, sent_version=2)
    found = list(faults_of_sent([sent], {1: (BASE, TERMS), 2: text}))
    assert f"version 2 has not redline {number} as it was agreed" in found
    assert sum("has no answer" in fault for fault in found) == len(CHANGES) - 1


def test_what_is_proposed_is_numbered_on_and_keyed_apart():
    twice = numbered([CHANGES[2], Change(RedlineKind.INSERT, None, None, Wording("¡Ñ!", "x"))], 7)
    assert [(one.number, one.clause_key) for one in twice] == [(7, "own_first_7"), (8, "own_8")]
    assert keys_in_order(BASE, begun().redlines) == ["own_top_5", "a", "b", "own_first_3", "own_second_4", "c"]


def test_two_values_for_one_term_are_named():
    changes = [CHANGES[0], Change(RedlineKind.REPLACE, "c", None, Wording("C", "{rounds}", {"rounds": 4}))]
    assert list(change_errors(changes, BASE, TERMS)) == [
        ("changes.1", "{rounds} has another value in an earlier change")
    ]


def test_a_value_that_changes_is_marked_wherever_it_is_read():
    redlines = numbered([Change(RedlineKind.REPLACE, "a", None, Wording("A", "a {days}.", {"days": 11}))], 1)
    marked = {
        marked_clause.key: marked_clause for marked_clause in marked_clauses((BASE, TERMS), redlines, {}, "USD", "")
    }
    assert {run.text for line in marked["c"].lines for run in line.runs if run.is_in != "both"} == {"10.", "11."}
    refused = [answered(redlines[0], RedlineAnswerKind.REFUSED)]
    marked = {
        marked_clause.key: marked_clause for marked_clause in marked_clauses((BASE, TERMS), refused, {}, "USD", "")
    }
    assert {line.change for line in marked["c"].lines} == {"same"}


def test_a_clause_that_nothing_changes_reads_as_it_was_sent():
    sent = "# T\n\n## 1. A\n\na 9.\n\n## 2. B\n\nb 9.\n\n## 3. Other\n\nb too.\n\n## 3. C\n\nc 9.\n"
    assert clauses_as_sent(sent, BASE) == {"a": "a 9.", "b": "b 9.\n\n## 3. Other\n\nb too.", "c": "c 9.\n"}
    change = Change(RedlineKind.REPLACE, "a", None, Wording("A", "new {days}."))
    marked = marked_clauses((BASE, TERMS), numbered([change], 1), {}, "USD", sent)
    read = {one.key: [run.text for line in one.lines for run in line.runs] for one in marked}
    assert read["a"] == ["A", "a", "new", " 10."], "before and after by the facts of today"
    assert read["c"] == ["C", "c 9."]


def test_a_text_too_long_for_words_is_marked_by_paragraphs():
    long = Change(RedlineKind.REPLACE, "a", None, Wording("A", "word " * (MAX_CHARS // 5)))
    (first, *_) = marked_clauses((BASE, TERMS), numbered([long], 1), {}, "USD", "")
    assert [line.change for line in first.lines] == ["removed", "removed", "added", "added"]
