"""Interest on invoices that are paid late: computed by the day, charged once, on the next invoice without tax."""

from datetime import date, timedelta
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.core.plural import day_in_words
from app.money.invoices.late_interest import interest_minor
from app.money.models import Invoice
from tests.app.money.agreed import TODAY, Agreed, day, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

DUE = date(2026, 3, 1)


def on(days: int) -> date:
    return DUE + timedelta(days=days)


@pytest.mark.parametrize(
    ("payments", "until", "minor"),
    [
        ([], on(0), 0),
        ([], on(1), 33),  # 1 % of 1,000.00 a month is 10.00, a day 0.333…
        ([], on(30), 1_000),
        ([], on(-5), 0),
        ([(on(0), 100_000)], on(30), 0),  # in time
        ([(on(-9), 40_000)], on(30), 600),
        ([(on(10), 100_000)], on(30), 333),  # ten days, the day of the payment among them
        ([(on(10), 40_000)], on(30), 733),  # 10 days of 1,000.00 and 20 of 600.00
        ([(on(10), 40_000), (on(20), -40_000)], on(30), 867),  # it went back: 10, 10 and 10 days
        ([(on(40), 100_000)], on(30), 1_000),  # recorded ahead of the day that is asked
    ],
)
def test_simple_interest_by_the_day(payments: list[tuple[date, int]], until: date, minor: int) -> None:
    assert interest_minor(100_000, payments, due_on=DUE, until=until, monthly_bp=100) == minor


def test_a_credit_note_bears_none() -> None:
    assert interest_minor(-100_000, [], due_on=DUE, until=on(30), monthly_bp=100) == 0


def late(world: World, **terms: Any) -> tuple[Agreed, dict[str, Any]]:
    """Have an invoice over 1,000.00 whose due day was 30 days ago."""
    agreed = Agreed(world, terms={"late_interest_monthly_bp": 100, "tax_bp": 1_900, **terms})
    cue, other = agreed.cue(), agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, other, amount_minor=200_000))
    agreed.approve(agreed.take(cue))
    invoice = agreed.invoice()

    def put_back(session: Session) -> None:
        session.get_one(Invoice, UUID(invoice["id"])).due_on = TODAY - timedelta(days=30)

    world.server.in_database(put_back)
    return agreed, body_of(world.designer.get(f"/v1/invoices/{invoice['id']}"))


def charge(by: Any, invoice: dict[str, Any]) -> Any:
    return by.post(f"/v1/invoices/{invoice['id']}/late-interest")


@pytest.mark.slow
def test_it_is_shown_charged_once_and_invoiced_without_tax(world: World) -> None:
    agreed, invoice = late(world)
    assert (invoice["total_minor"], invoice["late_interest_minor"]) == (119_000, 1_190)
    assert invoice["late_interest_charged_minor"] == 0
    assert charge(world.designer, invoice).json()["late_interest_charged_minor"] == 1_190
    assert refused(charge(world.designer, invoice)) == (409, "no-interest-due")
    assert agreed.owed()[-1] == ("late_interest", 1_190)
    figures = agreed.figures()
    assert figures["agreed_minor"] == 201_190
    sums = ("paid_minor", "due_minor", "open_minor", "saved_minor")
    assert sum(figures[name] for name in sums) == figures["agreed_minor"]
    billed = agreed.invoice()
    assert [line["text"] for line in billed["lines"]] == [
        f"Interest on invoice {invoice['full_number']}, up to {day_in_words(TODAY)}"
    ]
    assert (billed["taxes"], billed["total_minor"]) == ([], 1_190)
    record = body_of(world.producer.get(f"/v1/contracts/{agreed.contract_id}/record"))
    assert record["faults"] == []


@pytest.mark.slow
def test_interest_bears_no_interest(world: World) -> None:
    agreed, invoice = late(world)
    charge(world.designer, invoice)
    billed = agreed.invoice()

    def put_back(session: Session) -> None:
        session.get_one(Invoice, UUID(billed["id"])).due_on = TODAY - timedelta(days=300)

    world.server.in_database(put_back)
    assert body_of(world.designer.get(f"/v1/invoices/{billed['id']}"))["late_interest_minor"] == 0


@pytest.mark.slow
def test_a_late_payment_ends_it(world: World) -> None:
    agreed, invoice = late(world)
    answer = world.producer.post(
        f"/v1/invoices/{invoice['id']}/payments",
        json={"amount_minor": 119_000, "reference": "T-1", "paid_on": day(-15)},
    )
    assert answer.status_code == 201, answer.text
    assert answer.json()["late_interest_minor"] == 595, "half of the month"
    assert charge(world.designer, invoice).status_code == 201
    assert agreed.owed()[-1] == ("late_interest", 595)


@pytest.mark.slow
@pytest.mark.parametrize(
    "terms", [{"late_interest_monthly_bp": 0}, {"late_interest_monthly_bp": 0, "late_monthly_bp": 100}]
)
def test_a_text_without_the_rate_bears_none(world: World, terms: dict[str, int]) -> None:
    _, invoice = late(world, **terms)
    assert invoice["late_interest_minor"] == 0
    assert refused(charge(world.designer, invoice)) == (409, "no-interest-due")


@pytest.mark.slow
def test_only_the_designer_charges_it(world: World) -> None:
    _, invoice = late(world)
    assert refused(charge(world.producer, invoice)) == (403, "other-party-needed")
    assert charge(world.reviewer, invoice).status_code == 404
