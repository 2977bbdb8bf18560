"""What is done by hand to the tables of a contract is named by `soundlist verify`, each kind by its own words."""

import json
from collections.abc import Callable, Mapping, Sequence
from datetime import date, timedelta
from functools import partial
from pathlib import Path
from typing import Any
from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session
from sqlalchemy.sql.dml import UpdateBase
from typer.testing import CliRunner

from app.agreements.models import Contract, ContractAcceptance, ContractEvent, ContractVersion, Seal
from app.agreements.queries import contract_by_id, contract_by_id_or_none
from app.agreements.record.signed_checkpoints import signed_checkpoint
from app.agreements.rules import ContractState
from app.amendments.models import AmendmentAcceptance, ChangeOrder, Notice
from app.amendments.rules import ChangeOrderState
from app.amendments.verification import validation_errors
from app.cli import cli, keeping
from app.core import clock
from app.core.record import START, canonical, link
from app.money.ledger.rules import LineKind
from app.money.models import LedgerLine
from app.notifications import contract_jobs
from app.settings import Settings
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import TODAY, Agreed, deposit, milestone
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World
from tests.support.smtp import MailServer, mail_server
from tests.support.waiting import until


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
        return validation_errors(session, world.server.runtime.store, contract_by_id(session, contract_id))

    said: list[str] = world.server.in_database(found)
    return said


def faults_after(world: World, contract_id: UUID, deeds: Mapping[str, UpdateBase]) -> dict[str, list[str]]:
    """Return what is wrong after each deed alone: each is taken back before the next."""

    def found(session: Session) -> dict[str, list[str]]:
        named = {}
        for deed, statement in deeds.items():
            with session.begin_nested() as step:
                session.execute(statement)
                session.expire_all()
                named[deed] = validation_errors(
                    session, world.server.runtime.store, contract_by_id(session, contract_id)
                )
                step.rollback()
            session.expire_all()
        return named

    said: dict[str, list[str]] = world.server.in_database(found)
    return said


@pytest.mark.slow
def test_an_untouched_contract_is_whole(world: World, contract_id: UUID) -> None:
    assert faults(world, contract_id) == []


AT = clock.now()
DEEDS: dict[str, tuple[UpdateBase, str]] = {
    "another state": (
        sa.update(Contract).values(state=ContractState.AGREED, ended_at=None),
        "the contract is agreed, and the record says ended",
    ),
    "another end": (sa.update(Contract).values(ended_at=AT), "its ended_at is"),
    "another reason": (
        sa.update(Contract).values(end_reason="No money"),
        "its end_reason is No money",
    ),
    "a refused change order put in force": (
        sa.update(ChangeOrder).where(ChangeOrder.number == 2).values(state=ChangeOrderState.AGREED),
        "its state is agreed, and the record says refused",
    ),
    "another statement": (sa.update(Notice).values(statement="# Nothing is owed"), "its statement is sha256:"),
    "a notice that was not settled": (
        sa.update(Notice).values(statement=None, statement_sha256=None, settled_at=None),
        "its settled_at is empty",
    ),
    "a yes to the statement deleted": (sa.delete(AmendmentAcceptance), "is missing, and entry"),
}


def of_contract(statement: UpdateBase, contract_id: UUID) -> UpdateBase:
    named = sa.column("id" if statement.table.name == "contracts_contracts" else "contract_id", sa.Uuid)
    return statement.where(named == contract_id)


@pytest.mark.slow
def test_each_deed_is_named(world: World, contract_id: UUID) -> None:
    deeds = {deed: of_contract(statement, contract_id) for deed, (statement, _) in DEEDS.items()}
    named = faults_after(world, contract_id, deeds)
    assert {deed: said for deed, said in named.items() if not any(DEEDS[deed][1] in fault for fault in said)} == {}
    assert faults(world, contract_id) == [], "each was taken back"


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


ONCE_ONLY = (LineKind.EXTRA_ROUND, LineKind.REVERSED)


def add_a_line(session: Session, contract_id: UUID) -> None:
    """Copy a line of a kind that the database takes twice."""
    of_it = session.scalars(
        sa.select(LedgerLine).where(LedgerLine.contract_id == contract_id, LedgerLine.kind.not_in(ONCE_ONLY))
    ).first()
    assert of_it is not None
    facts: dict[str, Any] = {column.key: getattr(of_it, column.key) for column in sa.inspect(LedgerLine).columns}
    session.execute(sa.insert(LedgerLine), [facts | {"id": uuid4()}])


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


@pytest.mark.slow
@pytest.mark.parametrize(
    ("deed", "words"),
    [
        (chain_empty_entries, "is in no entry"),
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


# What is whole in itself: record and tables altered together. Only a head that a party has kept shows it.
def roll_back_with_tables(session: Session, contract_id: UUID) -> None:
    """Undo the last signature everywhere: entries, acceptance, seal and state."""
    events = events_in_order(session, contract_id)
    for event in events[-3:]:
        assert event.kind in ("accepted_by", "agreed", "sealed")
        session.delete(event)
    of_it = ContractAcceptance.contract_id == contract_id
    session.execute(sa.delete(ContractAcceptance).where(of_it, ContractAcceptance.party == "studio"))
    session.execute(sa.delete(Seal).where(Seal.contract_id == contract_id))
    before = {"state": ContractState.SENT, "agreed_at": None}
    head = {"record_length": events[-4].seq, "record_sha256": events[-4].sha256}
    session.execute(sa.update(Contract).where(Contract.id == contract_id).values(before | head))


def chain_another_name(session: Session, contract_id: UUID) -> None:
    """Put another name under a signature, in its row and in its entry, and write the chain after it again."""
    contract, previous = session.get_one(Contract, contract_id), START
    session.execute(
        sa.update(ContractAcceptance).where(ContractAcceptance.contract_id == contract_id).values(name="Somebody")
    )
    for event in events_in_order(session, contract_id):
        said = json.loads(event.payload)
        for signature in said.get("rows", {}).get("added", {}).get("signature", {}).values():
            signature["name"] = said["name"] = "Somebody"
        payload = canonical(said)
        at = event.at.isoformat(timespec="microseconds")
        entry = link(previous, of=str(contract_id), seq=event.seq, at=at, kind=event.kind, payload=payload)
        event.payload, event.previous_sha256, event.sha256 = payload, previous, entry.sha256
        previous = entry.sha256
    contract.record_sha256 = previous


def delete_the_contract(session: Session, contract_id: UUID) -> None:
    """Delete a contract with all that belongs to it."""
    for table in (Seal, ContractAcceptance, ContractEvent, ContractVersion):
        session.execute(sa.delete(table).where(table.contract_id == contract_id))
    session.execute(sa.delete(Contract).where(Contract.id == contract_id))


def events_in_order(session: Session, contract_id: UUID) -> Sequence[ContractEvent]:
    return session.scalars(
        sa.select(ContractEvent).where(ContractEvent.contract_id == contract_id).order_by(ContractEvent.seq)
    ).all()


@pytest.fixture
def nda_id(world: World, contracts: Contracts) -> UUID:
    agreed = contracts.agree(contracts.begin("nda"))
    world.server.wait_for_jobs()
    return UUID(agreed["id"])


def verified_with(world: World, head: Path, monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """Return what `soundlist verify --head` says of a kept head."""
    monkeypatch.setattr(keeping, "read_settings_or_exit", lambda: world.server.runtime.settings)
    output = CliRunner().invoke(cli, ["verify", "--head", str(head)]).output
    assert "and 1 copies looked at" in output
    return [line.removeprefix(f"{head}: ") for line in output.splitlines() if line.startswith(f"{head}: ")]


def kept_head(world: World, contract_id: UUID, folder: Path) -> Path:
    answer = world.designer.get(f"/v1/contracts/{contract_id}/head.json")
    assert answer.status_code == 200
    (folder / "head.json").write_text(answer.text)
    return folder / "head.json"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("deed", "words"),
    [
        (roll_back_with_tables, "the record has 2 entries, and had 5 on"),
        (chain_another_name, "entry 5 is not the one that stood there on"),
        (delete_the_contract, "is not on this server"),
    ],
)
def test_a_kept_head_shows_what_is_whole_in_itself(
    world: World,
    nda_id: UUID,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    deed: Callable[[Session, UUID], None],
    words: str,
) -> None:
    head = kept_head(world, nda_id, tmp_path)
    assert verified_with(world, head, monkeypatch) == []
    world.server.in_database(lambda session: deed(session, nda_id))

    def others_say(session: Session) -> list[str]:
        contract = contract_by_id_or_none(session, nda_id)
        return validation_errors(session, world.server.runtime.store, contract) if contract else []

    assert world.server.in_database(others_say) == []
    assert any(words in fault for fault in verified_with(world, head, monkeypatch))


@pytest.mark.slow
def test_a_head_stays_true_while_the_record_grows(
    world: World, contracts: Contracts, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    sent = contracts.send(contracts.begin("nda"))
    head = kept_head(world, UUID(sent["id"]), tmp_path)
    contracts.accept(sent, world.designer, "N. Designer")
    assert verified_with(world, head, monkeypatch) == []


@pytest.mark.slow
@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"length": 3}, "it was altered"),
        ({"sha256": "0" * 64}, "it was altered"),
        ({"format": 2}, "its format is 2"),
        ({"signature": "AAAA"}, "it was altered"),
        ({"key": "00"}, "it is not a signed head"),
    ],
)
def test_an_altered_head_is_none(
    world: World, nda_id: UUID, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, change: dict[str, Any], words: str
) -> None:
    head = kept_head(world, nda_id, tmp_path)
    head.write_text(json.dumps(json.loads(head.read_text()) | change))
    assert any(fault.startswith(words) for fault in verified_with(world, head, monkeypatch))


@pytest.mark.slow
def test_a_head_by_another_key_is_reported(
    world: World, nda_id: UUID, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    other = Settings(secret_key="the key of another server")

    def signed(session: Session) -> dict[str, Any]:
        return signed_checkpoint(other, contract_by_id(session, nda_id))

    head = tmp_path / "head.json"
    head.write_text(json.dumps(world.server.in_database(signed)))
    assert verified_with(world, head, monkeypatch)[0].startswith("it is signed by the key")


@pytest.mark.slow
def test_heads_are_mailed_once_a_day_to_both_parties_where_they_changed(
    world: World, contracts: Contracts, nda_id: UUID, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def mail() -> None:
        contract_jobs.mail_heads(world.server.runtime, {})
        world.server.wait_for_jobs()

    def heads_for(box: MailServer, person_id: UUID) -> list[str]:
        return [text for text in box.texts_for(f"{person_id}@example.test") if '"signature"' in text]

    with mail_server(world.server) as box:
        mail()
        for person_id in (world.designer_id, world.producer_id):
            until(partial(heads_for, box, person_id))  # the worker's own round may be sending it
            (text,) = heads_for(box, person_id)
        assert heads_for(box, world.approver_id) == []
        head = tmp_path / "mail.txt"
        head.write_text(text)
        assert verified_with(world, head, monkeypatch) == []  # a saved mail is read as it is
        contracts.ask(world.producer, "POST", f"/contracts/{nda_id}/end", json={"reason": "It is over."})
        mail()
        assert len(heads_for(box, world.designer_id)) == 1, "it has grown, and was mailed today"
        yesterday = sa.update(Contract).values(head_mailed_on=clock.now().date() - timedelta(days=1))
        world.server.in_database(lambda session: session.execute(yesterday))
        mail()
        until(lambda: len(heads_for(box, world.designer_id)) == 2)
        world.server.in_database(lambda session: session.execute(yesterday))
        mail()
        assert len(heads_for(box, world.designer_id)) == 2, "it has not grown since"


@pytest.mark.parametrize("stored", [TODAY - timedelta(days=1), None], ids=["another day", "no day"])
def test_another_day_of_shipping_than_the_one_on_record_is_named(world: World, stored: date | None) -> None:
    agreed = Agreed(world, terms={"bonus_minor": 30_000, "bonus_when": "shipped", "bonus_trigger": "it ships"})
    agreed.agree(milestone("Alpha", agreed.cue(), amount_minor=10_000))
    path = f"/v1/contracts/{agreed.contract_id}/shipped"
    body_of(world.producer.post(path, json={"shipped_on": TODAY.isoformat()}))
    assert not any("game_shipped_on" in fault for fault in faults(world, agreed.contract_id))
    altered = sa.update(Contract).where(Contract.id == agreed.contract_id).values(game_shipped_on=stored)
    world.server.in_database(lambda session: session.execute(altered))
    named = f"its game_shipped_on is {stored or 'empty'}, and the record says {TODAY}"
    assert any(named in fault for fault in faults(world, agreed.contract_id))
