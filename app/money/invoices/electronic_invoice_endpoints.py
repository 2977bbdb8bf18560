"""The endpoints of electronic invoices, and of the journal for accountants."""

from datetime import date
from uuid import UUID

from fastapi import APIRouter, Request, Response

from app.accounts.rules import Actor, Audience
from app.accounts.web.policies import allows
from app.accounts.web.recorded_downloads import record_download
from app.agreements.drafts import documents
from app.core.typesetting import DocumentTooLarge, TypesettingBusy
from app.core.web.downloads import downloads, file_response
from app.core.web.http import DbSession
from app.money.errors import InvoiceDetailsMissing, InvoiceNotFound, NoElectronicInvoice
from app.money.invoices import electronic_invoices
from app.money.ledger import journal
from app.projects.errors import ProjectNotFound, TeamNeeded
from app.projects.models import Project

router = APIRouter(prefix="/v1", tags=["money"])


@router.get(
    "/invoices/{invoice_id}/electronic-invoice.pdf",
    **downloads(
        documents.PDF, InvoiceNotFound, InvoiceDetailsMissing, NoElectronicInvoice, DocumentTooLarge, TypesettingBusy
    ),
)
def read_electronic_invoice_pdf(
    invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return an invoice as PDF/A-3 with its XML inside (Factur-X, profile EN 16931)."""
    made = electronic_invoices.invoice_pdf(session, actor, invoice_id)
    return file_response(made.content, documents.PDF, made.file_name)


@router.get(
    "/invoices/{invoice_id}/electronic-invoice.xml",
    **downloads(electronic_invoices.XML, InvoiceNotFound, InvoiceDetailsMissing, NoElectronicInvoice),
)
def read_electronic_invoice_xml(
    invoice_id: UUID, session: DbSession, actor: Actor = allows(Audience.PROJECT)
) -> Response:
    """Return an invoice as XML (EN 16931, Cross Industry Invoice)."""
    made = electronic_invoices.invoice_xml(session, actor, invoice_id)
    return file_response(made.content, electronic_invoices.XML, made.file_name)


@router.get(
    "/projects/{project_id}/journal.csv",
    **downloads("text/csv", ProjectNotFound, TeamNeeded),
)
def read_journal(
    project_id: UUID,
    request: Request,
    session: DbSession,
    actor: Actor = allows(Audience.PROJECT),
    from_on: date | None = None,
    until_on: date | None = None,
) -> Response:
    """Return invoices and payments as bookings for an accountant: a designer's sales, or a studio's purchases."""
    bookings = journal.journal(session, actor, project_id, from_on=from_on, until_on=until_on)
    project = session.get_one(Project, project_id)
    if actor.roles_in(project.studio_id):  # a designer takes the own sales along, not what the studio keeps
        record_download(request, session, actor, project.studio_id, project_id, f"the journal of {project.name}")
    return file_response(bookings, journal.CSV, "journal.csv")
