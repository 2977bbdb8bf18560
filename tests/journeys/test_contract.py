"""A contract through two parties: template, agreed text, sounds, a cut, an extra round, invoice, payment, record."""

import json
from datetime import date, timedelta
from typing import Any
from uuid import UUID

import pytest

from app.agreements.models import Contract
from app.agreements.record import service as record
from tests.journeys.people import Designer, Team
from tests.support.server import RunningServer
from tests.support.waves import sine, wav_bytes

pytestmark = pytest.mark.both_databases

CUES = ("radar_ping", "dock_clamp", "mine_arm", "missile_launch")
TODAY = date(2026, 11, 20)


def sound(hz: float) -> bytes:
    """Return a short tone that conforms."""
    samples = sine(hz=hz, dbfs=-6, seconds=0.3, rate=48_000)
    fade = [min(1.0, place / 48, (len(samples) - 1 - place) / 480) for place in range(len(samples))]
    return wav_bytes((samples.T * fade).T, rate=48_000, bits=24)


class Parties:
    """A producer who decides, and a designer, with a project between them."""

    def __init__(self, server: RunningServer) -> None:
        self.server = server
        self.studio, self.designer = Team(server), Designer(server)
        studio_id = self.studio.sign_up("Shield Wing studio")
        opened = {"studio_id": studio_id, "name": "Shield Wing", "cue_prefix": "SW", "description": ""}
        self.project: str = self.studio.ask("POST", "/projects", json=opened)["id"]
        self.path = f"/projects/{self.project}"
        cues = [{"name": name, "state": "locked"} for name in CUES]
        added = self.studio.ask("POST", f"{self.path}/cues", json={"cues": cues})
        self.cues: dict[str, str] = {cue["name"]: cue["id"] for cue in added}
        invitation = {"email": self.designer.address, "kind": "contract"}
        self.studio.ask("POST", f"{self.path}/invitations", json=invitation)
        server.wait_for_jobs()
        self.designer.look()
        self.designer.accept()
        (engagement,) = self.studio.ask("GET", self.path)["engagements"]
        begun = {"engagement_id": engagement["id"], "kind": "single", "title": "Effects", "currency": "EUR"}
        self.contract: str = self.studio.ask("POST", f"{self.path}/contracts", json=begun)["id"]

    def plan(self) -> dict[str, Any]:
        """Plan a deposit and two milestones of two cues."""

        def milestone(name: str, amount_minor: int, days: int, *names: str) -> dict[str, Any]:
            due_on = (TODAY + timedelta(days=days)).isoformat()
            covered = [{"cue_id": self.cues[cue]} for cue in names]
            return {"name": name, "amount_minor": amount_minor, "due_on": due_on, "cues": covered}

        deposit = {"name": "Deposit", "amount_minor": 25_000, "is_deposit": True}
        body = {
            "milestones": [
                deposit,
                milestone("Alpha", 36_001, 14, *CUES[:2]),
                milestone("Beta", 36_001, 28, *CUES[2:]),
            ]
        }
        planned: dict[str, Any] = self.studio.ask("PUT", f"/contracts/{self.contract}/milestones", json=body)
        return planned

    def agree(self) -> str:
        """Send the text, and have both say yes to it; return its hash."""
        self.studio.ask("POST", f"/contracts/{self.contract}/send", json={"note": ""})
        for party, name in ((self.designer, "Sound designer"), (self.studio, "Producer")):
            text_sha256 = party.ask("GET", f"/contracts/{self.contract}")["version"]["text_sha256"]
            body = {"name": name, "text_sha256": text_sha256}
            agreed = party.ask("POST", f"/contracts/{self.contract}/accept", json=body)
        assert agreed["state"] == "agreed"
        return str(text_sha256)

    def deliver(self, name: str, hz: float) -> str:
        """Deliver a sound for a cue, and return the take that the checks let through."""
        delivery = self.designer.open_delivery(self.project)
        take_id: str = self.designer.deliver(delivery, f"{name}.wav", sound(hz))["id"]
        self.server.wait_for_jobs()
        return take_id

    def approve(self, take_id: str) -> None:
        self.studio.ask("POST", f"/takes/{take_id}/verdict", json={"kind": "approve", "note": ""})

    def request_change(self, take_id: str) -> None:
        body = {"kind": "request_change", "note": "Later thrust."}
        self.studio.ask("POST", f"/takes/{take_id}/verdict", json=body)
        self.studio.ask("POST", f"{self.path}/feedback", json={"note": ""})

    def figures(self) -> dict[str, int]:
        (contract,) = self.designer.ask("GET", f"{self.path}/money")["contracts"]
        figures: dict[str, int] = contract["figures"]
        return figures


@pytest.fixture
def parties(server: RunningServer) -> Parties:
    return Parties(server)


def test_from_the_template_to_the_last_payment(parties: Parties, server: RunningServer) -> None:
    studio, designer = parties.studio, parties.designer
    assert "not-rising" not in {advice["code"] for advice in parties.plan()["advice"]}
    parties.agree()
    assert parties.figures()["due_minor"] == 25_000
    refused = studio.refused("PUT", f"/contracts/{parties.contract}/milestones", json={"milestones": []})
    assert refused["code"] == "plan-locked"

    # Two sounds are accepted; the odd cent of Alpha went to the first.
    parties.approve(parties.deliver("radar_ping", 440))
    parties.approve(parties.deliver("dock_clamp", 550))
    assert parties.figures()["due_minor"] == 25_000 + 18_001 + 18_000

    # A cue is cut while its first version is being changed.
    parties.request_change(parties.deliver("mine_arm", 660))
    studio.ask("POST", f"/cues/{parties.cues['mine_arm']}/cut", json={"reason": "Mines left the game"})
    assert parties.figures()["saved_minor"] == 18_001 - 9_001  # half of 180.01 is 90.005

    # The third round is one too many; the studio agrees to its price.
    for hz in (770, 780, 790):
        parties.request_change(parties.deliver("missile_launch", hz))
    (extra,) = designer.ask("GET", f"/contracts/{parties.contract}/extra-rounds")
    assert (extra["number"], extra["amount_minor"], extra["state"]) == (3, 4_500, "proposed")
    studio.ask("POST", f"/extra-rounds/{extra['id']}/agree")
    parties.approve(parties.deliver("missile_launch", 800))
    due_minor = 25_000 + 36_001 + 9_001 + 4_500 + 18_000
    assert parties.figures()["due_minor"] == due_minor

    # One invoice over all of it, paid in two parts.
    body = {"seller": "Sound designer", "po_number": "PO-7"}
    invoice = designer.ask("POST", f"/contracts/{parties.contract}/invoices", json=body)
    assert (invoice["number"], invoice["total_minor"]) == (1, due_minor)
    assert designer.ask("GET", f"/invoices/{invoice['id']}/invoice.pdf").startswith(b"%PDF")
    for reference, amount_minor in (("T-1", 50_000), ("T-2", due_minor - 50_000)):
        paid = {"amount_minor": amount_minor, "reference": reference, "paid_on": TODAY.isoformat()}
        invoice = studio.ask("POST", f"/invoices/{invoice['id']}/payments", json=paid)
    assert invoice["state"] == "paid"
    figures = parties.figures()
    assert (figures["due_minor"], figures["open_minor"]) == (0, 0)
    assert figures["paid_minor"] + figures["saved_minor"] == figures["agreed_minor"] == 25_000 + 72_002 + 4_500

    verify(parties, server)


def verify(parties: Parties, server: RunningServer) -> None:
    """Hold the record that both read to the chain that was written, and to the sums of the ledger."""
    address = f"/contracts/{parties.contract}/record"
    read = parties.designer.ask("GET", address)
    assert read["faults"] == []
    assert read == parties.studio.ask("GET", address)
    payloads = [entry["payload"] for entry in read["entries"] if entry["kind"] == "paid"]
    reported = [json.loads(payload) if isinstance(payload, str) else payload for payload in payloads]
    assert sum(one["amount_minor"] for one in reported) == parties.figures()["paid_minor"]
    kinds = {entry["kind"] for entry in read["entries"]}
    assert {"sent", "agreed", "planned", "accepted", "due", "cut", "round_proposed", "invoiced", "paid"} <= kinds

    def faults(session: Any) -> list[str]:
        return list(record.validation_errors(session, session.get_one(Contract, UUID(parties.contract))))

    assert server.in_database(faults) == []
