"""Contracts as a producer makes them, over HTTP."""

from typing import Any

import pytest
from httpx2 import Client

from tests.support.server import World


class Contracts:
    """What the producer and the designer of a world do with contracts."""

    def __init__(self, world: World) -> None:
        self.world = world

    def ask(self, by: Client, method: str, path: str, **more: Any) -> Any:
        """Send a request that must succeed and return its body."""
        answer = by.request(method, f"/v1{path}", **more)
        assert answer.is_success, f"{method} {path}: {answer.status_code} {answer.text}"
        is_json = "json" in answer.headers.get("content-type", "") and answer.content
        return answer.json() if is_json else answer.content

    def engagement_id(self) -> str:
        """Return the tie of the designer to the project."""
        project = self.ask(self.world.producer, "GET", f"/projects/{self.world.project_id}")
        engagement_id: str = project["engagements"][0]["id"]
        return engagement_id

    def begin(self, kind: str = "single", **more: Any) -> dict[str, Any]:
        """Begin a draft."""
        body = {"engagement_id": self.engagement_id(), "kind": kind, "title": "Effects for Alpha", **more}
        path = f"/projects/{self.world.project_id}/contracts"
        begun: dict[str, Any] = self.ask(self.world.producer, "POST", path, json=body)
        return begun

    def send(self, contract: dict[str, Any]) -> dict[str, Any]:
        """Send the newest text to both."""
        sent: dict[str, Any] = self.ask(self.world.producer, "POST", f"/contracts/{contract['id']}/send", json={})
        return sent

    def accept(self, contract: dict[str, Any], by: Client, name: str) -> dict[str, Any]:
        """Say yes to the text that was sent."""
        body = {"name": name, "text_sha256": contract["version"]["text_sha256"]}
        accepted: dict[str, Any] = self.ask(by, "POST", f"/contracts/{contract['id']}/accept", json=body)
        return accepted

    def agree(self, contract: dict[str, Any]) -> dict[str, Any]:
        """Send a draft and have both parties accept it."""
        sent = self.send(contract)
        self.accept(sent, self.world.designer, "N. Designer")
        return self.accept(sent, self.world.producer, "P. Producer")

    def end(self, contract: dict[str, Any], reason: str = "All is done.") -> dict[str, Any]:
        """Give notice of an agreed contract and have both agree to its statement."""
        path = f"/contracts/{contract['id']}/ending"
        ended: dict[str, Any] = self.ask(self.world.producer, "POST", f"{path}/notice", json={"reason": reason})
        for by, name in ((self.world.designer, "N. Designer"), (self.world.producer, "P. Producer")):
            body = {"name": name, "text_sha256": ended["statement_sha256"]}
            ended = self.ask(by, "POST", f"{path}/agree", json=body)
        return ended

    @staticmethod
    def draft_of(contract: dict[str, Any], **changes: Any) -> dict[str, Any]:
        """Return a contract's draft as the editor sends it."""
        same = {name: contract[name] for name in ("title", "currency", "release_clause", "holdback_bp")}
        version = contract["version"]
        return same | {"clauses": version["clauses"], "terms": version["terms"], **changes}

    def save(self, contract: dict[str, Any], **changes: Any) -> dict[str, Any]:
        """Save a changed draft as the next version."""
        body = self.draft_of(contract, **changes) | {"based_on_version": contract["version"]["number"]}
        path = f"/contracts/{contract['id']}/draft"
        saved: dict[str, Any] = self.ask(self.world.producer, "PUT", path, json=body)
        return saved

    def entries(self, contract: dict[str, Any], by: Client | None = None) -> list[dict[str, Any]]:
        """Return the entries of a contract's record, which is whole."""
        record = self.ask(by or self.world.producer, "GET", f"/contracts/{contract['id']}/record")
        assert record["faults"] == []
        entries: list[dict[str, Any]] = record["entries"]
        return entries


@pytest.fixture
def contracts(world: World) -> Contracts:
    return Contracts(world)


def words_of(contract: dict[str, Any]) -> str:
    """Return what the text says, block by block."""
    said: list[str] = []
    for block in contract["version"]["blocks"]:
        for cells in block["rows"] or [[block["spans"]]]:
            said += [" · ".join("".join(span["text"] for span in cell) for cell in cells)]
    return "\n".join(said)
