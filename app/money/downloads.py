"""Sounds closed to the studio until they are paid."""

from collections.abc import Collection

from sqlalchemy.orm import Session

from app.accounts.rules import Actor
from app.agreements.clauses.terms import DownloadsOpen
from app.agreements.models import Contract
from app.agreements.plan import queries as plan_queries
from app.agreements.plan.queries import terms_of
from app.agreements.queries import contract_for
from app.core.money import money
from app.deliveries.signals import DownloadsClosed, Work
from app.money import queries
from app.money.covering import newest_contracts
from app.money.ledger.book import LedgerBook, Line, PricedCue, open_lines
from app.money.ledger.service import load_ledger_book, priced

UNPAID = "its files open by payment, and it is not paid yet"


def closed_downloads(session: Session, actor: Actor | None, work: Collection[Work]) -> dict[Work, str]:
    """Return the reasons for closed files of some work, in words; open work is left out.

    Invoice and amount are named to those who see the contract, and to nobody where no actor is given.
    """
    newest = newest_contracts(session, work)
    closed: dict[Work, str] = {}
    for contract in {contract.id: contract for contract in newest.values()}.values():
        if terms_of(session, contract).downloads_open is not DownloadsOpen.WHEN_PAID:
            continue
        is_seen = actor is not None and contract_for(session, actor, contract.id) is not None
        book = load_ledger_book(session, contract)
        for cue in priced(plan_queries.cues_of(session, contract.id)):
            key = (cue.cue_id, contract.designer_id)
            lines = open_lines(book, cue)
            if newest.get(key) is contract and (lines is None or lines):
                closed[key] = _words(session, contract, book, cue, lines) if is_seen else UNPAID
    return closed


def answer_closed_downloads(session: Session, asked: DownloadsClosed) -> dict[Work, str]:
    """Return the reasons for closed files of some work to the room that asks for them."""
    return closed_downloads(session, asked.actor, asked.work)


def _words(
    session: Session, contract: Contract, book: LedgerBook, cue: PricedCue, lines: Collection[Line] | None
) -> str:
    if lines is None:
        if cue.cut_in is not None and not cue.is_accepted:
            return "its cue was cut before it was accepted, so its files stay with the designer"
        if cue.is_accepted:
            return "its files open by payment, which is due when its milestone is complete"
        return "its files open by payment, which is due when its cue is accepted"
    open_minor = sum(line.amount_minor - book.paid_minor(line.id) for line in lines)
    amount = money(open_minor, contract.currency)
    numbers = {invoice.id: invoice.full_number for invoice in queries.invoices_of(session, contract.id)}
    named = sorted({numbers[line.invoice_id] for line in lines if line.invoice_id is not None})
    if not named:
        return f"its files open by payment: {amount} is due for it, and on no invoice yet"
    invoices = f"invoice {named[0]}" if len(named) == 1 else f"invoices {', '.join(named)}"
    return f"its files open when {invoices} is paid: {amount} of it is open for this cue"
