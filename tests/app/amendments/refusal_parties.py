"""A producer and a designer whose requests are refused, and who do what the refusal advises."""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any
from uuid import UUID

from app.deliveries.rules import TakeState
from tests.app.agreements.conftest import Contracts
from tests.app.money.agreed import milestone
from tests.app.reviews.making import Stage
from tests.support.server import World

ENDED = "the studio begins another contract"
Scene = Callable[["Parties"], None]
SCENES: dict[str, Scene] = {}


def scene(*sites: str) -> Callable[[Scene], Scene]:
    """Register what follows the advice of some refusals."""

    def register(play: Scene) -> Scene:
        for site in sites:
            assert site not in SCENES, site
            SCENES[site] = play
        return play

    return register


def advised(answer: Any, code: str, *advice: str) -> None:
    """Assert that a request was refused under a code, with words that advise these things."""
    assert answer.status_code >= 400, f"was granted: {answer.text}"
    body = answer.json()
    assert body["code"] == code, body
    words = f"{body['detail']} {body.get('fix') or ''} {[one['message'] for one in body.get('errors') or []]}"
    for each in advice:
        assert each in words, words


def granted(answer: Any) -> Any:
    """Assert that a request was granted, and return the body of its answer."""
    assert answer.is_success, f"{answer.status_code} {answer.text}"
    is_json = answer.content and "json" in answer.headers.get("content-type", "")
    return answer.json() if is_json else answer.content


@dataclass
class Parties:
    """A producer and a designer of one project, and what they do with contracts."""

    world: World
    cues: list[UUID] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.stage, self.contracts = Stage(self.world), Contracts(self.world)

    @property
    def producer(self) -> Any:
        return self.world.producer

    @property
    def designer(self) -> Any:
        return self.world.designer

    def cue(self) -> UUID:
        """Put one more cue on the list."""
        self.cues.append(self.stage.cue(f"cue_{len(self.cues) + 1}"))
        return self.cues[-1]

    def planned(self, *milestones: dict[str, Any], kind: str = "single", **terms: Any) -> dict[str, Any]:
        """Begin a draft with a plan; without one, of two cues in Alpha and one in Beta."""
        begun = self.contracts.begin(kind)
        if terms:
            included = {"hours": "hour_rate_minor", "retainer": "retainer_minor", "bonus": "bonus_minor"}
            included |= {"downloads": "downloads_open"}
            clauses = [
                clause | ({"stands": True} if included.get(clause["key"]) in terms else {})
                for clause in begun["version"]["clauses"]
            ]
            begun = self.contracts.save(begun, terms=begun["version"]["terms"] | terms, clauses=clauses)
        plan = milestones or (
            milestone("Alpha", self.cue(), self.cue(), amount_minor=20_000),
            milestone("Beta", self.cue(), amount_minor=30_000),
        )
        if kind == "single":
            granted(self.plan(begun, *plan))
        return begun

    def plan(self, contract: dict[str, Any], *milestones: dict[str, Any]) -> Any:
        path = f"/v1/contracts/{contract['id']}/milestones"
        return self.producer.put(path, json={"milestones": list(milestones)})

    def sent(self, *milestones: dict[str, Any], **terms: Any) -> dict[str, Any]:
        return self.contracts.send(self.planned(*milestones, **terms))

    def agreed(self, *milestones: dict[str, Any], **terms: Any) -> dict[str, Any]:
        return self.contracts.agree(self.planned(*milestones, **terms))

    def nda(self) -> dict[str, Any]:
        return self.contracts.begin("nda")

    def post(self, by: Any, contract: dict[str, Any], what: str, **body: Any) -> Any:
        return by.post(f"/v1/contracts/{contract['id']}/{what}", json=body)

    def milestones(self, contract: dict[str, Any]) -> dict[str, str]:
        read = granted(self.producer.get(f"/v1/contracts/{contract['id']}/milestones"))
        return {one["name"]: one["id"] for one in read["milestones"]}

    def propose(self, contract: dict[str, Any], *changes: dict[str, Any], by: Any = None) -> Any:
        return self.post(by or self.producer, contract, "change-orders", reason="More", changes=list(changes))

    def extra_work(self, contract: dict[str, Any], name: str = "Alpha") -> dict[str, Any]:
        milestone_id = self.milestones(contract)[name]
        return {"kind": "add_work", "milestone_id": milestone_id, "text": "Rush", "amount_minor": 100}

    def accept_order(self, contract: dict[str, Any], number: int, by: Any) -> Any:
        orders = granted(by.get(f"/v1/contracts/{contract['id']}/change-orders"))["orders"]
        sha256 = next(order["text_sha256"] for order in orders if order["number"] == number)
        return self.post(by, contract, f"change-orders/{number}/accept", name="N. N.", text_sha256=sha256)

    def change(self, contract: dict[str, Any], *changes: dict[str, Any]) -> None:
        """Propose changes that both accept."""
        number = granted(self.propose(contract, *changes))["orders"][-1]["number"]
        for by in (self.designer, self.producer):
            granted(self.accept_order(contract, number, by))

    def notice(self, contract: dict[str, Any], by: Any = None, **more: Any) -> Any:
        return self.post(by or self.producer, contract, "ending/notice", reason="Shelved", **more)

    def agree_ending(self, contract: dict[str, Any], by: Any) -> Any:
        said = granted(by.get(f"/v1/contracts/{contract['id']}/ending"))
        return self.post(by, contract, "ending/agree", name="N. N.", text_sha256=said["statement_sha256"] or "0" * 64)

    def end(self, contract: dict[str, Any]) -> None:
        """Settle a contract that both end."""
        granted(self.notice(contract))
        for by in (self.designer, self.producer):
            granted(self.agree_ending(contract, by))

    def begins_another(self) -> None:
        """Do what a contract that has ended leaves to do."""
        granted_contract = self.agreed(milestone("Gamma", self.cue(), amount_minor=100))
        assert granted_contract["state"] == "agreed"

    def accept_cue(self, cue_id: UUID) -> None:
        self.stage.approve(self.stage.take(cue_id, state=TakeState.CONFORMING))
