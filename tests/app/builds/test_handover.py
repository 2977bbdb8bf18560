"""The handover pack of a contract that has ended: what the next designer needs, and nothing of money."""

import csv
import hashlib
import io
import zipfile
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.deliveries.models import Take
from app.reviews.rounds.comments import add_guest_comment
from tests.app.agreements.conftest import Contracts
from tests.app.builds.approved import sound
from tests.app.money.agreed import Agreed, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

pytestmark = pytest.mark.slow

REASON = "The budget is gone"
CUES = ("laser", "shield", "warp")


class Half:
    """Three cues under contract: one approved, one with a change requested and a question, one not begun."""

    def __init__(self, world: World, **terms: Any) -> None:
        self.world = world
        self.agreed = Agreed(world, terms={"notice_days": 14} | terms)
        listed = add_cues(world, *({"name": name, "file_name": name, "palette": name == "laser"} for name in CUES))
        self.cues = [UUID(cue["id"]) for cue in listed]
        self.agreed.agree(milestone("Alpha", *self.cues, amount_minor=29_997))
        delivery_id = open_delivery(world)
        self.masters = [sound(seed) for seed in (1, 2)]
        self.takes = [
            UUID(deliver(world, f"{name}.wav", master, delivery_id=delivery_id)["id"])
            for name, master in zip(CUES[:2], self.masters, strict=True)
        ]
        world.server.wait_for_jobs()
        stated = world.designer.put(f"/v1/takes/{self.takes[0]}/sources", json={"from_scratch": True})
        assert stated.status_code == 200, stated.text
        self.agreed.approve(self.takes[0])
        self.agreed.draft(self.takes[1], note="a duller clank", start_s=0.1)
        self.agreed.send()
        asked = world.designer.post(f"/v1/cues/{self.cues[2]}/questions", json={"text": "Which ship warps in?"})
        assert asked.status_code == 201, asked.text

    def end(self) -> None:
        at = f"/v1/contracts/{self.agreed.contract_id}/ending"
        body_of(self.world.producer.post(f"{at}/notice", json={"reason": REASON}))
        for by, name in ((self.world.producer, "Producer"), (self.world.designer, "Designer")):
            seen = body_of(by.get(at))["statement_sha256"]
            body_of(by.post(f"{at}/agree", json={"name": name, "text_sha256": seen}))

    def pack(self, by: str = "producer") -> Any:
        return getattr(self.world, by).get(f"/v1/contracts/{self.agreed.contract_id}/handover")


def test_it_has_what_the_next_designer_needs_and_nothing_of_money(world: World) -> None:
    half = Half(world)
    said = world.reviewer.post(f"/v1/takes/{half.takes[1]}/comments", json={"text": "Very long"})
    assert said.status_code == 201, said.text

    def add_advice(session: Session) -> None:
        take = session.get_one(Take, half.takes[1])
        add_guest_comment(session, take, "Ada", text="Too bright", start_s=None, end_s=None)

    world.server.in_database(add_advice)
    half.end()
    answer = half.pack()
    assert answer.status_code == 200, answer.text
    assert int(answer.headers["content-length"]) == len(answer.content)
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        assert archive.testzip() is None
        assert archive.namelist() == ["masters/laser.wav", "cues.csv", "README.md", "SHA256SUMS"]
        assert archive.read("masters/laser.wav") == half.masters[0]
        table, text, summed = (archive.read(name).decode("utf-8-sig") for name in archive.namelist()[1:])
    sha256 = hashlib.sha256(half.masters[0]).hexdigest()
    assert f"{sha256}  masters/laser.wav" in summed
    rows = [(row["name"], row["state"], row["file"], row["sha256"]) for row in csv.DictReader(io.StringIO(table))]
    assert rows == [
        ("laser", "accepted", "masters/laser.wav", sha256),
        ("shield", "in work", "shield", ""),
        ("warp", "not begun", "warp", ""),
    ]
    assert "laser: accepted, palette" in text
    assert f"- masters/laser.wav, SHA-256 {sha256}; made from scratch" in text
    assert "Change requested, shield.wav at 0.10 s, Audio director" in text
    assert "a duller clank" in text
    assert "- Comment, shield.wav, Composer, " in text
    assert "- Comment, shield.wav, guest Ada, " in text
    assert "Too bright" in text
    assert "warp: Which ship warps in?" in text
    for secret in (REASON, "USD", "299", "99.99", "99,99"):
        assert secret not in text.replace(sha256, "") + table.replace(sha256, "")


def test_cues_that_were_cut_from_the_list_own_no_names(world: World) -> None:
    half = Half(world)
    for cue_id in half.cues[:2]:  # one accepted, one in work
        cut = world.producer.post(f"/v1/cues/{cue_id}/cut", json={"reason": "They left the game"})
        assert cut.status_code == 200, cut.text
    half.end()
    answer = half.pack()
    assert answer.status_code == 200, answer.text
    with zipfile.ZipFile(io.BytesIO(answer.content)) as archive:
        table = archive.read("cues.csv").decode("utf-8-sig")
        masters = [name for name in archive.namelist() if name.startswith("masters/")]
    owed = [row["file"] for row in csv.DictReader(io.StringIO(table)) if not row["sha256"]]
    assert "shield" not in owed, "nobody waits for it"
    assert "warp" in owed
    assert masters == [f"masters/laser_cut_{half.takes[0].hex[-8:]}.wav"]


@pytest.mark.both_databases
def test_cues_of_an_ended_contract_wait_for_the_next_designer(world: World) -> None:
    path = f"/v1/projects/{world.project_id}/handovers"
    half = Half(world)
    assert world.producer.get(path).json() == []
    half.end()
    (waiting,) = world.producer.get(path).json()
    assert (waiting["title"], waiting["designer"]) == ("Effects", "Sound designer")
    assert [cue["name"] for cue in waiting["cues"]] == ["shield", "warp"], "the accepted one is done"
    cut = world.producer.post(f"/v1/cues/{half.cues[1]}/cut", json={"reason": "It left the game"})
    assert cut.status_code == 200, cut.text
    (waiting,) = world.producer.get(path).json()
    assert [cue["name"] for cue in waiting["cues"]] == ["warp"]
    contracts = Contracts(world)
    contract = contracts.begin()
    plan = {"milestones": [milestone("Rest", half.cues[2], amount_minor=9_999)]}
    contracts.ask(world.producer, "PUT", f"/contracts/{contract['id']}/milestones", json=plan)
    assert len(world.producer.get(path).json()) == 1, "a draft covers nothing"
    contracts.agree(contract)
    assert world.producer.get(path).json() == []
    assert world.approver.get(path).status_code == 403
    assert world.stranger.get(path).status_code == 404


def test_it_comes_once_the_contract_has_ended_and_to_producers_only(world: World) -> None:
    half = Half(world)
    assert refused(half.pack()) == (409, "contract-not-ended")
    half.end()
    assert refused(half.pack("reviewer")) == (404, "contract-not-found")
    assert refused(half.pack("designer"))[0] == 403
    assert half.pack().status_code == 200


@pytest.mark.parametrize("downloads_open", ["when_paid", "at_once"])
def test_masters_that_are_not_paid_are_named_and_left_out(world: World, downloads_open: str) -> None:
    half = Half(world, downloads_open=downloads_open)
    half.end()
    with zipfile.ZipFile(io.BytesIO(half.pack().content)) as archive:
        text = archive.read("README.md").decode()
        is_closed = downloads_open == "when_paid"
        assert ("masters/laser.wav" in archive.namelist()) is not is_closed
        assert ("not in this pack: its files open by payment" in text) is is_closed
