"""What is delivered and judged under a contract stands in its record; what is not under one stands in none."""

import json
from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractEvent
from app.agreements.record import service as record
from tests.app.money.agreed import Agreed, milestone
from tests.support.deliver import deliver
from tests.support.server import World

SOUND = b"no sound, but bytes that were delivered"


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def recorded(agreed: Agreed, kind: str) -> list[dict[str, Any]]:
    def read(session: Session) -> list[str]:
        assert list(record.validation_errors(session, session.get_one(Contract, agreed.contract_id))) == []
        of_it = select(ContractEvent.payload).where(ContractEvent.contract_id == agreed.contract_id)
        return list(session.scalars(of_it.where(ContractEvent.kind == kind).order_by(ContractEvent.seq)))

    return [json.loads(payload) for payload in agreed.world.server.in_database(read)]


def test_what_is_delivered(world: World, agreed: Agreed) -> None:
    inside, outside = agreed.cue("radar_ping"), agreed.cue("dock_clamp")
    agreed.agree(milestone("Alpha", inside, amount_minor=18_000))
    take = deliver(world, "radar_ping.wav", SOUND, cue_id=str(inside))
    deliver(world, "dock_clamp.wav", SOUND + b"!", cue_id=str(outside))
    unmatched = deliver(world, "something.wav", SOUND + b"?")
    (reported,) = recorded(agreed, "delivered")
    assert reported["cue"].endswith(" radar_ping")
    assert (reported["version"], reported["file"]) == (1, "radar_ping.wav")
    assert reported["by"] == "Sound designer"
    assert len(reported["sha256"]) == 64
    world.server.wait_for_jobs()
    matched = world.designer.put(f"/v1/takes/{unmatched['id']}/match", json={"cue_id": str(inside)})
    assert matched.status_code == 200, matched.text
    assert [each["version"] for each in recorded(agreed, "delivered")] == [1, 2]
    assert take["number"] == 1
    assert str(outside) not in json.dumps(recorded(agreed, "delivered"))


@pytest.mark.slow
def test_what_is_judged(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    first = agreed.take(cue)
    agreed.draft(first, note="a duller clank")
    sent = agreed.world.approver.post(
        f"/v1/projects/{agreed.world.project_id}/feedback", json={"note": "All of one metal"}
    )
    assert sent.is_success, sent.text
    second = agreed.take(cue)
    agreed.approve(second)
    undone = agreed.world.approver.delete(f"/v1/takes/{second}/verdict")
    assert undone.is_success, undone.text
    reported = [(each["verdict"], each["version"], each["note"], each["by"]) for each in recorded(agreed, "judged")]
    assert reported == [
        ("request_change", 1, "a duller clank", "Audio director"),
        ("approve", 2, "", "Audio director"),
        ("withdraw", 2, "", "Audio director"),
    ]
    rows = recorded(agreed, "judged")[0]["rows"]["added"]
    [request] = rows["change request"].values()
    assert (request["text"], request["take_id"]) == ("a duller clank", str(first))
    [sending] = rows["feedback"].values()
    assert sending["note"] == "All of one metal"


def test_what_is_asked_and_answered(world: World, agreed: Agreed) -> None:
    inside, outside = agreed.cue("radar_ping"), agreed.cue("dock_clamp")
    before = ask(world.designer, inside, "Which size?")
    agreed.agree(milestone("Alpha", inside, amount_minor=18_000))
    ask(world.designer, outside, "Which metal?")
    asked = ask(world.designer, inside, "How far away?")
    ask(world.producer, inside, "Is two seconds enough?")
    for question, text in ((before, "Large"), (asked, "Ten metres")):
        answer = world.producer.post(f"/v1/questions/{question['id']}/answer", json={"text": text, "joins": False})
        assert answer.is_success, answer.text
    assert [(each["text"], each["by"]) for each in recorded(agreed, "question_asked")] == [
        ("How far away?", "Sound designer"),
        ("Is two seconds enough?", "Producer"),
    ]
    answers = recorded(agreed, "question_answered")
    assert [(each["text"], each["answer"]) for each in answers] == [
        ("Which size?", "Large"),
        ("How far away?", "Ten metres"),
    ]
    [row] = answers[0]["rows"]["changed"]["question"].values()
    assert row["answer"] == "Large"


def ask(client: Client, cue: UUID, text: str) -> dict[str, Any]:
    answer = client.post(f"/v1/cues/{cue}/questions", json={"text": text})
    assert answer.is_success, answer.text
    return answer.json()
