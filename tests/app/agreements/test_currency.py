"""Another currency of a draft converts nothing: its amounts are entered again."""

from typing import Any

import pytest

from tests.app.agreements.conftest import Contracts
from tests.app.agreements.redlining import refusal
from tests.support.server import World

PLAN = [
    {"name": "Deposit", "amount_minor": 100_000, "is_deposit": True},
    {"name": "Alpha", "amount_minor": 400_000, "due_on": "2027-03-01"},
]


def drafted(world: World, contracts: Contracts) -> dict[str, Any]:
    begun = contracts.begin()
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json={"milestones": PLAN})
    draft: dict[str, Any] = contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}")
    return draft


@pytest.mark.slow
def test_the_plans_amounts_are_asked_for_again(world: World, contracts: Contracts) -> None:
    draft = drafted(world, contracts)
    body = contracts.draft_of(draft, currency="EUR") | {"based_on_version": draft["version"]["number"]}
    refused = world.producer.put(f"/v1/contracts/{draft['id']}/draft", json=body)
    assert refusal(refused)[:2] == (422, "amounts-needed")
    assert "Alpha: USD 4,000.00" in refused.json()["detail"]
    assert "EUR" in refused.json()["fix"]
    plan = contracts.ask(world.producer, "GET", f"/contracts/{draft['id']}/milestones")
    assert plan["currency"] == "USD", "nothing was saved"
    ids = [one["id"] for one in plan["milestones"]]
    half = [{"milestone_id": ids[0], "amount_minor": 90_000}]
    missing = world.producer.put(f"/v1/contracts/{draft['id']}/draft", json=body | {"amounts": half})
    assert [one["where"] for one in missing.json()["errors"]] == [f"milestones.{ids[1]}"]
    whole = [*half, {"milestone_id": ids[1], "amount_minor": 360_000}]
    saved = contracts.save(draft, currency="EUR", amounts=whole)
    assert saved["currency"] == "EUR"
    plan = contracts.ask(world.producer, "GET", f"/contracts/{draft['id']}/milestones")
    assert [one["amount_minor"] for one in plan["milestones"]] == [90_000, 360_000]


@pytest.mark.slow
def test_amounts_of_the_clauses_are_asked_for_too(world: World, contracts: Contracts) -> None:
    begun = contracts.begin()
    terms = begun["version"]["terms"] | {"direction_hour_minor": 9_900}
    contracts.save(begun, terms=terms)
    draft = contracts.ask(world.producer, "GET", f"/contracts/{begun['id']}")
    body = contracts.draft_of(draft, currency="EUR") | {"based_on_version": draft["version"]["number"]}
    refused = world.producer.put(f"/v1/contracts/{draft['id']}/draft", json=body)
    assert [one["where"] for one in refused.json()["errors"]] == ["terms.direction_hour_minor"]
    assert contracts.save(draft, currency="EUR", amounts=[])["currency"] == "EUR"


def test_a_draft_without_amounts_of_its_own_changes_its_currency(world: World, contracts: Contracts) -> None:
    assert contracts.save(contracts.begin(), currency="EUR")["currency"] == "EUR"
