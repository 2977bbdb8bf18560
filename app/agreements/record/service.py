"""The record of a contract: what was agreed, delivered, accepted and paid, chained by hashes."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Any
from uuid import UUID

from sqlalchemy.event import listens_for
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.accounts.rules import Actor
from app.agreements import queries
from app.agreements.drafts.documents import sha256_of
from app.agreements.models import Contract, ContractEvent, ContractVersion
from app.agreements.record.authorship import author_of
from app.agreements.rules import ORDERS, ContractState
from app.core import clock
from app.core.db import REACH
from app.core.record import Entry, canonical, faults, link
from app.core.recorded_rows import RowChanges, owners_with_changes, take_changes
from app.core.storage import Store
from app.core.storage.store import BlobAltered, BlobMissing

FORMAT = 2
SENT, AGREED, ROWS = "sent", "agreed", "rows"
WRITTEN = "written"  # an entry of rows that no other entry tells of
HOW = (
    "Each sha256 is that of the UTF-8 JSON of at, kind, of (the contract), payload, previous and seq, "
    "with keys in order and no spaces; previous is the sha256 of the entry before, 64 zeros for the first."
)


class NoRecord(Exception):
    """A file is not a record that was taken from a contract, or was altered since."""


def append(
    session: Session,
    contract_id: UUID,
    kind: str,
    payload: Mapping[str, Any],
    *,
    by: UUID | None,
    on_behalf_of: UUID | None = None,
    rows: RowChanges | None = None,
) -> ContractEvent:
    """Add an entry to a contract's record; it names who did it, as what, and on whose behalf.

    `by` is a person or a build token; None: the server, by a clause or a schedule. The payload is plain JSON (text,
    whole numbers, lists and tables of these), and names people and cues in words: both parties read it without the
    server. `rows` are rows of other owners that it tells of, beside what this transaction changed of the contract's.
    """
    session.flush()
    contract = queries.lock_contract(session, contract_id)
    changes = _changes_to_record(session, contract, kind)
    changes.merge(rows or RowChanges())
    payload = {**payload, **author_of(session, contract, by, on_behalf_of)}
    if changes:
        payload[ROWS] = changes.as_json()
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


def _changes_to_record(session: Session, contract: Contract, kind: str) -> RowChanges:
    """Return the changes of this transaction to the rows of a contract, as far as both parties may read it.

    When it is sent, all that it will be agreed on goes on record; so does, once it is agreed, who may approve by which
    delivery spec.
    """
    changes = take_changes(session, contract.id)
    if kind == SENT:
        changes = changes.without_drafts()
        return changes.add(*queries.rows_as_sent(session, contract))
    if contract.state is ContractState.DRAFT:
        return changes.without_drafts()
    if kind == AGREED and contract.kind in ORDERS:
        changes.add(*queries.rows_on_approval(session, contract.project_id))
    return changes


@listens_for(Session, "before_commit", insert=True)
def _append_rest(session: Session) -> None:
    """Put rows on record that changed without an entry of their own."""
    session.flush()
    reach = session.info.get(REACH)
    for contract_id in owners_with_changes(session):
        contract = session.get(Contract, contract_id)
        if contract is None:
            take_changes(session, contract_id)  # deleted, with its record
            continue
        changes = take_changes(session, contract_id)
        if contract.state is ContractState.DRAFT:
            changes = changes.without_drafts()
        if changes:
            facts = {"data": changes.in_words()}
            append(session, contract_id, WRITTEN, facts, by=reach.person_id if reach else None, rows=changes)


def append_by(
    session: Session, actor: Actor, contract: Contract, kind: str, version: ContractVersion | None = None, **facts: Any
) -> None:
    """Write into a contract's record what its caller did, and to which text."""
    person = session.get_one(Person, actor.person)
    payload: dict[str, Any] = {"by_email": person.email, **facts}
    if version is not None:
        payload |= {
            "version": version.number,
            "text_sha256": version.text_sha256,
            "pdf_sha256": version.pdf_sha256 or "",
        }
    append(session, contract.id, kind, payload, by=person.id)


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


def validation_errors(session: Session, contract: Contract) -> Iterator[str]:
    """Yield, in words, where a contract's record is not the one that was written."""
    events = queries.events_of(session, contract.id)
    for event in events:
        if (event.studio_id, event.project_id) != (contract.studio_id, contract.project_id):
            yield f"entry {event.seq} is kept for another studio or project than the contract"
    entries = map(entry_of, events)
    yield from faults(entries, of=str(contract.id), length=contract.record_length, last_sha256=contract.record_sha256)


def document_of(session: Session, contract: Contract) -> dict[str, Any]:
    """Return the record as the file that a party keeps: whole, and verifiable without the server."""
    return {
        "format": FORMAT,
        "contract": str(contract.id),
        "title": contract.title,
        "studio": contract.project.studio.name,
        "designer": contract.designer.name,
        "how": HOW,
        "length": contract.record_length,
        "sha256": contract.record_sha256,
        "entries": [
            {name: value for name, value in vars(entry_of(event)).items() if name != "of"}
            for event in queries.events_of(session, contract.id)
        ],
    }


def read_document(text: str) -> tuple[UUID, list[Entry]]:
    """Return the contract and the entries of a kept file; raise NoRecord, saying why, for anything else."""
    try:
        document = json.loads(text)
        if document["format"] != FORMAT:
            raise NoRecord(f"its format is {document['format']!r}; this version reads format {FORMAT}")
        entries = [Entry(of=str(UUID(document["contract"])), **entry) for entry in document["entries"]]
        ends = document["length"], document["sha256"]
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise NoRecord(f"it is not a record that was taken from a contract ({error})") from None
    if found_faults := list(faults(entries, of=document["contract"], length=ends[0], last_sha256=ends[1])):
        raise NoRecord(f"the file itself was altered: {found_faults[0]}")
    return UUID(document["contract"]), entries


def faults_beside(session: Session, contract_id: UUID, kept: Sequence[Entry]) -> Iterator[str]:
    """Yield sentences on where the server's record differs from a kept copy."""
    here = {event.seq: entry_of(event) for event in queries.events_of(session, contract_id)}
    if missing := [entry.seq for entry in kept if entry.seq not in here]:
        yield f"entry {missing[0]} of the copy is not in the server's record"
    for entry in kept:
        if entry.seq in here and here[entry.seq] != entry:
            yield f"entry {entry.seq} is another one in the copy"
            return


def text_faults(session: Session, store: Store, contract: Contract) -> Iterator[str]:
    """Yield, in words, where texts and PDFs are not those that the record names."""
    versions = {version.number: version for version in queries.versions_of(session, contract.id)}
    for version in versions.values():
        if sha256_of(version.text) != version.text_sha256:
            yield f"the text of version {version.number} was altered"
        if version.pdf_sha256 is not None:
            try:
                store.verify(contract.studio_id, version.pdf_sha256)
            except BlobMissing:
                yield f"the PDF of version {version.number} is not in the store"
            except BlobAltered:
                yield f"the PDF of version {version.number} was altered"
    for seal in queries.sealed_versions(session, contract.id).values():
        if not _is_kept(store, contract, seal.file_sha256):
            yield f"the sealed PDF {seal.file_sha256} is not in the store, or was altered"
    for event in queries.events_of(session, contract.id):
        try:
            payload = json.loads(event.payload)
            named = payload.get("version"), payload.get("text_sha256"), payload.get("pdf_sha256")
        except (ValueError, AttributeError):
            yield f"entry {event.seq} cannot be read"
            continue
        if named[1] is not None:
            named_version = versions.get(named[0])
            if named_version is None or (named_version.text_sha256, named_version.pdf_sha256 or "") != named[1:]:
                yield f"version {named[0]} is not the text that entry {event.seq} names"


def _is_kept(store: Store, contract: Contract, sha256: str) -> bool:
    try:
        store.verify(contract.studio_id, sha256)
    except (BlobMissing, BlobAltered):
        return False
    return True
