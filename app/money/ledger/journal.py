"""The journal of a project for accountants: every invoice and payment that the caller sees, booked for their side."""

from collections.abc import Iterator
from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.models import Contract
from app.agreements.queries import agreed_in
from app.money import queries
from app.money.invoices.electronic_invoices import billed_lines
from app.money.ledger.bookings import BUYERS, SELLERS, Booking, Books, Document, billed, csv_of, paid
from app.money.ledger.rules import LineKind
from app.money.ledger.service import load_ledger_book
from app.money.models import Invoice
from app.projects.service import project_access

CSV = "text/csv; charset=utf-8"


def journal(
    session: Session, actor: Actor, project_id: UUID, *, from_on: date | None = None, until_on: date | None = None
) -> str:
    """Return the bookings of a project from one day to another, both included, as CSV.

    A designer's own are sales; to those who act for the studio all are purchases. Raises TeamNeeded for others.
    """
    project_access(session, actor, project_id).ensure_party()
    return csv_of(
        booking
        for contract in agreed_in(session, actor, project_id)
        for booking in _bookings(session, contract, SELLERS if contract.designer_id == actor.person else BUYERS)
        if (from_on is None or booking.document.on >= from_on) and (until_on is None or booking.document.on <= until_on)
    )


def _bookings(session: Session, contract: Contract, books: Books) -> Iterator[Booking]:
    numbers = {}
    for invoice in queries.invoices_of(session, contract.id):
        numbers[invoice.id] = invoice.full_number
        yield from _of_invoice(session, contract, invoice, books)
    for payment in queries.payments_of(session, contract.id):
        verb = "Refund" if payment.refund_of_id else "Payment"
        document = _document(contract, books, payment.paid_on, payment.reference, verb.lower())
        yield paid(books, document, payment.amount_minor, f"{verb} of invoice {numbers[payment.invoice_id]}")


def _of_invoice(session: Session, contract: Contract, invoice: Invoice, books: Books) -> Iterator[Booking]:
    owed = [line for line in load_ledger_book(session, contract).owed if line.invoice_id == invoice.id]
    kind = "credit note" if sum(line.amount_minor for line in owed) < 0 else "invoice"
    document = _document(contract, books, invoice.issued_on, invoice.full_number, kind, invoice)
    for line in billed_lines(
        session, contract, invoice, [owed_line for owed_line in owed if owed_line.kind is not LineKind.TAX]
    ):
        account = books.work if line.is_work else books.interest
        yield billed(
            books,
            document,
            line.amount_minor,
            line.text,
            account=account,
            tax_bp=line.rate_bp,
            category=line.category.value,
        )
    texts = queries.invoice_texts(session, invoice.id)
    for tax in (owed_line for owed_line in owed if owed_line.kind is LineKind.TAX):
        yield billed(
            books, document, tax.amount_minor, texts[tax.id], account=books.tax, tax_bp=tax.tax_bp, category="S"
        )


def _document(
    contract: Contract, books: Books, on: date, number: str, kind: str, invoice: Invoice | None = None
) -> Document:
    return Document(
        on=on,
        number=number,
        kind=kind,
        party=contract.project.studio.name if books.is_seller else contract.designer.name,
        currency=contract.currency,
        contract=contract.title,
        due_on=invoice.due_on if invoice else None,
        po_number=invoice.po_number if invoice else "",
    )
