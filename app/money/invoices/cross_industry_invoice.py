"""An invoice as the XML of EN 16931 (UN/CEFACT Cross Industry Invoice), and that XML inside a PDF/A-3: Factur-X.

The terms of the standard stand beside what fills them: BT-1 is the invoice's number.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import date
from decimal import Decimal
from enum import StrEnum
from typing import TYPE_CHECKING

from app.accounts.invoice_details.rules import PartyDetails
from app.core.money import minor_digits

if TYPE_CHECKING:  # the library and lxml take some 20 MiB: only a process that writes such an invoice loads them
    from drafthorse.models.document import Document
    from drafthorse.models.party import TradeParty

PROFILE = "urn:cen.eu:en16931:2017"
SCHEMA = "FACTUR-X_EN16931"
INVOICE, CREDIT_NOTE = "380", "381"  # UNTDID 1001
CREDIT_TRANSFER = "30"  # UNTDID 4461
PIECE = "C62"  # UN/ECE Recommendation 20
REVERSE_CHARGE_CODE = "VATEX-EU-AE"
NO_TAX_ON_INTEREST = "Interest on a late payment is not a price of a service, and bears no VAT."
REVERSE_CHARGE = "Reverse charge: the recipient of the service owes the tax."
MAX_DIGITS = 2  # of amounts after the point, by the standard


class TaxCategory(StrEnum):
    """The reason for a line's tax (UNTDID 5305)."""

    STANDARD = "S"
    REVERSE_CHARGE = "AE"
    EXEMPT = "E"


@dataclass(frozen=True)
class BilledLine:
    """One line of an invoice."""

    text: str
    amount_minor: int
    category: TaxCategory
    rate_bp: int = 0
    is_work: bool = True  # else interest on a late payment


@dataclass(frozen=True)
class BilledTax:
    """The tax of all lines of one category and rate."""

    category: TaxCategory
    rate_bp: int
    basis_minor: int
    amount_minor: int
    reason: str = ""  # why there is none


@dataclass(frozen=True)
class BilledInvoice:
    """All that an electronic invoice says; amounts are as in the ledger, so those of a credit note are below zero."""

    number: str
    issued_on: date
    due_on: date
    from_on: date
    until_on: date
    currency: str
    seller_id: str
    seller: PartyDetails
    buyer: PartyDetails
    po_number: str
    notes: Sequence[str]
    corrects: Sequence[tuple[str, date]]
    lines: Sequence[BilledLine]
    taxes: Sequence[BilledTax]

    @property
    def net_minor(self) -> int:
        """The sum of the lines."""
        return sum(line.amount_minor for line in self.lines)

    @property
    def tax_minor(self) -> int:
        """The sum of the taxes."""
        return sum(tax.amount_minor for tax in self.taxes)

    @property
    def is_credit(self) -> bool:
        """Whether the seller owes it."""
        return self.net_minor + self.tax_minor < 0


def taxes_of(
    lines: Sequence[BilledLine], tax_minor: Mapping[int | None, int], *, no_tax_reason: str
) -> list[BilledTax]:
    """Return the tax of each category and rate, with the amounts that were invoiced by their rates."""
    groups: dict[tuple[TaxCategory, int], list[BilledLine]] = {}
    for line in lines:
        groups.setdefault((line.category, line.rate_bp), []).append(line)
    return [
        BilledTax(
            category,
            rate_bp,
            basis_minor=sum(line.amount_minor for line in group),
            amount_minor=tax_minor.get(rate_bp, 0) if category is TaxCategory.STANDARD else 0,
            reason=_reason(category, group, no_tax_reason),
        )
        for (category, rate_bp), group in groups.items()
    ]


def _reason(category: TaxCategory, lines: Sequence[BilledLine], no_tax_reason: str) -> str:
    if category is TaxCategory.STANDARD:
        return ""
    if category is TaxCategory.REVERSE_CHARGE:
        return REVERSE_CHARGE
    reasons = {True: no_tax_reason, False: NO_TAX_ON_INTEREST}
    return " ".join(reasons[is_work] for is_work in sorted({line.is_work for line in lines}, reverse=True))


def cross_industry_invoice(invoice: BilledInvoice) -> bytes:
    """Return an invoice as XML, held against the schema of the standard."""
    from drafthorse.models.document import Document
    from drafthorse.models.note import IncludedNote

    document = Document()
    document.context.guideline_parameter.id = PROFILE  # BT-24
    document.header.id = invoice.number  # BT-1
    document.header.type_code = CREDIT_NOTE if invoice.is_credit else INVOICE  # BT-3
    document.header.issue_date_time = invoice.issued_on  # BT-2
    for text in invoice.notes:
        note = IncludedNote()
        note.content = printable(text)  # BT-22
        document.header.notes.add(note)
    agreement = document.trade.agreement
    _add_party(agreement.seller, invoice.seller)
    agreement.seller.id = invoice.seller_id  # BT-29: a seller without a VAT ID needs one
    _add_party(agreement.buyer, invoice.buyer)
    if invoice.po_number:
        agreement.buyer_order.issuer_assigned_id = printable(invoice.po_number)  # BT-13
    _add_lines(document, invoice)
    _add_settlement(document, invoice)
    return bytes(document.serialize(schema=SCHEMA))


def printable(text: str) -> str:
    """Return a text without the characters that XML has no way to write."""
    return "".join(letter for letter in text if letter >= " " or letter in "\n\t")


def _add_party(party: TradeParty, details: PartyDetails) -> None:
    from drafthorse.models.party import TaxRegistration

    party.name = details.name  # BT-27, BT-44
    party.address.postcode = details.postal_code
    party.address.line_one = details.street
    party.address.city_name = details.city
    party.address.country_id = details.country_code
    for scheme, number in (("VA", details.vat_id), ("FC", details.tax_number)):  # BT-31 and BT-48, BT-32
        if number:
            party.tax_registrations.add(TaxRegistration(id=(scheme, number)))


def _add_lines(document: Document, invoice: BilledInvoice) -> None:
    from drafthorse.models.tradelines import LineItem

    amount = _amounts(invoice)
    for number, line in enumerate(invoice.lines, start=1):
        total = amount(line.amount_minor)
        item = LineItem()
        item.document.line_id = str(number)  # BT-126
        item.product.name = printable(line.text)  # BT-153
        item.agreement.net.amount = abs(total)  # BT-146 is never below zero, so what is taken back has that quantity
        item.delivery.billed_quantity = (Decimal(1 if total >= 0 else -1), PIECE)  # BT-129
        item.settlement.trade_tax.type_code = "VAT"
        item.settlement.trade_tax.category_code = line.category.value  # BT-151
        item.settlement.trade_tax.rate_applicable_percent = Decimal(line.rate_bp).scaleb(-2)  # BT-152
        item.settlement.monetary_summation.total_amount = total  # BT-131
        document.trade.items.add(item)


def _add_settlement(document: Document, invoice: BilledInvoice) -> None:
    from drafthorse.models.payment import PaymentMeans, PaymentTerms

    amount, settlement = _amounts(invoice), document.trade.settlement
    settlement.currency_code = invoice.currency  # BT-5
    if not invoice.is_credit:
        settlement.payment_reference = invoice.number  # BT-83
        means = PaymentMeans()
        means.type_code = CREDIT_TRANSFER  # BT-81
        if invoice.seller.has_iban:
            means.payee_account.iban = invoice.seller.account_number  # BT-84
        else:
            means.payee_account.proprietary_id = invoice.seller.account_number
        settlement.payment_means.add(means)
    settlement.period.start, settlement.period.end = invoice.from_on, invoice.until_on  # BT-73, BT-74
    _add_taxes(document, invoice)
    terms = PaymentTerms()
    terms.due = invoice.due_on  # BT-9
    settlement.terms.add(terms)
    if len(invoice.corrects) == 1:  # the library has room for one; others stand in a note
        number, issued_on = invoice.corrects[0]
        settlement.invoice_referenced_document.issuer_assigned_id = number  # BT-25
        settlement.invoice_referenced_document.issue_date_time = issued_on  # BT-26
    net, tax = amount(invoice.net_minor), amount(invoice.tax_minor)
    sums = settlement.monetary_summation
    sums.line_total, sums.tax_basis_total = net, net  # BT-106, BT-109
    sums.charge_total = sums.allowance_total = Decimal(0)
    sums.tax_total = (tax, invoice.currency)  # BT-110
    sums.grand_total = sums.due_amount = net + tax  # BT-112, BT-115


def _add_taxes(document: Document, invoice: BilledInvoice) -> None:
    from drafthorse.models.accounting import ApplicableTradeTax

    amount = _amounts(invoice)
    for tax in invoice.taxes:
        entry = ApplicableTradeTax()
        entry.calculated_amount = amount(tax.amount_minor)  # BT-117
        entry.type_code = "VAT"
        if tax.reason:
            entry.exemption_reason = printable(tax.reason)  # BT-120
        if tax.category is TaxCategory.REVERSE_CHARGE:
            entry.exemption_reason_code = REVERSE_CHARGE_CODE  # BT-121
        entry.basis_amount = amount(tax.basis_minor)  # BT-116
        entry.category_code = tax.category.value  # BT-118
        entry.rate_applicable_percent = Decimal(tax.rate_bp).scaleb(-2)  # BT-119
        document.trade.settlement.trade_tax.add(entry)


def _amounts(invoice: BilledInvoice) -> Callable[[int], Decimal]:
    """Return the converter of ledger amounts to invoice amounts; a credit note states its credits above zero."""
    sign, digits = -1 if invoice.is_credit else 1, minor_digits(invoice.currency)
    return lambda amount_minor: Decimal(sign * amount_minor).scaleb(-digits)


def factur_x(pdf: bytes, xml: bytes, *, title: str, author: str) -> bytes:
    """Return a PDF/A-2 as PDF/A-3 that has the XML of its invoice inside, as Factur-X wants it."""
    from drafthorse.pdf import attach_xml

    facts = {"title": title, "subject": title, "author": author, "creator": "Soundlist", "keywords": "Factur-X"}
    return bytes(attach_xml(pdf, xml, level="EN 16931", metadata=facts, lang="en"))
