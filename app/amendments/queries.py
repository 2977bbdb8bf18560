"""Notices, yeses and the state of work under a contract, read from the database; callers have checked who looks."""

from collections.abc import Sequence
from datetime import date
from uuid import UUID

from sqlalchemy import func, select
from sqlalchemy.orm import Session, joinedload

from app.amendments.models import AmendmentAcceptance, ChangeOrder, Notice


def standing_notice(session: Session, contract_id: UUID) -> Notice | None:
    """Return the notice of a contract that was not withdrawn, settled or not."""
    return session.scalar(
        select(Notice)
        .where(Notice.contract_id == contract_id, Notice.withdrawn_at.is_(None))
        .options(joinedload(Notice.giver))
        .execution_options(populate_existing=True)
    )


def next_notice_number(session: Session, contract_id: UUID) -> int:
    """Return the number of a contract's next notice."""
    return (session.scalar(select(func.max(Notice.number)).where(Notice.contract_id == contract_id)) or 0) + 1


def contracts_to_settle(session: Session, today: date) -> Sequence[UUID]:
    """Return the contracts whose notice is over and which are not settled."""
    return session.scalars(
        select(Notice.contract_id)
        .where(Notice.ends_on < today, Notice.withdrawn_at.is_(None), Notice.settled_at.is_(None))
        .order_by(Notice.id)
    ).all()


def acceptances_of(session: Session, contract_id: UUID, text_sha256: str) -> Sequence[AmendmentAcceptance]:
    """Return the acceptances of a text, in order."""
    return session.scalars(
        select(AmendmentAcceptance)
        .where(AmendmentAcceptance.contract_id == contract_id, AmendmentAcceptance.text_sha256 == text_sha256)
        .order_by(AmendmentAcceptance.id)
    ).all()


def change_orders_of(session: Session, contract_id: UUID) -> Sequence[ChangeOrder]:
    """Return the change orders of a contract, the oldest first, with who proposed them."""
    return session.scalars(
        select(ChangeOrder)
        .where(ChangeOrder.contract_id == contract_id)
        .options(joinedload(ChangeOrder.proposer))
        .order_by(ChangeOrder.number)
    ).all()


def change_order_by_number(session: Session, contract_id: UUID, number: int) -> ChangeOrder | None:
    """Return one change order of a contract as it stands now, with who proposed it."""
    return session.scalar(
        select(ChangeOrder)
        .where(ChangeOrder.contract_id == contract_id, ChangeOrder.number == number)
        .options(joinedload(ChangeOrder.proposer))
        .execution_options(populate_existing=True)
    )


def next_change_order_number(session: Session, contract_id: UUID) -> int:
    """Return the number of a contract's next change order."""
    return (session.scalar(select(func.max(ChangeOrder.number)).where(ChangeOrder.contract_id == contract_id)) or 0) + 1


def notices_of(session: Session, contract_id: UUID) -> Sequence[Notice]:
    """Return the notices of a contract, withdrawn ones included, the oldest first."""
    return session.scalars(select(Notice).where(Notice.contract_id == contract_id).order_by(Notice.number)).all()
