"""Invoices: everything that is due and on none yet, numbered without gaps, with the tax of each rate."""

from collections.abc import Iterable, Sequence
from datetime import date, timedelta
from uuid import UUID

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.access import visible_contract
from app.agreements.errors import ContractNotFound
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import lock_contract
from app.agreements.record import service as record
from app.agreements.rules import ContractState, WorkState
from app.agreements.sources import ensure_stated_to_invoice
from app.core.events import publish
from app.core.money import money, percent
from app.core.plural import day_in_words
from app.money import queries, schemas
from app.money.errors import InvoiceNotFound, InvoiceNumberTaken, NoInterestDue, NotAgreed, OtherPartyNeeded
from app.money.invoices import numbers as invoice_numbers
from app.money.invoices.late_interest import interest_minor
from app.money.ledger.book import CLAUSES, SHARES, Entry, LedgerBook, Line, tax_entries
from app.money.ledger.rules import LineKind, hours_in_words
from app.money.ledger.service import cue_label, load_ledger_book, write
from app.money.models import Invoice, InvoiceLine
from app.projects.models import Project
from app.sound_lists.models import Cue

CUT_IN = {
    WorkState.NOT_BEGUN: "cut before work began",
    WorkState.IN_WORK: "cut in progress",
    WorkState.DELIVERED: "cut after delivery",
    WorkState.ACCEPTED: "cut after acceptance",
}


def draft_invoice(session: Session, actor: Actor, contract_id: UUID, *, full_number: str = "") -> schemas.InvoiceDraft:
    """Return the content of an invoice if it were issued now, under a number or the one after the last."""
    contract = _for_designer(session, actor, contract_id)
    book, terms = load_ledger_book(session, contract), terms_of(session, contract)
    billed = book.billable
    taxes = tax_entries(billed, tax_rates_of(session, contract), default_bp=terms.invoiced_tax_bp)
    texts = texts_of(session, contract, billed)
    last = queries.last_invoice(session, contract.studio_id, contract.designer_id)
    net_minor = sum(line.amount_minor for line in billed)
    used = queries.full_numbers_of(session, contract.designer_id)
    full_number = full_number or _next_number(session, contract)
    return schemas.InvoiceDraft(
        contract_id=contract.id,
        currency=contract.currency,
        number=last.number + 1 if last else 1,
        full_number=full_number,
        number_advice=invoice_numbers.advice(full_number, used),
        is_number_taken=full_number in used,
        seller=last.seller if last else contract.designer.name,
        buyer=last.buyer if last else contract.project.studio.name,
        po_number=terms.po_number or (last.po_number if last else ""),
        reverse_charge=terms.reverse_charge,
        payment_days=terms.payment_days,
        lines=[
            schemas.InvoiceLineRead(text=texts[line.id], amount_minor=line.amount_minor, tax_bp=None) for line in billed
        ],
        taxes=[schemas.TaxRead(tax_bp=tax.tax_bp or 0, amount_minor=tax.amount_minor) for tax in taxes],
        net_minor=net_minor,
        total_minor=net_minor + sum(tax.amount_minor for tax in taxes),
    )


def issue_invoice(
    session: Session,
    actor: Actor,
    contract_id: UUID,
    *,
    full_number: str = "",
    seller: str,
    buyer: str,
    po_number: str,
    note: str,
) -> Invoice:
    """Issue an invoice over everything that is due and on none yet.

    Raise NothingToInvoice where nothing is, InvoiceNumberTaken for a number that the designer has used.
    """
    contract = _for_designer(session, actor, contract_id)
    parties = contract.designer.name, contract.project.studio.name
    lock_contract(session, contract.id)
    number = queries.next_invoice_number(session, contract.studio_id, contract.designer_id)
    full_number = full_number or _next_number(session, contract)
    if full_number in queries.full_numbers_of(session, contract.designer_id):
        raise InvoiceNumberTaken(
            f"you have issued an invoice {full_number} already",
            fix=f"the next one is {_next_number(session, contract)}",
        )
    book, terms = load_ledger_book(session, contract), terms_of(session, contract)
    billed = book.billable
    cue_ids = [line.cue_id for line in billed if line.kind in SHARES and line.cue_id]
    ensure_stated_to_invoice(session, contract, cue_ids)
    taxes: Sequence[Entry] = tax_entries(billed, tax_rates_of(session, contract), default_bp=terms.invoiced_tax_bp)
    today = plan_queries.today_of(session, contract)
    invoice = Invoice(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract.id,
        designer_id=contract.designer_id,
        number=number,
        full_number=full_number,
        issued_on=today,
        due_on=today + timedelta(days=terms.payment_days),
        po_number=po_number or terms.po_number,
        seller=seller or parties[0],
        buyer=buyer or parties[1],
        note=note,
        reverse_charge=terms.reverse_charge,
        issued_by=actor.person,
    )
    session.add(invoice)
    session.flush()
    texts = texts_of(session, contract, billed)
    _put_on(session, invoice, texts)
    tax_lines = write(session, contract, taxes, person_id=actor.person)
    _put_on(session, invoice, {line.id: f"Tax, {percent(line.tax_bp or 0)}" for line in tax_lines})
    whole_minor = sum(line.amount_minor for line in (*billed, *taxes))
    facts = {
        "number": full_number,
        "total": money(whole_minor, contract.currency),
        "due_on": invoice.due_on.isoformat(),
        "lines": [str(line_id) for line_id in texts],
    }
    record.append(session, contract.id, "invoiced", facts, by=actor.person)
    publish(session, "invoice.issued", studio_id=contract.studio_id, invoice_id=invoice.id, total=str(facts["total"]))
    return invoice


def _next_number(session: Session, contract: Contract) -> str:
    newest = queries.newest_invoice_of(session, contract.designer_id)
    if newest is None:
        return "1"
    used = queries.full_numbers_of(session, contract.designer_id)
    return invoice_numbers.following(
        newest.full_number, newest.issued_on, plan_queries.today_of(session, contract), used
    )


def _for_designer(session: Session, actor: Actor, contract_id: UUID) -> Contract:
    contract = visible_contract(session, actor, contract_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("the designer of this contract invoices what is due", fix="ask the designer for it")
    if contract.state not in (ContractState.AGREED, ContractState.ENDED):
        raise NotAgreed("nothing is due before both have signed", fix="sign the contract first")
    return contract


def tax_rates_of(session: Session, contract: Contract) -> dict[UUID, int]:
    """Return the tax rates of the milestones that have one of their own."""
    if terms_of(session, contract).reverse_charge:
        return {}
    milestones = plan_queries.milestones_of(session, contract.id)
    return {milestone.id: milestone.tax_bp for milestone in milestones if milestone.tax_bp is not None}


def _put_on(session: Session, invoice: Invoice, texts: dict[UUID, str]) -> None:
    session.add_all(
        InvoiceLine(
            ledger_line_id=line_id,
            invoice_id=invoice.id,
            studio_id=invoice.studio_id,
            project_id=invoice.project_id,
            text=text,
        )
        for line_id, text in texts.items()
    )
    session.flush()


def texts_of(session: Session, contract: Contract, lines: Iterable[Line]) -> dict[UUID, str]:
    """Return the purpose of lines in words, by their ids."""
    cue_prefix = session.get_one(Project, contract.project_id).cue_prefix
    milestones = {milestone.id: milestone.name for milestone in plan_queries.milestones_of(session, contract.id)}
    cut_in = {cue.cue_id: cue.cut_in for cue in plan_queries.cues_of(session, contract.id)}

    worked = {worked_day.id: worked_day for worked_day in queries.worked_days_of(session, contract.id)}

    def text(line: Line) -> str:
        cue = cue_label(session.get_one(Cue, line.cue_id), cue_prefix) if line.cue_id else ""
        milestone = milestones[line.milestone_id] if line.milestone_id else ""
        match line.kind:
            case LineKind.DEPOSIT:
                return f"{milestone}, due at signing"
            case LineKind.ACCEPTED:
                return f"{cue}, accepted ({milestone})"
            case LineKind.HELD_BACK:
                return f"{cue}, retention ({milestone})"
            case LineKind.CUT:
                state = cut_in.get(line.cue_id) if line.cue_id else None
                return f"{cue}, {CUT_IN[state] if state else 'cut'} ({milestone})"
            case LineKind.EXTRA_ROUND:
                return f"{cue}, round {line.round_number} ({milestone})"
            case LineKind.WORKED_DAY:
                return f"Work by the day ({milestone})" if milestone else "Work by the day"
            case LineKind.WORKED_HOURS if line.worked_day_id:
                day = worked[line.worked_day_id]
                length = hours_in_words(day.minutes or 0)
                about = ", ".join(part for part in (cue, day.note) if part)
                return f"{length} on {day_in_words(day.worked_on)}: {about}"
            case LineKind.RETAINER:
                return f"Retainer, month {line.month_number}"
            case LineKind.LATE_INTEREST if line.late_invoice_id and line.late_until_on:
                late = queries.invoice_by_id(session, line.late_invoice_id)
                until = day_in_words(line.late_until_on)
                return f"Interest on invoice {late.full_number if late else ''}, up to {until}"
            case LineKind.EXTRA_WORK:
                return f"Work by a change order ({milestone})"
            case LineKind.BONUS:
                return "Bonus"
        return f"Taken back: {cue or milestone or 'bonus'}"

    return {line.id: text(line) for line in lines}


def invoices(session: Session, actor: Actor, contract_id: UUID) -> list[schemas.InvoiceRead]:
    """Return the invoices of a contract, the oldest first."""
    contract = visible_contract(session, actor, contract_id)
    book = load_ledger_book(session, contract)
    return [invoice_read(session, contract, book, row) for row in queries.invoices_of(session, contract.id)]


def visible_invoice(session: Session, actor: Actor, invoice_id: UUID) -> tuple[Invoice, Contract]:
    """Return an invoice that the caller may see, with its contract."""
    invoice = queries.invoice_by_id(session, invoice_id)
    if invoice is None:
        raise InvoiceNotFound(f"no invoice {invoice_id}")
    try:
        return invoice, visible_contract(session, actor, invoice.contract_id)
    except ContractNotFound:
        raise InvoiceNotFound(f"no invoice {invoice_id}") from None


def invoice(session: Session, actor: Actor, invoice_id: UUID) -> schemas.InvoiceRead:
    """Return an invoice with its lines and payments."""
    row, contract = visible_invoice(session, actor, invoice_id)
    return invoice_read(session, contract, load_ledger_book(session, contract), row)


def charge_late_interest(session: Session, actor: Actor, invoice_id: UUID) -> schemas.InvoiceRead:
    """Make the interest that an invoice bears by today due, as its designer; what is charged already is left out."""
    row, contract = visible_invoice(session, actor, invoice_id)
    if contract.designer_id != actor.person:
        raise OtherPartyNeeded("the designer of this contract charges interest", fix="ask the designer for it")
    lock_contract(session, contract.id)
    book, today = load_ledger_book(session, contract), plan_queries.today_of(session, contract)
    accrued_minor, charged_minor = _late_interest(session, contract, book, row, today)
    if accrued_minor <= charged_minor:
        raise NoInterestDue(
            f"{money(charged_minor, contract.currency)} of interest is charged, and no more is due",
            fix="wait until the page shows more of it; a paid invoice accrues none",
        )
    entry = Entry(
        LineKind.LATE_INTEREST,
        accrued_minor - charged_minor,
        CLAUSES[LineKind.LATE_INTEREST],
        late_invoice_id=row.id,
        late_until_on=today,
    )
    write(session, contract, [entry], person_id=actor.person)
    return invoice_read(session, contract, load_ledger_book(session, contract), row)


def _late_interest(
    session: Session, contract: Contract, book: LedgerBook, invoice: Invoice, until: date
) -> tuple[int, int]:
    """Return the interest that an invoice bears up to a day, and how much of it is charged; interest bears none."""
    monthly_bp = terms_of(session, contract).late_interest_monthly_bp
    owed_minor = sum(
        line.amount_minor
        for line in book.owed
        if line.invoice_id == invoice.id and line.kind is not LineKind.LATE_INTEREST
    )
    payments = [
        (payment.paid_on, payment.amount_minor)
        for payment in queries.payments_of(session, contract.id)
        if payment.invoice_id == invoice.id
    ]
    accrued_minor = interest_minor(owed_minor, payments, due_on=invoice.due_on, until=until, monthly_bp=monthly_bp)
    charged = [line.amount_minor for line in book.lines if line.late_invoice_id == invoice.id]
    return accrued_minor, sum(charged)


def invoice_read(session: Session, contract: Contract, book: LedgerBook, invoice: Invoice) -> schemas.InvoiceRead:
    """Return an invoice with its lines, its sums and what was paid on it."""
    texts = queries.invoice_texts(session, invoice.id)
    lines = [line for line in book.owed if line.invoice_id == invoice.id]
    taxes = [line for line in lines if line.kind is LineKind.TAX]
    payments = [payment for payment in queries.payments_of(session, contract.id) if payment.invoice_id == invoice.id]
    whole_minor = sum(line.amount_minor for line in lines)
    paid_minor = sum(payment.amount_minor for payment in payments)
    is_paid = paid_minor == whole_minor
    last_on = max((payment.paid_on for payment in payments if payment.refund_of_id is None), default=None)
    today = plan_queries.today_of(session, contract)
    is_late = today > invoice.due_on
    accrued_minor, charged_minor = _late_interest(session, contract, book, invoice, today)
    return schemas.InvoiceRead(
        id=invoice.id,
        contract_id=contract.id,
        number=invoice.number,
        full_number=invoice.full_number,
        currency=contract.currency,
        issued_on=invoice.issued_on,
        due_on=invoice.due_on,
        seller=invoice.seller,
        buyer=invoice.buyer,
        po_number=invoice.po_number,
        note=invoice.note,
        reverse_charge=invoice.reverse_charge,
        lines=[
            schemas.InvoiceLineRead(text=texts[line.id], amount_minor=line.amount_minor, tax_bp=line.tax_bp)
            for line in lines
            if line.kind is not LineKind.TAX
        ],
        taxes=[schemas.TaxRead(tax_bp=line.tax_bp or 0, amount_minor=line.amount_minor) for line in taxes],
        net_minor=whole_minor - sum(line.amount_minor for line in taxes),
        total_minor=whole_minor,
        paid_minor=paid_minor,
        open_minor=whole_minor - paid_minor,
        state="paid" if is_paid else "late" if is_late else "partly_paid" if paid_minor else "open",
        late_interest_minor=accrued_minor,
        late_interest_charged_minor=charged_minor,
        days_to_pay=(last_on - invoice.issued_on).days if is_paid and last_on else None,
        payments=[
            schemas.PaymentRead(
                id=payment.id,
                amount_minor=payment.amount_minor,
                reference=payment.reference,
                paid_on=payment.paid_on,
                refund_of_id=payment.refund_of_id,
                left_minor=payment.amount_minor
                + sum(refund.amount_minor for refund in payments if refund.refund_of_id == payment.id),
            )
            for payment in payments
        ],
    )
