"""The endpoints of electronic invoices, and of the journal for accountants."""

from typing import Any
from uuid import UUID

from fastapi import Response

from app.accounts.policies import allows
from app.accounts.rules import Actor, Audience
from app.agreements import documents
from app.kit.http import DbSession, Route, Router, problems
from app.kit.typesetting import DocumentTooLarge, TypesettingBusy
from app.money import electronic_invoices
from app.money.errors import InvoiceDetailsMissing, InvoiceNotFound, NoElectronicInvoice

router = Router(prefix="/v1", tags=["money"], route_class=Route)
PDF_ANSWER: dict[int | str, dict[str, Any]] = {200: {"content": {documents.PDF: {}}, "description": "Factur-X"}}
XML_ANSWER: dict[int | str, dict[str, Any]] = {
    200: {"content": {electronic_invoices.XML: {}}, "description": "EN 16931, Cross Industry Invoice"}
}


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


def _attachment(file_name: str) -> dict[str, str]:
    return {"Content-Disposition": f'attachment; filename="{file_name}"'}
