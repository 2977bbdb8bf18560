"""The journal for accountants: every line balances, and each side books what is its own."""

import csv
import io
from collections import Counter
from decimal import Decimal
from typing import Any

import pytest

from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import refused
from tests.support.server import World


def read(by: Any, world: World, **days: str) -> list[dict[str, str]]:
    """Return the bookings as a person reads them."""
    answer = by.get(f"/v1/projects/{world.project_id}/journal.csv", params=days)
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    return list(csv.DictReader(io.StringIO(answer.text)))


def balances(rows: list[dict[str, str]]) -> dict[str, Decimal]:
    """Return what each account comes to, debit above zero."""
    sums: Counter[str] = Counter()
    for row in rows:
        sums[row["debit"]] += Decimal(row["amount"])  # type: ignore[assignment]
        sums[row["credit"]] -= Decimal(row["amount"])  # type: ignore[assignment]
    return {account: Decimal(amount) for account, amount in sums.items()}


def paid_in_part(world: World) -> Agreed:
    """Have a deposit of 100.00 and a cue of 180.03 invoiced with 19 % tax, and 300.00 of 333.24 paid."""
    agreed = Agreed(world, terms={"tax_bp": 1_900, "po_number": "PO-77"}, currency="EUR")
    cue = agreed.cue("radar_ping")
    agreed.agree(deposit(10_000), milestone("Alpha", cue, amount_minor=18_003))
    agreed.approve(agreed.take(cue))
    assert agreed.pay(agreed.invoice(full_number="INV-7"), 30_000, "=T-1").status_code == 201
    return agreed


@pytest.mark.slow
def test_a_studio_books_purchases(world: World) -> None:
    paid_in_part(world)
    rows = read(world.producer, world)
    assert balances(rows) == {
        "Purchases of sound": Decimal("280.03"),
        "Input tax": Decimal("53.21"),
        "Accounts payable": Decimal("-33.24"),
        "Bank": Decimal("-300.00"),
    }
    first = rows[0]
    assert (first["date"], first["document"], first["kind"]) == (TODAY.isoformat(), "INV-7", "invoice")
    assert (first["tax_rate"], first["tax_category"], first["currency"]) == ("19", "S", "EUR")
    assert (first["due_date"], first["po_number"], first["party"]) == (day(14), "PO-77", "Sound designer")


def test_a_designer_books_sales(world: World) -> None:
    paid_in_part(world)
    assert balances(read(world.designer, world)) == {
        "Accounts receivable": Decimal("33.24"),
        "Sales of sound": Decimal("-280.03"),
        "Output tax": Decimal("-53.21"),
        "Bank": Decimal("300.00"),
    }


@pytest.mark.slow
def test_a_credit_note_exchanges_debit_and_credit(world: World) -> None:
    agreed = Agreed(world, currency="JPY")
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    agreed.approve(take)
    agreed.invoice(full_number="A-1")
    agreed.undo(take)
    agreed.invoice(full_number="A-2")
    billed, taken_back = read(world.producer, world)
    assert (billed["amount"], billed["kind"], taken_back["kind"]) == ("18000", "invoice", "credit note")
    assert (billed["debit"], billed["credit"]) == (taken_back["credit"], taken_back["debit"])
    assert taken_back["amount"] == "18000"


@pytest.mark.slow
def test_days_limit_it(world: World) -> None:
    paid_in_part(world)
    assert read(world.producer, world, from_on=day(1)) == []
    assert len(read(world.producer, world, from_on=day(0), until_on=day(0))) == 4


@pytest.mark.slow
def test_no_cell_is_a_formula(world: World) -> None:
    paid_in_part(world)
    assert read(world.producer, world)[-1]["document"] == "'=T-1"


@pytest.mark.slow
def test_a_reviewer_has_no_journal(world: World) -> None:
    paid_in_part(world)
    assert refused(world.reviewer.get(f"/v1/projects/{world.project_id}/journal.csv"))[0] == 403
    assert refused(world.stranger.get(f"/v1/projects/{world.project_id}/journal.csv"))[0] == 404
