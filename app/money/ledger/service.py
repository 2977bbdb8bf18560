"""A contract's ledger as it is kept: read as a book, written line by line, each line also recorded."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.clauses.deemed_acceptance import CLAUSE as SILENCE
from app.agreements.clauses.terms import MoneyTerms
from app.agreements.models import Contract, ContractCue, Milestone
from app.agreements.plan import queries as plan_queries
from app.agreements.record import service as record
from app.agreements.rules import AcceptedBy, ContractState, next_action_hint
from app.core.money import money
from app.money import queries
from app.money.errors import NotAgreed
from app.money.ledger.book import CLAUSES, Entry, LedgerBook, Line, PayRules, PricedCue
from app.money.ledger.rules import LineKind
from app.money.models import Invoice, LedgerLine
from app.projects.models import Project
from app.sound_lists.models import Cue
from app.sound_lists.rules import label

# What the record calls it when a line of this kind is written.
EVENTS = {
    LineKind.DEPOSIT: "due",
    LineKind.ACCEPTED: "due",
    LineKind.HELD_BACK: "due",
    LineKind.CUT: "due",
    LineKind.EXTRA_ROUND: "due",
    LineKind.WORKED_DAY: "due",
    LineKind.WORKED_HOURS: "due",
    LineKind.RETAINER: "due",
    LineKind.EXTRA_WORK: "due",
    LineKind.LATE_INTEREST: "due",
    LineKind.BONUS: "due",
    LineKind.TAX: "due",
    LineKind.REVERSED: "taken_back",
    LineKind.PAID: "paid",
    LineKind.REFUNDED: "refunded",
}


def load_ledger_book(session: Session, contract: Contract) -> LedgerBook:
    """Return a contract's ledger with its sums."""
    lines = [_line(line, invoice_id) for line, invoice_id in queries.ledger_of(session, contract.id)]
    return LedgerBook(lines, contract.currency)


def _line(line: LedgerLine, invoice_id: UUID | None) -> Line:
    return Line(
        kind=line.kind,
        amount_minor=line.amount_minor,
        clause=line.clause,
        cue_id=line.cue_id,
        milestone_id=line.milestone_id,
        about_id=line.about_id,
        round_number=line.round_number,
        tax_bp=line.tax_bp,
        late_invoice_id=line.late_invoice_id,
        late_until_on=line.late_until_on,
        worked_day_id=line.worked_day_id,
        month_number=line.month_number,
        id=line.id,
        person_id=line.person_id,
        invoice_id=invoice_id,
        payment_id=line.payment_id,
    )


def priced(cues: Iterable[ContractCue]) -> list[PricedCue]:
    """Return the cues of an agreed contract with their prices, and where they stand."""
    return [
        PricedCue(
            cue_id=cue.cue_id,
            milestone_id=cue.milestone_id,
            amount_minor=cue.amount_minor or 0,
            is_accepted=cue.accepted_at is not None,
            cut_in=cue.cut_in,
            accepting_clause=SILENCE if cue.accepted_by is AcceptedBy.SILENCE else CLAUSES[LineKind.ACCEPTED],
        )
        for cue in cues
    ]


def rules_of(contract: Contract, terms: MoneyTerms) -> PayRules:
    """Return the clauses by which a contract's shares become due."""
    return PayRules(contract.release_clause, contract.holdback_bp, terms.kill_fees)


def write(
    session: Session,
    contract: Contract,
    entries: Sequence[Entry],
    *,
    person_id: UUID | None,
    payment_id: UUID | None = None,
    is_by_server: bool = False,
    reason: str = "",
) -> list[LedgerLine]:
    """Add lines to a contract's ledger, and record each; callers hold the contract's lock.

    `reason` is what the record says besides.
    `is_by_server`: a clause or a schedule did it, and the person, if there is one, answers for it only.
    """
    lines = [
        LedgerLine(
            studio_id=contract.studio_id,
            project_id=contract.project_id,
            contract_id=contract.id,
            person_id=person_id,
            payment_id=payment_id,
            **asdict(entry),
        )
        for entry in entries
    ]
    session.add_all(lines)
    session.flush()
    if lines:
        prefix = session.get_one(Project, contract.project_id).cue_prefix
        for line in lines:
            facts = _facts_of(session, line, contract.currency, prefix) | ({"reason": reason} if reason else {})
            record.append(session, contract.id, EVENTS[line.kind], facts, by=None if is_by_server else person_id)
    return lines


def not_agreed(contract: Contract, message: str) -> NotAgreed:
    """Return the refusal of work under a contract that is not agreed, or not any more."""
    if contract.state is ContractState.ENDED:
        return NotAgreed("this contract has ended", fix=next_action_hint(contract.state, contract.kind))
    return NotAgreed(message, fix="sign the contract first")


def charge_deposits(session: Session, event: Mapping[str, Any]) -> None:
    """Make the deposits of a contract due, in the transaction in which both have agreed to it."""
    contract = session.get_one(Contract, UUID(event["contract_id"]))
    deposits = [
        Entry(LineKind.DEPOSIT, milestone.amount_minor, CLAUSES[LineKind.DEPOSIT], milestone_id=milestone.id)
        for milestone in plan_queries.milestones_of(session, contract.id)
        if milestone.is_deposit and milestone.amount_minor
    ]
    write(session, contract, deposits, person_id=UUID(event["person_id"]))


def _facts_of(session: Session, line: LedgerLine, currency: str, cue_prefix: str) -> dict[str, object]:
    facts: dict[str, object] = {
        "amount": money(line.amount_minor, currency),
        "amount_minor": line.amount_minor,
        "because": line.kind.value,
        "clause": line.clause,
        "line": str(line.id),
    }
    if line.cue_id is not None:
        facts["cue"] = cue_label(session.get_one(Cue, line.cue_id), cue_prefix)
    if line.milestone_id is not None:
        facts["milestone"] = session.get_one(Milestone, line.milestone_id).name
    if line.round_number is not None:
        facts["round"] = line.round_number
    if line.tax_bp is not None and line.cue_id is None and line.milestone_id is None:
        facts["tax_bp"] = line.tax_bp
    if line.late_invoice_id is not None and line.late_until_on is not None:
        facts["late_invoice"] = session.get_one(Invoice, line.late_invoice_id).full_number
        facts["until"] = line.late_until_on.isoformat()
    if line.worked_day_id is not None:
        facts["worked_day"] = str(line.worked_day_id)
    if line.month_number is not None:
        facts["month"] = line.month_number
    if line.about_id is not None:
        facts["about_line"] = str(line.about_id)
    if line.payment_id is not None:
        facts["payment"] = str(line.payment_id)
    return facts


def cue_label(cue: Cue, cue_prefix: str) -> str:
    """Return a cue as people name it: SW-007 shield_hit."""
    return f"{label(cue_prefix, cue.number)} {cue.name}"
