"""The worked example of the docs, over the API: every amount of the page is what the ledgers say."""

import io
import re
import zipfile
from datetime import UTC, datetime, timedelta, tzinfo
from pathlib import Path
from typing import Any
from uuid import UUID

import pytest

from app.agreements.deemed_acceptance.jobs import apply_deemed_acceptance
from app.agreements.models import Contract
from app.amendments.verification import table_faults
from app.core import clock
from tests.journeys.people import Designer, Team
from tests.journeys.test_contract import sound
from tests.support.server import RunningServer

pytestmark = pytest.mark.both_databases

PAGE = Path(__file__).parents[2] / "docs/explanation/contracts-and-money.md"
ROW = re.compile(r"^\| (?P<label>[^|]+) \| [^|]+ \| (?P<amount>[\d,]+\.\d\d) \|$", re.MULTILINE)
ALPHA, BETA = ("radar_ping", "dock_clamp", "mine_arm"), ("missile_launch", "hull_hit", "warp_in")


class Page:
    """The amounts of the page in cents, by their labels; each is to be read."""

    def __init__(self, text: str) -> None:
        self.amounts = {row["label"]: int(re.sub(r"[,.]", "", row["amount"])) for row in ROW.finditer(text)}
        self.unread = set(self.amounts)

    def __getitem__(self, label: str) -> int:
        self.unread.discard(label)
        return self.amounts[label]


class Calendar:
    """The server's time, which goes on from where it is put."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.ahead = timedelta()
        monkeypatch.setattr(clock, "datetime", self)

    def now(self, zone: tzinfo) -> datetime:
        """Return what the server takes for the present."""
        return datetime.now(zone) + self.ahead

    def go_to(self, day: int, hour: int = 9) -> None:
        """Put the server's time to a day of November 2026."""
        self.ahead = datetime(2026, 11, day, hour, tzinfo=UTC) - datetime.now(UTC)


class Story:
    """A studio with two producers, its project, and two designers one after the other."""

    def __init__(self, server: RunningServer) -> None:
        self.server = server
        self.producer, self.second_producer = Team(server), Team(server)
        studio_id = self.producer.sign_up("Shield Wing studio")
        invited = {"email": self.second_producer.address, "roles": ["producer"]}
        self.producer.ask("POST", f"/studios/{studio_id}/invitations", json=invited)
        self.second_producer_id = self.second_producer.join("Second producer")
        self.producer_id: str = self.producer.ask("GET", "/me")["person"]["id"]
        opened = {"studio_id": studio_id, "name": "Shield Wing", "cue_prefix": "SW", "description": ""}
        self.path = f"/projects/{self.producer.ask('POST', '/projects', json=opened)['id']}"
        rows = [{"name": name, "state": "locked"} for name in (*ALPHA, *BETA)]
        added = self.producer.ask("POST", f"{self.path}/cues", json={"cues": rows})
        self.cues: dict[str, str] = {cue["name"]: cue["id"] for cue in added}

    def hire(self) -> tuple[Designer, str]:
        """Invite a designer, who joins; return them and their engagement."""
        designer = Designer(self.server)
        self.producer.ask(
            "POST", f"{self.path}/invitations", json={"email": designer.address, "kind": "contract", "note": ""}
        )
        designer.look()
        designer.accept()
        engagements = self.producer.ask("GET", self.path)["engagements"]
        return designer, next(
            engagement["id"] for engagement in engagements if engagement["designer"]["id"] == designer_id(designer)
        )

    def begin(self, engagement_id: str, title: str, stands: set[str], **terms: Any) -> "Agreement":
        """Begin a draft with clauses that stand and values for what they leave open."""
        begun = {"engagement_id": engagement_id, "kind": "single", "title": title, "currency": "EUR"}
        contract = self.producer.ask("POST", f"{self.path}/contracts", json=begun)
        version = contract["version"]
        for clause in version["clauses"]:
            clause["stands"] |= clause["key"] in stands
        same = {name: contract[name] for name in ("title", "currency", "release_clause", "holdback_bp")}
        body = same | {
            "clauses": version["clauses"],
            "terms": version["terms"] | terms,
            "based_on_version": version["number"],
        }
        self.producer.ask("PUT", f"/contracts/{contract['id']}/draft", json=body)
        return Agreement(self, contract["id"])

    def deliver(self, designer: Designer, name: str, hz: float) -> str:
        """Deliver a sound for a cue, and return the take that the checks let through."""
        delivery = designer.open_delivery(self.path.rpartition("/")[2])
        take_id: str = designer.deliver(delivery, f"{name}.wav", sound(hz))["id"]
        self.server.wait_for_jobs()
        return take_id

    def approve(self, take_id: str) -> None:
        """Approve a take."""
        self.producer.ask("POST", f"/takes/{take_id}/verdict", json={"kind": "approve", "note": ""})

    def request_change(self, take_id: str) -> None:
        """Send one round of changes."""
        body = {"kind": "request_change", "note": "Later thrust."}
        self.producer.ask("POST", f"/takes/{take_id}/verdict", json=body)
        self.producer.ask("POST", f"{self.path}/feedback", json={"note": ""})


def designer_id(designer: Designer) -> str:
    person_id: str = designer.ask("GET", "/me")["person"]["id"]
    return person_id


class Agreement:
    """A contract, and what its parties do with it."""

    def __init__(self, story: Story, contract_id: str) -> None:
        self.story, self.id, self.path = story, contract_id, f"/contracts/{contract_id}"

    def plan(self, *milestones: tuple[str, int, int, tuple[str, ...]], deposit_minor: int) -> int:
        """Plan a deposit and milestones, each with amount, day of November and cues; return the price."""
        rows: list[dict[str, Any]] = [{"name": "Deposit", "amount_minor": deposit_minor, "is_deposit": True}]
        for name, amount_minor, day, cues in milestones:
            covered = [{"cue_id": self.story.cues[cue]} for cue in cues]
            rows.append({"name": name, "amount_minor": amount_minor, "due_on": f"2026-11-{day}", "cues": covered})
        self.story.producer.ask("PUT", f"{self.path}/milestones", json={"milestones": rows})
        return sum(row["amount_minor"] for row in rows)

    def sign(self, *people: Designer | Team) -> str:
        """Have people sign the text that was sent, one after the other; return the contract's state then."""
        for person in people:
            text_sha256 = person.ask("GET", self.path)["version"]["text_sha256"]
            body = {"name": "A. Name", "text_sha256": text_sha256}
            state: str = person.ask("POST", f"{self.path}/accept", json=body)["state"]
        return state

    def redline(self, designer: Designer, key: str, values: dict[str, Any], answer: str, **more: Any) -> int:
        """Propose other values of a clause, have the studio answer and send; return the number of the version."""
        version = designer.ask("GET", self.path)["version"]
        clause = next(row for row in version["clauses"] if row["key"] == key)
        same = {"title": clause["title"], "text": clause["text"]}
        change = {"kind": "replace", "clause_key": key, **same, "terms": values}
        body = {"version": version["number"], "changes": [change]}
        proposed = designer.ask("POST", f"{self.path}/redlines", json=body)["round"]["clauses"]
        (number,) = [one["redline"]["number"] for one in proposed if one["redline"]]
        wording = same if answer == "countered" else {}
        self.story.producer.ask(
            "POST", f"{self.path}/redlines/{number}/answer", json={"answer": answer, **wording, **more}
        )
        sent: int = self.story.producer.ask("POST", f"{self.path}/send", json={"note": ""})["version"]["number"]
        return sent

    def change_order(self, by: Designer, changes: list[dict[str, Any]], **more: Any) -> dict[str, Any]:
        """Propose a change order, have each person sign it whose signature it needs, and return it."""
        body = {"reason": "As we said", "changes": changes, **more}
        number = by.ask("POST", f"{self.path}/change-orders", json=body)["orders"][-1]["number"]
        proposed: dict[str, Any] = by.ask("GET", f"{self.path}/change-orders")["orders"][number - 1]
        for person in (by, self.story.producer, self.story.second_producer):
            order = person.ask("GET", f"{self.path}/change-orders")["orders"][number - 1]
            if order["may"]["agree"]:
                signed = {"name": "A. Name", "text_sha256": order["text_sha256"]}
                person.ask("POST", f"{self.path}/change-orders/{number}/accept", json=signed)
        state = by.ask("GET", f"{self.path}/change-orders")["orders"][number - 1]["state"]
        assert state == "agreed"
        return proposed

    def settle(self, designer: Designer) -> dict[str, Any]:
        """Give notice as the studio, and have each person agree to the statement whose agreement it needs."""
        self.story.producer.ask("POST", f"{self.path}/ending/notice", json={"reason": "The game is put off."})
        for person in (designer, self.story.producer, self.story.second_producer):
            ending = person.ask("GET", f"{self.path}/ending")
            if ending["may"]["agree"]:
                body = {"name": "A. Name", "text_sha256": ending["statement_sha256"]}
                person.ask("POST", f"{self.path}/ending/agree", json=body)
        settled: dict[str, Any] = designer.ask("GET", f"{self.path}/ending")
        assert settled["state"] == "settled"
        return settled

    def owed(self) -> list[tuple[str, str, int]]:
        """Return kind, cue and amount of every line of the ledger."""
        lines = self.story.producer.ask("GET", f"{self.path}/ledger")["lines"]
        names = {cue_id: name for name, cue_id in self.story.cues.items()}
        return [
            (line["kind"], names.get(line["cue"]["id"], "") if line["cue"] else "", line["amount_minor"])
            for line in lines
        ]

    def figures(self) -> dict[str, int]:
        """Return what the contract comes to."""
        figures: dict[str, int] = self.story.producer.ask("GET", f"{self.path}/ledger")["figures"]
        return figures

    def faults(self) -> list[str]:
        """Return what `soundlist verify` says of the tables against the record."""
        contract_id = UUID(self.id)

        def found(session: Any) -> list[str]:
            return list(table_faults(session, session.get_one(Contract, contract_id)))

        faults: list[str] = self.story.server.in_database(found)
        return faults


@pytest.mark.slow
def test_every_amount_of_the_page(server: RunningServer, monkeypatch: pytest.MonkeyPatch) -> None:
    page, november = Page(PAGE.read_text()), Calendar(monkeypatch)
    november.go_to(2)
    story = Story(server)
    first, engagement_id = story.hire()

    contract = story.begin(
        engagement_id,
        "Effects",
        {"silence", "bonus"},
        extra_round_bp=2_000,
        bonus_minor=12_000,
        bonus_when="on_time",
    )
    price_minor = contract.plan(
        ("Alpha", page["Alpha, due on 13 November"], 13, ALPHA),
        ("Beta", page["Beta, due on 30 November"], 30, BETA),
        deposit_minor=page["Deposit"],
    )
    assert price_minor == page["Price"]
    signers = {"person_ids": [story.producer_id, story.second_producer_id], "first": "designer"}
    story.producer.ask("PUT", f"{contract.path}/signers", json=signers)
    story.producer.ask("POST", f"{contract.path}/send", json={"note": ""})
    sent = [
        contract.redline(first, "rates", {"extra_round_bp": 4_000}, "refused", comment="That is too much."),
        contract.redline(first, "rates", {"extra_round_bp": 3_000}, "countered", terms={"extra_round_bp": 2_500}),
        contract.redline(first, "silence", {"silence_days": 5}, "accepted"),
    ]
    assert [number - sent[0] for number in sent] == sorted(number - sent[0] for number in sent)
    assert contract.sign(first, story.producer, story.second_producer) == "agreed"
    assert contract.owed() == [("deposit", "", page["deposit"])]

    november.go_to(4)
    story.approve(story.deliver(first, "radar_ping", 440))
    story.deliver(first, "dock_clamp", 550)
    story.request_change(story.deliver(first, "mine_arm", 660))
    story.request_change(story.deliver(first, "missile_launch", 770))

    november.go_to(5)
    question = first.ask("POST", f"/cues/{story.cues['dock_clamp']}/questions", json={"text": "How heavy is it?"})
    story.producer.ask("POST", f"/cues/{story.cues['mine_arm']}/cut", json={"reason": "Mines left the game"})
    story.request_change(story.deliver(first, "missile_launch", 780))

    november.go_to(6)
    story.request_change(story.deliver(first, "missile_launch", 790))
    (offer,) = first.ask("GET", f"{contract.path}/change-orders")["offers"]
    assert offer["kind"] == "round"
    third_round = {"kind": "add_round", "cue_id": offer["change"]["cue_id"]}
    contract.change_order(first, [third_round], offers=[offer["offer"]])
    assert first.ask("GET", f"{contract.path}/change-orders")["offers"] == []
    beta = next(
        one["id"] for one in first.ask("GET", f"{contract.path}/change-orders")["milestones"] if one["name"] == "Beta"
    )
    rush = {"kind": "add_work", "milestone_id": beta, "text": "Rush: hull_hit", "amount_minor": page["rush"]}
    by_tuesday = {"kind": "move_date", "milestone_id": beta, "due_on": "2026-11-10"}
    proposed = contract.change_order(first, [rush, by_tuesday])
    assert "rush" in [one["code"] for one in proposed["difference"]["warnings"]]

    november.go_to(9)
    answer = {"text": "Two tonnes.", "joins": False}
    story.producer.ask("POST", f"/questions/{question['id']}/answer", json=answer)
    story.approve(story.deliver(first, "missile_launch", 800))

    november.go_to(10)
    story.deliver(first, "hull_hit", 880)

    november.go_to(16, hour=23)
    apply_deemed_acceptance(server.runtime, {})
    assert ("accepted", "dock_clamp") not in [line[:2] for line in contract.owed()]
    november.go_to(17)
    apply_deemed_acceptance(server.runtime, {})
    assert contract.owed() == [
        ("deposit", "", page["deposit"]),
        ("accepted", "radar_ping", page["radar_ping"]),
        ("cut", "mine_arm", page["mine_arm"]),
        ("extra_round", "missile_launch", page["missile_launch, round 3"]),
        ("extra_work", "", page["rush"]),
        ("accepted", "missile_launch", page["missile_launch"]),
        ("accepted", "dock_clamp", page["dock_clamp"]),
    ]

    settled = contract.settle(first)
    stated = {one["cue"]["name"]: one["owed_minor"] for one in settled["cues"]}
    assert stated == {name: page[name] for name in (*ALPHA, *BETA)}
    assert settled["cues_minor"] == page["cues of the statement"]
    assert (settled["deposit_minor"], settled["rounds_minor"], settled["extra_minor"]) == (
        page["deposit"],
        page["missile_launch, round 3"],
        page["rush"],
    )
    assert sum(amount for kind, _, amount in contract.owed() if kind == "bonus") == page["first bonus"]
    assert contract.owed()[-1] == ("cut", "hull_hit", page["hull_hit"])
    invoice = first.ask("POST", f"{contract.path}/invoices", json={"seller": "Sound designer"})
    assert invoice["total_minor"] == page["settlement"]
    paid = {"amount_minor": page["settlement"], "reference": "T-1", "paid_on": "2026-11-17"}
    story.producer.ask("POST", f"/invoices/{invoice['id']}/payments", json=paid)
    figures = contract.figures()
    assert (figures["paid_minor"], figures["due_minor"], figures["open_minor"]) == (page["settlement"], 0, 0)
    assert (figures["agreed_minor"], figures["saved_minor"]) == (
        page["agreed with its change orders"],
        page["not owed"],
    )

    pack = zipfile.ZipFile(io.BytesIO(story.producer.ask("GET", f"{contract.path}/handover")))
    masters = {name for name in pack.namelist() if name.startswith("masters/")}
    assert masters == {f"masters/{name}.wav" for name in ("radar_ping", "dock_clamp", "missile_launch")}
    said = pack.read("README.md").decode() + pack.read("cues.csv").decode()
    assert "hull_hit" in said
    assert "warp_in" in said
    assert not re.search(r"\d\.\d\d|EUR|€", said), "amounts are not handed over"

    november.go_to(18)
    second, engagement_id = story.hire()
    rest = story.begin(
        engagement_id,
        "Effects, second part",
        {"bonus"},
        bonus_minor=page["second bonus"],
        bonus_when="no_rejected_take",
    )
    amount_minor = page["second hull_hit"] + page["second warp_in"]
    rest.plan(("Rest", amount_minor, 30, BETA[1:]), deposit_minor=page["second deposit"])
    story.producer.ask("POST", f"{rest.path}/send", json={"note": ""})
    assert rest.sign(second, story.producer) == "agreed"
    second.refused("GET", f"{contract.path}/ledger")
    story.approve(story.deliver(second, "hull_hit", 890))
    story.approve(story.deliver(second, "warp_in", 990))
    assert rest.owed() == [
        ("deposit", "", page["second deposit"]),
        ("accepted", "hull_hit", page["second hull_hit"]),
        ("accepted", "warp_in", page["second warp_in"]),
        ("bonus", "", page["second bonus"]),
    ]
    invoice = second.ask("POST", f"{rest.path}/invoices", json={"seller": "Sound designer"})
    assert invoice["total_minor"] == page["second total"]
    assert contract.figures()["accepted_minor"] + rest.figures()["accepted_minor"] == page["both contracts"]
    assert (contract.faults(), rest.faults()) == ([], [])
    assert page.unread == set(), "amounts that nothing was held against"
