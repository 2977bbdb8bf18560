"""The forms of a contract, its PDF, and two versions word by word."""

import io
import subprocess
import sys
from hashlib import sha256

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pypdf import PdfReader

from app.agreements.clauses.text import Span, blocks_of, literal, marked, plain, spans_of
from app.agreements.drafts.comparison import compare, lines_of, words_between
from app.agreements.drafts.documents import pdf_of, sha256_of

TEXT = """# Effects

## 1. Parties

Between **Shield Wing studio** and the
*designer*.

- one
- two, and
  more of it

| Number | Sound |
| --- | --- |
| SW-001 | Shield \\| hit |

The end.
"""


def test_forms():
    kinds = [(block.kind, plain(block)) for block in blocks_of(TEXT)]
    assert kinds == [
        ("head", ["Effects"]),
        ("head", ["1. Parties"]),
        ("text", ["Between Shield Wing studio and the designer."]),
        ("item", ["one"]),
        ("item", ["two, and more of it"]),
        ("table", ["Number · Sound", "SW-001 · Shield | hit"]),
        ("text", ["The end."]),
    ]
    assert spans_of("a **b** *c*") == [Span("a "), Span("b", strong=True), Span(" "), Span("c", emphatic=True)]


@settings(max_examples=50)
@given(st.text(max_size=40))
def test_a_name_says_itself_whatever_it_is(name: str):
    (block,) = blocks_of(f"It is {literal(name)}.")
    assert plain(block) == [" ".join(f"It is {' '.join(name.split())}.".split())]


@pytest.mark.parametrize(
    "name", ['") #panic("x', "\\", '#import "/etc/passwd"', "*a*", "{studio}", "Привет, ß ø", "\x00"]
)
def test_nothing_that_was_typed_is_run(name: str):
    markdown = f"# {literal(name)}\n\nText {literal(name)} ends.\n\n- {literal(name)}\n\n| {literal(name)} |\n"
    pdf = PdfReader(io.BytesIO(pdf_of(name, markdown)))
    shown = name.replace("\x00", " ")
    (page,) = pdf.pages
    assert page.extract_text().splitlines() == [
        shown,
        f"Text {shown} ends.",
        f"• {shown}",
        shown,
        f"SHA-256 of the text {sha256_of(markdown)} 1 of 1",
    ]
    assert pdf.metadata is not None
    assert pdf.metadata.title == shown


@pytest.mark.slow
def test_the_same_text_is_the_same_pdf_in_another_process():
    code = (
        "import hashlib, sys; from app.agreements.drafts.documents import pdf_of;"
        "print(hashlib.sha256(pdf_of('Effects', sys.stdin.read())).hexdigest())"
    )
    elsewhere = subprocess.run(
        [sys.executable, "-c", code], input=TEXT, capture_output=True, text=True, check=True, timeout=300
    )
    first, second = pdf_of("Effects", TEXT), pdf_of("Effects", TEXT)
    assert first == second
    assert elsewhere.stdout.strip() == sha256(first).hexdigest()
    assert pdf_of("Effects", TEXT + "\nMore.\n") != first


def test_another_text_has_another_hash():
    assert sha256_of(TEXT) != sha256_of(TEXT + " ")


def difference(earlier: str, later: str) -> list[tuple[str, str]]:
    return [
        (line.change, "".join(f"[{run.is_in} {run.text}]" for run in line.runs)) for line in compare(earlier, later)
    ]


def test_words_are_distinguished():
    assert difference("Two rounds are included.", "Three rounds are included.") == [
        ("changed", "[earlier Two][later Three][both  rounds are included.]")
    ]
    assert difference("One.\n\nTwo.", "One.\n\nA new one.\n\nTwo.") == [
        ("same", "[both One.]"),
        ("added", "[later A new one.]"),
        ("same", "[both Two.]"),
    ]
    assert difference("One.\n\nTwo.", "One.") == [("same", "[both One.]"), ("removed", "[earlier Two.]")]


WORDS = st.lists(
    st.sampled_from(["the", "cue", "is", "accepted", "when", "paid", "in", "full", "two", "rounds", "days"]),
    min_size=1,
    max_size=9,
)
TEXTS = st.lists(WORDS.map(" ".join), max_size=7).map("\n\n".join)


@pytest.mark.slow
@given(TEXTS, TEXTS)
def test_both_texts_can_be_read_back(earlier: str, later: str):
    compared = compare(earlier, later)
    for side, text in (("earlier", earlier), ("later", later)):
        kept = ["".join(run.text for run in line.runs if run.is_in in ("both", side)) for line in compared]
        assert [line for line in kept if line] == [line.text for line in lines_of(text)]


@pytest.mark.slow
@given(WORDS.map(" ".join))
def test_no_change_is_no_notification(text: str):
    assert [run.is_in for run in words_between(text, text)] == ["both"]


def test_a_figure_keeps_its_name_and_the_weight_around_it():
    text = f"It costs **{marked('total', 'EUR 5.00')}** for {marked('rounds_included', '')} rounds."
    assert [(span.text, span.strong, span.field) for span in spans_of(text)] == [
        ("It costs ", False, ""),
        ("EUR 5.00", True, "total"),
        (" for ", False, ""),
        ("", False, "rounds_included"),
        (" rounds.", False, ""),
    ]
