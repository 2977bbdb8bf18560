"""Signers who are named in a contract sign its change orders and its settlement statement too."""

from typing import Any
from uuid import UUID

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.accounts.models import Membership, Person
from app.accounts.rules import AddressProof, Role
from app.agreements.models import ContractSigner
from app.agreements.queries import contract_by_id
from app.amendments.verification import validation_errors
from app.core import clock
from app.core.db import new_id
from tests.app.agreements.test_signing import code_for
from tests.app.amendments.test_change_orders import Order, move
from tests.app.money.agreed import day
from tests.app.reviews.making import body_of, refused
from tests.support.server import World
from tests.support.smtp import mail_server
from tests.support.waiting import until

pytestmark = pytest.mark.both_databases


@pytest.fixture
def order(world: World) -> Order:
    return Order(world)


@pytest.fixture
def second(order: Order) -> UUID:
    """Another producer of the studio, the second signer of the contract."""
    world, person_id = order.world, new_id()

    def name_both(session: Session) -> None:
        session.add(Person(id=person_id, email=f"{person_id}@example.test", name="Executive producer"))
        session.flush()
        session.add(Membership(studio_id=world.studio_id, person_id=person_id, roles=[Role.PRODUCER]))
        for position, signer in enumerate((world.producer_id, person_id), start=1):
            tenant = {"studio_id": world.studio_id, "project_id": world.project_id}
            session.add(ContractSigner(**tenant, contract_id=order.contract_id, person_id=signer, position=position))

    world.server.in_database(name_both)
    return person_id


def proposed(order: Order, by: Any) -> dict[str, Any]:
    assert order.propose(move(order, "Beta", day(32)), by=by).status_code == 201
    one: dict[str, Any] = order.read()["orders"][-1]
    return one


def signed(order: Order) -> list[tuple[str, str]]:
    return [(one["party"], one["name"]) for one in order.read()["orders"][-1]["signed"]]


@pytest.mark.slow
def test_a_change_order_holds_once_both_signers_and_the_designer_have_signed(order: Order, second: UUID) -> None:
    world, executive = order.world, order.world.signed_in(second)
    before = faults(order)
    assert proposed(order, world.designer)["signatures_needed"] == 3
    assert order.read(executive)["orders"][0]["may"]["agree"] is False
    assert refused(order.accept(executive, "E. Producer")) == (409, "not-your-turn")
    body_of(order.accept(world.producer, "P. Producer"))
    assert refused(order.accept(world.producer, "P. Producer")) == (409, "already-accepted")
    assert order.read(executive)["orders"][0]["may"]["agree"] is True
    halfway = body_of(order.accept(world.designer, "N. Designer"))["orders"][0]
    assert (halfway["state"], order.plan_now()[2][2]) == ("proposed", day(28))
    agreed = body_of(order.accept(executive, "E. Producer"))["orders"][0]
    assert (agreed["state"], order.plan_now()[2][2]) == ("agreed", day(32))
    assert signed(order) == [("studio", "P. Producer"), ("designer", "N. Designer"), ("studio", "E. Producer")]
    assert order.entries()[-5:] == ["change_accepted", "change_accepted", "change_accepted", "changed", "planned"]
    assert faults(order) == before


def test_a_producer_who_is_not_named_does_not_sign_it(order: Order, second: UUID) -> None:
    world, other = order.world, new_id()

    def add(session: Session) -> None:
        session.add(Person(id=other, email=f"{other}@example.test", name="Line producer"))
        session.flush()
        session.add(Membership(studio_id=world.studio_id, person_id=other, roles=[Role.PRODUCER]))

    world.server.in_database(add)
    proposed(order, world.signed_in(other))
    assert refused(order.accept(world.signed_in(other), "L. Producer")) == (403, "not-a-signer")


@pytest.mark.slow
def test_a_signer_who_is_no_producer_any_more_is_passed_over(order: Order, second: UUID) -> None:
    leaves = sa.delete(Membership).where(Membership.person_id == second)
    order.world.server.in_database(lambda session: session.execute(leaves))
    assert proposed(order, order.world.designer)["signatures_needed"] == 2
    body_of(order.accept(order.world.producer, "P. Producer"))
    agreed = body_of(order.accept(order.world.designer, "N. Designer"))["orders"][0]
    assert agreed["state"] == "agreed"


@pytest.mark.slow
def test_the_settlement_statement_needs_both_signers(order: Order, second: UUID) -> None:
    world, executive = order.world, order.world.signed_in(second)
    path = f"/v1/contracts/{order.contract_id}/ending"
    before = faults(order)
    ending = body_of(world.producer.post(f"{path}/notice", json={"reason": "The level is cut"}))
    body = {"name": "A. Name", "text_sha256": ending["statement_sha256"]}
    for by in (world.designer, world.producer):
        assert body_of(by.post(f"{path}/agree", json=body))["state"] == "notice"
    halfway = body_of(executive.get(path))
    assert (len(halfway["signed"]), halfway["signatures_needed"], halfway["may"]["agree"]) == (2, 3, True)
    assert body_of(executive.post(f"{path}/agree", json=body))["state"] == "settled"
    assert set(faults(order)) <= set(before), "no signature is named"


@pytest.mark.slow
def test_the_second_signer_is_mailed_once_the_first_has_signed(order: Order, second: UUID) -> None:
    world, needs = order.world, "a change order needs your signature"
    text = {"text_sha256": proposed(order, world.producer)["text_sha256"]}
    verified = sa.update(Person).values(email_verified_at=clock.now(), email_proof=AddressProof.MAIL)
    world.server.in_database(lambda session: session.execute(verified))
    with mail_server(world.server) as mails:
        code = code_for(world, mails, {"id": order.contract_id, "version": text}, world.producer, world.producer_id)
        assert not any(needs in text for text in mails.texts_for(f"{second}@example.test"))
        body_of(world.producer.post(f"{order.path}/1/accept", json={"name": "P. Producer", "code": code, **text}))
        until(lambda: any(needs in text for text in mails.texts_for(f"{second}@example.test")))


@pytest.mark.slow
def test_a_signature_that_is_taken_away_is_found(order: Order, second: UUID) -> None:
    world = order.world
    proposed(order, world.designer)
    for by in (world.producer, world.designer, world.signed_in(second)):
        body_of(order.accept(by, "A. Name"))
    taken = "delete from contracts_amendment_acceptances where person_id = :person"
    bound = sa.text(taken).bindparams(sa.bindparam("person", second, type_=sa.Uuid))
    world.server.in_database(lambda session: session.execute(bound))
    assert any("is missing, and entry" in fault for fault in faults(order))


def faults(order: Order) -> list[str]:
    """Return what is wrong with the contract, whose text and state no test has recorded."""

    def found(session: Session) -> list[str]:
        return validation_errors(session, order.world.server.runtime.store, contract_by_id(session, order.contract_id))

    said: list[str] = order.world.server.in_database(found)
    return said
