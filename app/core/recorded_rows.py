"""Tables whose rows are on record: which columns count, and what a transaction changed in them.

A table is declared once. From then on each flush collects the columns that it changed, under the id of the record that
owns the row, and the room with that record writes them down in the same transaction. A change that is made past this
software is in no record, so a comparison of tables and record shows it.
"""

import hashlib
import json
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from datetime import date, datetime
from enum import Enum
from typing import Any
from uuid import UUID

import sqlalchemy as sa
from sqlalchemy import event
from sqlalchemy.orm import Session, UOWTransaction

from app.core.db import Base

Facts = dict[str, Any]  # columns of a row as plain JSON
Owners = Callable[[Session, Any], Iterable[UUID]]
PENDING = "rows to record"  # key in a session's info
SCOPE = ("studio_id", "project_id", "contract_id")  # of a row that its owner names already
DIGEST = "sha256:"


@dataclass(frozen=True)
class RecordedTable:
    """A table whose rows are on record, under the name that people read."""

    model: type[Base]
    name: str
    columns: tuple[str, ...]
    digested: frozenset[str]  # long or private: the record has their hashes
    implied: tuple[str, ...]  # columns that have to be those of the owner
    key: str
    is_draft: bool  # while its owner is a draft, its rows are nobody's but the author's
    owners: Owners | None  # None: rows are handed over, not collected

    def value(self, column: str, value: Any) -> Any:
        """Return a column's value as the record has it."""
        if value is None:
            return None
        if column in self.digested or isinstance(value, list | dict):
            text = value if isinstance(value, str) else _one_text(value)
            return DIGEST + hashlib.sha256(text.encode()).hexdigest()
        return plain(value)

    def facts(self, row: Any) -> Facts:
        """Return the columns of a row that hold something."""
        values = ((column, self.value(column, getattr(row, column))) for column in self.columns)
        return {column: value for column, value in values if value is not None}

    def id_of(self, row: Any) -> str:
        """Return the id by which the record names a row."""
        return str(getattr(row, self.key))


def _one_text(value: list[Any] | dict[str, Any]) -> str:
    return json.dumps(value, sort_keys=True, ensure_ascii=False, separators=(",", ":"))


def plain(value: Any) -> Any:
    """Return a value of a column as plain JSON that reads the same on every database."""
    if isinstance(value, Enum):
        return value.value
    if isinstance(value, datetime):
        return value.isoformat(timespec="microseconds")
    if isinstance(value, date):
        return value.isoformat()
    if isinstance(value, bool | int | str):
        return value
    if isinstance(value, UUID | float):
        return str(value)
    raise TypeError(f"a {type(value).__name__} cannot be put on record")


TABLES: dict[type[Any], RecordedTable] = {}
NAMES: dict[str, RecordedTable] = {}


def by_contract(_session: Session, row: Any) -> Iterable[UUID]:
    """Return the contract that a row names."""
    return (row.contract_id,)


def declare(
    model: type[Base],
    name: str,
    *,
    owners: Owners | None = by_contract,
    only: Iterable[str] = (),
    left_out: Iterable[str] = (),
    digested: Iterable[str] = (),
    implied: Iterable[str] = SCOPE,
    is_draft: bool = False,
) -> None:
    """Put the rows of a table on record: all columns, or those named, but for what is left out."""
    table = model.metadata.tables[model.__tablename__]
    (key,) = table.primary_key.columns.keys()
    has_implied = tuple(column for column in implied if column in table.columns)
    skipped = {key, *left_out, *has_implied}
    columns = tuple(column for column in (*only,) or table.columns.keys() if column not in skipped)
    declared = RecordedTable(model, name, columns, frozenset(digested), has_implied, key, is_draft, owners)
    TABLES[model] = NAMES[name] = declared


@dataclass
class RowChanges:
    """The changes of rows, by the name of their table and their id."""

    added: dict[str, dict[str, Facts]] = field(default_factory=lambda: defaultdict(dict))
    changed: dict[str, dict[str, Facts]] = field(default_factory=lambda: defaultdict(dict))
    removed: dict[str, list[str]] = field(default_factory=lambda: defaultdict(list))

    def __bool__(self) -> bool:
        return any((self.added, self.changed, self.removed))

    def add(self, *rows: Any) -> "RowChanges":
        """Note whole rows as they are."""
        for row in rows:
            table = TABLES[type(row)]
            self.added[table.name][table.id_of(row)] = table.facts(row)
        return self

    def change(self, row: Any, facts: Facts) -> None:
        """Note columns of a row that changed."""
        table, id_ = TABLES[type(row)], TABLES[type(row)].id_of(row)
        if id_ in self.added.get(table.name, {}):
            self.added[table.name][id_] |= facts
        else:
            self.changed[table.name].setdefault(id_, {}).update(facts)

    def remove(self, row: Any) -> "RowChanges":
        """Note that a row is gone, or that it is not the owner's any more."""
        table, id_ = TABLES[type(row)], TABLES[type(row)].id_of(row)
        self.changed.get(table.name, {}).pop(id_, None)
        if self.added.get(table.name, {}).pop(id_, None) is None:
            self.removed[table.name].append(id_)
        return self

    def merge(self, other: "RowChanges") -> None:
        """Note the other changes."""
        for name, rows in other.added.items():
            self.added[name] |= rows
        for name, rows in other.changed.items():
            for id_, facts in rows.items():
                self.changed[name].setdefault(id_, {}).update(facts)
        for name, ids in other.removed.items():
            self.removed[name] += ids

    def without_drafts(self) -> "RowChanges":
        """Return the changes without the tables that are private while their owner is a draft."""
        kept = RowChanges()
        for name in (*self.added, *self.changed, *self.removed):
            if not NAMES[name].is_draft:
                for mine, theirs in ((kept.added, self.added), (kept.changed, self.changed)):
                    if name in theirs:
                        mine[name] = theirs[name]
                if name in self.removed:
                    kept.removed[name] = self.removed[name]
        return kept

    def as_json(self) -> dict[str, Any]:
        """Return the facts for the record, without those that are empty."""
        kept: dict[str, Any] = {}
        for act, tables in (("added", self.added), ("changed", self.changed), ("removed", self.removed)):
            if some := {name: rows for name, rows in tables.items() if rows}:
                kept[act] = some
        return kept

    def in_words(self) -> list[str]:
        """Return in a few words what happened."""
        acts: Mapping[str, Mapping[str, Any]] = self.as_json()
        return [f"{name} {act}" for act, tables in acts.items() for name in tables]


def take_changes(session: Session, owner_id: UUID) -> RowChanges:
    """Return the changes of this transaction to the rows of an owner since the last call."""
    pending: dict[UUID, RowChanges] = session.info.get(PENDING, {})
    return pending.pop(owner_id, RowChanges())


def owners_with_changes(session: Session) -> list[UUID]:
    """Return the owners of rows that this transaction changed and that are on no record yet, in one order."""
    return sorted(session.info.get(PENDING, {}))


@event.listens_for(Session, "after_flush")
def _collect(session: Session, _context: UOWTransaction) -> None:
    for row in session.new:
        for changes in _changes_of(session, row):
            changes.add(row)
    for row in session.dirty:
        if facts := dict(_changed_columns(row)):
            for changes in _changes_of(session, row):
                changes.change(row, facts)
    for row in session.deleted:
        for changes in _changes_of(session, row):
            changes.remove(row)


def _changes_of(session: Session, row: Any) -> Iterator[RowChanges]:
    table = TABLES.get(type(row))
    if table is None or table.owners is None:
        return
    pending = session.info.setdefault(PENDING, defaultdict(RowChanges))
    yield from (pending[owner_id] for owner_id in table.owners(session, row))


def _changed_columns(row: Any) -> Iterator[tuple[str, Any]]:
    table = TABLES.get(type(row))
    if table is None or table.owners is None:
        return
    attributes = sa.inspect(row).attrs
    for column in table.columns:
        if attributes[column].history.has_changes():
            yield column, table.value(column, getattr(row, column))


@event.listens_for(Session, "after_rollback")
def _forget(session: Session) -> None:
    session.info.pop(PENDING, None)
