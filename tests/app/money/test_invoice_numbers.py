"""The designer's own series of invoice numbers."""

from datetime import date

import pytest

from app.money.invoices.numbers import advice, file_part, following
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

THIS_YEAR = date(2026, 5, 1)


@pytest.mark.parametrize(
    ("last", "next_one"),
    [
        ("1", "2"),
        ("9", "10"),
        ("INV-2026-014", "INV-2026-015"),
        ("INV-2026-999", "INV-2026-1000"),
        ("2026/7-A", "2026/8-A"),
        ("RE007", "RE008"),
        ("Ocean", "Ocean-2"),
    ],
)
def test_the_one_that_follows(last: str, next_one: str) -> None:
    assert following(last, THIS_YEAR, THIS_YEAR) == next_one


def test_a_series_with_the_year_in_it_restarts_each_year() -> None:
    assert following("INV-2026-014", date(2026, 12, 30), date(2027, 1, 4)) == "INV-2027-001"
    assert following("INV-014", date(2026, 12, 30), date(2027, 1, 4)) == "INV-015"
    assert following("INV-2026-014", date(2026, 12, 30), date(2027, 1, 4), {"INV-2027-001"}) == "INV-2027-002"


def test_a_used_number_is_passed_over() -> None:
    assert following("7", THIS_YEAR, THIS_YEAR, {"8", "9"}) == "10"


@pytest.mark.parametrize(
    ("number", "words"),
    [
        ("INV-015", ""),
        ("INV-016", "INV-015 is left out."),
        ("INV-020", "INV-015 to INV-019 are left out."),
        ("INV-014", "You have issued an invoice INV-014 already."),
        ("INV-012", "INV-014 is issued already; this one stands before it."),
        ("2026-001", ""),
        ("Ocean", "It has no digits to count on; the next one would be Ocean-2."),
    ],
)
def test_what_is_said_of_a_number(number: str, words: str) -> None:
    assert advice(number, ["INV-013", "INV-014"]) == words


def test_a_number_in_a_file_name() -> None:
    assert file_part('2026/7 Ä"') == "2026-7"
    assert file_part("…") == "number"


@pytest.mark.slow
def test_typed_once_and_remembered(world: World) -> None:
    agreed = Agreed(world)
    cues = [agreed.cue("radar_ping"), agreed.cue("airlock")]
    agreed.agree(deposit(10_000), milestone("Alpha", *cues, amount_minor=18_000))
    address, issue = f"/v1/contracts/{agreed.contract_id}/invoice-draft", f"/v1/contracts/{agreed.contract_id}/invoices"
    assert body_of(world.designer.get(address))["full_number"] == "1"

    first = agreed.invoice(full_number=" SND-014 ")
    assert (first["full_number"], first["number"]) == ("SND-014", 1)
    lines = body_of(world.producer.get(f"/v1/contracts/{agreed.contract_id}/ledger"))["lines"]
    assert {line["invoice_number"] for line in lines if line["invoice_id"]} == {"SND-014"}
    pdf = world.producer.get(f"/v1/invoices/{first['id']}/invoice.pdf")
    assert pdf.headers["content-disposition"] == 'inline; filename="invoice-SND-014.pdf"'

    agreed.approve(agreed.take(cues[0]))
    assert body_of(world.designer.get(address))["full_number"] == "SND-015"
    gap = body_of(world.designer.get(address, params={"full_number": "SND-017"}))
    assert (gap["number_advice"], gap["is_number_taken"]) == ("SND-015 to SND-016 are left out.", False)
    assert body_of(world.designer.get(address, params={"full_number": "SND-014"}))["is_number_taken"]
    again = world.designer.post(issue, json={"seller": "me", "full_number": "SND-014"})
    assert refused(again) == (409, "invoice-number-taken")
    assert agreed.invoice()["full_number"] == "SND-015"


def test_a_number_of_two_lines_is_refused(world: World) -> None:
    agreed = Agreed(world)
    agreed.agree(deposit(10_000), milestone("Alpha", agreed.cue("radar_ping"), amount_minor=18_000))
    answer = world.designer.post(
        f"/v1/contracts/{agreed.contract_id}/invoices", json={"seller": "me", "full_number": "1\n2"}
    )
    assert answer.status_code == 422
