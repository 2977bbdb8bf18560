"""A chain of entries each of which holds the hash of the one before: what is altered, taken out or moved, shows."""

import hashlib
import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from app.core.plural import counted, verb

START = "0" * 64  # what stands before the first entry


@dataclass(frozen=True)
class Entry:
    """One entry of a chain; `of` says whose chain it is, so that none can be moved to another."""

    of: str
    seq: int
    at: str  # an instant in UTC, ISO 8601 with microseconds
    kind: str
    payload: str  # canonical JSON
    previous_sha256: str
    sha256: str


def canonical(payload: Mapping[str, Any]) -> str:
    """Return the one JSON text of a payload: keys in order, no spaces, no fractions that could round."""
    return json.dumps(payload, ensure_ascii=False, sort_keys=True, separators=(",", ":"), allow_nan=False)


def link(previous_sha256: str, *, of: str, seq: int, at: str, kind: str, payload: str) -> Entry:
    """Return the entry that follows another."""
    sealed = canonical({"at": at, "kind": kind, "of": of, "payload": payload, "previous": previous_sha256, "seq": seq})
    return Entry(of, seq, at, kind, payload, previous_sha256, hashlib.sha256(sealed.encode()).hexdigest())


def faults(entries: Iterable[Entry], *, of: str, length: int, last_sha256: str) -> Iterator[str]:
    """Yield, in words, where a chain is not the one that was written: `length` and `last_sha256` are its end.

    Entries come in order of their numbers.
    """
    previous, expected = START, 1
    for entry in entries:
        if entry.seq != expected:
            yield f"entry {expected} is missing" if entry.seq > expected else f"entry {entry.seq} is there twice"
            previous, expected = entry.sha256, entry.seq + 1
            continue
        whole = link(previous, of=of, seq=entry.seq, at=entry.at, kind=entry.kind, payload=entry.payload)
        if entry.previous_sha256 != previous:
            yield f"entry {entry.seq} does not follow entry {entry.seq - 1}"
        elif entry.sha256 != whole.sha256:
            yield f"entry {entry.seq} was altered"
        previous, expected = entry.sha256, expected + 1
    if expected - 1 < length:
        missing = length - expected + 1
        yield f"the last {missing} of {counted(length, 'entry', 'entries')} {verb(missing, 'is', 'are')} missing"
    elif expected - 1 > length:
        yield f"{counted(expected - 1 - length, 'entry was', 'entries were')} added past the end"
    elif previous != last_sha256:
        yield f"entry {length} is not the one that was written last"
