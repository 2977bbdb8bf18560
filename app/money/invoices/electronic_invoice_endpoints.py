"""The endpoints of electronic invoices, and of the journal for accountants."""

from datetime import date
from typing import Any
from uuid import UUID

from fastapi import APIRouter, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.agreements.drafts import documents
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.http import DbSession, problems
from app.money.errors import InvoiceDetailsMissing, InvoiceNotFound, NoElectronicInvoice
from app.money.invoices import electronic_invoices
from app.money.ledger import journal
from app.projects.errors import ProjectNotFound, TeamNeeded

router = APIRouter(prefix="/v1", tags=["money"])
PDF_ANSWER: dict[int | str, dict[str, Any]] = {200: {"content": {documents.PDF: {}}, "description": "Factur-X"}}
XML_ANSWER: dict[int | str, dict[str, Any]] = {
    200: {"content": {electronic_invoices.XML: {}}, "description": "EN 16931, Cross Industry Invoice"}
}
CSV_ANSWER: dict[int | str, dict[str, Any]] = {200: {"content": {"text/csv": {}}, "description": "Bookings"}}


@router.get(
    "/invoices/{invoice_id}/electronic-invoice.pdf",
    response_class=Response,
    responses=PDF_ANSWER
    | problems(InvoiceNotFound, InvoiceDetailsMissing, NoElectronicInvoice, DocumentTooLarge, TypesettingBusy),
)
def read_electronic_invoice_pdf(
    invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return an invoice as PDF/A-3 with its XML inside (Factur-X, profile EN 16931)."""
    made = electronic_invoices.invoice_pdf(session, actor, invoice_id)
    return Response(made.content, media_type=documents.PDF, headers=_attachment(made.file_name))


@router.get(
    "/invoices/{invoice_id}/electronic-invoice.xml",
    response_class=Response,
    responses=XML_ANSWER | problems(InvoiceNotFound, InvoiceDetailsMissing, NoElectronicInvoice),
)
def read_electronic_invoice_xml(
    invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return an invoice as XML (EN 16931, Cross Industry Invoice)."""
    made = electronic_invoices.invoice_xml(session, actor, invoice_id)
    return Response(made.content, media_type=electronic_invoices.XML, headers=_attachment(made.file_name))


@router.get(
    "/projects/{project_id}/journal.csv",
    response_class=Response,
    responses=CSV_ANSWER | problems(ProjectNotFound, TeamNeeded),
)
def read_journal(
    project_id: UUID,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
    from_on: date | None = None,
    until_on: date | None = None,
) -> Response:
    """Return invoices and payments as bookings for an accountant: a designer's sales, or a studio's purchases."""
    bookings = journal.journal(session, actor, project_id, from_on=from_on, until_on=until_on)
    return Response(bookings, media_type=journal.CSV, headers=_attachment("journal.csv"))


def _attachment(file_name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{file_name}"'}
