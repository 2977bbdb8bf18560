"""Rows of the tables that money and rights depend on, held against the record of their contract."""

from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from sqlalchemy.orm import Session

from app.agreements.models import Contract, ContractVersion
from app.agreements.rules import ORDERS, ContractState
from app.amendments import row_queries
from app.amendments.entries import DRAFTS, Entry, state_after
from app.amendments.row_queries import UNREADABLE, StoredRows, first_line
from app.core.recorded_rows import NAMES, RecordedTable
from app.projects.models import Deputy

TITLES = ("title", "full_number", "reference", "name", "file_name", "kind", "number")  # what tells rows apart


@dataclass
class RecordedRow:
    """A row as its record has it."""

    facts: dict[str, Any]
    entries: dict[str, int]  # for each column, the entry that says so
    is_whole: bool  # what it does not name is empty

    @property
    def seq(self) -> int:
        """The entry that tells of the row last."""
        return max(self.entries.values(), default=0)


@dataclass
class RecordedRows:
    """The rows of every table as a record has them, and where it contradicts itself."""

    by_table: defaultdict[str, dict[str, RecordedRow]] = field(default_factory=lambda: defaultdict(dict))
    gone: set[tuple[str, str]] = field(default_factory=set)
    faults: list[str] = field(default_factory=list)
    has_plan: bool = False  # it was sent, and is no draft again

    def read(self, entry: Entry) -> None:
        """Take over what an entry says of rows."""
        if entry.kind in DRAFTS:
            self.has_plan = False
            for name in [name for name in self.by_table if NAMES[name].is_draft]:
                if NAMES[name].model is not ContractVersion:  # what was sent stays as it was
                    del self.by_table[name]
        rows = entry.said.get("rows", {})
        for name, added in rows.get("added", {}).items():
            for id_, facts in added.items():
                self._add(name, id_, facts, entry.seq)
        for name, changed in rows.get("changed", {}).items():
            for id_, facts in changed.items():
                row = self.by_table[name].setdefault(id_, RecordedRow({}, {}, is_whole=False))
                row.facts |= facts
                row.entries |= dict.fromkeys(facts, entry.seq)
        for name, removed in rows.get("removed", {}).items():
            for id_ in removed:
                self.by_table[name].pop(id_, None)
                self.gone.add((name, id_))
        self.has_plan = self.has_plan or entry.kind == "sent"

    def _add(self, name: str, id_: str, facts: Mapping[str, Any], seq: int) -> None:
        before = self.by_table[name].get(id_)
        if before is None or not before.is_whole:
            entries = dict.fromkeys(NAMES[name].columns, seq)
            self.by_table[name][id_] = RecordedRow(dict(facts), entries, is_whole=True)
            self.gone.discard((name, id_))
            return
        self.faults += [
            f"the {name} {id_}: entry {seq} has the {column} {facts.get(column, 'none')}, "
            f"and entry {before.entries[column]} had {before.facts.get(column, 'none')}"
            for column in NAMES[name].columns
            if facts.get(column) != before.facts.get(column)
        ]


def row_faults(session: Session, contract: Contract, entries: Sequence[Entry]) -> Iterator[str]:
    """Yield, in words, each row that was altered, taken out, put in or moved since its record was written."""
    recorded = RecordedRows()
    for entry in entries:
        recorded.read(entry)
    yield from recorded.faults
    state = state_after(entries)
    scope = _scope_of(contract, recorded)
    for table in NAMES.values():
        if table.model is Deputy and state is not ContractState.AGREED:
            continue  # they are on record while the contract is in force
        rows = recorded.by_table[table.name]
        try:
            stored = row_queries.stored_rows(session, table, contract, rows)
            yield from _faults_of_table(session, table, rows, stored, scope)
        except UNREADABLE as error:
            yield f"the table {table.model.__tablename__} cannot be read: {first_line(error)}"
            continue
        if _is_complete(table, state, recorded, contract):
            yield from _in_no_entry(session, table, rows, stored)


def _in_no_entry(
    session: Session, table: RecordedTable, rows: Mapping[str, RecordedRow], stored: StoredRows
) -> Iterator[str]:
    for id_ in sorted(stored.in_scope - rows.keys()):
        values = stored.values[id_]
        if table.model is not ContractVersion or values["sent_at"] is not None:
            yield f"{_called(session, table, id_, values)} is in no entry ({table.model.__tablename__} {id_})"


def _scope_of(contract: Contract, recorded: RecordedRows) -> dict[str, str]:
    """Return the studio, project and contract that all rows of a contract belong to, as the record has them."""
    row = recorded.by_table["contract"].get(str(contract.id))
    scope = {"studio_id": contract.studio_id, "project_id": contract.project_id, "contract_id": contract.id}
    return {name: (row.facts.get(name) if row else None) or str(value) for name, value in scope.items()}


def _is_complete(table: RecordedTable, state: ContractState, recorded: RecordedRows, contract: Contract) -> bool:
    """Return whether every row that the contract has in a table is on record."""
    if table.model is ContractVersion:
        return True  # only those that were sent are asked for
    if table.is_draft:
        return recorded.has_plan
    if row_queries.is_of_project(table):
        return state is ContractState.AGREED and contract.kind in ORDERS
    return True


def _faults_of_table(
    session: Session,
    table: RecordedTable,
    rows: Mapping[str, RecordedRow],
    stored: StoredRows,
    scope: Mapping[str, str],
) -> Iterator[str]:
    for (id_, column), why in sorted(stored.unreadable.items()):
        yield f"the {column} of the {table.name} {id_} cannot be read: {why}"
    for id_, row in sorted(rows.items()):
        where = f"{table.model.__tablename__} {id_}"
        if id_ not in stored.values:
            called = _called(session, table, id_, row.facts)
            yield f"{called} is missing, and entry {row.seq} of the record has it ({where})"
            continue
        for column, is_, says, seq in _differences(table, row, stored.values[id_], scope):
            if (id_, column) not in stored.unreadable:
                called = _called(session, table, id_, row.facts)
                now, then = (row_queries.shown(session, table, column, value) for value in (is_, says))
                yield f"{called}: its {column} is {now}, and the record says {then} ({where}, entry {seq})"


def _differences(
    table: RecordedTable, row: RecordedRow, values: Mapping[str, Any], scope: Mapping[str, str]
) -> Iterator[tuple[str, Any, Any, int]]:
    """Yield each column that differs: what it holds, what the record says, and by which entry."""
    for column in table.columns if row.is_whole else row.facts:
        is_, says = table.value(column, values[column]), row.facts.get(column)
        if is_ != says:
            yield column, is_, says, row.entries[column]
    for column in table.implied:
        if str(values[column]) != scope[column]:
            yield column, str(values[column]), scope[column], row.seq


def _called(session: Session, table: RecordedTable, id_: str, facts: Mapping[str, Any]) -> str:
    """Return a row as people name it: the milestone Alpha, the payment T-1, the cue of the plan SW-007."""
    title = next((str(facts[column]) for column in TITLES if facts.get(column) not in (None, "")), "")
    if "cue_id" in facts:
        title = f"{title} of {row_queries.shown(session, table, 'cue_id', facts['cue_id'], with_id=False)}".strip()
    return f"the {table.name} {title or id_}"
