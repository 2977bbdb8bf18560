"""Refusals of electronic invoices and of downloads, each followed by the act that its text advises."""

from typing import Any
from uuid import UUID

from tests.app.amendments.money_refusal_scenes import invoice, pay, with_deposit
from tests.app.amendments.refusal_parties import Parties, advised, granted, scene
from tests.app.builds.approved import sound
from tests.app.money.agreed import deposit, milestone
from tests.app.money.test_electronic_invoices import BUYER, SELLER, fill_in
from tests.support.deliver import add_cues, deliver

ELECTRONIC = "money.invoices.electronic_invoices"
MONGOLIAN = "\u182e\u1823\u1829\u182d\u1823\u182f"  # a script without a font


def electronic(parties: Parties, bill: dict[str, Any], kind: str) -> Any:
    return parties.designer.get(f"/v1/invoices/{bill['id']}/electronic-invoice.{kind}")


@scene(f"{ELECTRONIC}._parties InvoiceDetailsMissing", f"{ELECTRONIC}.invoice_pdf NoElectronicInvoice")
def _each_party_enters_its_details(parties: Parties) -> None:
    bill = granted(invoice(parties, with_deposit(parties)))
    studio = f"/v1/studios/{parties.world.studio_id}/invoice-details"
    words = ("enters theirs on the page Account, under Invoice details", "on the page Studio, under Invoice details")
    advised(electronic(parties, bill, "xml"), "invoice-details-missing", *words)
    granted(parties.designer.put("/v1/me/invoice-details", json=SELLER | {"name": MONGOLIAN}))
    advised(electronic(parties, bill, "xml"), "invoice-details-missing", "a producer of")
    granted(parties.producer.put(studio, json=BUYER))
    advised(electronic(parties, bill, "pdf"), "no-electronic-invoice", "take the XML, which has every letter")
    assert MONGOLIAN in granted(electronic(parties, bill, "xml")).decode()


@scene(f"{ELECTRONIC}._billed NoElectronicInvoice")
def _amounts_of_three_digits_go_as_pdf(parties: Parties) -> None:
    begun = parties.planned(deposit(10_000), milestone("Alpha", parties.cue(), amount_minor=20_000))
    plan = granted(parties.producer.get(f"/v1/contracts/{begun['id']}/milestones"))
    amounts = [
        {"milestone_id": milestone["id"], "amount_minor": milestone["amount_minor"]} for milestone in plan["milestones"]
    ]
    parties.contracts.agree(parties.contracts.save(begun, currency="TND", amounts=amounts))
    fill_in(parties.world)
    bill = granted(invoice(parties, begun))
    advised(electronic(parties, bill, "xml"), "no-electronic-invoice", "send the PDF of the invoice")
    assert granted(parties.designer.get(f"/v1/invoices/{bill['id']}/invoice.pdf")).startswith(b"%PDF")


@scene("deliveries.downloads.ensure_open DownloadUnpaid")
def _files_open_by_payment(parties: Parties) -> None:
    world = parties.world
    (cue,) = add_cues(world, {"name": "laser", "file_name": "laser"})
    plan = milestone("Alpha", UUID(cue["id"]), amount_minor=20_000)
    contract = parties.agreed(deposit(10_000), plan, downloads_open="when_paid")
    master = sound(1)
    take_id = deliver(world, "laser.wav", master)["id"]
    world.server.wait_for_jobs()
    path = f"/v1/takes/{take_id}/master"
    words = ("listen to the preview until then", "payments are recorded on the page Money")
    advised(parties.producer.get(path), "download-unpaid", "due when its cue is accepted", *words)
    preview = granted(parties.producer.get(f"/v1/takes/{take_id}/sounds"))["master"]["preview_url"]
    assert granted(parties.producer.get(preview))
    parties.stage.approve(UUID(take_id))
    bill = granted(invoice(parties, contract))
    advised(parties.producer.get(path), "download-unpaid", f"open when invoice {bill['full_number']} is paid", *words)
    granted(pay(parties, bill, bill["total_minor"]))
    assert granted(parties.producer.get(path)) == master
