"""Change orders that set the caps of hours and days: accepted by both, then the ledger pays up to them."""

from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa

from app.agreements.models import Contract
from app.agreements.queries import contract_by_id
from app.amendments.verification import validation_errors
from tests.app.amendments.refusal_parties import Parties, advised, granted
from tests.app.money.agreed import day, deposit, milestone
from tests.support.pdfs import text_of
from tests.support.server import World

pytestmark = pytest.mark.slow

BY_HOUR = {"hour_rate_minor": 6_001, "hours_cap": 5, "hours_month_cap": 4}


@pytest.fixture
def parties(world: World) -> Parties:
    return Parties(world)


def by_hour(parties: Parties, **terms: Any) -> dict[str, Any]:
    plan = milestone("Alpha", parties.cue(), amount_minor=20_000)
    return parties.agreed(deposit(1_000), plan, **BY_HOUR, **terms)


def caps(**more: int) -> dict[str, Any]:
    return {"kind": "set_caps", **more}


def log(parties: Parties, contract: dict[str, Any], minutes: int) -> Any:
    body = {"worked_on": day(-1), "minutes": minutes, "note": "Directing"}
    return parties.post(parties.designer, contract, "worked-days", **body)


def agreed_minor(parties: Parties, contract: dict[str, Any]) -> int:
    ledger = granted(parties.producer.get(f"/v1/contracts/{contract['id']}/ledger"))
    return int(ledger["figures"]["agreed_minor"])


def orders(parties: Parties, contract: dict[str, Any]) -> dict[str, Any]:
    read: dict[str, Any] = granted(parties.designer.get(f"/v1/contracts/{contract['id']}/change-orders"))
    return read


def faults(parties: Parties, contract: dict[str, Any]) -> list[str]:
    server = parties.world.server
    found: list[str] = server.in_database(
        lambda session: validation_errors(session, server.runtime.store, contract_by_id(session, UUID(contract["id"])))
    )
    return found


@pytest.mark.both_databases
def test_raised_caps_count_once_both_have_accepted(parties: Parties) -> None:
    contract = by_hour(parties)
    assert orders(parties, contract)["caps"] == {"hours_cap": 5, "hours_month_cap": 4, "days_cap": None}
    granted(log(parties, contract, 240))
    advised(log(parties, contract, 60), "cap-exceeded", "propose a change order that raises the caps of hours")
    before = agreed_minor(parties, contract)
    read = granted(parties.propose(contract, caps(hours_cap=8, hours_month_cap=6), by=parties.designer))
    difference = read["orders"][-1]["difference"]
    assert difference["changes"] == [
        "At most 8 hours in all instead of 5 and 6 hours in a month instead of 4 are paid, at USD 60.01 an hour."
    ]
    assert difference["price_after_minor"] - difference["price_before_minor"] == 3 * 6_001
    granted(parties.accept_order(contract, 1, parties.designer))
    advised(log(parties, contract, 60), "cap-exceeded")
    granted(parties.accept_order(contract, 1, parties.producer))
    assert orders(parties, contract)["caps"] == {"hours_cap": 8, "hours_month_cap": 6, "days_cap": None}
    assert agreed_minor(parties, contract) - before == 3 * 6_001
    granted(log(parties, contract, 120))
    advised(log(parties, contract, 1), "cap-exceeded", "at most 6 h a month and 8 h in all are paid by the hour")
    pdf = parties.designer.get(f"/v1/contracts/{contract['id']}/change-orders/1/change-order.pdf")
    assert difference["changes"][0] in text_of(pdf.content)
    assert faults(parties, contract) == []


def test_caps_sink_no_lower_than_what_counts_towards_them(parties: Parties) -> None:
    contract = by_hour(parties)
    granted(log(parties, contract, 121))
    refused = parties.propose(contract, caps(hours_cap=2, hours_month_cap=2))
    words = (
        "2 h 1 min count towards the cap already; the cap can be 3 hours or more",
        "2 h 1 min of one month count towards the cap already; the cap can be 3 hours or more",
    )
    advised(refused, "bad-change-order", *words)
    parties.change(contract, caps(hours_cap=3, hours_month_cap=3))
    granted(log(parties, contract, 59))
    advised(log(parties, contract, 1), "cap-exceeded")


def test_days_have_a_cap_too(parties: Parties) -> None:
    by_day = {"price_mode": "day_rate", "day_rate_minor": 40_000, "days_cap": 2}
    contract = parties.agreed(milestone("Alpha", parties.cue(), amount_minor=0), **by_day)
    for on in (-1, -2):
        body = {"worked_on": day(on), "quarters": 3}
        entry = granted(parties.post(parties.designer, contract, "worked-days", **body))
        granted(parties.producer.post(f"/v1/worked-days/{entry['id']}/agree"))
    refused = parties.propose(contract, caps(days_cap=1))
    advised(refused, "bad-change-order", "days for USD 600.00 are agreed to; the cap can be 2 days or more")
    parties.change(contract, caps(days_cap=5))
    assert orders(parties, contract)["caps"] == {"hours_cap": None, "hours_month_cap": None, "days_cap": 5}
    assert agreed_minor(parties, contract) == 200_000


def test_an_order_that_another_one_overtook_fits_no_longer(parties: Parties) -> None:
    contract = by_hour(parties)
    for cap in (6, 7):
        granted(parties.propose(contract, caps(hours_cap=cap)))
    for by in (parties.designer, parties.producer):
        granted(parties.accept_order(contract, 1, by))
    advised(parties.accept_order(contract, 2, parties.designer), "change-order-stale")


def test_a_cap_put_in_by_hand_is_named(parties: Parties) -> None:
    contract = by_hour(parties)
    parties.change(contract, caps(hours_cap=6))
    assert faults(parties, contract) == []
    raised = sa.update(Contract).values(changed_terms={"hours_cap": 600, "days_cap": 3})
    parties.world.server.in_database(lambda session: session.execute(raised))
    [fault] = faults(parties, contract)
    assert "its changed_terms is sha256:" in fault


def test_a_change_of_no_cap_is_refused(parties: Parties) -> None:
    contract = by_hour(parties)
    answer = parties.propose(contract, caps())
    assert answer.status_code == 422
    assert "name the cap that changes" in answer.text
