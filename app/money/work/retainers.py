"""Retainers: each month of an agreed contract is due when it begins, once."""

from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.queries import lock_contract
from app.agreements.rules import ContractState
from app.money.ledger.service import load_ledger_book, write
from app.money.work.worked_hours import HourBook


def charge_retainer(session: Session, contract_id: UUID) -> None:
    """Make each month that has begun due, as the server; charging twice is charging once."""
    contract = lock_contract(session, contract_id)
    if contract.state is not ContractState.AGREED:
        return
    entries = HourBook(session, contract).retainer_entries(load_ledger_book(session, contract))
    write(session, contract, entries, person_id=None, is_by_server=True)
