"""Every entry of a contract's record names who really did it: each act that leaves one, as each role that may do it."""

import json
from collections.abc import Callable
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy import select
from sqlalchemy.orm import Session

from app.accounts.rules import Scope
from app.accounts.service import add_token
from app.agreements.models import ContractEvent
from app.conformance.models import CheckRun
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.money.agreed import Agreed, milestone
from tests.support.deliver import deliver, open_delivery, upload
from tests.support.server import World

PEOPLE = {
    "producer": ("Producer", "producer"),
    "approver": ("Audio director", "approver, liaison"),
    "reviewer": ("Composer", "reviewer"),
    "designer": ("Sound designer", "designer"),
}
Act = Callable[[Agreed, Any, UUID, UUID], Any]


def match(agreed: Agreed, client: Any, _take: UUID, _cue: UUID) -> Any:
    unmatched = deliver(agreed.world, "something.wav", b"no sound, but bytes")
    agreed.world.server.wait_for_jobs()
    return client.put(f"/v1/takes/{unmatched['id']}/match", json={"cue_id": str(_cue)})


def move(agreed: Agreed, client: Any, take: UUID, _cue: UUID) -> Any:
    other = agreed.cue("not_under_contract")
    return client.put(f"/v1/takes/{take}/match", json={"cue_id": str(other)})


def upload_take(agreed: Agreed, _client: Any, _take: UUID, cue: UUID) -> Any:
    made = deliver(agreed.world, "another.wav", b"bytes of another", cue_id=str(cue))
    assert made["number"] == 2


def verdict(kind: str) -> Act:
    return lambda _agreed, client, take, _cue: client.post(f"/v1/takes/{take}/verdict", json={"kind": kind})


def undo(_agreed: Agreed, client: Any, take: UUID, _cue: UUID) -> Any:
    assert client.post(f"/v1/takes/{take}/verdict", json={"kind": "set_aside"}).is_success
    return client.delete(f"/v1/takes/{take}/verdict")


def send(agreed: Agreed, client: Any, take: UUID, _cue: UUID) -> Any:
    assert client.post(f"/v1/takes/{take}/verdict", json={"kind": "request_change", "note": "duller"}).is_success
    return client.post(f"/v1/projects/{agreed.world.project_id}/feedback", json={"note": ""})


def accept_set(_agreed: Agreed, client: Any, _take: UUID, cue: UUID) -> Any:
    return client.post(f"/v1/cues/{cue}/accept-set", json={})


def cut(_agreed: Agreed, client: Any, _take: UUID, cue: UUID) -> Any:
    return client.post(f"/v1/cues/{cue}/cut", json={"reason": "the level is gone"})


def end(agreed: Agreed, client: Any, _take: UUID, _cue: UUID) -> Any:
    return client.post(f"/v1/contracts/{agreed.contract_id}/ending/notice", json={"reason": "the game is shelved"})


def invoice(agreed: Agreed, client: Any, take: UUID, _cue: UUID) -> Any:
    agreed.approve(take)
    body = {"seller": "Sound designer\n1 Quay Street"}
    return client.post(f"/v1/contracts/{agreed.contract_id}/invoices", json=body)


def pay(agreed: Agreed, client: Any, take: UUID, _cue: UUID) -> Any:
    agreed.approve(take)
    issued = agreed.invoice()
    body = {"amount_minor": 100, "reference": "T-1", "paid_on": issued["issued_on"]}
    return client.post(f"/v1/invoices/{issued['id']}/payments", json=body)


ACTS: list[tuple[str, Act, str, tuple[str, ...]]] = [
    ("match", match, "delivered", ("producer", "approver", "reviewer", "designer")),
    ("move away", move, "moved_away", ("producer", "approver", "reviewer", "designer")),
    ("deliver", upload_take, "delivered", ("designer",)),
    ("approve", verdict("approve"), "judged", ("approver",)),
    ("accept", verdict("approve"), "accepted", ("approver",)),
    ("accept a set", accept_set, "accepted", ("approver",)),
    ("set aside", verdict("set_aside"), "judged", ("approver",)),
    ("withdraw", undo, "judged", ("approver",)),
    ("send changes", send, "judged", ("approver",)),
    ("cut", cut, "cut", ("producer", "approver")),
    ("give notice", end, "notice_given", ("producer",)),
    ("invoice", invoice, "invoiced", ("designer",)),
    ("pay", pay, "paid", ("producer",)),
]


@pytest.fixture
def agreed(world: World) -> Agreed:
    return Agreed(world)


def reject(session: Session, take_id: UUID) -> None:
    run = session.scalars(select(CheckRun).where(CheckRun.take_id == take_id)).one()
    run.verdict, run.report = "rejected", run.report | {"verdict": "rejected", "judgements": {}, "findings": []}


def entries(agreed: Agreed) -> list[dict[str, Any]]:
    def read(session: Session) -> list[dict[str, Any]]:
        of_it = select(ContractEvent).where(ContractEvent.contract_id == agreed.contract_id)
        return [
            json.loads(one.payload) | {"kind": one.kind} for one in session.scalars(of_it.order_by(ContractEvent.seq))
        ]

    found: list[dict[str, Any]] = agreed.world.server.in_database(read)
    return found


@pytest.mark.slow
@pytest.mark.parametrize(
    ("act", "kind", "part"),
    [pytest.param(act, kind, part, id=f"{name} by {part}") for name, act, kind, parts in ACTS for part in parts],
)
def test_an_entry_names_who_did_it(agreed: Agreed, act: Act, kind: str, part: str) -> None:
    cue = agreed.cue("radar_ping")
    take = agreed.take(cue)
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    before = len(entries(agreed))
    answer = act(agreed, getattr(agreed.world, part), take, cue)
    assert answer is None or answer.is_success, answer.text
    added = [entry for entry in entries(agreed)[before:] if entry["kind"] == kind]
    assert added, [entry["kind"] for entry in entries(agreed)]
    assert (added[-1]["by"], added[-1]["role"]) == PEOPLE[part]
    assert all(entry["by"] and entry["role"] for entry in entries(agreed))


@pytest.mark.slow
def test_a_designers_file_that_a_reviewer_matches_is_the_designers_still(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    match(agreed, agreed.world.reviewer, UUID(int=0), cue)
    assert entries(agreed)[-1]["on_behalf_of"] == "Sound designer"


def test_a_waiver_is_the_approvers(agreed: Agreed) -> None:
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue, state="returned")
    agreed.world.server.in_database(lambda session: reject(session, take))
    reason = {"reason": "it is meant to hit the ceiling"}
    waived = agreed.world.approver.post(f"/v1/takes/{take}/waiver", json=reason)
    assert waived.status_code == 201, waived.text
    (reported,) = [entry for entry in entries(agreed) if entry["kind"] == "waived"]
    assert (reported["by"], reported["role"], reported["reason"]) == (
        "Audio director",
        "approver, liaison",
        reason["reason"],
    )


@pytest.mark.slow
def test_what_a_build_delivers_names_its_token(agreed: Agreed) -> None:
    world, cue = agreed.world, agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))

    def prepare(session: Session) -> str:
        engagement = session.scalars(select(Engagement).where(Engagement.designer_id == world.designer_id)).one()
        engagement.kind = EngagementKind.IN_HOUSE
        of = {"studio_id": world.studio_id, "project_id": world.project_id, "created_by": world.producer_id}
        return add_token(session, **of, name="Nightly", scopes=list(Scope))[1]

    build = world.server.browser()
    build.headers["Authorization"] = f"Bearer {world.server.in_database(prepare)}"
    delivery_id = open_delivery(world, build)
    upload_id = upload(world, delivery_id, "radar_ping.wav", b"bytes of a build", build)
    body = {"upload_id": upload_id, "file_name": "radar_ping.wav", "cue_id": str(cue)}
    assert build.post(f"/v1/deliveries/{delivery_id}/takes", json=body).status_code == 201
    reported = entries(agreed)[-1]
    assert (reported["by"], reported["role"], reported["on_behalf_of"]) == ("Nightly", "build token", "Sound designer")
