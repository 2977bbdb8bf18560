"""Redlines in the record, in mails, on Today, and held against what was sent."""

from uuid import UUID

import pytest
import sqlalchemy as sa
from sqlalchemy.orm import Session

from app.agreements.models import ContractEvent, ContractVersion
from app.agreements.queries import version_by_number
from app.notifications.models import Mail
from tests.app.agreements.conftest import Contracts
from tests.app.agreements.redlining import INSERTED, Redlining
from tests.support.server import World

pytestmark = pytest.mark.slow


@pytest.fixture
def redlining(world: World, contracts: Contracts) -> Redlining:
    return Redlining(world, contracts)


def test_the_contract_and_today_name_what_is_open(world: World, redlining: Redlining):
    assert redlining.draft()["redlines"] is None
    redlining.propose(redlining.replace("warranty", "Own work."), INSERTED)
    redlining.answer(1, "accepted")
    read = redlining.draft()
    assert {name: read["redlines"][name] for name in ("rounds", "count", "unanswered", "is_open", "by")} == {
        "rounds": 1,
        "count": 2,
        "unanswered": 1,
        "is_open": True,
        "by": "Sound designer",
    }
    steps = redlining.contracts.ask(world.producer, "GET", f"/projects/{world.project_id}/next-steps")["steps"]
    assert "change_contract" in [step["kind"] for step in steps], "an answer leaves the step where it is"


def test_the_producers_are_mailed_what_is_proposed(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."), INSERTED, note="See you at four.")
    world.server.wait_for_jobs()

    def texts(session: Session) -> list[str]:
        mails = session.scalars(sa.select(Mail).where(Mail.studio_id == world.studio_id))
        return [line for mail in mails for line in mail.lines]

    assert any(
        "Effects for Alpha: 2 proposed changes: Originality, Tea. See you at four." in text
        for text in world.server.in_database(texts)
    )


def test_the_record_names_each_act_and_who_did_it(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "countered", title="Originality", text="Licensed work.", comment="Half way.")
    proposed, answered = redlining.contracts.entries(redlining.sent, world.designer)[-2:]
    assert (proposed["kind"], proposed["payload"]["by"], proposed["payload"]["role"]) == (
        "redlines_proposed",
        "Sound designer",
        "designer",
    )
    assert proposed["payload"]["text_sha256"] == redlining.sent["version"]["text_sha256"]
    assert proposed["payload"]["redlines"][0]["text"] == "Own work."
    assert (answered["kind"], answered["payload"]["by"], answered["payload"]["text"]) == (
        "redline_answered",
        "Producer",
        "Licensed work.",
    )
    assert redlining.faults() == []


def agreed_by_redline(redlining: Redlining) -> int:
    """Send a version that has an accepted redline, and return its number."""
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "accepted")
    number: int = redlining.contracts.send(redlining.draft())["version"]["number"]
    return number


def test_verify_names_a_sent_version_without_what_was_agreed(world: World, redlining: Redlining):
    number = agreed_by_redline(redlining)

    def tamper(session: Session) -> None:
        version = version_by_number(session, UUID(redlining.sent["id"]), number)
        assert version is not None
        version.clauses = [row | {"text": "Any work."} if row["key"] == "warranty" else row for row in version.clauses]

    assert redlining.faults() == []
    world.server.in_database(tamper)
    assert redlining.faults() == [f"version {number} has not redline 1 as it was agreed"]


@pytest.mark.parametrize("kind", ["redlines_proposed", "redline_answered"])
def test_verify_names_an_entry_on_redlines_that_was_altered(world: World, redlining: Redlining, kind: str):
    agreed_by_redline(redlining)

    def tamper(session: Session) -> None:
        of_it = (ContractEvent.contract_id == UUID(redlining.sent["id"])) & (ContractEvent.kind == kind)
        event = session.scalars(sa.select(ContractEvent).where(of_it)).one()
        event.payload = event.payload.replace("Own work", "Any work").replace("accepted", "refused")

    world.server.in_database(tamper)
    assert any("was altered" in fault for fault in redlining.faults())


def test_versions_say_which_answer_made_them(world: World, redlining: Redlining):
    redlining.propose(redlining.replace("warranty", "Own work."))
    redlining.answer(1, "accepted")

    def notes(session: Session) -> list[str]:
        of_it = ContractVersion.contract_id == UUID(redlining.sent["id"])
        return list(session.scalars(sa.select(ContractVersion.note).where(of_it).order_by(ContractVersion.number)))

    assert world.server.in_database(notes)[-1] == "Redline 1 accepted: Originality"
