"""A deposit is due in the transaction of the second signature."""

import pytest

from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import deposit


def test_the_record_of_signing_names_the_plan_and_what_is_due(contracts: Contracts) -> None:
    begun = contracts.begin()
    plan = {"milestones": [deposit(10_000)]}
    contracts.ask(contracts.world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(begun)
    entries = contracts.entries(agreed)
    assert [entry["kind"] for entry in entries][-3:] == ["agreed", "planned", "due"]
    assert entries[-1]["payload"]["amount_minor"] == 10_000


@pytest.mark.slow
def test_no_contract_is_agreed_without_its_deposit(contracts: Contracts, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise RuntimeError("the deposit cannot be charged")

    sent = contracts.send(contracts.begin())
    contracts.accept(sent, contracts.world.designer, "N. Designer")
    monkeypatch.setattr("app.core.events._handlers", {"contract.agreed": (fail,)})
    body = {"name": "P. Producer", "text_sha256": sent["version"]["text_sha256"]}
    failed = contracts.world.producer.post(f"/v1/contracts/{sent['id']}/accept", json=body)
    assert failed.status_code == 500
    read = contracts.ask(contracts.world.producer, "GET", f"/contracts/{sent['id']}")
    assert (read["state"], len(read["acceptances"])) == ("sent", 1)
