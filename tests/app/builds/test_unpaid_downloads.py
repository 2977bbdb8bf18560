"""Where a contract opens masters and game files by payment: closed until then, the invoice named to the parties."""

import hashlib
import io
import zipfile
from typing import Any
from uuid import UUID

import pytest
from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.agreements.rules import ReleaseClause
from tests.app.builds.approved import sound
from tests.app.money.agreed import Agreed, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.deliver import add_cues, deliver, open_delivery
from tests.support.server import World

WHEN_PAID = {"downloads_open": "when_paid"}


class Work:
    """Cues under a contract that opens files by payment, each delivered once, and none approved yet."""

    def __init__(self, world: World, *names: str, holdback_bp: int = 0, **agreed: Any) -> None:
        self.world = world
        self.agreed = Agreed(world, **({"terms": WHEN_PAID} | agreed))
        cues = add_cues(world, *({"name": name, "file_name": name} for name in names))
        self.cues = [UUID(cue["id"]) for cue in cues]

        def hold_back(session: Session) -> None:
            session.get_one(Contract, self.agreed.contract_id).holdback_bp = holdback_bp

        world.server.in_database(hold_back)
        self.agreed.agree(deposit(10_000), milestone("Alpha", *self.cues, amount_minor=20_000))
        delivery_id = open_delivery(world)
        self.masters = [sound(seed) for seed in range(len(names))]
        self.takes = [
            deliver(world, f"{name}.wav", master, delivery_id=delivery_id)["id"]
            for name, master in zip(names, self.masters, strict=True)
        ]
        world.server.wait_for_jobs()

    def approve(self, *places: int) -> None:
        for place in places or range(len(self.takes)):
            self.agreed.approve(UUID(self.takes[place]))
        self.world.server.wait_for_jobs()

    def master(self, place: int = 0, by: str = "producer") -> Any:
        return getattr(self.world, by).get(f"/v1/takes/{self.takes[place]}/master")

    def sounds(self, place: int = 0, by: str = "producer") -> dict[str, Any]:
        return body_of(getattr(self.world, by).get(f"/v1/takes/{self.takes[place]}/sounds"))

    def pack(self, **params: Any) -> Any:
        path = f"/v1/projects/{self.world.project_id}/pack.zip"
        return self.world.producer.get(path, params={"target": "game"} | params)


def gross(invoice: dict[str, Any]) -> int:
    return int(invoice["total_minor"])


@pytest.mark.slow
def test_files_open_with_the_payment_of_the_invoice_that_is_named(world: World) -> None:
    work = Work(world, "laser")
    answer = work.master()
    assert refused(answer) == (403, "download-unpaid")
    assert "due when its cue is accepted" in answer.json()["detail"]
    work.approve()
    assert "USD 200.00 is due for it, and on no invoice yet" in work.master().json()["detail"]
    invoice = work.agreed.invoice()
    said = work.master().json()["detail"]
    assert f"open when invoice {invoice['full_number']} is paid: USD 200.00 of it is open for this cue" in said
    body_of_payment = work.agreed.pay(invoice, gross(invoice) - 1)
    assert body_of_payment.status_code == 201
    assert "USD 0.01 of it is open" in work.master().json()["detail"]
    assert work.agreed.pay(invoice, 1).status_code == 201
    assert work.master().content == work.masters[0]
    assert work.sounds()["closed"] is None


@pytest.mark.slow
def test_all_that_is_of_full_quality_is_closed_and_what_review_needs_is_not(world: World) -> None:
    work = Work(world, "laser")
    render = work.sounds(by="designer")["renders"][0]
    export_path = f"/v1/takes/{work.takes[0]}/master-exports"
    export = world.designer.post(export_path).json()
    world.server.wait_for_jobs()
    refusals = {
        "render": world.producer.get(render["file_url"]),
        "new export": world.producer.post(export_path),
        "export": world.producer.get(f"/v1/master-exports/{export['id']}/file"),
        "dry stem": world.producer.get(f"/v1/takes/{work.takes[0]}/dry-stem"),
        "master": work.master(by="reviewer"),
    }
    assert {name: refused(answer) for name, answer in refusals.items()} == dict.fromkeys(
        refusals, (403, "download-unpaid")
    )
    sounds = work.sounds()
    assert sounds["closed"]
    assert {one["file_url"] for one in sounds["renders"]} == {None}
    for url in (sounds["master"]["preview_url"], sounds["master"]["spectrum_url"], sounds["renders"][0]["preview_url"]):
        assert world.producer.get(url).status_code == 200
    assert body_of(world.approver.get(f"/v1/cues/{work.cues[0]}/review"))["takes"]
    work.approve()
    assert work.master(by="designer").content == work.masters[0], "designers have their own files"


@pytest.mark.slow
def test_only_those_who_see_the_contract_read_its_invoice(world: World) -> None:
    work = Work(world, "laser")
    work.approve()
    invoice = work.agreed.invoice(full_number="INV-2026-014")
    detail = work.master(by="reviewer").json()["detail"]
    assert detail == "this file cannot be downloaded: its files open by payment, and it is not paid yet"
    assert invoice["full_number"] not in str(work.sounds(by="reviewer"))


@pytest.mark.slow
def test_a_pack_is_refused_by_name_or_leaves_the_unpaid_out(world: World) -> None:
    work = Work(world, "laser", "shield")
    work.approve(0)
    paid = work.agreed.invoice()
    assert work.agreed.pay(paid, gross(paid)).status_code == 201
    work.approve(1)
    answer = work.pack()
    assert refused(answer) == (409, "pack-incomplete")
    assert "shield.wav cannot be packed for game: its files open by payment" in answer.json()["detail"]
    pack = body_of(world.producer.get(f"/v1/projects/{world.project_id}/pack", params={"target": "game"}))
    assert (pack["files"], pack["masters_bytes"]) == (1, len(work.masters[0]))
    (missing,) = pack["missing"]
    assert "USD 100.00 is due for it" in missing["reason"]
    with zipfile.ZipFile(io.BytesIO(work.pack(masters=True, allow_missing=True).content)) as archive:
        assert [name for name in archive.namelist() if name.endswith(".wav")] == ["laser.wav", "masters/laser.wav"]
        held = {hashlib.sha256(archive.read(name)).hexdigest() for name in archive.namelist()}
        assert hashlib.sha256(work.masters[1]).hexdigest() not in held
    sealing = {"target": "game", "masters": True, "allow_missing": False}
    assert refused(world.producer.post(f"/v1/projects/{world.project_id}/packs", json=sealing))[1] == "pack-incomplete"
    rest = work.agreed.invoice()
    assert work.agreed.pay(rest, gross(rest)).status_code == 201
    assert work.pack(masters=True).status_code == 200


@pytest.mark.slow
def test_a_retained_part_does_not_keep_a_paid_cue_closed(world: World) -> None:
    work = Work(world, "laser", "shield", holdback_bp=1_000)
    work.approve(0)
    invoice = work.agreed.invoice()
    assert work.agreed.pay(invoice, gross(invoice)).status_code == 201
    assert work.master().status_code == 200
    assert work.master(1).status_code == 403


@pytest.mark.slow
def test_on_completion_files_wait_for_their_milestone(world: World) -> None:
    work = Work(world, "laser", "shield", release=ReleaseClause.ON_COMPLETION)
    work.approve(0)
    assert "due when its milestone is complete" in work.master().json()["detail"]
    work.approve(1)
    invoice = work.agreed.invoice()
    assert work.agreed.pay(invoice, gross(invoice)).status_code == 201
    assert [work.master(place).status_code for place in (0, 1)] == [200, 200]


@pytest.mark.slow
def test_a_refund_closes_and_a_cut_before_acceptance_never_opens(world: World) -> None:
    work = Work(world, "laser", "shield")
    work.approve(0)
    assert world.producer.post(f"/v1/cues/{work.cues[1]}/cut", json={"reason": "no shields"}).status_code == 200
    invoice = work.agreed.invoice()
    (payment,) = work.agreed.pay(invoice, gross(invoice)).json()["payments"]
    assert work.master().status_code == 200
    assert "stay with the designer" in work.master(1).json()["detail"]
    back = {"amount_minor": gross(invoice), "reference": "R-1", "paid_on": payment["paid_on"]}
    assert world.producer.post(f"/v1/payments/{payment['id']}/refunds", json=back).status_code == 201
    assert work.master().status_code == 403


@pytest.mark.slow
@pytest.mark.parametrize("terms", [{}, {"downloads_open": "at_once"}])
def test_without_the_clause_everything_is_open(world: World, terms: dict[str, Any]) -> None:
    work = Work(world, "laser", terms=terms)
    assert work.master().content == work.masters[0]
    assert work.sounds()["closed"] is None
