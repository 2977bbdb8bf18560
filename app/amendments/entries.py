"""Entries of a record as they are read: what each says, and which state the contract has after it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

from app.agreements.rules import ContractState

# The state that a contract has after an entry of the record.
STATE_AFTER = {
    "sent": ContractState.SENT,
    "taken_back": ContractState.DRAFT,
    "change_requested": ContractState.DRAFT,
    "redlines_proposed": ContractState.DRAFT,
    "agreed": ContractState.AGREED,
    "ended": ContractState.ENDED,
}
DRAFTS = frozenset(kind for kind, state in STATE_AFTER.items() if state is ContractState.DRAFT)


@dataclass(frozen=True)
class Entry:
    """One entry of the record, read."""

    seq: int
    kind: str
    at: datetime
    said: Mapping[str, Any]


def state_after(entries: Sequence[Entry]) -> ContractState:
    """Return the state that a contract has by its record."""
    states = [STATE_AFTER[entry.kind] for entry in entries if entry.kind in STATE_AFTER]
    return states[-1] if states else ContractState.DRAFT
