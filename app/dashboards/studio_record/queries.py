"""What a studio's record is counted from; each function is one SELECT of narrow rows."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy import Row, func, select
from sqlalchemy.orm import Session

from app.agreements.models import Contract
from app.money.models import Invoice, Payment
from app.projects.models import Project

NEWEST = 100  # invoices, contracts, projects: older ones say nothing of today


def projects_of(session: Session, studio_id: UUID) -> Sequence[UUID]:
    """Return the newest projects of a studio."""
    query = select(Project.id).where(Project.studio_id == studio_id).order_by(Project.id.desc()).limit(NEWEST)
    return session.scalars(query).all()


def payment_days(session: Session, studio_id: UUID) -> Sequence[Row[date, date | None]]:
    """Return the times of the newest invoices to a studio, and of the last payment of each."""
    return session.execute(
        select(Invoice.issued_on, func.max(Payment.paid_on))
        .outerjoin(Payment, Payment.invoice_id == Invoice.id)
        .where(Invoice.studio_id == studio_id)
        .group_by(Invoice.id, Invoice.issued_on)
        .order_by(Invoice.id.desc())
        .limit(NEWEST)
    ).all()


def agreed_contracts(session: Session, studio_id: UUID) -> Sequence[Contract]:
    """Return the newest contracts of a studio that were agreed."""
    query = select(Contract).where(Contract.studio_id == studio_id, Contract.agreed_at.is_not(None))
    return session.scalars(query.order_by(Contract.id.desc()).limit(NEWEST)).all()
