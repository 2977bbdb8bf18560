"""A contract begun like the last one."""

from typing import Any

import pytest
from sqlalchemy.orm import Session

from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.agreements.conftest import Contracts
from tests.app.reviews.making import refused
from tests.support.server import World


def last(contracts: Contracts, kind: str = "single", engagement_id: str | None = None) -> Any:
    path = f"/projects/{contracts.world.project_id}/last-contract"
    params = {"engagement_id": engagement_id or contracts.engagement_id(), "kind": kind}
    return contracts.ask(contracts.world.producer, "GET", path, params=params)["contract"]


def changed(contracts: Contracts) -> dict[str, Any]:
    """Draft, change in clauses, terms and payment, and send a contract."""
    draft = contracts.begin(currency="EUR")
    version = draft["version"]
    clauses = [
        one | {"text": f"{one['text']} Of our own."} if one["key"] == "parties" else one for one in version["clauses"]
    ]
    terms = version["terms"] | {"rounds_included": 3, "po_number": "PO-77", "tax_bp": 1_900}
    saved = contracts.save(draft, clauses=clauses, terms=terms, release_clause="on_completion", holdback_bp=1_000)
    return contracts.send(saved)


def engage_another(contracts: Contracts) -> str:
    """Engage a second designer on the project, and return the engagement's id."""
    world = contracts.world

    def engaged(session: Session) -> str:
        of = {"studio_id": world.studio_id, "project_id": world.project_id}
        engagement = Engagement(**of, designer_id=world.other_designer_id, kind=EngagementKind.CONTRACT)
        session.add(engagement)
        session.flush()
        return str(engagement.id)

    return str(world.server.in_database(engaged))


def test_nothing_to_begin_like_before_one_was_sent(contracts: Contracts) -> None:
    contracts.begin()
    assert last(contracts) is None


@pytest.mark.slow
def test_clauses_terms_and_payment_are_those_of_the_last(contracts: Contracts) -> None:
    sent = changed(contracts)
    found = last(contracts)
    assert (found["id"], found["currency"]) == (sent["id"], "EUR")
    begun = contracts.begin(currency="EUR", same_as_id=found["id"], title="Effects for Beta")
    assert begun["version"]["note"] == "Begun like Effects for Alpha"
    assert begun["version"]["clauses"] == sent["version"]["clauses"]
    assert (begun["release_clause"], begun["holdback_bp"]) == ("on_completion", 1_000)
    terms, before = begun["version"]["terms"], sent["version"]["terms"]
    assert terms["po_number"] == ""  # it belongs to one contract
    assert {**terms, "po_number": "PO-77"} == before


@pytest.mark.slow
def test_what_is_another_designers_own_begins_as_in_the_library(contracts: Contracts, world: World) -> None:
    sent = changed(contracts)
    library = contracts.begin()["version"]
    other = engage_another(contracts)
    found = last(contracts, engagement_id=other)
    assert found["id"] == sent["id"]  # the last of the studio, as there is none with this designer
    begun = contracts.begin(engagement_id=other, same_as_id=found["id"])["version"]
    parties = {one["key"]: one["text"] for one in begun["clauses"]}["parties"]
    assert parties == {one["key"]: one["text"] for one in library["clauses"]}["parties"]
    assert (begun["terms"]["tax_bp"], begun["terms"]["rounds_included"]) == (library["terms"]["tax_bp"], 3)


@pytest.mark.slow
def test_the_last_with_the_same_designer_comes_first(contracts: Contracts) -> None:
    mine = changed(contracts)
    other = engage_another(contracts)
    theirs = contracts.send(contracts.begin(engagement_id=other))
    assert last(contracts)["id"] == mine["id"]
    assert last(contracts, engagement_id=other)["id"] == theirs["id"]


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["nda", "framework"])
def test_one_of_another_kind_is_none_to_begin_like(contracts: Contracts, kind: str) -> None:
    sent = changed(contracts)
    assert last(contracts, kind) is None
    body = {"engagement_id": contracts.engagement_id(), "kind": kind, "title": "Other", "same_as_id": sent["id"]}
    path = f"/v1/projects/{contracts.world.project_id}/contracts"
    assert refused(contracts.world.producer.post(path, json=body)) == (404, "contract-not-found")
