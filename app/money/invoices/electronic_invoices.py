"""Invoices that a program reads: EN 16931 as XML, alone or inside the PDF (Factur-X)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.invoice_details.rules import PartyDetails, missing_of_buyer, missing_of_seller
from app.accounts.invoice_details.service import details_as_of, history_of_person, history_of_studio
from app.accounts.rules import Actor
from app.agreements.models import Contract
from app.agreements.plan.queries import terms_of
from app.core.money import minor_digits
from app.money import queries
from app.money.errors import InvoiceDetailsMissing, NoElectronicInvoice
from app.money.invoices import text as invoice_text
from app.money.invoices.cross_industry_invoice import (
    MAX_DIGITS,
    BilledInvoice,
    BilledLine,
    TaxCategory,
    cross_industry_invoice,
    factur_x,
    taxes_of,
)
from app.money.invoices.numbers import file_part
from app.money.invoices.service import invoice_read, tax_rates_of, visible_invoice
from app.money.ledger.book import Line, rate_of
from app.money.ledger.rules import LineKind
from app.money.ledger.service import load_ledger_book
from app.money.models import Invoice
from app.money.schemas import InvoiceRead

XML = "application/xml"
ARCHIVAL_MARK = b"pdfaid:part"  # in the metadata of every PDF/A
FIELD_WORDS = {
    "name": "name",
    "street": "street",
    "city": "city",
    "country_code": "country",
    "vat_id": "VAT ID",
    "account_number": "account to pay to",
    "no_tax_reason": "reason why no tax is charged",
}


@dataclass(frozen=True)
class ElectronicInvoice:
    """The file of an invoice."""

    file_name: str
    content: bytes


@dataclass(frozen=True)
class Parties:
    """The two parties of an invoice."""

    seller: PartyDetails
    buyer: PartyDetails


def invoice_xml(session: Session, actor: Actor, invoice_id: UUID) -> ElectronicInvoice:
    """Return an invoice as XML; raise InvoiceDetailsMissing, NoElectronicInvoice."""
    invoice, contract = visible_invoice(session, actor, invoice_id)
    xml = cross_industry_invoice(_billed(session, contract, invoice))
    return ElectronicInvoice(f"invoice-{file_part(invoice.full_number)}.xml", xml)


def invoice_pdf(session: Session, actor: Actor, invoice_id: UUID) -> ElectronicInvoice:
    """Return an invoice as PDF with its XML inside; raise InvoiceDetailsMissing, NoElectronicInvoice."""
    invoice, contract = visible_invoice(session, actor, invoice_id)
    billed = _billed(session, contract, invoice)
    read = invoice_read(session, contract, load_ledger_book(session, contract), invoice)
    printed = _as_printed(read, billed)
    pdf = invoice_text.archival_pdf(printed)
    if ARCHIVAL_MARK not in pdf:
        raise NoElectronicInvoice(
            "the fonts of the PDF lack letters of this invoice, and the standard allows no such text",
            fix="take the XML, which has every letter",
        )
    xml = cross_industry_invoice(billed)
    content = factur_x(pdf, xml, title=invoice_text.title_of(read), author=billed.seller.name)
    return ElectronicInvoice(f"invoice-{file_part(invoice.full_number)}.pdf", content)


def _as_printed(read: InvoiceRead, billed: BilledInvoice) -> InvoiceRead:
    """Return an invoice whose PDF says of the parties what its XML says."""
    account = f"Account: {billed.seller.account_number}" if billed.seller.account_number else ""
    reasons = [tax.reason for tax in billed.taxes if tax.category is TaxCategory.EXEMPT]
    return read.model_copy(
        update={
            "seller": "\n".join([*billed.seller.address, account]),
            "buyer": "\n".join(billed.buyer.address),
            "note": "\n\n".join([*billed.notes, *reasons]),
        }
    )


def _billed(session: Session, contract: Contract, invoice: Invoice) -> BilledInvoice:
    if (digits := minor_digits(contract.currency)) > MAX_DIGITS:
        raise NoElectronicInvoice(
            f"amounts in {contract.currency} have {digits} digits after the point, and EN 16931 allows {MAX_DIGITS}",
            fix="send the PDF of the invoice",
        )
    book = load_ledger_book(session, contract)
    owed = [line for line in book.owed if line.invoice_id == invoice.id]
    billed = billed_lines(session, contract, invoice, [line for line in owed if line.kind is not LineKind.TAX])
    is_untaxed = any(line.is_work and line.category is TaxCategory.EXEMPT for line in billed)
    is_credit = sum(line.amount_minor for line in owed) < 0
    parties = _parties(session, contract, invoice, is_credit=is_credit, is_untaxed=is_untaxed)
    first, last = queries.days_of_invoice(session, invoice.id)
    corrects = [
        (corrected.full_number, corrected.issued_on) for corrected in queries.invoices_corrected_by(session, invoice.id)
    ]
    notes = [invoice.note] if invoice.note else []
    if len(corrects) > 1:
        notes.append(f"Corrects the invoices {', '.join(number for number, _ in corrects)}.")
    tax_minor = {line.tax_bp: line.amount_minor for line in owed if line.kind is LineKind.TAX}
    return BilledInvoice(
        number=invoice.full_number,
        issued_on=invoice.issued_on,
        due_on=invoice.due_on,
        from_on=first.date(),
        until_on=last.date(),
        currency=contract.currency,
        seller_id=str(invoice.designer_id),
        seller=parties.seller,
        buyer=parties.buyer,
        po_number=invoice.po_number,
        notes=notes,
        corrects=corrects,
        lines=billed,
        taxes=taxes_of(billed, tax_minor, no_tax_reason=parties.seller.no_tax_reason),
    )


def billed_lines(session: Session, contract: Contract, invoice: Invoice, lines: Sequence[Line]) -> list[BilledLine]:
    """Return lines of an invoice that are not tax, each with its tax category and rate."""
    texts = queries.invoice_texts(session, invoice.id)
    rates, default_bp = tax_rates_of(session, contract), terms_of(session, contract).invoiced_tax_bp
    billed = []
    for line in lines:
        rate_bp = rate_of(line, rates, default_bp=default_bp)
        category = TaxCategory.STANDARD if rate_bp else TaxCategory.EXEMPT
        if invoice.reverse_charge and rate_bp is not None:
            category, rate_bp = TaxCategory.REVERSE_CHARGE, 0
        billed.append(BilledLine(texts[line.id], line.amount_minor, category, rate_bp or 0, rate_bp is not None))
    return billed


def _parties(session: Session, contract: Contract, invoice: Invoice, *, is_credit: bool, is_untaxed: bool) -> Parties:
    def lacks_of_seller(details: PartyDetails) -> list[str]:
        return missing_of_seller(details, is_credit=is_credit, is_untaxed=is_untaxed)

    def lacks_of_buyer(details: PartyDetails) -> list[str]:
        return missing_of_buyer(details, is_reverse_charge=invoice.reverse_charge)

    seller = details_as_of(history_of_person(session, invoice.designer_id), invoice.created_at, lacks_of_seller)
    buyer = details_as_of(history_of_studio(session, invoice.studio_id), invoice.created_at, lacks_of_buyer)
    lacking = {"seller": lacks_of_seller(seller), "buyer": lacks_of_buyer(buyer)}
    if missing := {part: fields for part, fields in lacking.items() if fields}:
        raise _details_missing(contract, missing)
    return Parties(seller, buyer)


def _details_missing(contract: Contract, missing: Mapping[str, Sequence[str]]) -> InvoiceDetailsMissing:
    names = {"seller": contract.designer.name, "buyer": contract.project.studio.name}
    fixes = {
        "seller": f"{names['seller']} enters theirs on the page Account, under Invoice details",
        "buyer": f"a producer of {names['buyer']} enters those of the studio on the page Studio, under Invoice details",
    }
    lists = [
        f"of {names[part]}: {', '.join(FIELD_WORDS[field] for field in fields)}" for part, fields in missing.items()
    ]
    return InvoiceDetailsMissing(
        f"the electronic invoice lacks {'; '.join(lists)}",
        fix="; ".join(fixes[part] for part in missing),
        errors=[
            {"where": f"{part}.{field}", "message": f"the {FIELD_WORDS[field]} of {names[part]} is missing"}
            for part, fields in missing.items()
            for field in fields
        ],
    )
