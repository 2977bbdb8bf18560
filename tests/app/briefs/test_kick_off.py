"""Decisions of the talks before a contract: changed until it is signed, then an entry of its record."""

from typing import Any

from tests.app.agreements.conftest import Contracts
from tests.support.server import World

DECISION = {"decided_on": "2026-11-02", "attended": "Producer, Sound designer", "text": "SW-001 is dry; question 4."}


def decisions(world: World) -> list[dict[str, Any]]:
    listed: list[dict[str, Any]] = world.designer.get(f"/v1/projects/{world.project_id}/decisions").json()
    return listed


def add(world: World, **more: Any) -> dict[str, Any]:
    answer = world.approver.post(f"/v1/projects/{world.project_id}/decisions", json=DECISION | more)
    assert answer.status_code == 201, answer.text
    added: dict[str, Any] = answer.json()
    return added


def test_a_decision_is_written_changed_and_deleted(world: World) -> None:
    later, first = add(world), add(world, decided_on="2026-11-01", text="No music under menus.")
    assert [each["id"] for each in decisions(world)] == [first["id"], later["id"]], "in order of their days"
    assert (first["author"]["name"], first["signed_at"]) == ("Audio director", None)
    path = f"/v1/decisions/{first['id']}"
    changed = world.producer.put(path, json=DECISION | {"text": "No music at all."})
    assert changed.json()["text"] == "No music at all."
    assert world.producer.delete(path).status_code == 204
    assert [each["id"] for each in decisions(world)] == [later["id"]]


def test_a_designer_reads_and_does_not_write(world: World) -> None:
    added = add(world)
    refused = world.designer.put(f"/v1/decisions/{added['id']}", json=DECISION)
    assert (refused.status_code, refused.json()["code"]) == (403, "team-needed")
    assert world.stranger.put(f"/v1/decisions/{added['id']}", json=DECISION).status_code == 404


def test_with_the_signature_it_stands_in_the_record_and_changes_no_more(world: World) -> None:
    contracts = Contracts(world)
    added = add(world)
    contract = contracts.begin()
    contracts.agree(contract)
    (entry,) = [entry for entry in contracts.entries(contract) if entry["kind"] == "kick_off"]
    assert entry["payload"]["decisions"] == [DECISION]
    assert decisions(world)[0]["signed_at"] is not None
    refused = world.producer.put(f"/v1/decisions/{added['id']}", json=DECISION)
    assert (refused.status_code, refused.json()["code"]) == (409, "decision-signed")
    assert world.producer.delete(f"/v1/decisions/{added['id']}").status_code == 409


def test_the_vision_is_what_the_brief_says_of_the_feel(world: World) -> None:
    path = f"/v1/projects/{world.project_id}"
    assert world.designer.get(f"{path}/vision").json() == {"text": None}
    answers = {"feel": {"value": "Heavy and close.\nNothing chirps."}}
    saved = world.producer.patch(f"{path}/brief", json={"revision": 0, "answers": answers})
    assert saved.status_code == 200, saved.text
    assert world.designer.get(f"{path}/vision").json() == {"text": "Heavy and close.; Nothing chirps."}
