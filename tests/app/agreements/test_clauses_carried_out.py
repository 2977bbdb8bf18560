"""docs/how-to/contracts.md says of each clause who carries it out, and by which terms the software goes."""

import dataclasses
import re
from pathlib import Path

import pytest

from app.agreements.clauses.deemed_acceptance import DeemedAcceptance
from app.agreements.clauses.named_days import DAY_TERMS
from app.agreements.clauses.rules import library, variables_in
from app.agreements.clauses.terms import MoneyTerms
from app.operations.retention.service import TERM

ROOT = Path(__file__).resolve().parents[3]
DOCUMENT = ROOT / "docs/how-to/contracts.md"
BY = {"Soundlist", "parties", "both"}


def table() -> dict[str, list[str]]:
    """Return the cells of each row by the key of its clause."""
    text = DOCUMENT.read_text().partition("| clause | carried out by |")[2].partition("\n\n")[0]
    rows = [[cell.strip() for cell in line.strip("| ").split("|")] for line in text.splitlines()[2:]]
    assert len({row[0] for row in rows}) == len(rows), "a clause stands twice"
    return {row[0].strip("`"): row[1:] for row in rows}


def named(cell: str) -> set[str]:
    return set(re.findall(r"`(\w+)`", cell))


def terms_of_the_code() -> set[str]:
    """Return the terms that the software reads: of money, of silence, of credits and days, and of change orders."""
    money = {field.name for field in dataclasses.fields(MoneyTerms)}
    silence = {"silence_days", "silence_reminder_days"}
    assert DeemedAcceptance.of(dict.fromkeys(silence, 5)) is not None
    assert all(DeemedAcceptance.of({name: 5}) is None for name in silence)
    by_studio = DeemedAcceptance.of({**dict.fromkeys(silence, 5), "silence_calendar": "studio"})
    assert by_studio is not None
    assert by_studio.by_studio_calendar
    silence |= {"silence_calendar"}
    looked_up = re.findall(r'_number\(terms, "(\w+)"\)', (ROOT / "app/amendments/change_order_review.py").read_text())
    return money | silence | set(looked_up) | {*DAY_TERMS, "credit_line", TERM}


def test_every_clause_is_in_the_table_and_no_other() -> None:
    assert table().keys() == {each.clause.key for each in library()}


@pytest.mark.parametrize("clause", library(), ids=lambda each: each.clause.key)
def test_each_of_its_terms_is_carried_out_by_one_side(clause) -> None:
    by, ours, theirs, how = table()[clause.clause.key]
    assert by in BY
    assert how
    terms = {term.name for term in clause.terms}
    assert named(ours) | named(theirs) == terms
    assert not named(ours) & named(theirs)
    assert named(ours) <= terms_of_the_code(), "the table says that the software goes by a term that it never reads"
    assert not named(theirs) & terms_of_the_code(), "the software goes by a term that the table leaves to the parties"
    if by == "parties":
        assert not named(ours)
    if by == "Soundlist":
        assert not named(theirs)


def test_the_software_reads_no_term_that_no_clause_has() -> None:
    assert terms_of_the_code() == {name for row in table().values() for name in named(row[1])}


def test_money_that_the_parties_calculate_says_so_in_the_text() -> None:
    """An amount without a line of its own names the change order, the plan or the account that makes it due."""
    for each in library():
        theirs = named(table()[each.clause.key][2])
        amounts = {
            name for name in theirs if name.endswith(("_minor", "_bp")) and name in variables_in(each.clause.text)
        }
        if amounts:
            words = " ".join(each.clause.text.split())
            assert re.search(r"change order|keep account|outside this software", words), each.clause.key
