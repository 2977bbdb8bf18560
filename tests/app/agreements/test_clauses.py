"""The library's clauses are whole, and a draft's faults are named where they stand."""

import pytest

from app.agreements.clauses.rules import (
    FACTS,
    Clause,
    default_clauses,
    known_terms,
    library,
    names_in,
    render,
    terms_in_force,
    validation_errors,
    variables_in,
)
from app.agreements.rules import ContractKind

WANTED = {
    "parties",
    "services",
    "brief",
    "acceptance",
    "silence",
    "rounds",
    "rates",
    "payment_plan",
    "payment",
    "kill_fee",
    "ownership",
    "ownership_on_creation",
    "library_layers",
    "ai_declared",
    "reel",
    "credit",
    "warranty",
    "confidentiality",
    "equipment",
    "exclusivity",
    "bonus",
    "termination",
    "retention",
    "disputes",
}
MUSIC = {"music_rights", "music_skus", "music_soundtrack"}
OFF = {
    "ownership_on_creation",
    "equipment",
    "exclusivity",
    "bonus",
    "purchase_order",
    "silence",
    "downloads",
    "source_files",
} | MUSIC
OFF |= {"next_project", "points", "hours", "retainer", "joint"}


def standing(kind: ContractKind, **how: bool) -> set[str]:
    return {clause.key for clause in default_clauses(kind, **how)[0] if clause.stands}


def test_a_single_contract_has_every_kind_of_clause():
    keys = {clause.key for clause in default_clauses(ContractKind.SINGLE)[0]}
    assert keys >= WANTED | MUSIC
    assert standing(ContractKind.SINGLE) == keys - OFF


def test_music_stands_only_when_asked_for():
    assert not standing(ContractKind.SINGLE) & MUSIC
    assert standing(ContractKind.SINGLE, with_music=True) >= MUSIC


def test_a_framework_and_its_batch_make_one_contract_together():
    batch, framework = standing(ContractKind.STATEMENT_OF_WORK), standing(ContractKind.FRAMEWORK)
    both = standing(ContractKind.SINGLE)
    assert both - (batch | framework) == set()
    assert {"services", "payment_plan"} <= batch - framework
    assert len(batch) < len(framework) / 2, "a statement of work is short"


@pytest.mark.parametrize("kind", ContractKind)
def test_what_the_library_begins_has_no_faults(kind: ContractKind):
    for with_music in (False, True):
        clauses, terms = default_clauses(kind, with_music=with_music)
        assert list(validation_errors(clauses, terms)) == []
        text = render("Effects", clauses, terms | {"po_number": "PO-1"}, dict.fromkeys(FACTS, "something"), "USD")
        assert variables_in(text) == []
        assert "no legal advice" in text, "a template says that it is a start"


def test_every_term_of_the_library_is_used_by_its_own_clause():
    for each in library():
        named = names_in([each.clause])
        assert {term.name for term in each.terms} <= named, each.clause.key
        assert named <= FACTS.keys() | known_terms().keys()


def test_terms_are_written_by_their_units():
    clause = Clause("a", "A", "{kill_fee_in_work_bp} of it, {bonus_minor}, {silence_days} days, {credit_line}")
    terms = {"kill_fee_in_work_bp": 1250, "bonus_minor": 100_000, "silence_days": 10, "credit_line": "by {designer}"}
    text = render("Effects", [clause], terms, {"designer": "N. N. {studio}"}, "EUR")
    assert text == "# Effects\n\n## 1. A\n\n12.5 % of it, EUR 1,000.00, 10 days, by N. N. {studio}\n"


def test_struck_clauses_are_not_numbered():
    clauses = [Clause("a", "A", "One."), Clause("b", "B", "Two.", stands=False), Clause("c", "C", "Three.")]
    text = render("Effects", clauses, {}, {}, "USD")
    assert "## 2. C" in text
    assert "Two." not in text


PRICE = [Clause("price", "Price", "It comes about {price_mode}.")]


@pytest.mark.parametrize(
    ("clauses", "terms", "place", "words"),
    [
        ([Clause("a", "A", "{silense_days}")], {"silence_days": 5}, "clauses.a", "is it {silence_days}?"),
        ([Clause("a", "A", "{}")], {}, "clauses.a", "there is no variable {}"),
        ([Clause("a", "A", "x"), Clause("a", "B", "y")], {}, "clauses.a", "stands twice"),
        ([Clause("A b", "A", "x")], {}, "clauses.A b", "is not a key"),
        ([Clause("a", " ", "x")], {}, "clauses.a", "enter a title"),
        ([Clause("a", "A", " ")], {}, "clauses.a", "the clause is empty"),
        ([Clause("a", "A", "x", stands=False)], {}, "clauses", "no clause is included"),
        ([Clause("a", "A", "x")], {"rounds_included": 21}, "terms.rounds_included", "21; wanted 0 to 20"),
        ([Clause("a", "A", "x")], {"extra_round_bp": 10_001}, "terms.extra_round_bp", "100.01 %; wanted 0 % to 100 %"),
        ([Clause("a", "A", "x")], {"silence_days": "ten"}, "terms.silence_days", "wanted a whole number"),
        ([Clause("a", "A", "x")], {"own_minor": -1}, "terms.own_minor", "wanted 0 or more"),
        ([Clause("a", "A", "x")], {"studio": "ours"}, "terms.studio", "none of the server's own"),
        (PRICE, {"price_mode": "day_rat"}, "terms.price_mode", "wanted flat or per_cue or day_rate; is it day_rate?"),
        (PRICE, {"price_mode": "day_rate"}, "terms.day_rate_minor", "wants a rate"),
        (PRICE, {"price_mode": "day_rate", "day_rate_minor": 40_000}, "terms.days_cap", "the most days that are paid"),
        ([Clause("a", "A", "x")], {"price_mode": "per_cue"}, "terms.price_mode", "no clause in force says so"),
        ([Clause("a", "A", "x")], {"tax_bp": 1_900}, "terms.tax_bp", "19 %, and no clause in force says so"),
        ([Clause("a", "A", "{reverse_charge}")], {"reverse_charge": 2}, "terms.reverse_charge", "2; wanted 0 or 1"),
        ([Clause("a", "A", "{po_number}")], {"po_number": ""}, "terms.po_number", "fill it in, or remove its clause"),
        ([Clause("a", "A", "{po_number}")], {"po_number": 7}, "terms.po_number", "7; wanted a text"),
        ([Clause("a", "A", "x")], {"round_included": 2}, "terms.round_included", "is it {rounds_included}?"),
    ],
)  # fmt: skip
def test_faults_are_named(clauses: list[Clause], terms: dict[str, int | str], place: str, words: str):
    found = dict(validation_errors(clauses, terms))
    assert place in found
    assert words in found[place]


def test_clauses_that_stand_instead_of_one_another_do_not_stand_together():
    clauses, terms = default_clauses(ContractKind.SINGLE)
    both = [Clause(clause.key, clause.title, clause.text) for clause in clauses]
    assert "remove one of them" in dict(validation_errors(both, terms))["clauses.ownership_on_creation"]


@pytest.mark.parametrize(
    ("terms", "words"),
    [
        ({"price_mode": "flat"}, "a fixed amount for each milestone"),
        ({"price_mode": "per_cue"}, "by the price of each cue"),
        (
            {"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 12},
            "a day of work costs EUR 400.00, counted in quarters, and at most 12 days are paid",
        ),
        ({"reverse_charge": 0, "tax_bp": 1_900}, "adds tax of 19 % to each invoice"),
        ({"reverse_charge": 1, "tax_bp": 1_900}, "(reverse charge): the designer invoices none"),
        ({"po_number": "PO-77"}, "purchase order for this work is PO-77"),
        ({"voice_hour_minor": 25_000}, "Voice talent that the designer brings costs EUR 250.00 an hour"),
        ({"rush_bp": 3_000, "rush_days": 3}, "in less than 3 working days costs 30 % more"),
        ({"direction_hour_minor": 8_000}, "Directing a voice session costs EUR 80.00 an hour"),
    ],
)
def test_the_text_states_the_terms_that_the_software_computes_with(terms: dict[str, int | str], words: str):
    clauses, defaults = default_clauses(ContractKind.SINGLE)
    standing = [Clause(clause.key, clause.title, clause.text) for clause in clauses if clause.key != "ownership"]
    days = {"option_until_on": "2027-12-31", "points_until_on": "2031-12-31"}
    whole = defaults | {"po_number": "PO-1"} | days | terms
    assert list(validation_errors(standing, whole)) == []
    assert words in render("Effects", standing, whole, dict.fromkeys(FACTS, "something"), "EUR")


def test_terms_of_a_struck_clause_no_longer_hold():
    clauses, terms = default_clauses(ContractKind.SINGLE)
    struck = [
        Clause(clause.key, clause.title, clause.text, clause.key not in ("kill_fee", "rates")) for clause in clauses
    ]
    assert terms_in_force(clauses, terms)["kill_fee_in_work_bp"] == 5_000
    left = terms_in_force(struck, terms)
    assert [left[name] for name in ("kill_fee_in_work_bp", "kill_fee_delivered_bp", "extra_round_bp")] == [0, 0, 0]
    assert left["rounds_included"] == terms["rounds_included"]
