"""What is done by hand to the tables of a contract is named by `soundlist verify`, each kind by its own words."""

from collections.abc import Callable
from typing import Any
from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session
from sqlalchemy.sql.dml import UpdateBase

from app.agreements.models import Contract, ContractAcceptance, ContractEvent, ContractVersion
from app.agreements.rules import ContractState
from app.amendments.models import AmendmentAcceptance, ChangeOrder, Notice
from app.amendments.rules import ChangeOrderState
from app.amendments.verification import faults_of_all
from app.kit.record import START, link
from app.money.models import LedgerLine, Payment
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import TODAY, deposit, milestone
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World


@pytest.fixture
def contract_id(world: World, contracts: Contracts) -> UUID:
    """Return a contract that was agreed, paid, changed, refused a change, and ended with a settlement."""
    stage = Stage(world)
    cues = [stage.cue("radar_ping"), stage.cue("dock_clamp")]
    begun = contracts.begin()
    plan = {"milestones": [deposit(25_000), milestone("Alpha", *cues, amount_minor=36_000)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(begun)
    path = f"/contracts/{agreed['id']}"
    invoice = contracts.ask(world.designer, "POST", f"{path}/invoices", json={"seller": "Sound designer"})
    body = {"amount_minor": 25_000, "reference": "T-1", "paid_on": TODAY.isoformat()}
    contracts.ask(world.producer, "POST", f"/invoices/{invoice['id']}/payments", json=body)
    for number in (1, 2):
        order = {"reason": "More", "changes": [{"kind": "add_round", "cue_id": str(cues[0])}]}
        read = contracts.ask(world.producer, "POST", f"{path}/change-orders", json=order)
        if number == 2:
            refusal = {"reason": "Enough"}
            contracts.ask(world.designer, "POST", f"{path}/change-orders/2/refuse", json=refusal)
            continue
        for by, name in ((world.designer, "N. Designer"), (world.producer, "P. Producer")):
            yes = {"name": name, "text_sha256": read["orders"][-1]["text_sha256"]}
            contracts.ask(by, "POST", f"{path}/change-orders/{number}/accept", json=yes)
    stage.approve(stage.take(cues[0]))
    contracts.end(agreed)
    assert body_of(world.producer.get(f"/v1{path}"))["state"] == "ended"
    return UUID(agreed["id"])


def faults(world: World, contract_id: UUID) -> list[str]:
    def found(session: Session) -> list[str]:
        return next(
            faults for one, faults in faults_of_all(session, world.server.runtime.store) if one.id == contract_id
        )

    said: list[str] = world.server.in_database(found)
    return said


def test_an_untouched_contract_is_whole(world: World, contract_id: UUID) -> None:
    assert faults(world, contract_id) == []


def line(kind: str) -> sa.ColumnElement[bool]:
    return LedgerLine.kind == kind


DEEDS: dict[str, tuple[UpdateBase, str]] = {
    "a ledger times ten": (
        sa.update(LedgerLine).where(line("deposit")).values(amount_minor=LedgerLine.amount_minor * 10),
        "was altered",
    ),
    "a line of another clause": (sa.update(LedgerLine).where(line("accepted")).values(clause="bonus"), "was altered"),
    "a line of another kind": (sa.update(LedgerLine).where(line("accepted")).values(kind="extra_work"), "was altered"),
    "another payment": (sa.update(Payment).values(amount_minor=24_999), "payment"),
    "another state": (
        sa.update(Contract).values(state=ContractState.AGREED, ended_at=None),
        "the contract is agreed, and the record says ended",
    ),
    "another reason": (sa.update(Contract).values(end_reason="The designer left"), "the reason of its end"),
    "another name on an acceptance": (
        sa.update(ContractAcceptance).where(ContractAcceptance.party == "studio").values(name="Somebody"),
        "by the studio is missing or was altered",
    ),
    "an acceptance from elsewhere": (sa.update(ContractAcceptance).values(address="10.0.0.1"), "is in no entry"),
    "an acceptance deleted": (
        sa.delete(ContractAcceptance).where(ContractAcceptance.party == "designer"),
        "by the designer is missing or was altered",
    ),
    "a yes to a change order by another": (sa.update(AmendmentAcceptance).values(email="a@b.example"), "in no entry"),
    "a yes to a change order deleted": (sa.delete(AmendmentAcceptance), "is missing or was altered"),
    "another text of a change order": (
        sa.update(ChangeOrder).where(ChangeOrder.number == 1).values(text="# Free"),
        "the text of change order 1 was altered",
    ),
    "a refused change order put in force": (
        sa.update(ChangeOrder).where(ChangeOrder.number == 2).values(state=ChangeOrderState.AGREED),
        "change order 2 is agreed, and the record says refused",
    ),
    "a change order deleted": (sa.delete(ChangeOrder), "change order 1 of the record is missing"),
    "another last day": (sa.update(Notice).values(ends_on=TODAY), "notice 1 was altered"),
    "another statement": (
        sa.update(Notice).values(statement="# Nothing is owed"),
        "the settlement statement of notice 1",
    ),
    "a notice deleted": (sa.delete(Notice), "notice 1 of the record is missing"),
    "a version that was never sent": (
        sa.update(ContractVersion).values(sent_at=None, pdf_sha256=None),
        "is not the text that entry",
    ),
    "an edited entry": (
        sa.update(ContractEvent).where(ContractEvent.seq == 2).values(payload="{}"),
        "entry 2 was altered",
    ),
}


@pytest.mark.parametrize("deed", DEEDS)
def test_each_deed_is_named(world: World, contract_id: UUID, deed: str) -> None:
    statement, words = DEEDS[deed]
    named = sa.column("id" if statement.table.name == "contracts_contracts" else "contract_id", sa.Uuid)
    world.server.in_database(lambda session: session.execute(statement.where(named == contract_id)))
    assert any(words in fault for fault in faults(world, contract_id)), faults(world, contract_id)


def empty_the_record(session: Session, contract_id: UUID) -> None:
    session.execute(sa.delete(ContractEvent).where(ContractEvent.contract_id == contract_id))
    contract = session.get_one(Contract, contract_id)
    contract.record_length, contract.record_sha256 = 0, START


def roll_back(session: Session, contract_id: UUID) -> None:
    """Take the last entries away, and set the head to the one before."""
    events = session.scalars(
        sa.select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ).all()
    for event in events[-4:]:
        session.delete(event)
    contract = session.get_one(Contract, contract_id)
    contract.record_length, contract.record_sha256 = events[-5].seq, events[-5].sha256


def add_a_line(session: Session, contract_id: UUID) -> None:
    of_it = session.scalars(sa.select(LedgerLine).where(LedgerLine.contract_id == contract_id)).first()
    assert of_it is not None
    facts: dict[str, Any] = {column.key: getattr(of_it, column.key) for column in sa.inspect(LedgerLine).columns}
    session.add(LedgerLine(**facts | {"id": uuid4()}))


def chain_empty_entries(session: Session, contract_id: UUID) -> None:
    """Empty what an entry says, and write the chain after it again."""
    contract, previous = session.get_one(Contract, contract_id), START
    for event in session.scalars(
        sa.select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ):
        payload = "{}" if event.kind == "sent" else event.payload
        at = event.at.isoformat(timespec="microseconds")
        entry = link(previous, of=str(contract_id), seq=event.seq, at=at, kind=event.kind, payload=payload)
        event.payload, event.previous_sha256, event.sha256 = payload, previous, entry.sha256
        previous = entry.sha256
    contract.record_sha256 = previous


@pytest.mark.parametrize(
    ("deed", "words"),
    [
        (chain_empty_entries, "has another form than this software writes"),
        (empty_the_record, "the contract is ended, and the record says draft"),
        (roll_back, "the contract is ended, and the record says agreed"),
        (add_a_line, "is in no entry"),
    ],
)
def test_each_deed_of_several_steps_is_named(
    world: World, contract_id: UUID, deed: Callable[[Session, UUID], None], words: str
) -> None:
    world.server.in_database(lambda session: deed(session, contract_id))
    assert any(words in fault for fault in faults(world, contract_id)), faults(world, contract_id)
