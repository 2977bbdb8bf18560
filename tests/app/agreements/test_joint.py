"""Joint work: one plan divided between two designers, with two contracts that are sent and agreed together."""

from typing import Any
from uuid import UUID

import pytest
from httpx2 import Client
from sqlalchemy.orm import Session

from app.agreements.clauses.rules import Clause
from app.agreements.errors import BadSplit
from app.agreements.joint.rules import Share, divide, shares_in_words, with_clause
from app.agreements.plan.planned import PlannedCue, PlannedMilestone
from app.core.db import new_id
from app.projects.models import Engagement
from app.projects.rules import EngagementKind
from tests.app.agreements.conftest import Contracts, words_of
from tests.app.money.agreed import deposit, milestone
from tests.app.reviews.making import Stage
from tests.support.deliver import open_delivery, upload
from tests.support.server import World


class Joint:
    """A draft of 1,000.00 over three cues, and a second designer, who is engaged on its project."""

    def __init__(self, world: World) -> None:
        self.world, self.contracts, self.stage = world, Contracts(world), Stage(world)
        self.second = world.other_designer
        self.cue_ids = [self.stage.cue(name) for name in ("shield_hit", "laser", "theme")]
        self.engagement_id = world.server.in_database(self._engage)
        self.draft = self.contracts.begin()
        self.plan(self.draft, deposit(10_001), milestone("Alpha", *self.cue_ids, amount_minor=89_999))

    def _engage(self, session: Session) -> UUID:
        world = self.world
        engagement = Engagement(
            studio_id=world.studio_id,
            project_id=world.project_id,
            designer_id=world.other_designer_id,
            kind=EngagementKind.CONTRACT,
        )
        session.add(engagement)
        session.flush()
        return engagement.id

    def plan(self, contract: dict[str, Any], *milestones: dict[str, Any]) -> None:
        self.contracts.ask(
            self.world.producer, "PUT", f"/contracts/{contract['id']}/milestones", json={"milestones": list(milestones)}
        )

    def request(self, method: str, by: Client | None = None, **body: Any) -> Any:
        return (by or self.world.producer).request(method, f"/v1/contracts/{self.draft['id']}/joint", json=body)

    def divide(self, *cue_ids: UUID, by: Client | None = None, **share: int) -> Any:
        body = {"engagement_id": str(self.engagement_id), "cue_ids": [str(cue_id) for cue_id in cue_ids]}
        return self.request("POST", by, **body, **share)

    def divided(self, **share: int) -> tuple[dict[str, Any], dict[str, Any]]:
        """Divide the draft, the theme being the second designer's; return both drafts."""
        answer = self.divide(self.cue_ids[2], **share)
        assert answer.status_code == 201, answer.text
        (other_id,) = [part["contract_id"] for part in answer.json()["joint"] if not part["is_own"]]
        return answer.json(), self.read(other_id)

    def read(self, contract_id: str, by: Client | None = None) -> dict[str, Any]:
        contract: dict[str, Any] = self.contracts.ask(by or self.world.producer, "GET", f"/contracts/{contract_id}")
        return contract

    def amounts(self, contract: dict[str, Any]) -> list[int]:
        """Return the amount of each milestone of a contract."""
        plan = self.contracts.ask(self.world.producer, "GET", f"/contracts/{contract['id']}/milestones")
        return [planned["amount_minor"] for planned in plan["milestones"]]

    def states(self, *contracts: dict[str, Any]) -> list[str]:
        return [self.read(contract["id"])["state"] for contract in contracts]

    def sent(self, **share: int) -> tuple[dict[str, Any], dict[str, Any]]:
        first, second = self.divided(**share)
        self.contracts.send(first)
        return self.read(first["id"]), self.read(second["id"])

    def agreed(self, **share: int) -> tuple[dict[str, Any], dict[str, Any]]:
        first, second = self.sent(**share)
        for contract, by in ((first, self.world.designer), (second, self.second)):
            self.contracts.accept(contract, by, "N. Designer")
            self.contracts.accept(contract, self.world.producer, "P. Producer")
        return self.read(first["id"]), self.read(second["id"])


@pytest.fixture
def joint(world: World) -> Joint:
    return Joint(world)


A, B, C = (new_id() for _ in range(3))


def test_amounts_follow_the_cues_and_add_up():
    priced = PlannedMilestone("Alpha", None, None, cues=[PlannedCue(A, 300), PlannedCue(B, 100)])
    plain = PlannedMilestone("Beta", 1_000, None, cues=[PlannedCue(C)])
    first, second = divide([PlannedMilestone("Deposit", 101, None, is_deposit=True), priced, plain], {B})
    assert [planned.whole_minor for planned in first] == [94, 300, 1_000]  # 101 · 1,300 / 1,400 is 93.79
    assert [planned.whole_minor for planned in second] == [7, 100]
    assert [planned.name for planned in second] == ["Deposit", "Alpha"]


def test_what_is_left_goes_to_the_largest_remainder():
    assert Share(share_bp=3_333).of(100, "USD") == 33
    assert Share(share_bp=5_000).of(101, "USD") == 51  # alike: the first
    assert shares_in_words([1, 1, 1]) == ["33.34 %", "33.33 %", "33.33 %"]
    assert shares_in_words([0, 0]) == ["", ""]


def test_a_share_is_one_figure_within_the_whole():
    for share in (Share(), Share(1, 1), Share(share_minor=101)):
        with pytest.raises(BadSplit):
            share.of(100, "USD")
    for cue_ids in ({A}, {B}, set()):
        with pytest.raises(BadSplit):
            divide([PlannedMilestone("Alpha", 1, None, cues=[PlannedCue(A)])], cue_ids)


def test_the_clause_is_put_in_once():
    clause = Clause("joint", "Joint work", "{joint_work}", stands=False)
    assert with_clause([], clause, stands=True) == [Clause("joint", "Joint work", "{joint_work}")]
    assert with_clause([clause], clause, stands=True) == [Clause("joint", "Joint work", "{joint_work}")]
    assert with_clause([], clause, stands=False) == []


def test_both_texts_name_both_designers_and_the_figures_that_are_charged(joint: Joint) -> None:
    first, second = joint.divided(share_bp=4_000)
    assert sum(joint.amounts(first)) == 60_000
    assert sum(joint.amounts(second)) == 40_000
    first, second = (joint.contracts.send(first), joint.read(second["id"]))
    cues = joint.world.producer.get(f"/v1/projects/{joint.world.project_id}/sound-list").json()["cues"]
    labels = {cue["id"]: cue["label"] for cue in cues}
    shield_hit, laser, theme = (labels[str(cue_id)] for cue_id in joint.cue_ids)
    rows = [
        f"Sound designer · {shield_hit}, {laser} · USD 600.00 · 60 %",
        f"Another sound designer · {theme} · USD 400.00 · 40 %",
        "Both ·  · USD 1,000.00 · ",
    ]
    for contract in (first, second):
        words = words_of(contract)
        assert [row for row in rows if row not in words] == [], words
    assert "The price is USD 600.00." in words_of(first)
    assert "The price is USD 400.00." in words_of(second)
    assert [(part["amount_minor"], part["share"], part["cues"]) for part in second["joint"]] == [
        (60_000, "60 %", 2),
        (40_000, "40 %", 1),
    ]


def test_without_a_share_the_amounts_follow_the_cues(joint: Joint) -> None:
    first, second = joint.divided()
    assert (joint.amounts(first), joint.amounts(second)) == ([6_667, 60_000], [3_334, 29_999])


@pytest.mark.slow
def test_the_split_of_drafts_is_changed_and_the_sum_stays(joint: Joint) -> None:
    first, second = joint.divided()
    assert joint.request("PUT", share_minor=33_333).status_code == 200
    assert (sum(joint.amounts(first)), sum(joint.amounts(second))) == (33_333, 66_667)
    assert joint.request("PUT", share_minor=100_001).json()["code"] == "bad-split"
    joint.contracts.send(second)
    assert joint.request("PUT", share_bp=5_000).json()["code"] == "wrong-state"


def test_a_cue_has_one_designer(joint: Joint) -> None:
    first, second = joint.divided()
    for contract, cue_id in ((first, joint.cue_ids[2]), (second, joint.cue_ids[0])):
        body = {"milestones": [milestone("Alpha", cue_id, amount_minor=1)]}
        refused = joint.world.producer.put(f"/v1/contracts/{contract['id']}/milestones", json=body)
        assert (refused.status_code, refused.json()["code"]) == (422, "bad-plan")
        assert "the other designer's" in refused.text


def test_both_are_agreed_once_all_have_signed_both(joint: Joint) -> None:
    first, second = joint.sent()
    joint.contracts.accept(first, joint.world.designer, "N. Designer")
    joint.contracts.accept(first, joint.world.producer, "P. Producer")
    waiting = joint.read(first["id"])
    assert (waiting["state"], waiting["waits_for"], waiting["may"]["accept"]) == ("sent", [], False)
    joint.contracts.accept(second, joint.world.producer, "P. Producer")
    assert joint.states(first, second) == ["sent", "sent"]
    joint.contracts.accept(second, joint.second, "A. Composer")
    assert joint.states(first, second) == ["agreed", "agreed"]
    for contract in (first, second):
        entries = {entry["kind"]: entry["payload"] for entry in joint.contracts.entries(contract)}
        assert entries["sent"]["split"] == entries["agreed"]["split"]
        assert [part["amount"] for part in entries["agreed"]["split"]] == ["USD 666.67", "USD 333.33"]
        assert entries["agreed"]["together"] == "USD 1,000.00"
        assert {"planned", "due", "accepted_by"} <= entries.keys()
    assert entries["agreed"]["role"] == "designer"
    by_other = [entry["payload"] for entry in joint.contracts.entries(first) if entry["kind"] == "agreed"]
    assert by_other[0]["role"] == "designer of the other contract"


@pytest.mark.slow
def test_what_takes_one_back_takes_the_other_back(joint: Joint) -> None:
    first, second = joint.sent()
    joint.contracts.accept(first, joint.world.designer, "N. Designer")
    path = f"/contracts/{second['id']}/ask-change"
    joint.contracts.ask(joint.second, "POST", path, json={"text": "A later date, please."})
    assert joint.states(first, second) == ["draft", "draft"]
    assert joint.contracts.entries(first)[-1]["kind"] == "taken_back"
    again = joint.contracts.send(first)
    assert (again["acceptances"], joint.states(first, second)) == ([], ["sent", "sent"])
    joint.contracts.ask(joint.world.producer, "POST", f"/contracts/{first['id']}/recall", json={"reason": "A slip."})
    assert joint.states(first, second) == ["draft", "draft"]


@pytest.mark.slow
def test_where_one_is_given_up_the_other_stands_alone(joint: Joint) -> None:
    first, second = joint.sent()
    joint.contracts.ask(joint.second, "POST", f"/contracts/{second['id']}/end", json={"reason": "No time."})
    assert joint.states(first, second) == ["draft", "ended"]
    alone = joint.read(first["id"])
    assert alone["joint"] == []
    assert joint.contracts.entries(first)[-1]["kind"] == "stands_alone"
    refused = joint.world.producer.post(f"/v1/contracts/{first['id']}/send", json={})
    assert "remove the clause on joint work" in refused.text
    clauses = [
        clause | {"stands": clause["stands"] and clause["key"] != "joint"} for clause in alone["version"]["clauses"]
    ]
    joint.contracts.agree(joint.contracts.save(alone, clauses=clauses))


@pytest.mark.slow
def test_money_follows_each_designers_sounds(joint: Joint) -> None:
    first, second = joint.agreed(share_bp=4_000)
    world = joint.world
    for (name, cue_id), designer, ids in (
        (("shield_hit", joint.cue_ids[0]), world.designer_id, first),
        (("theme", joint.cue_ids[2]), world.other_designer_id, second),
    ):
        take_id = joint.stage.take(cue_id, designer_id=designer)
        joint.stage.approve(take_id)
        lines = joint.contracts.ask(world.producer, "GET", f"/contracts/{ids['id']}/ledger")["lines"]
        assert [line["kind"] for line in lines] == ["deposit", "accepted"], name
    own = joint.contracts.ask(joint.second, "GET", f"/contracts/{second['id']}/ledger")["figures"]
    assert (own["agreed_minor"], own["due_minor"]) == (40_000, 40_000)


@pytest.mark.slow
def test_each_designer_delivers_and_sees_their_own_contract_and_the_others_part(joint: Joint) -> None:
    first, second = joint.divided()
    world = joint.world
    assert joint.second.get(f"/v1/contracts/{second['id']}").status_code == 404  # a draft is the studio's
    joint.contracts.send(first)
    for by, own, other in ((world.designer, first, second), (joint.second, second, first)):
        parts = joint.read(own["id"], by)["joint"]
        assert [part["contract_id"] for part in parts if not part["is_own"]] == [None]
        assert sum(part["amount_minor"] for part in parts) == 100_000
        assert by.get(f"/v1/contracts/{other['id']}").status_code == 404
        assert by.get(f"/v1/contracts/{other['id']}/milestones").status_code == 404
    for contract in (first, second):
        assert world.stranger.get(f"/v1/contracts/{contract['id']}").status_code == 404
    delivery_id = open_delivery(world, joint.second)
    upload_id = upload(world, delivery_id, "theme.wav", b"RIFF, a theme", joint.second)
    body = {"upload_id": upload_id, "file_name": "theme.wav", "cue_id": str(joint.cue_ids[2])}
    take = joint.contracts.ask(joint.second, "POST", f"/deliveries/{delivery_id}/takes", json=body)
    assert take["cue"]["name"] == "theme"


def test_only_a_producer_divides_a_single_draft_once(joint: Joint) -> None:
    theme = joint.cue_ids[2]
    for by, status in ((joint.world.designer, 404), (joint.world.stranger, 404), (joint.world.reviewer, 404)):
        assert joint.divide(theme, by=by).status_code == status
    assert joint.request("PUT", share_bp=5_000).json()["code"] == "bad-split"
    assert joint.divide(*joint.cue_ids).json()["code"] == "bad-split"
    assert joint.divide(theme, share_bp=5_000, share_minor=5).json()["code"] == "bad-split"
    same = {"engagement_id": joint.contracts.engagement_id(), "cue_ids": [str(theme)]}
    assert joint.request("POST", **same).json()["code"] == "bad-split"
    assert joint.divide(theme).status_code == 201
    assert joint.divide(theme).json()["code"] == "wrong-state"
    assert len(joint.contracts.ask(joint.world.producer, "GET", f"/projects/{joint.world.project_id}/contracts")) == 2


@pytest.mark.slow
def test_a_refusal_names_the_other_contract_where_that_cannot_be_sent(joint: Joint) -> None:
    first, second = joint.divided()
    clauses = [clause for clause in second["version"]["clauses"] if clause["key"] != "joint"]
    body = Contracts.draft_of(second, clauses=clauses) | {"based_on_version": second["version"]["number"]}
    refused = joint.world.producer.put(f"/v1/contracts/{second['id']}/draft", json=body)
    assert "{joint_work}" in refused.text  # the clause cannot be taken out of one of the two
    joint.contracts.send(first)
    redline = {"clause_key": "credit", "kind": "strike", "comment": ""}
    path = f"/contracts/{second['id']}/redlines"
    body = {"version": joint.read(second["id"])["version"]["number"], "changes": [redline], "note": ""}
    joint.contracts.ask(joint.second, "POST", path, json=body)
    assert joint.states(first, second) == ["draft", "draft"]
    refused = joint.world.producer.post(f"/v1/contracts/{first['id']}/send", json={})
    assert refused.json()["detail"].startswith(f"{second['title']}: 1 proposed change")


def test_one_currency(joint: Joint) -> None:
    first, _ = joint.divided()
    plan = joint.contracts.ask(joint.world.producer, "GET", f"/contracts/{first['id']}/milestones")["milestones"]
    amounts = [{"milestone_id": planned["id"], "amount_minor": planned["amount_minor"]} for planned in plan]
    joint.contracts.save(first, currency="EUR", amounts=amounts)
    refused = joint.world.producer.post(f"/v1/contracts/{first['id']}/send", json={})
    assert (refused.status_code, refused.json()["code"]) == (422, "bad-draft")
    assert joint.request("PUT", share_bp=5_000).json()["code"] == "bad-split"
