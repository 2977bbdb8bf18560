"""Invoice details: what invoices say of a person who sells, and of a studio that buys."""

from collections.abc import Callable, Sequence
from dataclasses import asdict, fields, replace
from datetime import datetime
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts import queries
from app.accounts.errors import BadInvoiceDetails
from app.accounts.invoice_details.rules import PartyDetails, detail_errors, normalised_account, normalised_code
from app.accounts.models import InvoiceDetails
from app.accounts.rules import Actor
from app.accounts.service import ensure_producer_of
from app.core.db import bypass_row_policies


def details_of_me(session: Session, actor: Actor) -> PartyDetails:
    """Return the caller's details on invoices."""
    return newest(history_of_person(session, actor.person))


def save_my_details(session: Session, actor: Actor, details: PartyDetails) -> PartyDetails:
    """Save the caller's details on invoices from now on; raise BadInvoiceDetails."""
    return _save(session, actor, details, person_id=actor.person)


def details_of_studio(session: Session, actor: Actor, studio_id: UUID) -> PartyDetails:
    """Return a studio's details on invoices, to its producers."""
    ensure_producer_of(session, actor, studio_id)
    return newest(history_of_studio(session, studio_id))


def save_studio_details(session: Session, actor: Actor, studio_id: UUID, details: PartyDetails) -> PartyDetails:
    """Save a studio's details on invoices from now on, as a producer; raise BadInvoiceDetails."""
    ensure_producer_of(session, actor, studio_id)
    return _save(session, actor, details, studio_id=studio_id)


def history_of_person(session: Session, person_id: UUID) -> Sequence[InvoiceDetails]:
    """Return every saved state of a person's details, the oldest first, without a check of the caller."""
    with bypass_row_policies(session):  # the other party of an invoice reads what the invoice says
        return queries.invoice_details_of(session, person_id=person_id)


def history_of_studio(session: Session, studio_id: UUID) -> Sequence[InvoiceDetails]:
    """Return every saved state of a studio's details, the oldest first, without a check of the caller."""
    with bypass_row_policies(session):  # the other party of an invoice reads what the invoice says
        return queries.invoice_details_of(session, studio_id=studio_id)


def newest(history: Sequence[InvoiceDetails]) -> PartyDetails:
    """Return the details that hold now; empty where none were saved."""
    return party_details(history[-1]) if history else PartyDetails()


def details_as_of(
    history: Sequence[InvoiceDetails], at: datetime, missing_of: Callable[[PartyDetails], Sequence[str]]
) -> PartyDetails:
    """Return the details that held at a moment; where they lacked something, the first later ones that do not."""
    earlier = [saved for saved in history if saved.saved_at <= at]
    candidates = [party_details(saved) for saved in [*earlier[-1:], *history[len(earlier) :]]]
    complete = (details for details in candidates if not missing_of(details))
    return next(complete, candidates[-1] if candidates else PartyDetails())


def party_details(saved: InvoiceDetails) -> PartyDetails:
    """Return saved details as plain values."""
    return PartyDetails(**{field.name: getattr(saved, field.name) for field in fields(PartyDetails)})


def _save(
    session: Session,
    actor: Actor,
    details: PartyDetails,
    *,
    person_id: UUID | None = None,
    studio_id: UUID | None = None,
) -> PartyDetails:
    new_details = replace(
        details,
        country_code=details.country_code.upper(),
        vat_id=normalised_code(details.vat_id),
        account_number=normalised_account(details.account_number),
    )
    if faults := list(detail_errors(new_details)):
        raise BadInvoiceDetails(
            faults[0][1], errors=[{"where": field, "message": message} for field, message in faults]
        )
    history = queries.invoice_details_of(session, person_id=person_id, studio_id=studio_id)
    if newest(history) == new_details:
        return new_details
    session.add(InvoiceDetails(**asdict(new_details), person_id=person_id, studio_id=studio_id, saved_by=actor.person))
    session.flush()
    return new_details
