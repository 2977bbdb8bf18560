"""A contract that was sent, and what both parties do with its redlines."""

from typing import Any
from uuid import UUID

from httpx import Response
from sqlalchemy.orm import Session

from app.agreements.queries import contract_by_id
from app.amendments.verification import validation_errors
from tests.app.agreements.conftest import Contracts
from tests.support.server import World

INSERTED = {"kind": "insert", "after_key": "rounds", "title": "Tea", "text": "At four, with {designer}."}
EDITED = {"kind": "replace", "clause_key": "warranty", "title": "Originality", "text": "A."}
STRUCK = {"kind": "strike", "clause_key": "about"}


class Redlining:
    """A contract that was sent, and what both parties do with its redlines."""

    def __init__(self, world: World, contracts: Contracts) -> None:
        self.world, self.contracts = world, contracts
        self.sent = contracts.send(contracts.begin())
        self.path = f"/contracts/{self.sent['id']}"

    def clause(self, key: str) -> dict[str, Any]:
        """Return a clause of the version that was sent."""
        return next(row for row in self.sent["version"]["clauses"] if row["key"] == key)

    def replace(self, key: str, text: str, **more: Any) -> dict[str, Any]:
        """Return a change of a clause's text."""
        return {"kind": "replace", "clause_key": key, "title": self.clause(key)["title"], "text": text, **more}

    def try_to_propose(self, *changes: dict[str, Any], **more: Any) -> Response:
        """Propose changes as the designer."""
        body = {"version": self.sent["version"]["number"], "changes": changes, **more}
        return self.world.designer.post(f"/v1{self.path}/redlines", json=body)

    def propose(self, *changes: dict[str, Any], **more: Any) -> dict[str, Any]:
        """Propose changes and return the round."""
        proposed = self.try_to_propose(*changes, **more)
        assert proposed.status_code == 201, proposed.text
        found: dict[str, Any] = proposed.json()["round"]
        return found

    def try_to_answer(self, number: int, answer: str, **more: Any) -> Response:
        """Answer a redline as the producer."""
        body = {"answer": answer, **more}
        return self.world.producer.post(f"/v1{self.path}/redlines/{number}/answer", json=body)

    def answer(self, number: int, answer: str, **more: Any) -> dict[str, Any]:
        """Answer a redline and return the round."""
        answered = self.try_to_answer(number, answer, **more)
        assert answered.status_code == 200, answered.text
        found: dict[str, Any] = answered.json()["round"]
        return found

    def draft(self) -> dict[str, Any]:
        """Return the contract as the producer has it."""
        read: dict[str, Any] = self.contracts.ask(self.world.producer, "GET", self.path)
        return read

    def drafted(self, key: str) -> dict[str, Any] | None:
        """Return a clause of the draft."""
        return next((row for row in self.draft()["version"]["clauses"] if row["key"] == key), None)

    def faults(self) -> list[str]:
        """Return what `soundlist verify` says of the contract."""

        def found(session: Session) -> list[str]:
            contract = contract_by_id(session, UUID(self.sent["id"]))
            return validation_errors(session, self.world.server.runtime.store, contract)

        said: list[str] = self.world.server.in_database(found)
        return said


def refusal(answer: Response) -> tuple[int, str, str]:
    said = answer.json()
    return answer.status_code, said["code"], said["detail"]
