"""Electronic invoices: XML by EN 16931 that its schema accepts, the same inside a PDF/A-3, and nothing invented."""

import io
from datetime import timedelta
from decimal import Decimal
from pathlib import Path
from typing import Any
from uuid import UUID

import drafthorse
import pytest
from lxml import etree
from pypdf import PdfReader
from sqlalchemy.orm import Session

from app.money.models import Invoice
from tests.app.money.agreed import TODAY, Agreed, day, deposit, milestone
from tests.app.reviews.making import body_of, refused
from tests.support.server import World

RAM = "urn:un:unece:uncefact:data:standard:ReusableAggregateBusinessInformationEntity:100"
NAMES = {
    "ram": RAM,
    "rsm": "urn:un:unece:uncefact:data:standard:CrossIndustryInvoice:100",
    "udt": "urn:un:unece:uncefact:data:standard:UnqualifiedDataType:100",
}
SCHEMA = etree.XMLSchema(file=str(Path(drafthorse.__file__).parent / "schema" / "Factur-X_1.0.07_EN16931.xsd"))
SELLER = {
    "name": "Quay Sound",
    "street": "1 Quay Street",
    "postal_code": "10115",
    "city": "Berlin",
    "country_code": "DE",
    "vat_id": "DE136695976",
    "account_number": "DE89370400440532013000",
    "no_tax_reason": "VAT exempt small business",
}
BUYER = {
    "name": "Night Harbour",
    "street": "2 Pier Road",
    "city": "Dublin",
    "country_code": "IE",
    "vat_id": "IE6388047V",
}


def fill_in(world: World, seller: dict[str, str] | None = None, buyer: dict[str, str] | None = None) -> None:
    """Have both parties fill in their details."""
    body_of(world.designer.put("/v1/me/invoice-details", json=SELLER if seller is None else seller))
    address = f"/v1/studios/{world.studio_id}/invoice-details"
    body_of(world.producer.put(address, json=BUYER if buyer is None else buyer))


def taxed(world: World, **terms: Any) -> Agreed:
    """Return a contract in EUR of which a deposit of 100.00 and a cue of 180.03 are due."""
    agreed = Agreed(world, terms={"tax_bp": 1_900, "po_number": "PO-77"} | terms, currency="EUR")
    cue = agreed.cue("radar_ping")
    agreed.agree(deposit(10_000), milestone("Alpha", cue, amount_minor=18_003))
    agreed.approve(agreed.take(cue))
    return agreed


def read_xml(by: Any, invoice: dict[str, Any]) -> Any:
    """Return the XML of an invoice, after the schema of the standard has accepted it."""
    answer = by.get(f"/v1/invoices/{invoice['id']}/electronic-invoice.xml")
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "application/xml"
    root = etree.fromstring(answer.content)
    assert SCHEMA.validate(root), SCHEMA.error_log
    ensure_sums(root)
    return root


def texts(root: Any, path: str) -> list[str]:
    return [str(node.text) for node in root.xpath(path, namespaces=NAMES)]


def amounts(root: Any, path: str) -> list[Decimal]:
    return [Decimal(text) for text in texts(root, path)]


def ensure_sums(root: Any) -> None:
    """Hold an invoice against the sums that EN 16931 states as BR-CO-10 to BR-CO-16, BR-S-08 and BR-S-09."""
    lines = amounts(root, "//ram:SpecifiedTradeSettlementLineMonetarySummation/ram:LineTotalAmount")
    sums = "//ram:SpecifiedTradeSettlementHeaderMonetarySummation/ram:"
    net, tax, grand, due = (
        amounts(root, sums + name)[0]
        for name in ("TaxBasisTotalAmount", "TaxTotalAmount", "GrandTotalAmount", "DuePayableAmount")
    )
    assert sum(lines) == net == amounts(root, sums + "LineTotalAmount")[0]
    assert net + tax == grand == due
    taxes = root.xpath("//ram:ApplicableHeaderTradeSettlement/ram:ApplicableTradeTax", namespaces=NAMES)
    of = [{etree.QName(part).localname: part.text for part in entry} for entry in taxes]
    assert sum(Decimal(one["CalculatedAmount"]) for one in of) == tax
    assert sum(Decimal(one["BasisAmount"]) for one in of) == net
    for one in of:
        exact = Decimal(one["BasisAmount"]) * Decimal(one["RateApplicablePercent"]) / 100
        assert abs(exact - Decimal(one["CalculatedAmount"])) <= Decimal("0.005")
        assert (one["CategoryCode"] == "S") == ("ExemptionReason" not in one)


@pytest.mark.slow
def test_the_xml_says_what_the_invoice_says(world: World) -> None:
    agreed = taxed(world)
    fill_in(world)
    issued = agreed.invoice(full_number="INV-2026-014")
    root = read_xml(world.designer, issued)
    assert texts(root, "//rsm:ExchangedDocument/ram:ID") == ["INV-2026-014"]
    assert texts(root, "//rsm:ExchangedDocument/ram:TypeCode") == ["380"]
    assert texts(root, "//ram:BuyerOrderReferencedDocument/ram:IssuerAssignedID") == ["PO-77"]
    assert texts(root, "//ram:DueDateDateTime/udt:DateTimeString") == [day(14).replace("-", "")]
    assert texts(root, "//ram:SellerTradeParty//ram:LineOne") == ["1 Quay Street"]
    assert texts(root, "//ram:BuyerTradeParty//ram:CountryID") == ["IE"]
    assert texts(root, "//ram:SellerTradeParty/ram:SpecifiedTaxRegistration/ram:ID[@schemeID='VA']") == ["DE136695976"]
    assert texts(root, "//ram:IBANID") == ["DE89370400440532013000"]
    names = texts(root, "//ram:SpecifiedTradeProduct/ram:Name")
    assert names[0] == "Deposit, due at signing"
    assert names[1].endswith("radar_ping, accepted (Alpha)")
    assert texts(root, "//ram:IncludedSupplyChainTradeLineItem//ram:CategoryCode") == ["S", "S"]
    assert amounts(root, "//ram:GrandTotalAmount") == [Decimal("333.24")]  # 280.03 and 19 % of it, 53.2057
    assert texts(read_xml(world.producer, issued), "//ram:GrandTotalAmount") == texts(root, "//ram:GrandTotalAmount")


@pytest.mark.slow
def test_under_reverse_charge_the_category_says_so(world: World) -> None:
    agreed = taxed(world, reverse_charge=True)
    fill_in(world)
    root = read_xml(world.designer, agreed.invoice())
    assert set(texts(root, "//ram:ApplicableTradeTax/ram:CategoryCode")) == {"AE"}
    assert texts(root, "//ram:ExemptionReasonCode") == ["VATEX-EU-AE"]
    assert amounts(root, "//ram:TaxTotalAmount") == [Decimal(0)]


@pytest.mark.slow
def test_where_no_tax_is_charged_the_reason_is_the_sellers_own(world: World) -> None:
    agreed = taxed(world, tax_bp=0)
    fill_in(world)
    root = read_xml(world.designer, agreed.invoice())
    assert set(texts(root, "//ram:ApplicableTradeTax/ram:CategoryCode")) == {"E"}
    assert texts(root, "//ram:ExemptionReason") == ["VAT exempt small business"]


@pytest.mark.slow
def test_two_rates_are_two_taxes(world: World) -> None:
    agreed = Agreed(world, terms={"tax_bp": 1_900}, currency="EUR")
    first, second = agreed.cue("radar_ping"), agreed.cue("vo_oath")
    agreed.agree(
        milestone("Alpha", first, amount_minor=10_003),
        milestone("Voice", second, amount_minor=10_050, tax_bp=700, due_on=day(30)),
    )
    agreed.approve(agreed.take(first))
    agreed.approve(agreed.take(second))
    fill_in(world)
    root = read_xml(world.designer, agreed.invoice())
    header = "//ram:ApplicableHeaderTradeSettlement/ram:ApplicableTradeTax/ram:"
    assert amounts(root, header + "RateApplicablePercent") == [Decimal(19), Decimal(7)]
    assert amounts(root, header + "CalculatedAmount") == [Decimal("19.01"), Decimal("7.04")]


@pytest.mark.slow
def test_a_credit_note_names_the_invoice_that_it_corrects(world: World) -> None:
    agreed = Agreed(world, terms={"tax_bp": 1_900}, currency="EUR")
    cue = agreed.cue("radar_ping")
    agreed.agree(milestone("Alpha", cue, amount_minor=18_000))
    take = agreed.take(cue)
    agreed.approve(take)
    fill_in(world, seller=SELLER | {"account_number": ""})
    first = agreed.invoice(full_number="A-1")
    agreed.undo(take)
    credit = agreed.invoice(full_number="A-2")
    assert credit["total_minor"] == -21_420
    root = read_xml(world.designer, credit)
    assert texts(root, "//rsm:ExchangedDocument/ram:TypeCode") == ["381"]
    assert amounts(root, "//ram:GrandTotalAmount") == [Decimal("214.20")]
    assert texts(root, "//ram:InvoiceReferencedDocument/ram:IssuerAssignedID") == ["A-1"]
    lacking = world.designer.get(f"/v1/invoices/{first['id']}/electronic-invoice.xml")
    assert refused(lacking) == (409, "invoice-details-missing")  # an invoice is paid to an account, a credit is not


@pytest.mark.slow
def test_what_is_missing_is_named_with_who_fills_it_in(world: World) -> None:
    agreed = taxed(world, reverse_charge=True)
    fill_in(world, seller=SELLER | {"street": "", "no_tax_reason": ""}, buyer=BUYER | {"vat_id": ""})
    issued = agreed.invoice()
    for ending in ("xml", "pdf"):
        answer = world.producer.get(f"/v1/invoices/{issued['id']}/electronic-invoice.{ending}")
        assert refused(answer) == (409, "invoice-details-missing")
        problem = answer.json()
        assert [error["where"] for error in problem["errors"]] == ["seller.street", "buyer.vat_id"]
        assert problem["detail"].startswith("the electronic invoice lacks of Sound designer: street; of ")
        assert "under Invoice details; a producer of" in problem["fix"]


@pytest.mark.slow
def test_details_that_change_later_leave_a_complete_invoice_alone(world: World) -> None:
    agreed = taxed(world)
    fill_in(world, buyer={})
    issued = agreed.invoice()
    fill_in(world)  # the first complete ones of the studio
    fill_in(world, seller=SELLER | {"city": "Hamburg"}, buyer=BUYER | {"city": "Cork"})
    root = read_xml(world.designer, issued)
    assert texts(root, "//ram:CityName") == ["Berlin", "Dublin"]


@pytest.mark.slow
def test_interest_bears_no_tax(world: World) -> None:
    agreed = taxed(world, late_interest_monthly_bp=100)
    fill_in(world)
    first = agreed.invoice()

    def put_back(session: Session) -> None:
        session.get_one(Invoice, UUID(first["id"])).due_on = TODAY - timedelta(days=30)

    world.server.in_database(put_back)
    assert world.designer.post(f"/v1/invoices/{first['id']}/late-interest").status_code == 201
    root = read_xml(world.designer, agreed.invoice())
    assert texts(root, "//ram:IncludedSupplyChainTradeLineItem//ram:CategoryCode") == ["E"]
    assert texts(root, "//ram:ExemptionReason")[0].startswith("Interest on a late payment")


def test_amounts_with_three_digits_after_the_point_are_refused(world: World) -> None:
    agreed = Agreed(world, terms={"tax_bp": 1_000}, currency="TND")
    agreed.agree(deposit(10_000))
    fill_in(world)
    answer = world.designer.get(f"/v1/invoices/{agreed.invoice()['id']}/electronic-invoice.xml")
    assert refused(answer) == (422, "no-electronic-invoice")


@pytest.mark.slow
def test_the_pdf_has_the_xml_inside(world: World) -> None:
    agreed = taxed(world)
    fill_in(world)
    issued = agreed.invoice(full_number="INV/7", note="Thank you")
    answer = world.producer.get(f"/v1/invoices/{issued['id']}/electronic-invoice.pdf")
    assert answer.status_code == 200, answer.text
    assert answer.headers["content-type"] == "application/pdf"
    reader = PdfReader(io.BytesIO(answer.content))
    [inside] = reader.attachments["factur-x.xml"]
    assert SCHEMA.validate(etree.fromstring(inside))
    [attached] = reader.trailer["/Root"]["/AF"]
    assert attached.get_object()["/AFRelationship"] == "/Alternative"
    metadata = reader.trailer["/Root"]["/Metadata"].get_object().get_data().decode()
    for said in (">3<", ">B<", ">factur-x.xml<", ">EN 16931<"):
        assert said in metadata
    text = "\n".join(page.extract_text() for page in reader.pages)
    for said in ("1 Quay Street", "VAT ID DE136695976", "Account: DE89370400440532013000", "2 Pier Road", "Thank you"):
        assert said in text
    assert "/OutputIntents" in reader.trailer["/Root"]


@pytest.mark.slow
def test_no_one_else_takes_it(world: World) -> None:
    agreed = taxed(world)
    fill_in(world)
    issued = agreed.invoice()
    for ending in ("xml", "pdf"):
        address = f"/v1/invoices/{issued['id']}/electronic-invoice.{ending}"
        assert refused(world.reviewer.get(address)) == (404, "invoice-not-found")
