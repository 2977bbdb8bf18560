"""Rows of any table that is on record, read for a comparison; for the server's own commands."""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any
from uuid import UUID

from sqlalchemy import ColumnElement, FromClause, String, cast, exists, false, inspect, or_, select
from sqlalchemy.exc import SQLAlchemyError
from sqlalchemy.orm import Session

from app.accounts.models import Person
from app.agreements.models import Contract, ContractEvent, Milestone
from app.core.db import Base
from app.core.in_array import in_array
from app.core.recorded_rows import NAMES, RecordedTable
from app.money.models import Invoice, InvoiceLine
from app.projects.models import ApproverChange, CategoryApprover, Deputy
from app.sound_lists.models import Cue

UNREADABLE = (SQLAlchemyError, ValueError, LookupError, TypeError)  # of a value that its column does not take
NAMED: dict[str, tuple[type[Base], str]] = {
    "accounts_people": (Person, "name"),
    "sound_lists_cues": (Cue, "name"),
    "contracts_milestones": (Milestone, "name"),
    "contracts_contracts": (Contract, "title"),
    "contracts_invoices": (Invoice, "full_number"),
}


@dataclass
class StoredRows:
    """Rows of a table as they are: by id, those that belong to the contract, and values that cannot be read."""

    values: dict[str, dict[str, Any]] = field(default_factory=dict)
    in_scope: set[str] = field(default_factory=set)
    unreadable: dict[tuple[str, str], str] = field(default_factory=dict)  # by id and column: why


def stored_rows(session: Session, table: RecordedTable, contract: Contract, ids: Collection[str]) -> StoredRows:
    """Return the rows that a contract has in a table, and those of these ids, whoever has them now."""
    columns = inspect(table.model).local_table.c
    key, names = columns[table.key], (*table.columns, *table.implied)
    scope = _scope(table, contract)
    keys = [UUID(id_) for id_ in ids if is_id(id_)]
    chosen = or_(scope, in_array(key, keys))
    stored = StoredRows()
    try:
        for id_, is_in_scope, *values in session.execute(
            select(key, scope, *(columns[name] for name in names)).where(chosen)
        ):
            stored.values[str(id_)] = dict(zip(names, values, strict=True))
            if is_in_scope:
                stored.in_scope.add(str(id_))
    except UNREADABLE:
        return _read_one_by_one(session, table, scope, chosen)
    return stored


def _read_one_by_one(
    session: Session, table: RecordedTable, scope: ColumnElement[bool], chosen: ColumnElement[bool]
) -> StoredRows:
    """Return rows of which some value cannot be read: each value on its own, and which these are."""
    columns = inspect(table.model).local_table.c
    as_text, stored = cast(columns[table.key], String), StoredRows()
    stored.in_scope = {id_of(text) for text in session.scalars(select(as_text).where(scope))}
    for text in session.scalars(select(as_text).where(chosen)).all():
        values: dict[str, Any] = {}
        for name in (*table.columns, *table.implied):
            try:
                values[name] = session.execute(select(columns[name]).where(as_text == text)).scalar_one()
            except UNREADABLE as error:
                stored.unreadable[id_of(text), name] = first_line(error)
                values[name] = None
        stored.values[id_of(text)] = values
    return stored


def _scope(table: RecordedTable, contract: Contract) -> ColumnElement[bool]:
    """Return the rows of a table that belong to a contract; none, where a row does not say so itself."""
    columns = inspect(table.model).local_table.c
    if table.model is Contract:
        return columns["id"] == contract.id
    if table.model is InvoiceLine:
        return columns["invoice_id"].in_(select(Invoice.id).where(Invoice.contract_id == contract.id))
    if is_of_project(table):
        return columns["project_id"] == contract.project_id
    return columns["contract_id"] == contract.id if "contract_id" in table.implied else false()


def is_of_project(table: RecordedTable) -> bool:
    """Return whether every contract in force of a project has the table's rows on record."""
    return table.model in (ApproverChange, CategoryApprover, Deputy)


def shown(session: Session, table: RecordedTable, column: str, value: Any, *, with_id: bool = True) -> str:
    """Return a value as people read it: of an id also the name of what it stands for."""
    if value is None:
        return "empty"
    foreign = next(iter(inspect(table.model).local_table.c[column].foreign_keys), None)
    target = foreign.target_fullname.split(".")[0] if foreign else "sound_lists_cues" if column == "cue_id" else ""
    if target in NAMED and is_id(str(value)):
        model, attribute = NAMED[target]
        row = session.get(model, UUID(str(value)))
        name = getattr(row, attribute, None)
        if name is not None:
            return f"{name} ({value})" if with_id else str(name)
    return str(value)


def orphans(session: Session) -> Iterator[tuple[str, str]]:
    """Yield the contracts that rows name and that are not there, each with a table that names it."""
    tables: dict[str, FromClause] = {
        table.name: inspect(table.model).local_table for table in NAMES.values() if "contract_id" in table.implied
    }
    for name, table in {"entry of the record": inspect(ContractEvent).local_table, **tables}.items():
        gone = ~exists().where(Contract.id == table.c.contract_id)
        ids: Sequence[str] = session.scalars(select(cast(table.c.contract_id, String)).where(gone).distinct()).all()
        yield from ((id_of(text), name) for text in ids)


def id_of(text: str) -> str:
    """Return an id in the form in which the record has it, whatever form the database keeps it in."""
    return str(UUID(text)) if is_id(text) else text


def is_id(text: str) -> bool:
    """Return whether a text is an id."""
    try:
        UUID(text)
    except ValueError:
        return False
    return True


def first_line(error: BaseException) -> str:
    """Return the message of an error, in one line."""
    return (str(error) or type(error).__name__).splitlines()[0]
