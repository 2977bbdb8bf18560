"""Payments and refunds, recorded with a reference; we move no money."""

from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role
from app.contracts import money_queries
from app.contracts.book import Entry, lay_out, refund
from app.contracts.errors import InvoiceNotFound, PaymentNotFound
from app.contracts.invoices import invoice_in_sight
from app.contracts.ledger import book_of, write
from app.contracts.models import Contract, Invoice, Payment
from app.contracts.queries import lock_contract
from app.contracts.rules import ensure_not_ahead
from app.kit import clock
from app.projects.errors import ProducerNeeded


def record_payment(
    session: Session, actor: Actor, invoice_id: UUID, *, amount_minor: int, reference: str, paid_on: date
) -> Payment:
    """Record what was paid on an invoice, in part or whole; raise PaysTooMuch beyond what is open."""
    invoice, contract = invoice_in_sight(session, actor, invoice_id)
    _ensure_pays(actor, contract)
    ensure_not_ahead(paid_on, clock.now().date(), "a payment is written down once it was made")
    lock_contract(session, contract.id)
    entries = lay_out(book_of(session, contract), invoice.id, amount_minor)
    return _keep(session, actor, contract, invoice, entries, reference=reference, paid_on=paid_on)


def refund_payment(
    session: Session, actor: Actor, payment_id: UUID, *, amount_minor: int, reference: str, paid_on: date
) -> Payment:
    """Record that a payment went back, in part or whole; its lines are taken back by reversing ones."""
    payment = money_queries.payment_by_id(session, payment_id)
    if payment is None or payment.refund_of_id is not None:
        raise PaymentNotFound(f"no payment {payment_id}")
    try:
        invoice, contract = invoice_in_sight(session, actor, payment.invoice_id)
    except InvoiceNotFound:
        raise PaymentNotFound(f"no payment {payment_id}") from None
    _ensure_pays(actor, contract)
    ensure_not_ahead(paid_on, clock.now().date(), "a refund is written down once it was made")
    lock_contract(session, contract.id)
    entries = refund(book_of(session, contract), payment.id, amount_minor)
    return _keep(
        session, actor, contract, invoice, entries, reference=reference, paid_on=paid_on, refund_of_id=payment.id
    )


def _ensure_pays(actor: Actor, contract: Contract) -> None:
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio records payments")


def _keep(
    session: Session,
    actor: Actor,
    contract: Contract,
    invoice: Invoice,
    entries: list[Entry],
    *,
    reference: str,
    paid_on: date,
    refund_of_id: UUID | None = None,
) -> Payment:
    payment = Payment(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        invoice_id=invoice.id,
        refund_of_id=refund_of_id,
        amount_minor=sum(entry.amount_minor for entry in entries),
        reference=reference,
        paid_on=paid_on,
        recorded_by=actor.person,
    )
    session.add(payment)
    session.flush()
    write(session, contract, entries, person_id=actor.person, payment_id=payment.id)
    return payment
