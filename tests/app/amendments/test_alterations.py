"""`soundlist verify` names whatever is altered by hand in the tables of a contract, and nothing that is untouched."""

import json
import re
import sqlite3
from collections.abc import Callable, Iterator
from contextlib import closing, contextmanager
from dataclasses import dataclass
from datetime import UTC, date, datetime, timedelta
from operator import attrgetter
from pathlib import Path
from typing import Any
from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.models import (
    ClockPause,
    Contract,
    ContractAcceptance,
    ContractCue,
    ContractEvent,
    ContractSigner,
    ContractVersion,
    Milestone,
    Seal,
)
from app.agreements.rules import AcceptedBy, ContractKind, Party, ReleaseClause, WorkState
from app.amendments.models import AmendmentAcceptance, ChangeOrder, Notice
from app.amendments.rules import ChangeOrderState
from app.amendments.verification import Verified, validation_errors, verify_all
from app.core.db import Base, Database
from app.core.record import START, canonical, link
from app.deliveries.models import Take
from app.deliveries.rules import TakeState
from app.money.ledger.rules import LineKind
from app.money.models import ExtraRound, Invoice, InvoiceLine, LedgerLine, Payment
from app.projects.models import ApproverChange, CategoryApprover, Deputy, Spec
from app.reviews.models import ChangeRequest, Comment, Feedback, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import CueChange, Question
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import TODAY, deposit, milestone
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World

pytestmark = [pytest.mark.slow, pytest.mark.both_databases]
LONG_AGO = datetime(2020, 1, 1, tzinfo=UTC)
A_DAY = date(2020, 1, 1)


@dataclass
class Scene:
    """An agreed contract with everything that can happen under one, and another contract beside it."""

    world: World
    contract_id: UUID
    other_id: UUID
    cues: dict[str, UUID]
    person_id: UUID  # who did none of it

    def faults(self, session: Session) -> list[str]:
        """Return what is wrong with the contract."""
        session.expire_all()
        contract = session.get(Contract, self.contract_id)
        assert contract is not None
        return validation_errors(session, self.world.server.runtime.store, contract)


@pytest.fixture
def scene(world: World, contracts: Contracts) -> Scene:
    stage = Stage(world)
    names = ("radar_ping", "dock_clamp", "reactor_hum", "warning_horn")
    cues = {name: stage.cue(name) for name in names}
    stage.approve(stage.take(cues["warning_horn"]))
    begun = contracts.save(contracts.begin(), holdback_bp=1_000)
    signers = {"person_ids": [str(world.producer_id)], "first": "designer"}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/signers", json=signers)
    plan = {"milestones": [deposit(25_000), milestone("Alpha", *cues.values(), amount_minor=48_000)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(begun)
    path, project = f"/contracts/{agreed['id']}", f"/projects/{world.project_id}"
    world.server.wait_for_jobs()
    stage.approve(stage.take(cues["radar_ping"]))
    second = stage.take(cues["radar_ping"])
    stage.approve(second)
    body_of(stage.undo(second))
    take = stage.take(cues["reactor_hum"])
    contracts.ask(world.reviewer, "POST", f"/takes/{take}/comments", json={"text": "A little dull."})
    stage.draft(take)
    stage.send()
    path_of_questions = f"/cues/{cues['reactor_hum']}/questions"
    asked = contracts.ask(world.designer, "POST", path_of_questions, json={"text": "Which size?"})
    answer = {"text": "Large", "joins": False}
    contracts.ask(world.producer, "POST", f"/questions/{asked['id']}/answer", json=answer)
    body_of(world.producer.patch(f"/v1/cues/{cues['reactor_hum']}", json={"edition": 1, "use": "the engine room"}))
    spec = world.producer.get(f"/v1{project}/spec").json()
    another = spec["toml"].replace("head_silence_ms = 5", "head_silence_ms = 9")
    body = {"toml": another, "based_on_version": spec["version"]}
    body_of(world.producer.put(f"/v1{project}/spec", json=body))
    changes = (
        {"kind": "reprice_cue", "cue_id": str(cues["reactor_hum"]), "price_minor": 15_000},
        {"kind": "add_round", "cue_id": str(cues["reactor_hum"])},
        {"kind": "add_round", "cue_id": str(cues["reactor_hum"])},
    )
    for number, change in enumerate(changes, start=1):
        order = {"reason": "Needed for the demo", "changes": [change]}
        read = contracts.ask(world.producer, "POST", f"{path}/change-orders", json=order)
        if number == len(changes):
            refusal = {"reason": "Enough"}
            contracts.ask(world.designer, "POST", f"{path}/change-orders/{number}/refuse", json=refusal)
            continue
        for by, name in ((world.designer, "N. Designer"), (world.producer, "P. Producer")):
            yes = {"name": name, "text_sha256": read["orders"][-1]["text_sha256"]}
            contracts.ask(by, "POST", f"{path}/change-orders/{number}/accept", json=yes)
    body_of(world.producer.post(f"/v1/cues/{cues['dock_clamp']}/cut", json={"reason": "The scene is gone"}))
    invoice = contracts.ask(world.designer, "POST", f"{path}/invoices", json={"seller": "Sound designer"})
    paid = {"amount_minor": 20_000, "reference": "T-1", "paid_on": TODAY.isoformat()}
    read = contracts.ask(world.producer, "POST", f"/invoices/{invoice['id']}/payments", json=paid)
    back = {"amount_minor": 1_000, "reference": "T-2", "paid_on": TODAY.isoformat()}
    contracts.ask(world.producer, "POST", f"/payments/{read['payments'][0]['id']}/refunds", json=back)
    named = {"person_id": str(world.producer_id), "category": "ui"}
    contracts.ask(world.producer, "PUT", f"{project}/category-approvers", json=named)
    while_away = {"person_id": str(world.approver_id), "deputy_id": str(world.producer_id)}
    days = {"from_on": (TODAY + timedelta(days=20)).isoformat(), "until_on": (TODAY + timedelta(days=30)).isoformat()}
    contracts.ask(world.producer, "POST", f"{project}/deputies", json=while_away | days)
    contracts.ask(world.producer, "POST", f"{path}/ending/notice", json={"reason": "The level is cut"})
    other = contracts.agree(contracts.begin("nda", title="Secrets"))
    world.server.wait_for_jobs()
    return Scene(world, UUID(agreed["id"]), UUID(other["id"]), cues, world.stranger_id)


Act = Callable[[Session, Scene], object]


NOTHING = r"\Z\A"  # a pattern that is nowhere
OF_TAKES = r"the take .* is \w+, and (its last verdict is|no verdict says so)"


@dataclass(frozen=True)
class Alteration:
    """What is done by hand to a table, and a pattern of the sentence that names it."""

    name: str
    act: Act
    names_it: str
    others: str = NOTHING  # what else is named, as it follows from it


def rows_of(model: type[Base], scene: Scene) -> sa.ColumnElement[bool]:
    """Return which rows of a table are the scene's."""
    columns = table_of(model).c
    if model is Contract:
        return columns["id"] == scene.contract_id
    if "contract_id" in columns:
        return columns["contract_id"] == scene.contract_id
    return columns["project_id"] == scene.world.project_id


def table_of(model: type[Base]) -> sa.Table:
    return model.metadata.tables[model.__tablename__]


def first_row(session: Session, scene: Scene, model: type[Base], where: sa.ColumnElement[bool] | None) -> Any:
    """Return the first row that an alteration is done to."""
    table = table_of(model)
    chosen = sa.select(table).where(rows_of(model, scene), sa.true() if where is None else where)
    row = session.execute(chosen.order_by(*table.primary_key.columns)).mappings().first()
    assert row is not None, f"the scene has no such row of {table.name}"
    return row


def key_is(model: type[Base], row: Any) -> sa.ColumnElement[bool]:
    (key,) = table_of(model).primary_key.columns
    return key == row[key.name]


def changed(
    model: type[Base], column: str, value: Any, where: sa.ColumnElement[bool] | None = None, **more: Any
) -> Alteration:
    """Return an alteration of one value of one row; a function makes the value from the scene."""

    def act(session: Session, scene: Scene) -> None:
        row = first_row(session, scene, model, where)
        new = value(scene) if callable(value) else value
        assert row[column] != new, "it alters nothing"
        session.execute(sa.update(table_of(model)).where(key_is(model, row)).values({column: new, **more}))

    also = "|".join(more)
    names_it = rf"its {column} is .*, and the record says .* \({model.__tablename__} "
    others = rf"its ({also}) is .* \({model.__tablename__} " if also else OF_TAKES if model is Verdict else NOTHING
    return Alteration(f"{column} of {model.__tablename__}", act, names_it, others)


def deleted(model: type[Base], where: sa.ColumnElement[bool] | None = None, others: str = NOTHING) -> Alteration:
    def act(session: Session, scene: Scene) -> None:
        row = first_row(session, scene, model, where)
        session.execute(sa.delete(table_of(model)).where(key_is(model, row)))

    names_it = rf"is missing, and entry \d+ of the record has it \({model.__tablename__} "
    return Alteration(f"a row of {model.__tablename__} deleted", act, names_it, others)


def inserted(
    model: type[Base], names_it: str = "", where: sa.ColumnElement[bool] | None = None, **other: Any
) -> Alteration:
    """Return the insertion of a row like another."""

    def act(session: Session, scene: Scene) -> None:
        row = first_row(session, scene, model, where)
        made = {name: value(scene) if callable(value) else value for name, value in other.items()}
        session.execute(sa.insert(table_of(model)).values(**dict(row) | {"id": uuid4()} | made))

    names_it = names_it or rf"is in no entry \({model.__tablename__} "
    return Alteration(f"a row put into {model.__tablename__}", act, names_it)


def moved(model: type[Base]) -> Alteration:
    """Return an alteration of the contract that a row belongs to."""
    altered = changed(model, "contract_id", lambda scene: scene.other_id)
    return Alteration(f"a row of {model.__tablename__} moved", altered.act, r"its contract_id is ", altered.names_it)


def of_record(name: str, act: Act, names_it: str, others: str = ".") -> Alteration:
    return Alteration(f"record: {name}", act, names_it, others)


def events_of(session: Session, scene: Scene) -> list[Any]:
    table = table_of(ContractEvent)
    of_contract = sa.select(table).where(table.c.contract_id == scene.contract_id)
    return [dict(event) for event in session.execute(of_contract.order_by(table.c.seq)).mappings()]


def set_event(session: Session, event: Any, **values: Any) -> None:
    session.execute(sa.update(table_of(ContractEvent)).where(key_is(ContractEvent, event)).values(**values))


def set_head(session: Session, scene: Scene, length: int, sha256: str) -> None:
    head = {"record_length": length, "record_sha256": sha256}
    session.execute(sa.update(table_of(Contract)).where(Contract.id == scene.contract_id).values(**head))


def drop_last_entries(session: Session, scene: Scene) -> None:
    """Delete the last entries and nothing else."""
    last = events_of(session, scene)[-3:]
    session.execute(sa.delete(table_of(ContractEvent)).where(ContractEvent.id.in_([event["id"] for event in last])))


def roll_back(session: Session, scene: Scene) -> None:
    """Delete the last entries, and set the head to the one before."""
    events = events_of(session, scene)
    drop_last_entries(session, scene)
    set_head(session, scene, events[-4]["seq"], events[-4]["sha256"])


def drop_an_entry(session: Session, scene: Scene) -> None:
    event = events_of(session, scene)[5]
    session.execute(sa.delete(table_of(ContractEvent)).where(key_is(ContractEvent, event)))


def empty_the_record(session: Session, scene: Scene) -> None:
    session.execute(sa.delete(table_of(ContractEvent)).where(ContractEvent.contract_id == scene.contract_id))
    set_head(session, scene, 0, START)


def swap_entries(session: Session, scene: Scene) -> None:
    fifth, sixth = events_of(session, scene)[4:6]
    for event, seq in ((fifth, 9_999), (sixth, 5), (fifth, 6)):
        set_event(session, event, seq=seq)


def add_an_entry(session: Session, scene: Scene) -> None:
    last = events_of(session, scene)[-1]
    session.execute(sa.insert(table_of(ContractEvent)).values(**last | {"id": uuid4(), "seq": last["seq"] + 1}))


def chain_again(session: Session, scene: Scene, alter: Callable[[str, dict[str, Any]], dict[str, Any]]) -> None:
    """Alter what entries say, and write the whole chain again, so that it is whole in itself."""
    previous = START
    for event in events_of(session, scene):
        payload = canonical(alter(event["kind"], json.loads(event["payload"])))
        at, of = event["at"].isoformat(timespec="microseconds"), str(scene.contract_id)
        entry = link(previous, of=of, seq=event["seq"], at=at, kind=event["kind"], payload=payload)
        set_event(session, event, payload=payload, previous_sha256=previous, sha256=entry.sha256)
        previous = entry.sha256
    set_head(session, scene, len(events_of(session, scene)), previous)


def pay_more(kind: str, payload: dict[str, Any]) -> dict[str, Any]:
    if kind == "paid":
        for row in payload["rows"]["added"]["payment"].values():
            row["amount_minor"] *= 2
    return payload


def forget_rows(kind: str, payload: dict[str, Any]) -> dict[str, Any]:
    return {} if kind == "invoiced" else payload


def other_master(kind: str, payload: dict[str, Any]) -> dict[str, Any]:
    """Put another master into the acceptance alone: the verdict before has the one that was heard."""
    if kind == "accepted":
        for row in payload["rows"]["added"]["take"].values():
            row["master_sha256"] = "f" * 64
    return payload


def no_rows_at_all(kind: str, payload: dict[str, Any]) -> dict[str, Any]:
    return payload | {"rows": ["nothing"]} if kind == "sent" else payload


STRANGER: Callable[[Scene], UUID] = attrgetter("person_id")
OTHER: Callable[[Scene], UUID] = attrgetter("other_id")


def cue_of(name: str) -> Callable[[Scene], UUID]:
    return lambda scene: scene.cues[name]


deposits, of_work = Milestone.is_deposit.is_(True), Milestone.is_deposit.is_(False)
accepted_line = LedgerLine.kind == LineKind.ACCEPTED
paid_line = LedgerLine.kind == LineKind.PAID
is_accepted, is_cut = ContractCue.accepted_at.is_not(None), ContractCue.cut_at.is_not(None)
is_open = sa.and_(ContractCue.accepted_at.is_(None), ContractCue.cut_at.is_(None))
text_too = r"version \d+ is not the text|the text of version \d+ was altered|PDF"
approves, is_withdrawn = Verdict.kind == VerdictKind.APPROVE, Verdict.withdraws_id.is_not(None)
a_draft = ContractVersion.sent_at.is_(None)
is_sent = ContractVersion.sent_at.is_not(None)

ALTERATIONS: tuple[Alteration, ...] = (
    # who agrees on what
    changed(Contract, "designer_id", STRANGER),
    changed(Contract, "title", "Effects for nobody"),
    changed(Contract, "number", 77),
    changed(Contract, "kind", ContractKind.FRAMEWORK),
    changed(Contract, "currency", "CHF"),
    changed(Contract, "release_clause", ReleaseClause.ON_COMPLETION),
    changed(Contract, "deposit_bp", 9_000),
    changed(Contract, "holdback_bp", 0),
    changed(Contract, "created_by", STRANGER),
    changed(Contract, "created_at", LONG_AGO),
    changed(Contract, "signs_first", Party.STUDIO),
    changed(Contract, "agreed_at", LONG_AGO),
    changed(Contract, "changed_terms", {"rounds_included": 9}),
    changed(Contract, "game_shipped_on", A_DAY),
    changed(Contract, "end_reason", "It was nothing."),
    Alteration(
        "a contract ended",
        changed(Contract, "state", "ended", ended_at=LONG_AGO).act,
        "the contract is ended, and the record says agreed",
        r"its ended_at is",
    ),
    Alteration("a contract drafted", changed(Contract, "state", "draft").act, "is draft, and the record says agreed"),
    changed(ContractVersion, "clauses", [], is_sent),
    changed(ContractVersion, "terms", {"rounds_included": 9}, is_sent),
    changed(ContractVersion, "created_by", STRANGER, is_sent),
    changed(ContractVersion, "note", "Never read", is_sent),
    changed(ContractVersion, "pdf_bytes", 1, is_sent),
    Alteration(
        "another text",
        changed(ContractVersion, "text", "# Free of charge", is_sent).act,
        r"the text of version \d+ was altered",
        "its text is",
    ),
    Alteration(
        "another text and its hash",
        changed(ContractVersion, "text", "", is_sent, text_sha256="e3b0c442" + "0" * 56).act,
        r"its text_sha256 is",
        rf"{text_too}|its text is",
    ),
    Alteration(
        "another PDF",
        changed(ContractVersion, "pdf_sha256", "0" * 64, is_sent).act,
        r"its pdf_sha256 is",
        text_too,
    ),
    Alteration(
        "a version that was never sent",
        changed(ContractVersion, "sent_at", None, is_sent, pdf_sha256=None).act,
        r"its sent_at is empty",
        rf"{text_too}|its pdf_sha256 is",
    ),
    inserted(ContractVersion, r"version 99 was added after version \d+ was sent", a_draft, number=99),
    # who signed, in which order, when, and what shows it
    changed(ContractSigner, "person_id", STRANGER),
    changed(ContractSigner, "position", 9),
    deleted(ContractSigner),
    inserted(ContractSigner, person_id=STRANGER, position=5),
    changed(ContractAcceptance, "person_id", STRANGER),
    changed(ContractAcceptance, "name", "Somebody"),
    changed(ContractAcceptance, "email", "somebody@example.test"),
    changed(ContractAcceptance, "address", "10.0.0.1"),
    changed(ContractAcceptance, "agent", "curl"),
    changed(ContractAcceptance, "accepted_at", LONG_AGO),
    changed(ContractAcceptance, "email_proof", "operator"),
    changed(ContractAcceptance, "code_entered_at", LONG_AGO),
    changed(ContractAcceptance, "drawing", [[[0, 0], [1, 1]]]),
    changed(ContractAcceptance, "party", Party.STUDIO, ContractAcceptance.party == Party.DESIGNER),
    deleted(ContractAcceptance),
    moved(ContractAcceptance),
    changed(Seal, "file_bytes", 1),
    changed(Seal, "key_sha256", "0" * 64),
    changed(Seal, "is_timestamped", value=True),
    changed(Seal, "sealed_at", LONG_AGO),
    Alteration("another sealed file", changed(Seal, "file_sha256", "0" * 64).act, "its file_sha256 is", "sealed PDF"),
    deleted(Seal),
    # the plan
    changed(Milestone, "name", "Omega", of_work),
    changed(Milestone, "amount_minor", 50_000, deposits),
    changed(Milestone, "due_on", A_DAY, of_work),
    changed(Milestone, "tax_bp", 1_900, of_work),
    changed(Milestone, "is_deposit", value=False, where=deposits),
    changed(Milestone, "position", 9, of_work),
    moved(Milestone),
    inserted(Milestone, position=8),
    deleted(Milestone, deposits),
    changed(ContractCue, "cue_id", lambda _scene: uuid4(), is_open),
    changed(ContractCue, "milestone_id", lambda _scene: uuid4(), is_open),
    changed(ContractCue, "price_minor", 1, is_open),
    changed(ContractCue, "amount_minor", 1, is_open),
    changed(ContractCue, "estimate_min", 1, is_open),
    changed(ContractCue, "position", 99, is_open),
    changed(ContractCue, "accepted_at", LONG_AGO, is_accepted),
    changed(ContractCue, "accepted_by", AcceptedBy.SILENCE, is_accepted),
    changed(ContractCue, "accepted_at", None, is_accepted, accepted_by=None),
    changed(ContractCue, "accepted_at", LONG_AGO, is_open, accepted_by="verdict"),
    changed(ContractCue, "cut_in", WorkState.DELIVERED, is_cut),
    changed(ContractCue, "cut_at", None, is_cut, cut_in=None),
    changed(ContractCue, "change_requested_at", LONG_AGO),
    deleted(ContractCue, is_open),
    # change orders and notices
    changed(ChangeOrder, "state", ChangeOrderState.AGREED, ChangeOrder.state == ChangeOrderState.REFUSED),
    changed(ChangeOrder, "party", Party.DESIGNER),
    changed(ChangeOrder, "proposed_by", STRANGER),
    changed(ChangeOrder, "proposed_at", LONG_AGO),
    changed(ChangeOrder, "reason", "None"),
    changed(ChangeOrder, "begins_at_once", value=True),
    changed(ChangeOrder, "changes", []),
    changed(ChangeOrder, "text", "# Free"),
    changed(ChangeOrder, "text_sha256", "0" * 64),
    changed(ChangeOrder, "closed_at", LONG_AGO),
    changed(ChangeOrder, "close_reason", "Enough of it", ChangeOrder.state == ChangeOrderState.REFUSED),
    changed(ChangeOrder, "number", 9),
    deleted(ChangeOrder),
    changed(AmendmentAcceptance, "person_id", STRANGER),
    changed(AmendmentAcceptance, "name", "Somebody"),
    changed(AmendmentAcceptance, "accepted_at", LONG_AGO),
    changed(AmendmentAcceptance, "text_sha256", "0" * 64),
    deleted(AmendmentAcceptance),
    changed(ClockPause, "began_at", LONG_AGO),
    changed(ClockPause, "ended_at", None),
    deleted(ClockPause),
    changed(Notice, "party", Party.DESIGNER),
    changed(Notice, "given_by", STRANGER),
    changed(Notice, "given_at", LONG_AGO),
    changed(Notice, "reason", "None"),
    changed(Notice, "ends_on", A_DAY),
    changed(Notice, "withdrawn_at", LONG_AGO),
    deleted(Notice),
    # money
    changed(LedgerLine, "amount_minor", 1, accepted_line),
    changed(LedgerLine, "kind", LineKind.EXTRA_WORK, accepted_line),
    changed(LedgerLine, "clause", "bonus", accepted_line),
    changed(LedgerLine, "cue_id", cue_of("dock_clamp"), accepted_line),
    changed(LedgerLine, "milestone_id", lambda _scene: uuid4(), accepted_line),
    changed(LedgerLine, "person_id", STRANGER, accepted_line),
    changed(LedgerLine, "tax_bp", 1_900, accepted_line),
    changed(LedgerLine, "created_at", LONG_AGO, accepted_line),
    changed(LedgerLine, "round_number", 7, LedgerLine.kind == LineKind.EXTRA_ROUND),
    changed(LedgerLine, "payment_id", lambda _scene: uuid4(), paid_line),
    changed(LedgerLine, "about_id", lambda _scene: uuid4(), paid_line),
    moved(LedgerLine),
    inserted(LedgerLine, where=accepted_line),
    deleted(LedgerLine, accepted_line),
    changed(ExtraRound, "number", 9),
    changed(ExtraRound, "agreed_by", STRANGER),
    changed(ExtraRound, "agreed_at", LONG_AGO),
    changed(ExtraRound, "proposed_by", STRANGER),
    changed(ExtraRound, "cue_id", cue_of("radar_ping")),
    inserted(ExtraRound, number=17),
    deleted(ExtraRound),
    changed(Invoice, "number", 9),
    changed(Invoice, "full_number", "INV-9"),
    changed(Invoice, "issued_on", A_DAY),
    changed(Invoice, "due_on", A_DAY),
    changed(Invoice, "po_number", "PO-9"),
    changed(Invoice, "seller", "Somebody else"),
    changed(Invoice, "buyer", "Somebody else"),
    changed(Invoice, "note", "Paid in cash"),
    changed(Invoice, "reverse_charge", value=True),
    changed(Invoice, "issued_by", STRANGER),
    changed(Invoice, "designer_id", STRANGER),
    changed(Invoice, "created_at", LONG_AGO),
    deleted(Invoice),
    inserted(Invoice, number=3, full_number="3"),
    changed(InvoiceLine, "text", "Nothing"),
    changed(InvoiceLine, "invoice_id", lambda _scene: uuid4()),
    deleted(InvoiceLine),
    changed(Payment, "amount_minor", 1),
    changed(Payment, "reference", "T-9"),
    changed(Payment, "paid_on", A_DAY),
    changed(Payment, "recorded_by", STRANGER),
    changed(Payment, "created_at", LONG_AGO),
    changed(Payment, "invoice_id", lambda _scene: uuid4()),
    changed(Payment, "refund_of_id", None, Payment.refund_of_id.is_not(None)),
    moved(Payment),
    inserted(Payment),
    deleted(Payment),
    # the work: takes, verdicts, comments, who approves, by which spec
    changed(Take, "master_sha256", "f" * 64),
    changed(Take, "master_bytes", 1),
    changed(Take, "file_name", "another.wav"),
    changed(Take, "designer_id", STRANGER),
    changed(Take, "delivery_id", lambda _scene: uuid4()),
    changed(Take, "received_at", LONG_AGO),
    changed(Take, "number", 99),
    changed(Take, "variation", 9),
    changed(Take, "cue_id", cue_of("dock_clamp"), Take.state == TakeState.APPROVED),
    Alteration(
        "an approved take put aside",
        changed(Take, "state", TakeState.SET_ASIDE, Take.state == TakeState.APPROVED).act,
        "is set_aside, and its last verdict is approve",
    ),
    Alteration(
        "a take approved by nobody",
        changed(Take, "state", TakeState.APPROVED, Take.state == TakeState.CHANGE_REQUESTED).act,
        "is approved, and its last verdict is request_change",
    ),
    deleted(Take),
    changed(Verdict, "kind", VerdictKind.SET_ASIDE, approves),
    changed(Verdict, "note", "Free of charge", approves),
    changed(Verdict, "given_by", STRANGER, approves),
    changed(Verdict, "on_behalf_of", STRANGER, approves),
    changed(Verdict, "take_id", lambda _scene: uuid4(), approves),
    changed(Verdict, "cue_id", cue_of("dock_clamp"), approves),
    changed(Verdict, "created_at", LONG_AGO, approves),
    changed(Verdict, "reasons", ["Best timing"], approves),
    changed(Verdict, "without_listening", value=False, where=approves),
    changed(Verdict, "withdraws_id", lambda _scene: uuid4(), is_withdrawn),
    deleted(Verdict, approves, OF_TAKES),
    inserted(Verdict, r"the verdict .* \(approve\) is in no entry", approves, created_at=lambda _s: datetime.now(UTC)),
    changed(Comment, "text", "Perfect."),
    changed(Comment, "written_by", STRANGER),
    changed(Comment, "created_at", LONG_AGO),
    deleted(Comment),
    inserted(Comment, "the comment .* is in no entry", created_at=lambda _scene: datetime.now(UTC)),
    changed(ChangeRequest, "text", "Perfect."),
    changed(ChangeRequest, "written_by", STRANGER),
    changed(ChangeRequest, "start_s", 9.5),
    deleted(ChangeRequest),
    changed(Feedback, "note", "All is well."),
    changed(Question, "text", "Any size?"),
    changed(Question, "answer", "Any size."),
    changed(Question, "asked_by", STRANGER),
    changed(Question, "answered_at", LONG_AGO),
    deleted(Question),
    inserted(Question, "the question .* is in no entry", asked_at=lambda _scene: datetime.now(UTC)),
    changed(ApproverChange, "person_id", STRANGER),
    changed(ApproverChange, "changed_by", STRANGER),
    changed(ApproverChange, "reason", "None"),
    changed(ApproverChange, "created_at", LONG_AGO),
    inserted(ApproverChange, person_id=STRANGER),
    deleted(ApproverChange),
    changed(CategoryApprover, "person_id", STRANGER),
    changed(CategoryApprover, "category", "creatures"),
    deleted(CategoryApprover),
    changed(Deputy, "deputy_id", STRANGER),
    changed(Deputy, "from_on", A_DAY),
    inserted(Deputy),
    changed(Spec, "toml", "format = 1"),
    changed(Spec, "version", 9),
    changed(Spec, "created_by", STRANGER),
    deleted(Spec),
    Alteration(
        "another description of a cue",
        lambda session, scene: session.execute(
            sa.update(table_of(CueChange))
            .where(CueChange.cue_id == scene.cues["reactor_hum"])
            .values(after={"use": "anywhere"})
        ),
        r"revision \d+ of the sound list was altered",
    ),
    # the record itself
    of_record("an edited entry", lambda s, scene: set_event(s, events_of(s, scene)[1], payload="{}"), "2 was altered"),
    of_record("no JSON", lambda s, scene: set_event(s, events_of(s, scene)[1], payload="{"), "entry 2 was altered"),
    of_record("re-dated", lambda s, scene: set_event(s, events_of(s, scene)[3], at=LONG_AGO), "entry 4 was altered"),
    of_record("renamed", lambda s, scene: set_event(s, events_of(s, scene)[3], kind="seen"), "entry 4 was altered"),
    of_record(
        "for another contract",
        lambda s, scene: set_event(s, events_of(s, scene)[5], contract_id=scene.other_id, seq=999),
        "entry 6 is missing",
    ),
    of_record(
        "for another studio",
        lambda s, scene: set_event(s, events_of(s, scene)[3], studio_id=uuid4()),
        "entry 4 is kept for another studio",
    ),
    of_record("the last entries deleted", drop_last_entries, r"the last 3 of \d+ entries are missing"),
    of_record("an entry deleted", drop_an_entry, "entry 6 is missing"),
    of_record("rolled back", roll_back, "is in no entry|and the record says"),
    of_record("emptied", empty_the_record, "the contract is agreed, and the record says draft"),
    of_record("two entries swapped", swap_entries, "entry 5 does not follow entry 4|entry 5 was altered"),
    of_record("an entry put past the end", add_an_entry, r"1 entr.* added past the end"),
    of_record("more paid, chained again", lambda s, scene: chain_again(s, scene, pay_more), "its amount_minor is"),
    of_record("rows forgotten", lambda s, scene: chain_again(s, scene, forget_rows), r"the invoice .* is in no entry"),
    of_record("another master", lambda s, scene: chain_again(s, scene, other_master), "has the master_sha256 f+, "),
    of_record("of another form", lambda s, scene: chain_again(s, scene, no_rows_at_all), "cannot be verified"),
)


# By hand means without foreign keys, as in a shell: dropped until the transaction is rolled back.
WITHOUT_KEYS = """
do $$ declare key record; begin
  for key in select conrelid::regclass as of_table, conname from pg_constraint
             where contype = 'f' and connamespace = current_schema()::regnamespace
  loop execute format('alter table %s drop constraint %I', key.of_table, key.conname); end loop;
end $$
"""


@contextmanager
def by_hand(scene: Scene, folder: Path) -> Iterator[Session]:
    """Give a session on the scene's database, on SQLite on a copy of it, where nothing else waits for the lock."""
    database = scene.world.server.runtime.database
    if not database.is_sqlite:
        with database.writing() as session:
            session.execute(sa.text(WITHOUT_KEYS))
            yield session
            session.rollback()
        return
    with closing(sqlite3.connect(str(database.engine.url.database))) as live:
        live.execute("vacuum into ?", (str(folder / "copy.sqlite"),))
    copy = Database(f"sqlite:///{folder / 'copy.sqlite'}")
    with copy.writing() as session:
        yield session
    copy.dispose()


def faults_after_each(session: Session, scene: Scene) -> Iterator[tuple[Alteration, list[str]]]:
    """Yield what is named after each alteration alone: each is taken back before the next."""
    is_sqlite = session.get_bind().dialect.name == "sqlite"
    for alteration in ALTERATIONS:
        with session.begin_nested() as step:
            if is_sqlite:
                session.execute(sa.text("pragma defer_foreign_keys = on"))
            alteration.act(session, scene)
            yield alteration, scene.faults(session)
            step.rollback()


def test_each_alteration_is_named_and_nothing_else(scene: Scene, tmp_path: Path) -> None:
    assert len(ALTERATIONS) >= 180
    wrong = []
    with by_hand(scene, tmp_path) as session:
        for alteration, faults in faults_after_each(session, scene):
            naming = [fault for fault in faults if re.search(alteration.names_it, fault)]
            others = [fault for fault in faults if fault not in naming]
            if not naming or not all(re.search(alteration.others, fault) for fault in others):
                wrong.append(f"{alteration.name}: {faults or 'nothing is named'}")
        assert scene.faults(session) == [], "each was taken back"
    assert "\n".join(wrong) == ""


def test_what_is_untouched_is_whole_and_one_damaged_contract_never_stops_the_rest(scene: Scene) -> None:
    runtime = scene.world.server.runtime

    def verified() -> dict[str, Verified]:
        return {contract.contract_id: contract for contract in verify_all(runtime.database, runtime.store)}

    whole = verified()
    assert [whole[str(id_)].faults for id_ in (scene.contract_id, scene.other_id)] == [[], []]

    def damage(session: Session, value: str) -> None:
        kind = sa.type_coerce(sa.literal(value), sa.String)
        table = table_of(Contract)
        session.execute(sa.update(table).where(table.c.id == scene.contract_id).values({"kind": kind}))

    scene.world.server.in_database(lambda session: damage(session, "scribble"))
    try:
        damaged = verified()
        assert "the contract cannot be read: 'scribble'" in damaged[str(scene.contract_id)].faults[0]
        assert damaged[str(scene.other_id)].faults == []
        assert damaged.keys() == whole.keys()
    finally:
        scene.world.server.in_database(lambda session: damage(session, "single"))
