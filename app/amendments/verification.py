"""Contracts held against their records: what was altered, taken out, put in or moved by hand is named."""

import json
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from uuid import UUID

from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractEvent
from app.agreements.queries import contract_by_id, contract_ids, events_of
from app.agreements.record import service as record
from app.agreements.redlines.rules import faults_of_sent
from app.agreements.redlines.service import rounds, texts_of
from app.amendments.entries import Entry, state_after
from app.amendments.row_queries import first_line, id_of, is_id, orphans
from app.amendments.row_verification import row_faults
from app.amendments.work_verification import work_faults
from app.core.db import Database
from app.core.storage import Store


@dataclass(frozen=True)
class Verified:
    """A contract that was held against its record, and what is wrong with it."""

    contract_id: str
    title: str
    entries: int
    faults: Sequence[str]


def verify_all(database: Database, store: Store) -> Iterator[Verified]:
    """Yield every contract of every studio with what is wrong with it; one that cannot be read never stops the rest."""
    with database.reading() as session:
        ids = [id_of(text) for text in contract_ids(session)]
    for contract_id in ids:
        with database.reading() as session:
            yield _verified(session, store, contract_id)
    with database.reading() as session:
        gone: defaultdict[str, list[str]] = defaultdict(list)
        for contract_id, name in orphans(session):
            gone[contract_id].append(name)
    for contract_id, names in sorted(gone.items()):
        fault = f"the contract is missing, and these name it: {', '.join(names)}"
        yield Verified(contract_id, "a contract that is not there", 0, [fault])


def _verified(session: Session, store: Store, contract_id: str) -> Verified:
    if not is_id(contract_id):
        return Verified(contract_id, "a contract", 0, [f"its id is {contract_id!r}, and an id is a UUID"])
    try:
        contract = contract_by_id(session, UUID(contract_id))
        title, entries = contract.title, contract.record_length
    except Exception as error:
        fault = f"the contract cannot be read: {first_line(error)}"
        return Verified(contract_id, "a contract", 0, [fault])
    return Verified(contract_id, title, entries, validation_errors(session, store, contract))


def validation_errors(session: Session, store: Store, contract: Contract) -> list[str]:
    """Return the faults of the record, the texts and the tables of a contract.

    Tables are held against a record that is whole; where it is not, that is what has to be looked into first.
    """
    of_record = list(_or_why_not("the record", record.validation_errors(session, contract)))
    of_texts = _or_why_not("texts and PDFs", record.text_faults(session, store, contract))
    return [*of_record, *of_texts, *([] if of_record else table_faults(session, contract))]


def table_faults(session: Session, contract: Contract) -> Iterator[str]:
    """Yield, in words, where the tables of a contract are not what its record says."""
    events = events_of(session, contract.id)
    try:
        entries = [_entry_of(event) for event in events]
    except (ValueError, TypeError) as error:
        yield f"an entry of the record has another form than this software writes: {first_line(error)}"
        return
    sent = (faults_of_sent(rounds(session, contract), texts_of(session, contract)) for _ in (0,))
    yield from _or_why_not("its state", _state(contract, entries))
    yield from _or_why_not("the tables", row_faults(session, contract, entries))
    yield from _or_why_not("redlines", (fault for faults in sent for fault in faults))
    yield from _or_why_not("the work", work_faults(session, contract, entries))


def _entry_of(event: ContractEvent) -> Entry:
    payload = json.loads(event.payload)
    if not isinstance(payload, dict):
        raise TypeError(f"entry {event.seq} is no table of facts")
    return Entry(event.seq, event.kind, event.at, payload)


def _or_why_not(what: str, faults: Iterable[str]) -> Iterator[str]:
    """Yield faults; of what cannot be read, why."""
    try:
        yield from faults
    except Exception as error:
        yield f"{what} cannot be verified: {type(error).__name__}: {first_line(error)}"


def _state(contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    recorded = state_after(entries)
    if contract.state is not recorded:
        yield f"the contract is {contract.state}, and the record says {recorded}"
