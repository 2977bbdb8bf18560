"""Every figure that the software counts by is a field: a text cannot say another number than is counted."""

import dataclasses
import re

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.agreements.clauses.figures import (
    figure_errors,
    number_in,
    plan_errors,
    text_errors,
    typed_figures,
    with_fields,
)
from app.agreements.clauses.rules import (
    FACTS,
    Clause,
    default_clauses,
    known_terms,
    library,
    render,
    variables_in,
    written_term,
)
from app.agreements.rules import ContractKind

SINGLE = ContractKind.SINGLE
CLAUSES, TERMS = default_clauses(SINGLE)
ALL = [dataclasses.replace(each, stands=True) for each in CLAUSES if each.key != "ownership_on_creation"]
FIELDS = [
    (each.clause.key, name)
    for each in library()
    if SINGLE in each.kinds and each.clause.key != "ownership_on_creation"
    for name in variables_in(each.clause.text)
    if name in TERMS
]
NUMBERS = [
    (key, name) for key, name in FIELDS if isinstance(TERMS[name], int) and not known_terms()[name].choices
]  # fmt: skip
COUNTED_NUMBERS = [(key, name) for key, name in NUMBERS if known_terms()[name].counted]


def edited(key: str, text: str, clauses: list[Clause] = ALL) -> list[Clause]:
    return [dataclasses.replace(each, text=text) if each.key == key else each for each in clauses]


def text_of(key: str) -> str:
    return next(each.text for each in ALL if each.key == key)


def another(name: str) -> int:
    """Return a value of a term that is not the one counted, and is one that a text could write."""
    value = TERMS[name]
    assert isinstance(value, int)
    return value + (500 if name.endswith(("_bp", "_minor")) else 3)


def in_a_word(number: int) -> str:
    small = (
        *("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"),
        *("thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"),
    )
    tens = ("twenty", "thirty", "forty", "fifty")
    if number < len(small):
        return small[number]
    return tens[number // 10 - 2] + (f"-{small[number % 10]}" if number % 10 else "")


@pytest.mark.parametrize("kind", ContractKind)
def test_the_library_has_its_figures_and_types_none(kind: ContractKind):
    clauses, terms = default_clauses(kind, with_music=True)
    standing = [dataclasses.replace(each, stands=True) for each in clauses if each.key != "ownership_on_creation"]
    for changed in ({}, {"price_mode": "day_rate"}, {"reverse_charge": 1, "bonus_when": "shipped"}):
        now = terms | {name: value for name, value in changed.items() if name in terms}
        assert list(figure_errors(clauses, now, kind)) == []
        assert list(figure_errors(standing, now, kind)) == []


@pytest.mark.parametrize(("key", "name"), NUMBERS)
def test_a_number_typed_over_a_field_is_named(key: str, name: str):
    typed = written_term(name, another(name), "USD")
    faults = list(figure_errors(edited(key, text_of(key).replace(f"{{{name}}}", typed)), TERMS, SINGLE))
    assert any(where == f"clauses.{key}" and f"{{{name}}}" in message for where, message in faults)


@pytest.mark.parametrize(("key", "name"), COUNTED_NUMBERS)
def test_a_copy_of_a_clause_with_another_number_is_named(key: str, name: str):
    copy = Clause("own_copy", "Copy", text_of(key).replace(f"{{{name}}}", written_term(name, another(name), "USD")))
    faults = list(figure_errors([*ALL, copy], TERMS, SINGLE))
    assert any(where == "clauses.own_copy" and f"{{{name}}}" in message for where, message in faults)


@pytest.mark.parametrize(("key", "name"), COUNTED_NUMBERS)
def test_what_is_typed_over_a_field_is_its_new_value(key: str, name: str):
    text, value = text_of(key), another(name)
    typed = text.replace(f"{{{name}}}", written_term(name, value, "USD"))
    assert with_fields(typed, text, TERMS, "USD") == (text, {name: value})


WORDS = "three", "3", "**3**", "three (3)", "３"


@pytest.mark.parametrize("word", WORDS)
def test_rounds_are_read_in_digits_and_words(word: str):
    text = text_of("rounds")
    typed = text.replace("{rounds_included}", word)
    assert dict(figure_errors(edited("rounds", typed), TERMS, SINGLE)).keys() == {"clauses.rounds"}
    back, changed = with_fields(typed, text, TERMS, "USD")
    assert changed == {"rounds_included": 3}
    assert back.replace("**", "") == text


@pytest.mark.parametrize(
    ("sentence", "figure"),
    [
        ("Three rounds are free.", "rounds_included"),
        ("A cue has up to 4 further rounds.", "rounds_included"),
        ("Rounds included: 5", "rounds_included"),
        ("The studio gets unlimited revisions.", "rounds_included"),
        ("Invoices are paid within thirty days.", "payment_days"),
        ("The studio pays within a month of the invoice.", "payment_days"),
        ("Payment is due 2 weeks after the invoice.", "payment_days"),
        ("Either side may leave with three months' notice.", "notice_days"),
        ("The notice period is 30 days.", "notice_days"),
        ("Late sums bear interest of 1.5 % a month.", "late_interest_monthly_bp"),
        ("A further round costs 30 percent of the cue.", "extra_round_bp"),
        ("Cues not begun are owed at ten per cent.", "kill_fee_not_begun_bp"),
        ("For a cut cue half is owed.", "kill_fee_delivered_bp"),
        ("VAT of 19 % is added.", "tax_bp"),
        ("A deposit of 30 % is paid at signing.", "deposit_sentence"),
        ("EUR 1,000 of it is the deposit.", "deposit_sentence"),
        ("Ten percent are held back until the end.", "holdback_sentence"),
        ("The price is €6,390.", "total"),
        ("The last delivery is due on 14 December 2026.", "milestones"),
        ("Everything is delivered by 2026-12-14.", "milestones"),
        ("The designer is paid in euros.", "currency"),
        ("An hour costs {bonus_minor}.", "hour_rate_minor"),
        ("A cue includes {payment_days} rounds of changes.", "rounds_included"),
    ],
)
def test_other_ways_to_type_a_figure_are_found(sentence: str, figure: str):
    found = dict(typed_figures(sentence, TERMS))
    assert figure in found, found
    faults = list(figure_errors([*ALL, Clause("own_1", "Own", sentence)], TERMS, SINGLE))
    assert any(where == "clauses.own_1" and f"{{{figure}}}" in message for where, message in faults)


@pytest.mark.parametrize(
    "sentence",
    [
        "The designer answers mail within two working days.",
        "The studio has 12 people and one office.",
        "Sounds are at least 48 kHz and 24 bit.",
        "One of the rounds may be heard in the studio.",
        "Each party keeps what it learns secret for five years.",
        "In round 2 the notes name times.",
        "The studio pays the travel of up to 3 people.",
        "The price of a cue includes {rounds_included} rounds; the studio pays within {payment_days} days.",
    ],
)
def test_other_numbers_are_the_parties_own(sentence: str):
    assert list(typed_figures(sentence, TERMS)) == []


@pytest.mark.parametrize("key", ["rounds", "payment"])
def test_a_needed_figure_cannot_be_struck(key: str):
    struck = [dataclasses.replace(each, stands=each.stands and each.key != key) for each in CLAUSES]
    (where, message), *_ = figure_errors(struck, TERMS, SINGLE)
    assert where in ("terms.rounds_included", "terms.payment_days")
    assert "no clause in force says so" in message
    without = {name: value for name, value in TERMS.items() if name not in ("rounds_included", "payment_days")}
    found = dict(figure_errors(struck, without, SINGLE))
    assert "the software counts by it" in found[where]


def test_an_order_says_price_deposit_and_what_is_held_back():
    struck = [dataclasses.replace(each, stands=each.stands and each.key != "payment_plan") for each in CLAUSES]
    everything = {"has_amounts": True, "has_deposit": True, "has_holdback": True}
    said = "".join(message for _, message in plan_errors(struck, SINGLE, **everything))
    for name in ("total", "milestones", "release_sentence", "deposit_sentence", "holdback_sentence"):
        assert f"{{{name}}}" in said
    assert list(plan_errors(CLAUSES, SINGLE, **everything)) == []
    assert list(plan_errors(struck, SINGLE, **dict.fromkeys(everything, False))) == []


@pytest.mark.parametrize("number", range(60))
def test_numbers_are_read_in_words(number: int):
    assert number_in(in_a_word(number)) == number
    assert number_in(str(number)) == number


def test_what_is_no_number_is_none():
    assert [number_in(words) for words in ("", "some", "3 days", "1.5", "{x}")] == [None] * 5


EDITS = st.sampled_from(["type", "word", "delete", "move", "copy", "strike"])


@pytest.mark.slow
@given(st.data())
@settings(max_examples=12, deadline=None)
def test_a_text_without_faults_says_what_is_counted(data: st.DataObject):
    """Edit clauses at random: where nothing is refused, each counted number stands in the text, and no other does."""
    clauses = list(ALL)
    for _ in range(data.draw(st.integers(1, 3))):
        key, name = data.draw(st.sampled_from(COUNTED_NUMBERS))
        place = next((at for at, each in enumerate(clauses) if each.key == key), None)
        if place is None:
            continue
        clause, value = clauses[place], another(name)
        typed = written_term(name, value, "USD")
        match data.draw(EDITS):
            case "type":
                clauses[place] = dataclasses.replace(clause, text=clause.text.replace(f"{{{name}}}", typed))
            case "word":
                word = in_a_word(value % 60) if not name.endswith(("_bp", "_minor")) else typed
                clauses[place] = dataclasses.replace(clause, text=clause.text.replace(f"{{{name}}}", word))
            case "delete":
                clauses[place] = dataclasses.replace(clause, text=clause.text.replace(f"{{{name}}}", ""))
            case "move":
                other = data.draw(st.integers(0, len(clauses) - 1))
                clauses[place] = dataclasses.replace(clause, text=clause.text.replace(f"{{{name}}}", "as agreed"))
                moved = clauses[other]
                clauses[other] = dataclasses.replace(moved, text=f"{moved.text} It is {{{name}}}.")
            case "copy":
                copied = clause.text.replace(f"{{{name}}}", typed)
                clauses.append(Clause(f"own_{len(clauses)}", "Copy", copied))
            case "strike":
                clauses[place] = dataclasses.replace(clause, stands=False)
    if list(text_errors(clauses, TERMS | {"po_number": "1", "option_until_on": "2027-12-31"}, SINGLE)):
        return
    text = render("T", clauses, TERMS, dict.fromkeys(FACTS, "-"), "USD")
    standing = {each.key for each in clauses if each.stands}
    for key, name in COUNTED_NUMBERS:
        if key not in standing:
            continue
        assert written_term(name, TERMS[name], "USD") in text
        value = written_term(name, another(name), "USD")
        own = library_words_around(key, name)
        assert not re.search(own.format(re.escape(value)), text), (name, value)


def library_words_around(key: str, name: str) -> str:
    """Return the words beside a field of the library as a pattern that a value is put into."""
    before, _, after = text_of(key).partition(f"{{{name}}}")
    left, right = before.split()[-2:], after.split()[:2]
    literal = [re.escape(word).replace("{", "{{").replace("}", "}}") for word in left]
    behind = [re.escape(word).replace("{", "{{").replace("}", "}}") for word in right]
    return r"\s+".join([*literal, "{}"]) + r"\s*" + r"\s+".join(behind)
