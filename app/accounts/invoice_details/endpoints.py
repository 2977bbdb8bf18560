"""The endpoints of invoice details: of the caller, and of a studio."""

from uuid import UUID

from fastapi import APIRouter

from app.accounts.errors import BadInvoiceDetails, ProducerNeeded, StudioNotFound
from app.accounts.invoice_details import service as invoice_details
from app.accounts.invoice_details.rules import PartyDetails
from app.accounts.rules import Actor, Audience
from app.accounts.schemas import InvoiceDetailsRead, InvoiceDetailsSave
from app.accounts.web.policies import allows
from app.core.web.http import DbSession, problems

router = APIRouter(prefix="/v1", tags=["accounts"])


@router.get("/me/invoice-details", response_model=InvoiceDetailsRead)
def read_my_invoice_details(session: DbSession, actor: Actor = allows(Audience.PERSON)) -> PartyDetails:
    """Return the caller's details on electronic invoices."""
    return invoice_details.details_of_me(session, actor)


@router.put("/me/invoice-details", response_model=InvoiceDetailsRead, responses=problems(BadInvoiceDetails))
def save_my_invoice_details(
    body: InvoiceDetailsSave, session: DbSession, actor: Actor = allows(Audience.PERSON)
) -> PartyDetails:
    """Save the caller's details on electronic invoices; invoices that were complete before keep theirs."""
    return invoice_details.save_my_details(session, actor, PartyDetails(**body.model_dump()))


@router.get(
    "/studios/{studio_id}/invoice-details",
    response_model=InvoiceDetailsRead,
    responses=problems(StudioNotFound, ProducerNeeded),
)
def read_studio_invoice_details(
    studio_id: UUID, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> PartyDetails:
    """Return the studio's details on electronic invoices."""
    return invoice_details.details_of_studio(session, actor, studio_id)


@router.put(
    "/studios/{studio_id}/invoice-details",
    response_model=InvoiceDetailsRead,
    responses=problems(StudioNotFound, ProducerNeeded, BadInvoiceDetails),
)
def save_studio_invoice_details(
    studio_id: UUID, body: InvoiceDetailsSave, session: DbSession, actor: Actor = allows(Audience.PRODUCER)
) -> PartyDetails:
    """Save the studio's details on electronic invoices; invoices that were complete before keep theirs."""
    return invoice_details.save_studio_details(session, actor, studio_id, PartyDetails(**body.model_dump()))
