"""The record of a contract: what was agreed, delivered, accepted and paid, chained so that nobody alters it unseen."""

from collections.abc import Iterator, Mapping
from typing import Any
from uuid import UUID

from sqlalchemy.orm import Session

from app.contracts import queries
from app.contracts.models import Contract, ContractEvent
from app.kit import clock
from app.kit.record import Entry, canonical, faults, link


def append(session: Session, contract_id: UUID, kind: str, payload: Mapping[str, Any]) -> ContractEvent:
    """Add an entry to a contract's record.

    The payload is plain JSON (text, whole numbers, lists and tables of these), and names people and cues in words:
    both parties read it without the server.
    """
    contract = queries.lock_contract(session, contract_id)
    at = clock.now()
    entry = link(
        contract.record_sha256,
        of=str(contract_id),
        seq=contract.record_length + 1,
        at=at.isoformat(timespec="microseconds"),
        kind=kind,
        payload=canonical(payload),
    )
    event = ContractEvent(
        studio_id=contract.studio_id,
        project_id=contract.project_id,
        contract_id=contract_id,
        seq=entry.seq,
        at=at,
        kind=kind,
        payload=entry.payload,
        previous_sha256=entry.previous_sha256,
        sha256=entry.sha256,
    )
    session.add(event)
    contract.record_length, contract.record_sha256 = entry.seq, entry.sha256
    session.flush()
    return event


def entry_of(event: ContractEvent) -> Entry:
    """Return an entry as its hash was made."""
    return Entry(
        of=str(event.contract_id),
        seq=event.seq,
        at=event.at.isoformat(timespec="microseconds"),
        kind=event.kind,
        payload=event.payload,
        previous_sha256=event.previous_sha256,
        sha256=event.sha256,
    )


def faults_of(session: Session, contract: Contract) -> Iterator[str]:
    """Yield, in words, where a contract's record is not the one that was written."""
    entries = (entry_of(event) for event in queries.events_of(session, contract.id))
    yield from faults(entries, of=str(contract.id), length=contract.record_length, last_sha256=contract.record_sha256)
