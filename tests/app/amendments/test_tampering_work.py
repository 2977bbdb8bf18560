"""`soundlist verify` names what was done by hand to plan, terms, verdicts, comments, list or spec under a contract."""

from collections.abc import Mapping
from typing import Any
from uuid import UUID, uuid4

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session
from sqlalchemy.sql.dml import UpdateBase

from app.agreements.models import Contract, ContractCue, ContractVersion, Milestone
from app.agreements.queries import contract_by_id
from app.agreements.rules import AcceptedBy, WorkState
from app.amendments.verification import faults_of
from app.kit import clock
from app.projects.models import Spec
from app.reviews.models import Comment, Verdict
from app.reviews.rules import VerdictKind
from app.sound_lists.models import Cue, CueChange
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import deposit, milestone
from tests.app.reviews.making import Stage, body_of
from tests.support.server import World

pytestmark = pytest.mark.both_databases


@pytest.fixture
def contract_id(world: World, contracts: Contracts) -> UUID:
    """Return an agreed contract: a cue accepted, one cut in work, one changed and commented; another spec."""
    stage = Stage(world)
    ping, clamp, hum = (stage.cue(name) for name in ("radar_ping", "dock_clamp", "reactor_hum"))
    begun = contracts.begin()
    plan = {"milestones": [deposit(25_000), milestone("Alpha", ping, clamp, hum, amount_minor=36_000)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{begun['id']}/milestones", json=plan)
    agreed = contracts.agree(begun)
    path = f"/contracts/{agreed['id']}"
    stage.approve(stage.take(ping))
    take = stage.take(hum)
    contracts.ask(world.reviewer, "POST", f"/takes/{take}/comments", json={"text": "A little dull."})
    body_of(world.producer.patch(f"/v1/cues/{hum}", json={"edition": 1, "use": "the engine room"}))
    spec = world.producer.get(f"/v1/projects/{world.project_id}/spec").json()
    another = spec["toml"].replace("head_silence_ms = 5", "head_silence_ms = 9")
    body = {"toml": another, "based_on_version": spec["version"]}
    body_of(world.producer.put(f"/v1/projects/{world.project_id}/spec", json=body))
    order = {
        "reason": "Needed for the demo",
        "changes": [{"kind": "reprice_cue", "cue_id": str(hum), "price_minor": 15_000}],
    }
    read = contracts.ask(world.producer, "POST", f"{path}/change-orders", json=order)
    for by, name in ((world.designer, "N. Designer"), (world.producer, "P. Producer")):
        yes = {"name": name, "text_sha256": read["orders"][-1]["text_sha256"]}
        contracts.ask(by, "POST", f"{path}/change-orders/1/accept", json=yes)
    world.producer.post(f"/v1/cues/{clamp}/cut", json={"reason": "The scene is gone"})
    world.server.wait_for_jobs()
    return UUID(agreed["id"])


def faults(world: World, contract_id: UUID) -> list[str]:
    def found(session: Session) -> list[str]:
        return faults_of(session, world.server.runtime.store, contract_by_id(session, contract_id))

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
                named[deed] = faults_of(session, world.server.runtime.store, contract_by_id(session, contract_id))
                step.rollback()
            session.expire_all()
        return named

    said: dict[str, list[str]] = world.server.in_database(found)
    return said


@pytest.mark.slow
def test_untouched_work_is_whole(world: World, contract_id: UUID) -> None:
    assert faults(world, contract_id) == []


@pytest.mark.slow
def test_the_record_says_what_changed_in_the_project(world: World, contract_id: UUID) -> None:
    entries = body_of(world.designer.get(f"/v1/contracts/{contract_id}/record"))["entries"]
    kinds = [entry["kind"] for entry in entries]
    assert {"commented", "list_revised", "spec_changed", "judged", "cut"} <= set(kinds)
    assert kinds.count("planned") == 2, "the plan, and the plan after the change order"


def cues_called(name: str) -> sa.Select[UUID]:
    return sa.select(Cue.id).where(Cue.name == name)


DEEDS: dict[str, tuple[UpdateBase, str]] = {
    "another price": (
        sa.update(ContractCue).where(ContractCue.cue_id.in_(cues_called("reactor_hum"))).values(amount_minor=1),
        "the milestone Alpha was altered",
    ),
    "another date": (
        sa.update(Milestone).where(Milestone.name == "Alpha").values(due_on=clock.now().date()),
        "the milestone Alpha was altered",
    ),
    "another amount": (
        sa.update(Milestone).where(Milestone.is_deposit).values(amount_minor=50_000),
        "the milestone Deposit was altered",
    ),
    "a cue more accepted": (
        sa.update(ContractCue)
        .where(ContractCue.cue_id.in_(cues_called("reactor_hum")))
        .values(accepted_at=clock.now(), accepted_by=AcceptedBy.VERDICT),
        "reactor_hum is accepted, and the record says otherwise",
    ),
    "an acceptance taken back": (
        sa.update(ContractCue).values(accepted_at=None, accepted_by=None),
        "radar_ping is not accepted, and the record says otherwise",
    ),
    "cut in another state": (
        sa.update(ContractCue).where(ContractCue.cut_at.is_not(None)).values(cut_in=WorkState.DELIVERED),
        "dock_clamp is cut in another state",
    ),
    "never cut": (
        sa.update(ContractCue).values(cut_at=None, cut_in=None),
        "dock_clamp is cut in another state",
    ),
    "another term": (
        sa.update(ContractVersion).values(terms={"rounds_included": 9}),
        "clauses, terms or currency of version",
    ),
    "another clause": (sa.update(ContractVersion).values(clauses=[]), "clauses, terms or currency of version"),
    "another currency": (sa.update(Contract).values(currency="CHF"), "clauses, terms or currency of version"),
    "another verdict": (sa.update(Verdict).values(kind=VerdictKind.SET_ASIDE), "a verdict on"),
    "another word of a verdict": (sa.update(Verdict).values(note="Free of charge"), "a verdict on"),
    "a verdict deleted": (sa.delete(Verdict), "is missing"),
    "another comment": (sa.update(Comment).values(text="Perfect."), "a comment on"),
    "a comment deleted": (sa.delete(Comment), "is missing"),
    "another description": (
        sa.update(CueChange).where(CueChange.cue_id.in_(cues_called("reactor_hum"))).values(after={"use": "anywhere"}),
        "of the sound list was altered",
    ),
    "a list change deleted": (
        sa.delete(CueChange).where(CueChange.cue_id.in_(cues_called("reactor_hum"))),
        "of the sound list was altered",
    ),
    "another spec": (
        sa.update(Spec).where(Spec.version == 2).values(toml="format = 1"),
        "version 2 of the delivery spec was altered",
    ),
}


@pytest.mark.slow
def test_each_deed_is_named(world: World, contract_id: UUID) -> None:
    of_studio = sa.column("studio_id", sa.Uuid) == world.studio_id
    named = faults_after(world, contract_id, {deed: one.where(of_studio) for deed, (one, _) in DEEDS.items()})
    assert {deed: said for deed, said in named.items() if not any(DEEDS[deed][1] in fault for fault in said)} == {}
    assert faults(world, contract_id) == [], "each was taken back"


def copied(row: Any, **other: Any) -> Any:
    """Return a row like another, with an id of its own."""
    facts = {column.key: getattr(row, column.key) for column in sa.inspect(type(row)).columns}
    return type(row)(**facts | {"id": uuid4()} | other)


@pytest.mark.slow
def test_a_verdict_put_in_is_named(world: World, contract_id: UUID) -> None:
    def put_in(session: Session) -> None:
        session.add(
            copied(
                session.scalars(sa.select(Verdict).where(Verdict.studio_id == world.studio_id)).first(),
                created_at=clock.now(),
            )
        )

    world.server.in_database(put_in)
    assert any(fault.endswith("(approve) is in no entry") for fault in faults(world, contract_id))


@pytest.mark.slow
def test_a_comment_put_in_is_named(world: World, contract_id: UUID) -> None:
    def put_in(session: Session) -> None:
        session.add(
            copied(
                session.scalars(sa.select(Comment).where(Comment.studio_id == world.studio_id)).first(),
                created_at=clock.now(),
            )
        )

    world.server.in_database(put_in)
    assert any(fault.startswith("the comment") for fault in faults(world, contract_id))


@pytest.mark.slow
def test_a_version_put_in_is_named(world: World, contract_id: UUID) -> None:
    def put_in(session: Session) -> None:
        of_contract = sa.select(ContractVersion).where(ContractVersion.contract_id == contract_id)
        newest = session.scalars(of_contract.order_by(ContractVersion.number.desc())).first()
        assert newest is not None
        session.add(copied(newest, number=newest.number + 1, terms={}, sent_at=None, pdf_sha256=None))

    world.server.in_database(put_in)
    assert any("was added after version" in fault for fault in faults(world, contract_id))
