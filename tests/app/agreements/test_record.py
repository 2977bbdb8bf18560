"""The record of a contract in the database: appended in order, and changes by hand are found."""

from collections.abc import Callable
from itertools import pairwise
from uuid import UUID

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractEvent
from app.agreements.record import service as record
from app.agreements.rules import ContractKind
from app.projects.models import Engagement
from tests.support.server import World


def add_contract(session: Session, world: World, number: int = 1) -> UUID:
    engagement = session.scalars(sa.select(Engagement).where(Engagement.project_id == world.project_id)).one()
    contract = Contract(
        studio_id=world.studio_id,
        project_id=world.project_id,
        engagement_id=engagement.id,
        designer_id=world.designer_id,
        number=number,
        title="Effects",
        kind=ContractKind.SINGLE,
        currency="USD",
        created_by=world.producer_id,
    )
    session.add(contract)
    session.flush()
    return contract.id


@pytest.fixture
def contract_id(world: World) -> UUID:
    def make(session: Session) -> UUID:
        contract_id = add_contract(session, world)
        for kind in ("sent", "agreed", "accepted", "due", "paid"):
            record.append(session, contract_id, kind, {"amount_minor": 18_000, "cue": "SW-001", "ort": "Köln"}, by=None)
        return contract_id

    made: UUID = world.server.in_database(make)
    return made


def faults(world: World, contract_id: UUID) -> list[str]:
    found: list[str] = world.server.in_database(
        lambda session: list(record.validation_errors(session, session.get_one(Contract, contract_id)))
    )
    return found


def test_entries_follow_one_another(world: World, contract_id: UUID) -> None:
    def read(session: Session) -> list[ContractEvent]:
        of_it = sa.select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
        return list(session.scalars(of_it))

    events = world.server.in_database(read)
    assert [event.seq for event in events] == [1, 2, 3, 4, 5]
    assert all(later.previous_sha256 == earlier.sha256 for earlier, later in pairwise(events))
    assert faults(world, contract_id) == []


EVENTS = sa.update(ContractEvent)
BY_HAND: dict[str, tuple[Callable[[UUID], list[sa.Executable]], str]] = {
    "an edited amount": (
        lambda of: [EVENTS.where(ContractEvent.contract_id == of, ContractEvent.seq == 4).values(payload="{}")],
        "entry 4 was altered",
    ),
    "another kind": (
        lambda of: [EVENTS.where(ContractEvent.contract_id == of, ContractEvent.seq == 2).values(kind="paid")],
        "entry 2 was altered",
    ),
    "a deletion": (
        lambda of: [sa.delete(ContractEvent).where(ContractEvent.contract_id == of, ContractEvent.seq == 3)],
        "entry 3 is missing",
    ),
    "the end cut off": (
        lambda of: [sa.delete(ContractEvent).where(ContractEvent.contract_id == of, ContractEvent.seq > 3)],
        "the last 2 of 5 entries are missing",
    ),
    "two swapped": (
        lambda of: [
            EVENTS.where(ContractEvent.contract_id == of, ContractEvent.seq == was).values(seq=becomes)
            for was, becomes in ((2, 20), (4, 2), (20, 4))
        ],
        "entry 2 does not follow entry 1",
    ),
}


@pytest.mark.parametrize("deed", BY_HAND)
def test_what_is_done_by_hand_is_found(world: World, contract_id: UUID, deed: str) -> None:
    statements, fault = BY_HAND[deed]

    def do(session: Session) -> None:
        for statement in statements(contract_id):
            session.execute(statement)

    world.server.in_database(do)
    assert fault in faults(world, contract_id)


def test_an_entry_of_another_contract_does_not_fit(world: World, contract_id: UUID) -> None:
    def move(session: Session) -> None:
        other = add_contract(session, world, number=2)
        entry = record.append(session, other, "paid", {"amount_minor": 1}, by=None)
        session.execute(
            sa.delete(ContractEvent).where(ContractEvent.contract_id == contract_id, ContractEvent.seq == 1)
        )
        session.execute(EVENTS.where(ContractEvent.id == entry.id).values(contract_id=contract_id))

    world.server.in_database(move)
    assert "entry 1 was altered" in faults(world, contract_id)
