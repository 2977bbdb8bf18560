"""Milestones, ledgers, invoices and payments, read from the database; callers have checked who looks."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from datetime import datetime
from typing import Literal
from uuid import UUID

from sqlalchemy import Row, exists, func, select
from sqlalchemy.orm import Session, aliased, joinedload

from app.accounts.models import Person
from app.agreements.models import Contract, ContractCue, ContractVersion
from app.agreements.rules import ContractState
from app.core.in_array import in_array
from app.money.ledger.rules import LineKind
from app.money.models import CalendarLink, ExtraRound, Invoice, InvoiceLine, LedgerLine, Payment, WorkedDay, WorkLog
from app.projects.models import Engagement


def ledger_of(session: Session, contract_id: UUID) -> Sequence[Row[LedgerLine, UUID | None]]:
    """Return the lines of a ledger in the order of their writing, each with the invoice that it stands on."""
    return session.execute(
        select(LedgerLine, InvoiceLine.invoice_id)
        .join(InvoiceLine, InvoiceLine.ledger_line_id == LedgerLine.id, isouter=True)
        .where(LedgerLine.contract_id == contract_id)
        .options(joinedload(LedgerLine.person), joinedload(LedgerLine.cue))
        .order_by(LedgerLine.id)
    ).all()


def invoices_of(session: Session, contract_id: UUID) -> Sequence[Invoice]:
    """Return the invoices of a contract, the oldest first."""
    return session.scalars(select(Invoice).where(Invoice.contract_id == contract_id).order_by(Invoice.number)).all()


def invoice_by_id(session: Session, invoice_id: UUID) -> Invoice | None:
    """Return an invoice without asking who looks."""
    return session.get(Invoice, invoice_id)


def last_invoice(session: Session, studio_id: UUID, designer_id: UUID) -> Invoice | None:
    """Return the newest invoice of a designer to a studio."""
    return session.scalar(
        select(Invoice)
        .where(Invoice.studio_id == studio_id, Invoice.designer_id == designer_id)
        .order_by(Invoice.number.desc())
        .limit(1)
    )


def next_invoice_number(session: Session, studio_id: UUID, designer_id: UUID) -> int:
    """Return the number of a designer's next invoice to a studio; locked until the transaction ends."""
    session.execute(select(Person.id).where(Person.id == designer_id).with_for_update(key_share=True))
    last = session.scalar(
        select(func.max(Invoice.number)).where(Invoice.studio_id == studio_id, Invoice.designer_id == designer_id)
    )
    return (last or 0) + 1


def newest_invoice_of(session: Session, designer_id: UUID) -> Invoice | None:
    """Return the newest invoice of a designer, to whichever studio."""
    return session.scalar(
        select(Invoice).where(Invoice.designer_id == designer_id).order_by(Invoice.id.desc()).limit(1)
    )


def full_numbers_of(session: Session, designer_id: UUID) -> Sequence[str]:
    """Return the numbers of all invoices of a designer, as the designer gave them."""
    return session.scalars(select(Invoice.full_number).where(Invoice.designer_id == designer_id)).all()


def payments_of(session: Session, contract_id: UUID) -> Sequence[Payment]:
    """Return the payments of a contract, refunds included, in the order of their recording."""
    return session.scalars(select(Payment).where(Payment.contract_id == contract_id).order_by(Payment.id)).all()


def contracts_covering(session: Session, cue_ids: Collection[UUID]) -> Sequence[tuple[UUID, Contract]]:
    """Return the contracts by which cues are or were ordered, each with the cue, the newest last."""
    rows = session.execute(
        select(ContractCue.cue_id, Contract)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(in_array(ContractCue.cue_id, cue_ids), Contract.agreed_at.is_not(None))
        .order_by(Contract.number)
    )
    return [(cue_id, contract) for cue_id, contract in rows]


def payment_by_id(session: Session, payment_id: UUID) -> Payment | None:
    """Return a payment without asking who looks."""
    return session.get(Payment, payment_id)


def extra_rounds_of(session: Session, contract_id: UUID) -> Sequence[ExtraRound]:
    """Return the rounds beyond the included ones, in the order of their proposal."""
    return session.scalars(
        select(ExtraRound)
        .where(ExtraRound.contract_id == contract_id)
        .options(joinedload(ExtraRound.cue))
        .order_by(ExtraRound.id)
    ).all()


def extra_round_by_id(session: Session, extra_round_id: UUID) -> ExtraRound | None:
    """Return a round beyond the included ones without asking who looks."""
    return session.scalar(select(ExtraRound).where(ExtraRound.id == extra_round_id).options(joinedload(ExtraRound.cue)))


def worked_days_of(session: Session, contract_id: UUID) -> Sequence[WorkedDay]:
    """Return the days that were logged, in order."""
    return session.scalars(
        select(WorkedDay)
        .where(WorkedDay.contract_id == contract_id)
        .options(joinedload(WorkedDay.cue))
        .order_by(WorkedDay.worked_on, WorkedDay.id)
    ).all()


def waiting_work(session: Session, contract_id: UUID, unit: Literal["quarters", "minutes"]) -> Sequence[WorkedDay]:
    """Return the days or the hours that the studio has neither agreed to nor refused, in order."""
    logged = worked_days_of(session, contract_id)
    return [day for day in logged if getattr(day, unit) and day.agreed_at is None and day.refused_at is None]


def contracts_with_retainer(session: Session) -> Sequence[UUID]:
    """Return the agreed contracts of which a version names a retainer, struck clauses included."""
    names_one = select(ContractVersion.contract_id).where(ContractVersion.terms["retainer_minor"].as_integer() > 0)
    return session.scalars(
        select(Contract.id)
        .where(Contract.state == ContractState.AGREED, Contract.id.in_(names_one))
        .order_by(Contract.id)
    ).all()


def worked_minutes(session: Session, contract_ids: Collection[UUID]) -> dict[tuple[UUID, UUID], int]:
    """Return the minutes logged by contract and cue; cues without any are left out."""
    rows = session.execute(
        select(WorkLog.contract_id, WorkLog.cue_id, func.sum(WorkLog.minutes))
        .where(WorkLog.contract_id.in_(contract_ids))
        .group_by(WorkLog.contract_id, WorkLog.cue_id)
    )
    minutes: dict[tuple[UUID, UUID], int] = defaultdict(int)
    for contract_id, cue_id, total in rows:
        minutes[contract_id, cue_id] = int(total)
    return dict(minutes)


def invoice_texts(session: Session, invoice_id: UUID) -> dict[UUID, str]:
    """Return the texts of the lines of an invoice, by the ledger's lines."""
    rows = session.execute(
        select(InvoiceLine.ledger_line_id, InvoiceLine.text).where(InvoiceLine.invoice_id == invoice_id)
    )
    return dict(rows.all())


def worked_day_by_id(session: Session, worked_day_id: UUID) -> WorkedDay | None:
    """Return a logged day without asking who looks."""
    return session.get(WorkedDay, worked_day_id)


def calendar_by_secret(session: Session, secret_sha256: str) -> CalendarLink | None:
    """Return the calendar behind a link that was not withdrawn."""
    return session.scalar(
        select(CalendarLink).where(CalendarLink.secret_sha256 == secret_sha256, CalendarLink.revoked_at.is_(None))
    )


def calendars_of_former_member(session: Session, studio_id: UUID, person_id: UUID) -> Sequence[CalendarLink]:
    """Return a person's calendar links of a studio's projects, but of those that engage the person."""
    engaged = exists().where(
        Engagement.project_id == CalendarLink.project_id,
        Engagement.designer_id == person_id,
        Engagement.ended_at.is_(None),
    )
    return session.scalars(
        select(CalendarLink).where(
            CalendarLink.studio_id == studio_id,
            CalendarLink.person_id == person_id,
            CalendarLink.revoked_at.is_(None),
            ~engaged,
        )
    ).all()


def calendars_of(session: Session, project_id: UUID, person_id: UUID) -> Sequence[CalendarLink]:
    """Return a person's calendar links of a project that were not withdrawn."""
    return session.scalars(
        select(CalendarLink).where(
            CalendarLink.project_id == project_id,
            CalendarLink.person_id == person_id,
            CalendarLink.revoked_at.is_(None),
        )
    ).all()


def days_of_invoice(session: Session, invoice_id: UUID) -> tuple[datetime, datetime]:
    """Return the times at which the first and the last line of an invoice were written, and so became due."""
    first, last = session.execute(
        select(func.min(LedgerLine.created_at), func.max(LedgerLine.created_at))
        .join(InvoiceLine, InvoiceLine.ledger_line_id == LedgerLine.id)
        .where(InvoiceLine.invoice_id == invoice_id, LedgerLine.kind != LineKind.TAX)
    ).one()
    return first, last


def invoices_corrected_by(session: Session, invoice_id: UUID) -> Sequence[Invoice]:
    """Return the earlier invoices of which an invoice takes lines back."""
    back, on, earlier = aliased(LedgerLine), aliased(InvoiceLine), aliased(InvoiceLine)
    return session.scalars(
        select(Invoice)
        .join(earlier, earlier.invoice_id == Invoice.id)
        .join(back, back.about_id == earlier.ledger_line_id)
        .join(on, on.ledger_line_id == back.id)
        .where(on.invoice_id == invoice_id, back.kind == LineKind.REVERSED)
        .order_by(Invoice.id)
        .distinct()
    ).all()
