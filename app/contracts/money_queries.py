"""Milestones, ledgers, invoices and payments, read from the database; callers have checked who looks."""

from collections import defaultdict
from collections.abc import Collection, Sequence
from uuid import UUID

from sqlalchemy import Row, func, select
from sqlalchemy.orm import Session, joinedload

from app.accounts.models import Person
from app.contracts.clauses import Clause, terms_in_force
from app.contracts.models import (
    CalendarLink,
    Contract,
    ContractCue,
    ContractVersion,
    ExtraRound,
    Invoice,
    InvoiceLine,
    LedgerLine,
    Milestone,
    Payment,
    WorkedDay,
    WorkLog,
)
from app.contracts.rules import ContractState
from app.sound_lists.models import Cue


def milestones_of(session: Session, contract_id: UUID) -> Sequence[Milestone]:
    """Return the milestones of a contract, in order."""
    return session.scalars(
        select(Milestone).where(Milestone.contract_id == contract_id).order_by(Milestone.position)
    ).all()


def milestone_by_id(session: Session, milestone_id: UUID) -> Milestone | None:
    """Return a milestone without asking who looks."""
    return session.get(Milestone, milestone_id)


def cues_of(session: Session, contract_id: UUID) -> Sequence[ContractCue]:
    """Return the cues of a contract with those of the list, in order."""
    return session.scalars(
        select(ContractCue)
        .where(ContractCue.contract_id == contract_id)
        .options(joinedload(ContractCue.cue))
        .order_by(ContractCue.position)
    ).all()


def running_cue(session: Session, cue_id: UUID, designer_ids: Collection[UUID] | None) -> ContractCue | None:
    """Return a cue as an agreed contract covers it; of one of these designers where some are given."""
    found = (
        select(ContractCue)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(ContractCue.cue_id == cue_id, Contract.state == ContractState.AGREED)
        .options(joinedload(ContractCue.cue))
        .order_by(Contract.number)
    )
    if designer_ids is not None:
        found = found.where(Contract.designer_id.in_(designer_ids))
    return session.scalars(found).first()


def cue_of(session: Session, contract_id: UUID, cue_id: UUID) -> ContractCue | None:
    """Return a cue as one contract covers it, as it stands now."""
    return session.scalar(
        select(ContractCue)
        .where(ContractCue.contract_id == contract_id, ContractCue.cue_id == cue_id)
        .options(joinedload(ContractCue.cue))
        .execution_options(populate_existing=True)
    )


def is_accepted_elsewhere(session: Session, contract_id: UUID, cue_id: UUID) -> bool:
    """Return whether a cue was accepted under another contract, which may have ended since."""
    found = select(ContractCue.id).where(
        ContractCue.cue_id == cue_id, ContractCue.contract_id != contract_id, ContractCue.accepted_at.is_not(None)
    )
    return session.scalars(found.limit(1)).first() is not None


def covered_elsewhere(session: Session, contract_id: UUID, cue_ids: Collection[UUID]) -> Sequence[Row[str, str]]:
    """Return the cues that another agreed contract covers and that are not settled there, with its title."""
    return session.execute(
        select(Cue.name, Contract.title)
        .join(ContractCue, ContractCue.cue_id == Cue.id)
        .join(Contract, Contract.id == ContractCue.contract_id)
        .where(
            Cue.id.in_(cue_ids),
            Contract.id != contract_id,
            Contract.state == ContractState.AGREED,
            ContractCue.cut_at.is_(None),
            ContractCue.accepted_at.is_(None),
        )
        .order_by(Cue.number)
    ).all()


def agreed_terms(session: Session, contract: Contract) -> dict[str, object]:
    """Return what the newest version of a contract leaves open and its standing clauses name, over its framework's."""
    terms: dict[str, object] = {}
    for contract_id in (contract.framework_id, contract.id):
        if contract_id is not None:
            newest = session.execute(
                select(ContractVersion.clauses, ContractVersion.terms)
                .where(ContractVersion.contract_id == contract_id)
                .order_by(ContractVersion.number.desc())
                .limit(1)
            ).first()
            if newest is not None:
                terms |= terms_in_force([Clause.of(row) for row in newest.clauses], newest.terms)
    return terms


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
    """Return the number of a designer's next invoice to a studio; nobody else gets one until the transaction ends."""
    session.execute(select(Person.id).where(Person.id == designer_id).with_for_update(key_share=True))
    last = session.scalar(
        select(func.max(Invoice.number)).where(Invoice.studio_id == studio_id, Invoice.designer_id == designer_id)
    )
    return (last or 0) + 1


def payments_of(session: Session, contract_id: UUID) -> Sequence[Payment]:
    """Return the payments of a contract, refunds included, in the order of their recording."""
    return session.scalars(select(Payment).where(Payment.contract_id == contract_id).order_by(Payment.id)).all()


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
        select(WorkedDay).where(WorkedDay.contract_id == contract_id).order_by(WorkedDay.worked_on)
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
    """Return what the lines of an invoice say, by the ledger's lines."""
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


def calendars_of(session: Session, project_id: UUID, person_id: UUID) -> Sequence[CalendarLink]:
    """Return a person's calendar links of a project that were not withdrawn."""
    return session.scalars(
        select(CalendarLink).where(
            CalendarLink.project_id == project_id,
            CalendarLink.person_id == person_id,
            CalendarLink.revoked_at.is_(None),
        )
    ).all()
