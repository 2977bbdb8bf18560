"""Payments and refunds, recorded with a reference; we move no money."""

from datetime import date
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor, Role, SecondFactorUse
from app.accounts.second_factors.requirements import ensure_second_factor_for
from app.agreements.models import Contract
from app.agreements.plan.queries import today_of
from app.agreements.queries import lock_contract
from app.core.events import publish
from app.money import queries
from app.money.errors import InvoiceNotFound, PaymentNotFound
from app.money.invoices.service import visible_invoice
from app.money.ledger.book import Entry, allocate, refund
from app.money.ledger.rules import ensure_not_ahead
from app.money.ledger.service import load_ledger_book, write
from app.money.models import Invoice, Payment
from app.projects.errors import ProducerNeeded


def record_payment(
    session: Session, actor: Actor, invoice_id: UUID, *, amount_minor: int, reference: str, paid_on: date
) -> Payment:
    """Record the payment of an invoice, in part or whole; raise Overpayment beyond what is open."""
    invoice, contract = visible_invoice(session, actor, invoice_id)
    _ensure_pays(session, actor, contract)
    ensure_not_ahead(paid_on, today_of(session, contract), "record a payment only after it was made")
    lock_contract(session, contract.id)
    entries = allocate(load_ledger_book(session, contract), invoice.id, amount_minor)
    return _keep(session, actor, contract, invoice, entries, reference=reference, paid_on=paid_on)


def refund_payment(
    session: Session, actor: Actor, payment_id: UUID, *, amount_minor: int, reference: str, paid_on: date
) -> Payment:
    """Record that a payment went back, in part or whole; its lines are taken back by reversing ones."""
    payment = queries.payment_by_id(session, payment_id)
    if payment is None or payment.refund_of_id is not None:
        raise PaymentNotFound(f"no payment {payment_id}")
    try:
        invoice, contract = visible_invoice(session, actor, payment.invoice_id)
    except InvoiceNotFound:
        raise PaymentNotFound(f"no payment {payment_id}") from None
    _ensure_pays(session, actor, contract)
    ensure_not_ahead(paid_on, today_of(session, contract), "record a refund only after it was made")
    lock_contract(session, contract.id)
    entries = refund(load_ledger_book(session, contract), payment.id, amount_minor)
    return _keep(
        session, actor, contract, invoice, entries, reference=reference, paid_on=paid_on, refund_of_id=payment.id
    )


def _ensure_pays(session: Session, actor: Actor, contract: Contract) -> None:
    if Role.PRODUCER not in actor.roles_in(contract.studio_id):
        raise ProducerNeeded("only a producer of the studio records payments")
    ensure_second_factor_for(session, actor, contract.studio_id, SecondFactorUse.PAYING)


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
    publish(session, "payment.recorded", studio_id=payment.studio_id, payment_id=payment.id)
    return payment
