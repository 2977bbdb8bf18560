"""Each signer of a contract has verified their address, and no one is on both of its sides."""

import json
from collections.abc import Iterator
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import update

from app.accounts.models import Membership, Person
from app.accounts.rules import AddressProof, Role
from app.agreements.errors import SamePersonOnBothSides
from app.agreements.rules import ensure_another_person
from app.core import clock
from app.core.db import new_id
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.agreements.conftest import Contracts
from tests.support.server import World


@pytest.fixture
def with_smtp(world: World) -> Iterator[None]:
    """A server with a mail server, so that addresses can be proven."""
    settings = world.server.runtime.settings
    settings.smtp_url = "smtp://127.0.0.1:9"
    yield
    settings.smtp_url = ""


def prove(world: World, person_id: UUID, proof: AddressProof = AddressProof.MAIL) -> None:
    proven = update(Person).where(Person.id == person_id)
    world.server.in_database(
        lambda session: session.execute(proven.values(email_verified_at=clock.now(), email_proof=proof))
    )


def accept(sent: dict[str, Any], by: Client) -> Any:
    body = {"name": "Full Name", "text_sha256": sent["version"]["text_sha256"]}
    return by.post(f"/v1/contracts/{sent['id']}/accept", json=body)


def entries(world: World, contract_id: str) -> list[dict[str, Any]]:
    record = world.producer.get(f"/v1/contracts/{contract_id}/record.json").json()
    return [json.loads(entry["payload"]) for entry in record["entries"] if entry["kind"] == "accepted_by"]


@pytest.mark.slow
def test_an_unproven_address_accepts_nothing_where_mail_can_prove_it(
    world: World, contracts: Contracts, with_smtp: None
) -> None:
    sent = contracts.send(contracts.begin())
    for who, person_id in ((world.designer, world.designer_id), (world.producer, world.producer_id)):
        refused = accept(sent, who)
        assert (refused.status_code, refused.json()["code"]) == (403, "address-not-proven")
        assert "Account page" in refused.json()["fix"]
        prove(world, person_id)
        assert accept(sent, who).json()["code"] == "signing-code-needed"  # test_signing.py goes on from here
    assert entries(world, sent["id"]) == []


@pytest.mark.slow
def test_without_mail_the_record_says_that_an_address_was_not_proven(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    prove(world, world.designer_id, AddressProof.OPERATOR)
    assert accept(sent, world.designer).json()["acceptances"][0]["email_proof"] == "operator"
    agreed = accept(sent, world.producer).json()
    assert agreed["state"] == "agreed"
    assert [each["email_proof"] for each in agreed["acceptances"]] == ["operator", None]
    assert [entry["email_proof"] for entry in entries(world, sent["id"])] == [
        "proven by a link that the server's operator handed over",
        "not proven",
    ]


def engage_producer(world: World) -> str:
    engagement_id = new_id()
    world.server.in_database(
        lambda session: session.add(
            Engagement(
                id=engagement_id,
                studio_id=world.studio_id,
                project_id=world.project_id,
                designer_id=world.producer_id,
                kind=EngagementKind.CONTRACT,
            )
        )
    )
    return str(engagement_id)


@pytest.mark.slow
def test_a_producer_begins_no_contract_with_themselves(world: World) -> None:
    body = {"engagement_id": engage_producer(world), "kind": "single", "title": "Effects"}
    refused = world.producer.post(f"/v1/projects/{world.project_id}/contracts", json=body)
    assert (refused.status_code, refused.json()["code"]) == (403, "same-person-on-both-sides")


@pytest.mark.slow
def test_its_designer_does_not_act_for_the_studio_even_as_its_producer(world: World, contracts: Contracts) -> None:
    contract = contracts.begin()
    membership = Membership(studio_id=world.studio_id, person_id=world.designer_id, roles=[Role.PRODUCER])
    world.server.in_database(lambda session: session.add(membership))
    for step, body in (("send", {}), ("recall", {"reason": "Too early."})):
        refused = world.designer.post(f"/v1/contracts/{contract['id']}/{step}", json=body)
        assert (refused.status_code, refused.json()["code"]) == (403, "same-person-on-both-sides")
    sent = contracts.send(contract)
    accept(sent, world.designer)
    assert accept(sent, world.designer).json()["code"] == "already-accepted"  # their second yes is not the studio's
    assert accept(sent, world.producer).json()["state"] == "agreed"


@pytest.mark.slow
def test_two_accounts_of_one_mailbox_do_not_agree_with_each_other(world: World, contracts: Contracts) -> None:
    sent = contracts.send(contracts.begin())
    box = f"{new_id()}"
    for person_id, name in ((world.designer_id, f"{box}+designs"), (world.producer_id, box)):
        email = f"{name}@example.test"
        world.server.in_database(
            lambda session, person_id=person_id, email=email: session.execute(
                update(Person).where(Person.id == person_id).values(email=email)
            )
        )
    assert accept(sent, world.designer).status_code == 200
    refused = accept(sent, world.producer)
    assert (refused.status_code, refused.json()["code"]) == (403, "same-person-on-both-sides")
    assert "on the contract's other side" in refused.json()["detail"]


ADA, BO = new_id(), new_id()


@pytest.mark.parametrize(
    ("person_id", "email", "is_both"),
    [
        (ADA, "other@x.test", True),
        (BO, "ada@x.test", True),
        (BO, "ada+sound@x.test", True),
        (BO, "ada@y.test", False),
        (BO, "adab@x.test", False),
    ],
)
def test_who_counts_as_the_same(person_id: UUID, email: str, is_both: bool) -> None:
    others = [(ADA, "ada+studio@x.test")]
    if not is_both:
        ensure_another_person(person_id, email, others)
        return
    with pytest.raises(SamePersonOnBothSides):
        ensure_another_person(person_id, email, others)
